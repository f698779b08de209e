// The page of a static BHA analysis in a real browser: `node test/bha.mjs CHROMIUM report.html`. Figures are drawn, tables are whole, what can
// be switched switches, nothing is fetched and nothing is complained about.
import assert from "node:assert/strict";
import { browse, settled, text } from "./browser.mjs";

const [executablePath, file] = process.argv.slice(2);
const { check, open, close } = await browse(executablePath, file, { timeout_ms: 60_000 });

const page = await open();

await check("the assembly is drawn from the side and from above, its forces named", async () => {
  const views = page.locator("#views .figure");
  assert.equal(await page.locator(".figure path[d*=NaN]").count(), 0, "no coordinate is missing");
  const words = await views.textContent();
  assert.match(words, /drawn \d+ times as wide as long/);
  assert.match(words, /From the side, high side up, mm/);
  assert.match(words, /From above, right side up, mm/);
  assert.match(words, /survey sensor/);
  assert.match(words, /\d kN/);
});

await check("everything that was varied has its picture", async () => {
  for (const id of ["toolface", "weight", "inclination"])
    assert.ok((await page.locator(`#${id} .figure path`).count()) > 4, id);
});

await check("tables hold words and numbers, and no objects", async () => {
  assert.doesNotMatch(await page.locator("main").textContent(), /\[object|NaN|undefined/);
  const rows = page.locator("#contacts tbody tr");
  assert.ok((await rows.count()) > 3);
  assert.match(await rows.first().textContent(), /^bitbit/);
  // Contacts are identified by their depth, to the centimetre.
  for (const text of await page.locator("#contacts tbody td:nth-child(5)").allTextContents()) assert.match(text, /^[\d,\u202f]+\.\d\d$/);
  assert.match(await page.locator("header .verdict").textContent(), /builds|drops|holds/);
  assert.match(await text(page, "#results"), /measured \+ correction = hole/);
});

await check("units switch everywhere", async () => {
  for (const [units, force, small, long] of [
    ["field", "klbf", "in", "ft"],
    ["metric", "t", "mm", "m"],
    ["si", "kN", "mm", "m"],
  ]) {
    await page.click(`.controls [data-value=${units}]`);
    await settled(page);
    const views = await page.locator("#views .figure").textContent();
    assert.ok(views.includes(`high side up, ${small}`) && views.includes(`from the bit, ${long}`), units);
    assert.match(await page.locator("#toolface .figure").textContent(), new RegExp(`Side force of the bit, ${force}`));
    assert.match(await page.locator("#contacts thead").textContent(), new RegExp(`Force ${force}`));
  }
});

await check("names are text, whatever they hold", async () => {
  const title = await page.evaluate(() => JSON.parse(document.getElementById("report").textContent).title);
  assert.equal(await text(page, "h1"), title);
  assert.equal(await page.evaluate(() => window.harmed), undefined);
});

await close(page, 20_000, "the page of a static BHA analysis");
