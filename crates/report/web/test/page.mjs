// The report in a real browser: `node test/page.mjs CHROMIUM report.html`. Everything draws, what can be switched
// switches, nothing is fetched and nothing is complained about.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { browse, colours, differs, picture, same, settled, SPACE, text } from "./browser.mjs";

const [executablePath, file] = process.argv.slice(2);
const { check, open, close } = await browse(executablePath, file, {
  args: SPACE,
  timeout_ms: 120_000,
});

const page = await open();
const report = await page.evaluate(() => JSON.parse(document.getElementById("report").textContent));
// The answer may open on an operation with a finding.
await page.click(".operations [data-value=drill]");
await settled(page);

/** The name and the text of the file that a button gives. */
async function downloaded(button) {
  const [download] = await Promise.all([page.waitForEvent("download"), button.click()]);
  return [download.suggestedFilename(), readFileSync(await download.path(), "utf8")];
}

await check("five answers", async () => {
  assert.equal(await page.locator(".key-result").count(), 5);
  for (const number of await page.locator(".key-result .number").allTextContents()) assert.match(number, /\d|none/);
});

await check("every track has a curve", async () => {
  const tracks = await page.evaluate(() =>
    [...document.querySelectorAll(".tracks > svg > svg")]
      .filter((track) => track.querySelector(".curve"))
      .map((track) => [...track.querySelectorAll(".curve")].map((curve) => curve.getAttribute("d").length)),
  );
  assert.equal(tracks.length, 8, `${tracks.length} tracks`);
  for (const curves of tracks) assert.ok(Math.max(...curves) > 20, "a curve has points");
  const broken = await page.locator(".tracks path[d*=NaN], .tracks [y*=NaN]").count();
  assert.equal(broken, 0, "no coordinate is missing");
});

await check("no two numbers of an axis overlap", async () => {
  const overlaps = await page.evaluate(() => {
    const found = [];
    for (const picture of document.querySelectorAll(".tracks > svg")) {
      const ticks = [...picture.querySelectorAll(".tick")].filter((tick) => tick.getAttribute("y") < 82);
      const boxes = ticks.map((tick) => [tick.getBoundingClientRect(), tick.textContent]);
      boxes.sort(([a], [b]) => a.left - b.left);
      for (let i = 1; i < boxes.length; i++)
        if (boxes[i][0].left < boxes[i - 1][0].right) found.push(`${boxes[i - 1][1]} and ${boxes[i][1]}`);
    }
    return found;
  });
  assert.deepEqual(overlaps, []);
});

await check("every time history is drawn", async () => {
  const count = await page.locator(".history canvas").count();
  assert.ok(count >= 6, `${count} histories`);
  for (let i = 0; i < count; i++) {
    await page.evaluate((i) => document.querySelectorAll(".history canvas")[i].setAttribute("id", `history-${i}`), i);
    assert.ok((await colours(page, `#history-${i}`)) > 4, `history ${i} is not blank`);
  }
});

await check("the soft string stands beside hook load and torque", async () => {
  const legends = await page.locator(".history .u-legend").allTextContents();
  assert.equal(legends.filter((legend) => legend.includes("soft string")).length, 2, JSON.stringify(legends));
});

await check("the map of contact is drawn", async () => {
  const side = await picture(page, "canvas.map");
  assert.ok((await colours(page, "canvas.map")) > 10);
  await page.click("[data-value=contact_force_N_per_m]");
  differs(await picture(page, "canvas.map"), side, "the other quantity");
});

await check("the well is drawn in space", async () => {
  assert.ok((await colours(page, "canvas.space")) > 50);
});

await check("the scrubber moves the string, and Mean takes it back", async () => {
  const before = await picture(page, "canvas.space");
  await page.locator(".moments input").evaluate((input) => {
    input.value = Math.floor(input.max / 2);
    input.dispatchEvent(new Event("input"));
  });
  await settled(page);
  const at = await picture(page, "canvas.space");
  differs(at, before, "the moment");
  assert.match(await text(page, ".moments output"), /^\d+\.\d\d s$/);
  await page.locator(".moments button", { hasText: "Mean" }).click();
  await settled(page);
  same(await picture(page, "canvas.space"), before, "the mean");
});

await check("exaggeration and colours change the view", async () => {
  const before = await picture(page, "canvas.space");
  await page.locator("#scene .tools input").evaluate((input) => {
    input.value = 3;
    input.dispatchEvent(new Event("input"));
  });
  const thicker = await picture(page, "canvas.space");
  differs(thicker, before, "a thicker string");
  await page.locator("#scene .tools select").selectOption("tension_N");
  differs(await picture(page, "canvas.space"), thicker, "another colour");
});

