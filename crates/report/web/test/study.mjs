// The page of a study in a real browser: `node test/study.mjs CHROMIUM report.html`. Figures and tables are there, the page
// follows the reader's colours without a program of its own, nothing is fetched and nothing is complained about.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { dirname, join } from "node:path";
import { browse } from "./browser.mjs";

const [executablePath, file] = process.argv.slice(2);
const { check, open, close } = await browse(executablePath, file, { timeout_ms: 60_000 });

const page = await open({ colorScheme: "light" });

await check("every figure is drawn, a map among them", async () => {
  const figures = page.locator("section figure svg");
  const count = await figures.count();
  assert.ok(count >= 5, `${count} figures`);
  for (let i = 0; i < count; i++) {
    const marks = await figures.nth(i).locator("path[class^=stroke-line][clip-path], path[class*=' stroke-line'], image").count();
    assert.ok(marks > 0, `figure ${i} shows something`);
  }
  assert.equal(await page.locator("figure:not(.narrow) image").count(), 2, "a map and its colours");
  assert.equal(await page.locator("figure path[d*=NaN]").count(), 0, "no coordinate is missing");
});

await check("a figure is as wide as the page lets it be, and says its title once", async () => {
  for (const section of await page.locator("section:has(figure)").all()) {
    const title = await section.locator("h2").textContent();
    const texts = await section.locator("figure text").allTextContents();
    assert.ok(!texts.includes(title), title);
    const [outer, inner] = await section.evaluate((section) => [
      section.clientWidth,
      section.querySelector("svg").getBoundingClientRect().width,
    ]);
    assert.ok(inner > 0.9 * outer, `${inner} of ${outer} pixels`);
  }
});

await check("its letters are read on a telephone", async () => {
  const narrow = await open({ viewport: { width: 420, height: 900 } });
  const sizes = await narrow.locator("figure:visible text").evaluateAll((texts) => texts.map((text) => {
    const scale = text.ownerSVGElement.getBoundingClientRect().width / text.ownerSVGElement.viewBox.baseVal.width;
    return scale * Number(text.getAttribute("font-size"));
  }));
  assert.ok(sizes.length > 50 && Math.min(...sizes) >= 9, `${Math.min(...sizes)} pixels`);
  await narrow.context().close();
});

await check("a wide page and a narrow one have a figure each, and never both", async () => {
  const narrow = await open({ viewport: { width: 420, height: 900 } });
  for (const [tab, shown, hidden] of [[page, "wide", "narrow"], [narrow, "narrow", "wide"]]) {
    assert.ok((await tab.locator(`figure.${shown}:visible`).count()) >= 2, shown);
    assert.equal(await tab.locator(`figure.${hidden}:visible`).count(), 0, hidden);
  }
  await narrow.context().close();
});

await check("its contents lead to every figure and table", async () => {
  const links = await page.locator(".contents a").evaluateAll((links) => links.map((link) => [link.getAttribute("href"), link.textContent]));
  const parts = await page.locator("section").evaluateAll((all) => all.map((part) => [`#${part.id}`, part.querySelector("h2").textContent]));
  assert.deepEqual(links, parts);
});

await check("numbers are judged in words that need no colour", async () => {
  for (const [kind, mark] of [
    ["agrees", "\u2713"],
    ["differs", "\u2717"],
  ]) {
    const cells = page.locator(`td.${kind}`);
    assert.ok((await cells.count()) >= 2, kind);
    const after = await cells.first().evaluate((cell) => getComputedStyle(cell, "::after").content);
    assert.ok(after.includes(mark), after);
  }
});

await check("the files that it names lie beside it", async () => {
  const links = await page.locator("section a").evaluateAll((links) => links.map((link) => link.getAttribute("href")));
  assert.ok(links.length >= 14, `${links.length} links`);
  for (const link of links) assert.ok(existsSync(join(dirname(file), decodeURIComponent(link))), link);
});

await check("dark where the reader's other windows are, figures with it", async () => {
  const looks = (page) =>
    page.evaluate(() => [
      getComputedStyle(document.body).backgroundColor,
      getComputedStyle(document.querySelector("figure text")).fill,
      getComputedStyle(document.querySelector("figure .stroke-line-0")).stroke,
    ]);
  const light = await looks(page);
  const dark = await looks(await open({ colorScheme: "dark" }));
  light.forEach((look, i) => assert.notEqual(look, dark[i]));
});

await close(page, 10_000, "the page of a study");
