// What is asked of pages that print as a report and hold every set of units: of plans, reaches, calibrations and modes.
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { numbersOf, pooled, quantities } from "./quantities.mjs";

const SETS = ["si", "metric", "field"];

/** What a sheet of A4 holds between margins of 12 mm, in pixels of 1/96 inch. */
const PAPER = { width: 703, height: 1032 };

/** The part of the page that is seen with a set of units. */
const seen = (units) => `.in-${units}:not(header *)`;

/** All sections with a set of units: title, headings, rows of cells, and the files that they lead to. */
const sections = (page, units) =>
  page.locator(`${seen(units)} section`).evaluateAll((all) => {
    // Spaces that break no line are spaces.
    const text = (element) => element.textContent.replaceAll("\u00a0", " ");
    return all.map((section) => ({
      title: text(section.querySelector("h2")),
      drawn: section.querySelector("figure svg") !== null,
      heads: [...section.querySelectorAll("thead th")].map((head) => ({
        text: text(head),
        words: head.classList.contains("words"),
      })),
      rows: [...section.querySelectorAll("tbody tr")].map((row) => [...row.cells].map(text)),
      files: [...section.querySelectorAll("p.note a")].map((link) => decodeURIComponent(link.getAttribute("href"))),
    }));
  });

const choose = (page, units) => page.check(`#units-${units}`);

/**
 * Checks a page; `file` is where it lies, `figures` how many it has at least, `sheets` on how many it prints at most.
 */