await check("units switch everywhere, by their factors", async () => {
  const number = async () => {
    const [, digits, unit] = (await text(page, ".key-result .number")).match(/^([\d\u202f,.\u2212]+)\u00a0(\S+)$/);
    return [Number(digits.replace(/[\u202f,]/g, "").replace("\u2212", "-")), unit];
  };
  const seen = {};
  for (const units of ["field", "metric", "si"]) {
    await page.click(`.controls [data-value=${units}]`);
    await settled(page);
    seen[units] = {
      hook: await number(),
      track: await text(page, ".tracks .unit.middle"),
      axis: await text(page, ".tracks text.unit"),
      history: await text(page, ".history .unit"),
      table: await text(page, "#results tbody .unit"),
      dogleg: (await page.locator(".tracks .unit.middle").allTextContents()).at(-1),
    };
  }
  const [kN, t, klbf] = ["si", "metric", "field"].map((units) => seen[units].hook[0]);
  assert.ok(Math.abs((klbf * 4.4482216) / kN - 1) < 1e-3, `${klbf} klbf is ${kN} kN`);
  assert.ok(Math.abs((t * 9.80665) / kN - 1) < 1e-3, `${t} t is ${kN} kN`);
  for (const place of ["track", "history", "table"])
    assert.deepEqual(
      ["si", "metric", "field"].map((units) => seen[units][place].trim()),
      ["kN", "t", "klbf"],
      place,
    );
  assert.deepEqual(
    ["si", "metric", "field"].map((units) => seen[units].axis),
    ["m", "m", "ft"],
  );
  assert.deepEqual([seen.si.dogleg, seen.field.dogleg], ["°/30 m", "°/100 ft"]);
});

await check("zooming one track zooms all, the map and the string with them", async () => {
  const cover = page.locator(".tracks .cover").first();
  await cover.scrollIntoViewIfNeeded();
  const map = await picture(page, "canvas.map");
  const box = await cover.boundingBox();
  await page.mouse.move(box.x + 300, box.y + 0.4 * box.height);
  await page.mouse.down();
  await page.mouse.move(box.x + 300, box.y + 0.6 * box.height, { steps: 4 });
  await page.mouse.up();
  const depths = await page
    .locator("#tracks input")
    .evaluateAll((inputs) => inputs.map((input) => Number(input.value)));
  const total = await page.evaluate(() => JSON.parse(document.getElementById("report").textContent).string.at(-1).to_m);
  assert.ok(
    Math.abs(depths[0] / total - 0.4) < 0.02 && Math.abs(depths[1] / total - 0.6) < 0.02,
    `${depths} of ${total}`,
  );
  differs(await picture(page, "canvas.map"), map, "a part of the map");
  await page.getByRole("button", { name: "All depths" }).click();
  await settled(page);
  same(await picture(page, "canvas.map"), map, "all of the map");
});

await check("Shift and drag moves the depths in view", async () => {
  const read = () => page.locator("#tracks input").evaluateAll((inputs) => inputs.map((input) => Number(input.value)));
  const total = (await read())[1];
  const cover = page.locator(".tracks .cover").first();
  const box = await cover.boundingBox();
  const y = (part) => box.y + part * box.height;
  await page.mouse.move(box.x + 300, y(0.3));
  await page.mouse.down();
  await page.mouse.move(box.x + 300, y(0.5), { steps: 3 });
  await page.mouse.up();
  await page.keyboard.down("Shift");
  await page.mouse.move(box.x + 300, y(0.8));
  await page.mouse.down();
  await page.mouse.move(box.x + 300, y(0.3), { steps: 5 });
  await page.mouse.up();
  await page.keyboard.up("Shift");
  const [from, to] = (await read()).map((depth) => depth / total);
  // Half of what was in view, a fifth of all, further down.
  assert.ok(Math.abs(from - 0.4) < 0.02 && Math.abs(to - 0.6) < 0.02, `${from} to ${to}`);
  await page.getByRole("button", { name: "All depths" }).click();
});

await check("the pointer is read on every track", async () => {
  const box = await page.locator(".tracks .cover").first().boundingBox();
  await page.mouse.move(box.x + 300, box.y + 0.5 * box.height);
  const readouts = await page.locator(".tracks .readout.middle:not(.small)").allTextContents();
  assert.ok(readouts.length === 8 && readouts.every((readout) => /\d/.test(readout)), JSON.stringify(readouts));
});

await check("time histories zoom together", async () => {
  const before = await picture(page, ".history:nth-of-type(3) canvas");
  const over = page.locator(".history .u-over").first();
  await over.scrollIntoViewIfNeeded();
  const box = await over.boundingBox();
  await page.mouse.move(box.x + 0.3 * box.width, box.y + 50);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.7 * box.width, box.y + 52, { steps: 4 });
  await page.mouse.up();
  await settled(page);
  differs(await picture(page, ".history:nth-of-type(3) canvas"), before, "a part of the time");
  await over.dblclick();
  await settled(page);
  same(await picture(page, ".history:nth-of-type(3) canvas"), before, "all of the time");
});

