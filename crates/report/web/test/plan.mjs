// The page of a plan in a real browser: `node test/plan.mjs CHROMIUM report.html`. Pictures, lights beside words, the workbook
// beside it, and what is asked of every page that prints as a report.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { dirname, join } from "node:path";
import { browse, text } from "./browser.mjs";
import { checkSheets, read } from "./sheets.mjs";

const [executablePath, file] = process.argv.slice(2);
const browser = await browse(executablePath, file, { timeout_ms: 60_000 });
const { check, close } = browser;

const page = await browser.open({ colorScheme: "light" });
const parts = await read(page);
const part = (title) => parts.find((part) => part.title === title);

await check("hook load, torque, weight to buckle and limits have their sections", async () => {
  for (const title of ["Hook load", "Surface torque", "Weight to buckle", "Limits", "Nearest limits", "Friction"])
    assert.ok(part(title), title);
  assert.match(parts.map((of) => of.title).join("; "), /With the bit at \d+ m/);
});

await check("every operation has a line for each friction", async () => {
  const figure = page.locator(".in-si section:has(> h2:text-is('Hook load')) figure svg").first();
  const keys = await figure.locator(".legend-key").allTextContents();
  for (const expected of ["trip out", "trip in", "rotate off bottom", "low friction", "expected friction", "high friction"])
    assert.ok(keys.some((key) => key.includes(expected)), `${expected} in ${keys}`);
  const names = await figure.locator("text").allTextContents();
  const friction = /low friction, (.*)/.exec(keys.find((key) => key.includes("low friction")))[1];
  // At the ends of trip out and trip in.
  assert.ok(names.filter((name) => name === friction).length >= 2, `${friction} in ${names}`);
});

await check("a light has a word and a mark", async () => {
  const words = part("Nearest limits").rows.map((row) => row[1]);
  assert.ok(words.length > 3);
  for (const word of words) assert.match(word, /^(OK|marginal|below required factor|exceeded)$/);
  let lights = 0;
  for (const [kind, mark] of [
    ["agrees", "\u2713"],
    ["near", "!"],
    ["differs", "\u2717"],
  ]) {
    const cells = page.locator(`.in-si td.${kind}`);
    const count = await cells.count();
    lights += count;
    if (count === 0) continue;
    const after = await cells.first().evaluate((cell) => getComputedStyle(cell, "::after").content);
    assert.ok(after.includes(mark), after);
  }
  assert.ok(lights >= words.length, `${lights} lights`);
  // What breaks or stops stands first, each half with the least reserve at its top.
  const { rows } = part("Nearest limits");
  const breaks = ([kind]) => !/buckling|overpull/i.test(kind);
  const first = rows.findIndex((row) => !breaks(row));
  assert.ok(first > 0 && rows.slice(first).every((row) => !breaks(row)), `${rows.map(([kind]) => kind)}`);
  for (const half of [rows.slice(0, first), rows.slice(first)]) {
    const known = half.map((row) => Number(row.at(-2)) / Number(row.at(-1))).filter(Number.isFinite);
    assert.ok(known.every((reserve, i) => i === 0 || reserve >= known[i - 1] - 0.02), `${known}`);
  }
  // One table of verdicts: errors, warnings, then the limits that govern.
  const verdicts = part("Verdict").rows;
  const governs = verdicts.filter(([verdict]) => verdict.endsWith(", governs"));
  assert.ok(governs.some(([, operation, friction, , finding]) => /^trip out/.test(operation) && friction === "high" && /^Hoist/.test(finding)), `${verdicts}`);
  assert.equal(part("Governing limits"), undefined);
});

await check("what was measured, another program, peaks and samples have their sections", async () => {
  for (const title of ["Measured", "Comparison with another program", "Peaks", "Uncertain inputs", "Bands", "Sobol indices"])
    assert.ok(part(title), `${title} in ${parts.map((of) => of.title)}`);
  const figure = page.locator(".in-si section:has(> h2:text-is('Surface torque')) figure svg").first();
  const names = await figure.locator("text").allTextContents();
  for (const limit of ["top drive", "top drive, peak"]) assert.ok(names.includes(limit), `${limit} in ${names}`);
});

await check("the workbook lies beside it", async () => {
  assert.equal(await page.locator(".in-si a[href='plan.xlsx']").count(), 2);
  assert.ok(existsSync(join(dirname(file), "plan.xlsx")));
});

await checkSheets(browser, page, file, { figures: 6, sheets: 15 });

await check("names are text, whatever they hold", async () => {
  assert.equal(await page.locator("main script").count(), 0);
  const title = await text(page, "h1");
  assert.match(title, /: plan$/);
  assert.equal(title, await page.title());
  assert.equal(await page.evaluate(() => window.harmed), undefined);
});

await close(page, 20_000, "the page of a plan");
