// The page of a reach in a real browser: `node test/reach.mjs CHROMIUM report.html`. Margins over depth, what stops the well
// first, and what is asked of every page that prints as a report.
import assert from "node:assert/strict";
import { browse } from "./browser.mjs";
import { checkSheets, read } from "./sheets.mjs";

const [executablePath, file] = process.argv.slice(2);
const browser = await browse(executablePath, file, { timeout_ms: 60_000 });
const { check, close } = browser;

const page = await browser.open({ colorScheme: "light" });
const parts = await read(page);
const [verdict, figure] = parts;
const limits = parts.find((part) => part.title === "Limits");

await check("each operation has a panel, each limit a colour of its own", async () => {
  const operations = new Set(limits.rows.map((row) => row[2]));
  const frames = await page.locator(".in-si figure path.stroke-frame").count();
  assert.ok(frames >= operations.size, `${frames} frames of ${operations.size} operations`);
  const samples = await page.locator(".in-si figure:not(.narrow) .legend-key path").evaluateAll((all) =>
    all.map((path) => {
      const style = getComputedStyle(path);
      // Marks of one ink differ by their outline.
      const outline = path.getAttribute("d").split(/[\s,a-zA-Z]+/).length;
      return `${style.stroke} ${style.strokeDasharray} ${style.fill} ${outline}`;
    }),
  );
  assert.equal(new Set(samples).size, samples.length, samples.join("\n"));
  assert.ok(figure.drawn);
});

await check("what stops the well first is said, marked and in the table", async () => {
  const answer = await page.locator("header .in-si p").first().textContent();
  const depth = /stopped(?: already)? at (\d+) m: (.*), (.*)\.$/.exec(answer);
  assert.ok(depth, answer);
  const rows = limits.rows.filter((row) => row.at(-1) === "stops the well first");
  assert.ok(rows.length >= 1, "a row stops the well");
  assert.ok(rows[0].includes(`${depth[1]} m`), `${rows[0]}`);
  assert.deepEqual([rows[0][0], rows[0][2]], [depth[2], depth[3]]);
  assert.ok(verdict.rows.length >= 1 && verdict.title === "Verdict", `${verdict.title}`);
  assert.match(verdict.rows[0].join(" "), /stopped|goes to|nothing stops/);
  const texts = await page.locator(".in-si figure").first().locator("text").allTextContents();
  assert.ok(texts.includes(depth[2]), `${depth[2]} in ${texts}`);
});

await check("the answer is told in the reader's units", async () => {
  const depths = [];
  for (const [units, symbol] of [
    ["si", "m"],
    ["field", "ft"],
  ]) {
    const answer = await page.locator(`header .in-${units} p`).first().textContent();
    const found = new RegExp(`at (\\d+) ${symbol}:`).exec(answer);
    assert.ok(found, answer);
    depths.push(Number(found[1]));
  }
  assert.ok(Math.abs(depths[1] * 0.3048 - depths[0]) < 1, `${depths}`);
});

await checkSheets(browser, page, file, { figures: 1, sheets: 4 });
await close(page, 10_000, "the page of a reach");