await check("what the bit does is drawn", async () => {
  const titles = await page.locator("#bit h3").allTextContents();
  for (const title of ["Rate of penetration", "Weight on bit", "Torque on bit", "Torque against weight"])
    assert.ok(
      titles.some((of) => of.startsWith(title)),
      `${title} in ${titles}`,
    );
  const count = await page.locator("#bit canvas").count();
  for (let i = 0; i < count; i++) {
    await page.evaluate((i) => document.querySelectorAll("#bit canvas")[i].setAttribute("id", `bit-${i}`), i);
    assert.ok((await colours(page, `#bit-${i}`)) > 4, `${titles[i]} is not blank`);
  }
  assert.equal(await page.locator("#bottom").count(), 0, "no bottom without solid rock");
});

await check("another operation has its own answer, and no bit where it does not drill", async () => {
  const before = await page.locator(".key-result .number").allTextContents();
  await page.locator(".operations button").first().click();
  await settled(page);
  assert.notDeepEqual(await page.locator(".key-result .number").allTextContents(), before);
  assert.ok(!(await page.locator("#bit").isVisible()), "a trip drills nothing");
});

await check("the contents lead to every section that is shown", async () => {
  const links = await page
    .locator(".contents a:not([hidden])")
    .evaluateAll((links) => links.map((link) => [link.getAttribute("href"), link.textContent]));
  const sections = await page
    .locator("section:not([hidden])")
    .evaluateAll((all) => all.map((section) => [`#${section.id}`, section.querySelector("h2").firstChild.textContent]));
  assert.deepEqual(links, sections);
  assert.ok(!links.some(([href]) => href === "#bit"), "a trip has no bit");
  await page.click(".operations [data-value=drill]");
  assert.equal(await page.locator('.contents a[href="#bit"]:not([hidden])').count(), 1);
});

await check("the legend hides curves, by click and by keyboard, and colours are not all that differs", async () => {
  const curves = () => page.locator(".tracks > svg > svg .curve").count();
  const all = await curves();
  const key = page.locator(".legend button").first();
  await key.click();
  const fewer = await curves();
  assert.ok(fewer < all, `${fewer} of ${all}`);
  await page.keyboard.press("Enter");
  assert.equal(await curves(), all);
  const shapes = await page
    .locator(".legend button .marker")
    .evaluateAll((markers) => new Set(markers.map((marker) => marker.getAttribute("d"))).size);
  assert.equal(shapes, 3, "a marker for each operation");
  // The charts of uPlot too.
  const chart = page.locator("#history .history", { hasText: "Torque" }).first();
  const torque = chart.locator(".u-legend .u-series").nth(1);
  await torque.locator("th").focus();
  await page.keyboard.press("Enter");
  assert.match(await torque.getAttribute("class"), /u-off/);
  await page.click(".controls [data-value=field]");
  await settled(page);
  assert.match(await torque.getAttribute("class"), /u-off/, "hidden when drawn anew");
  await page.click(".controls [data-value=si]");
  await torque.locator("th").click();
  assert.doesNotMatch(await torque.getAttribute("class"), /u-off/);
});

await check("the pointer says names with values", async () => {
  const cover = page.locator(".tracks .cover").first();
  await cover.scrollIntoViewIfNeeded();
  const box = await cover.boundingBox();
  await page.mouse.move(box.x + 150, box.y + 0.5 * box.height);
  const rows = await page.locator(".tip div").allTextContents();
  assert.equal(rows.length, 6, JSON.stringify(rows));
  assert.match(rows[0], /^trip out, soft string: [\d.\u2212]+\u00a0kN$/);
  await page.mouse.move(2, 2);
  await page.mouse.move(box.x + 150, box.y - 60);
  assert.ok(!(await page.locator(".tip").isVisible()), "away from it, nothing");
});