export async function checkSheets({ check, open }, page, file, { figures, sheets }) {
  const folder = dirname(file);

  await check("every figure has frames, named axes, ticks, a legend and curves", async () => {
    const drawn = page.locator(`${seen("si")} figure svg`);
    const count = await drawn.count();
    assert.ok(count >= figures, `${count} figures`);
    for (let i = 0; i < count; i++) {
      const figure = drawn.nth(i);
      const has = (selector) => figure.locator(selector).count();
      assert.ok((await has("path.stroke-frame")) > 0, `frames of figure ${i}`);
      assert.ok((await has(".legend-key")) > 0, `a legend of figure ${i}`);
      assert.ok((await has("[clip-path][class*=line-], .series path")) > 0, `curves or points of figure ${i}`);
      assert.equal(await has("path[d*=NaN]"), 0, "no coordinate is missing");
      const texts = await figure.locator("text").allTextContents();
      const ticks = texts.filter((text) => /^[−\d.\s\u202f]+$/.test(text));
      assert.ok(ticks.length >= 6, `ticks of figure ${i}: ${ticks}`);
      assert.ok(texts.some((text) => /depth|speed|best|MD|index|time/i.test(text)), `axes of figure ${i} say what they are`);
    }
  });

  await check("one set of units is seen, and the reader chooses which", async () => {
    for (const units of SETS) {
      await choose(page, units);
      for (const other of SETS)
        assert.equal(await page.locator(seen(other)).first().isVisible(), other === units, `${other} of ${units}`);
      assert.equal(await page.locator("header .in-units:visible").count(), 1);
    }
    await page.focus("#units-field");
    await page.keyboard.press("ArrowLeft");
    assert.ok(await page.locator(seen("metric")).first().isVisible(), "by keyboard too");
    await choose(page, "si");
  });

  await check("a number is the same quantity in every set of units", async () => {
    const [si, ...others] = await Promise.all(SETS.map((units) => sections(page, units)));
    let [same, changed] = [0, 0];
    for (const other of others) {
      assert.equal(other.length, si.length);
      // The rows of the roadmap are at depths that are round in each set.
      const alike = si.map((section, s) => [section, s]).filter(([section]) => section.title !== "Roadmap");
      alike.forEach(([section, s]) =>
        section.rows.forEach((row, r) =>
          row.forEach((_, c) => {
            const [mine, its] = [section, other[s]].map((of) => quantities(of, r, c));
            assert.equal(its.length, mine.length, `${section.title}, row ${r}: ${row[c]}`);
            mine.forEach((a, i) => {
              const b = its[i];
              assert.equal(b.kind, a.kind, `${section.title}: ${row[c]} and ${other[s].rows[r][c]}`);
              const off = Math.abs(a.si - b.si);
              assert.ok(off <= 1.01 * (a.half + b.half), `${section.title}: ${row[c]} and ${other[s].rows[r][c]}`);
              if (a.unit === b.unit) same += 1;
              else changed += 1;
            });
          }),
        ),
      );
    }
    assert.ok(changed > 10, `${changed} numbers change, ${same} do not`);
  });

  await check("every figure has its picture and its numbers beside it, every table its file", async () => {
    for (const { title, drawn, heads, files } of await sections(page, "si")) {
      // A part of words alone.
      if (!drawn && heads.length === 0) continue;
      const wanted = drawn ? [/\.svg$/, /\.csv$/] : [/\.(csv|json|xlsx)$/];
      for (const ending of wanted) assert.ok(files.some((name) => ending.test(name)), `${title}: ${files}`);
      for (const name of files) assert.ok(existsSync(join(folder, name)), `${title}: ${name}`);
      for (const name of files.filter((name) => name.endsWith(".csv"))) {
        const lines = readFileSync(join(folder, name), "utf8").trim().split("\n");
        assert.ok(lines.length > 1, `${name} has rows`);
      }
    }
  });

  await check("every number of a table stands in a machine file, in its unit", async () => {
    const summary = numbersOf(join(folder, "summary.json"));
    const sentences = readFileSync(join(folder, "summary.json"), "utf8").replaceAll("`", "");
    let count = 0;
    // The roadmap is in proportion between the depths of the plan.
    for (const section of (await sections(page, "si")).filter(({ title }) => title !== "Roadmap")) {
      const tables = section.files.filter((name) => /\.csv$/.test(name));
      // The workbook has all tables.
      const names = section.files.some((name) => name.endsWith(".xlsx")) ? ["plan_broomstick.csv"] : tables;
      const known = pooled([summary, ...names.map((name) => numbersOf(join(folder, name)))]);
      section.rows.forEach((row, r) =>
        row.forEach((text, c) => {
          // A sentence stands there word for word.
          if (section.heads[c].words && sentences.includes(text)) return;
          for (const { kind, si, half } of quantities(section, r, c)) {
            const stands = (known.get(kind) ?? []).some((value) => Math.abs(value - si) <= 1.01 * half + 1e-12 * Math.abs(si));
            assert.ok(stands, `${section.title}, row ${r}, "${section.heads[c].text}": ${text} is in none of ${names}`);
            count += 1;
          }
        }),
      );
    }
    assert.ok(count > 20, `${count} numbers`);
    console.log(`        ${count} numbers`);
  });

  await check("its contents lead to every section that is seen", async () => {
    const links = await page.locator(`${seen("si")} .contents a`).evaluateAll((all) => all.map((link) => link.getAttribute("href")));
    const ids = await page.locator(`${seen("si")} section`).evaluateAll((all) => all.map((part) => `#${part.id}`));
    assert.deepEqual(links, ids);
    const all = await page.locator("[id]").evaluateAll((all) => all.map((element) => element.id));
    assert.equal(new Set(all).size, all.length, "each name once");
  });

  await check("on a telephone a wide table moves in its own box, and letters are read", async () => {
    const narrow = await open({ viewport: { width: 420, height: 900 }, colorScheme: "light" });
    await choose(narrow, "si");
    const boxes = await narrow.locator(`${seen("si")} .scrolls`).evaluateAll((all) =>
      all.map((box) => ({ wide: box.scrollWidth > box.clientWidth, moves: getComputedStyle(box).overflowX })),
    );
    assert.ok(boxes.every((box) => box.moves === "auto"));
    const sizes = await narrow.locator(`${seen("si")} figure:visible text`).evaluateAll((texts) =>
      texts.map((text) => {
        const { width } = text.ownerSVGElement.getBoundingClientRect();
        return (width / text.ownerSVGElement.viewBox.baseVal.width) * Number(text.getAttribute("font-size"));
      }),
    );
    assert.ok(sizes.length > 20 && Math.min(...sizes) >= 9, `${Math.min(...sizes)} pixels`);
    await narrow.context().close();
  });

  await check("dark where the reader's other windows are, figures with it", async () => {
    const looks = (page) =>
      page.evaluate(() => [
        getComputedStyle(document.body).backgroundColor,
        getComputedStyle(document.querySelector("figure text")).fill,
        getComputedStyle(document.querySelector("figure [class*=stroke-line-], figure [class*=fill-line-]")).fill +
          getComputedStyle(document.querySelector("figure [class*=stroke-line-], figure [class*=fill-line-]")).stroke,
      ]);
    const [light, dark] = [await open({ colorScheme: "light" }), await open({ colorScheme: "dark" })];
    const [bright, dim] = [await looks(light), await looks(dark)];
    bright.forEach((look, i) => assert.notEqual(look, dim[i]));
    await Promise.all([light, dark].map((page) => page.context().close()));
  });

  await check("on paper nothing is cut, and headings stand on every sheet", async () => {
    for (const units of ["field", "si"]) {
      await choose(page, units);
      await page.setViewportSize(PAPER);
      await page.emulateMedia({ media: "print" });
      const { parts, hidden } = await page.evaluate(() => ({
        parts: [...document.querySelectorAll("section")]
          .filter((section) => section.checkVisibility())
          .map((section) => {
            const style = (selector, name) => {
              const found = section.querySelector(selector);
              return found && getComputedStyle(found)[name];
            };
            return {
              title: section.querySelector("h2").textContent,
              height: section.getBoundingClientRect().height,
              drawn: section.querySelector("figure svg") !== null,
              rights: [...section.querySelectorAll("table, svg, p")].map((part) => part.getBoundingClientRect().right),
              whole: getComputedStyle(section).breakInside,
              row: style("tbody tr", "breakInside"),
              head: style("thead", "display"),
              below: style("h2", "breakAfter"),
            };
          }),
        hidden: [...document.querySelectorAll(".units, .contents, .note")].filter((part) => part.checkVisibility()).length,
      }));
      assert.equal(hidden, 0, "what is of no use on paper");
      for (const { title, height, drawn, rights, whole, row, head, below } of parts) {
        assert.ok(rights.every((right) => right <= PAPER.width + 1), `${title} sticks out of the paper: ${Math.max(...rights)}`);
        assert.equal(whole, "avoid", title);
        assert.equal(below, "avoid", title);
        if (drawn) assert.ok(height <= PAPER.height, `${title} is ${height} pixels high`);
        if (row !== null) assert.equal(row, "avoid", title);
        if (head !== null) assert.equal(head, "table-header-group", title);
      }
      const paper = await page.pdf({ preferCSSPageSize: true, printBackground: true });
      const count = paper.toString("latin1").match(/\/Type\s*\/Page\b(?!s)/g).length;
      assert.ok(count <= sheets, `${count} sheets`);
      await page.emulateMedia({ media: null });
      await page.setViewportSize({ width: 1440, height: 1000 });
    }
  });
}

/** The sections of a page as `checkSheets` reads them, in SI. */
export const read = (page) => sections(page, "si");