await check("figures and tables are given as files", async () => {
  const [profile, picture_] = await downloaded(page.locator("#tracks [data-download=svg]"));
  assert.equal(profile, "along-the-hole.svg");
  const seen = await page.evaluate((text) => {
    const file = new DOMParser().parseFromString(text, "image/svg+xml");
    const strokes = [...file.querySelectorAll(".curve")].map((curve) => curve.getAttribute("stroke"));
    return [file.querySelector("parsererror")?.textContent ?? "", strokes.length, strokes.every((ink) => ink.startsWith("rgb"))];
  }, picture_);
  assert.deepEqual([seen[0], seen[2]], ["", true]);
  assert.ok(seen[1] > 20, `${seen[1]} curves`);
  const [name, table] = await downloaded(page.locator("#tracks [data-download=csv]"));
  assert.equal(name, "along-the-hole.csv");
  const lines = table.trim().split("\r\n");
  assert.equal(lines[0], 'quantity,unit,operation,model,"md, m",value,p05,p95');
  assert.ok(lines.some((line) => line.startsWith("Effective tension,kN,drill,dynamic,")));
  for (const [section, endings] of [
    ["#history", ["svg", "csv"]],
    ["#bit", ["svg", "csv"]],
    ["#contact", ["svg", "csv"]],
    ["#scene", ["png", "csv"]],
    ["#results", ["csv"]],
    ["#numerics", ["csv"]],
    ["#inputs", ["csv"]],
  ])
    for (const ending of endings) {
      const [file, content] = await downloaded(page.locator(`${section} [data-download=${ending}]`).first());
      assert.ok(file.endsWith(`.${ending}`) && content.length > 20, `${section} ${file}`);
      if (ending !== "svg") continue;
      const wrong = await page.evaluate(
        (text) => new DOMParser().parseFromString(text, "image/svg+xml").querySelector("parsererror")?.textContent ?? "",
        content,
      );
      assert.equal(wrong, "", file);
    }
  // Numbers of the file are those of the page.
  const [, history] = await downloaded(page.locator("#history [data-download=csv]").first());
  const [head, first] = history.split("\r\n");
  assert.equal(head, '"time, s","hook load, kN","soft string, kN"');
  assert.ok(first.split(",").every((cell) => Number.isFinite(Number(cell))), first);
});

await check("what hardly moves is not blown up", async () => {
  // The hook load's axis spans 20 kN at least, whatever the load does.
  const axis = await page.evaluate(() => {
    const plot = document.querySelector("#history .history .u-over");
    return plot.getBoundingClientRect().height;
  });
  const [, load] = await downloaded(page.locator("#history [data-download=svg]").first());
  const marks = [...load.matchAll(/text-anchor="end"[^>]*>([^<]+)</g)].map(([, mark]) => Number(mark.replace("\u2212", "-")));
  assert.ok(axis > 50 && Math.max(...marks) - Math.min(...marks) >= 12, `marks at ${marks}`);
});

await check("field units are rounded as people write them", async () => {
  await page.click(".controls [data-value=field]");
  await settled(page);
  const value = (label) => report.solved.at(-1).key_results.find((answer) => answer.label === label).value.value;
  const cards = await page.locator(".key-result .number").allTextContents();
  const torque = value("Surface torque") / 1.3558179483;
  const rounded = Number(torque.toPrecision(4)).toLocaleString("en-US");
  assert.equal(cards[1].split("\u00a0")[0].replace(/\.0+$/, ""), rounded);
  const depth = await page.locator(".facts div", { hasText: "Bit depth" }).locator("dd").textContent();
  assert.match(depth, /^\d,\d{3}(\.\d)?\u00a0ft$/);
});

await check("the hook load says that it is without the block, everywhere", async () => {
  for (const place of [".key-result h3", "#history h3", "#results tbody th"])
    assert.match(await text(page, place), /^Hook load without block/);
});

await check("units and colours are remembered", async () => {
  const again = await page.context().newPage();
  await again.goto(page.url());
  await again.waitForSelector("html[data-ready]");
  assert.equal(await again.locator('[aria-label="Units"] [aria-pressed="true"]').textContent(), "US field");
  await again.close();
  await page.click(".controls [data-value=si]");
});

await check("the whole well fills the stage, and no labels lie on each other", async () => {
  await page.locator("#tracks input").first().fill("200");
  await page.locator("#tracks input").first().press("Enter");
  await settled(page);
  await page.getByRole("button", { name: "Whole well" }).click();
  await settled(page);
  assert.equal(await page.locator("#tracks input").first().inputValue(), "0.0");
  const [across, up] = (await page.locator("#scene .space-holder").getAttribute("data-spans")).split(" ").map(Number);
  assert.ok(Math.max(across, up) > 0.85 && across <= 1 && up <= 1, `${across} across, ${up} up`);
  const labels = JSON.parse(await page.locator("#scene .space-holder").getAttribute("data-labels"));
  assert.ok(labels.length >= 5, `${labels.length} labels`);
  labels.forEach((a, i) =>
    labels.slice(0, i).forEach((b) =>
      assert.ok(a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top, JSON.stringify([a, b])),
    ),
  );
});

await check("dark looks different, and light comes back", async () => {
  const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const light = await ground();
  await page.click(".controls [data-value=dark]");
  assert.notEqual(await ground(), light);
  await page.click(".controls [data-value=light]");
  assert.equal(await ground(), light);
});

await check("names are text, whatever they hold", async () => {
  const title = await page.evaluate(() => JSON.parse(document.getElementById("report").textContent).title);
  assert.equal(await text(page, "h1"), title);
  assert.equal(await page.evaluate(() => window.harmed), undefined);
});

await close(page, 20_000, "the page");
