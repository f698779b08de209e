// The report of a sweep in a real browser: `node test/sweep.mjs CHROMIUM report.html`. The figure is drawn, units and
// colours switch, nothing is fetched and nothing is complained about.
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { browse } from "./browser.mjs";

const [executablePath, file] = process.argv.slice(2);
const { check, open, close } = await browse(executablePath, file, { timeout_ms: 60_000 });

const page = await open();
const texts = () => page.locator(".figure text").allTextContents();

await check("every curve of the sweep is drawn", async () => {
  assert.equal(await page.locator(".figure").count(), 1);
  const frames = await page.locator(".figure path.stroke-frame").count();
  assert.ok(frames >= 3, `${frames} panels`);
  const curves = await page.locator('.figure path[class^="stroke-line"][clip-path]').count();
  assert.ok(curves >= 3 * frames * 0.5, `${curves} curves`);
  assert.equal(await page.locator(".figure path[d*=NaN]").count(), 0, "no coordinate is missing");
});

await check("units switch in the figure and in the table", async () => {
  for (const [units, force, length] of [
    ["field", "klbf", "ft"],
    ["metric", "t", "m"],
    ["si", "kN", "m"],
  ]) {
    await page.click(`.controls [data-value=${units}]`);
    const all = await texts();
    assert.ok(all.includes(force), `${force} in ${all}`);
    assert.ok(all.includes(`Bit depth, ${length}`));
    assert.match(await page.locator("#cases thead").textContent(), new RegExp(`Hook load without block ${force}`));
  }
});

await check("the verdict is above the figure", async () => {
  assert.match(await page.locator("header .verdict").textContent(), /(errors|warnings).* cases/);
});

await check("every case has its row", async () => {
  const rows = page.locator("#cases tbody tr");
  assert.ok((await rows.count()) >= 4);
  for (const text of await rows.allTextContents()) assert.match(text, /\d/);
});

await check("the legend hides curves, by click and by keyboard", async () => {
  const shown = () => page.locator(".figure .series:not([hidden]) path").count();
  const all = await shown();
  const key = page.locator(".legend-key[role=button]").first();
  await key.click();
  const fewer = await shown();
  assert.ok(fewer < all, `${fewer} of ${all}`);
  await key.focus();
  await page.keyboard.press("Enter");
  assert.equal(await shown(), all);
});

await check("a point says its case", async () => {
  const spot = page.locator(".spot").first();
  await spot.focus();
  const said = await page.locator(".tip").textContent();
  for (const part of ["friction 0.2", "bit_depth 300m", "Hook load without block"]) assert.ok(said.includes(part), said);
});

await check("the figure and the table are given as files", async () => {
  for (const ending of ["svg", "csv"]) {
    const button = page.locator(`#sweep [data-download=${ending}]`);
    const [download] = await Promise.all([page.waitForEvent("download"), button.click()]);
    const content = readFileSync(await download.path(), "utf8");
    assert.ok(content.length > 200 && content.includes("Hook load without block"), download.suggestedFilename());
  }
});

await check("cases lead to their reports where they have one", async () => {
  const links = await page.locator("#cases td a").evaluateAll((links) => links.map((link) => link.getAttribute("href")));
  const { rows } = await page.evaluate(() => JSON.parse(document.getElementById("report").textContent));
  assert.deepEqual(links, rows.map((row) => row.page).filter(Boolean));
  for (const link of links) assert.ok(existsSync(join(dirname(file), decodeURIComponent(link))), link);
  assert.equal(await page.locator(".spot.leads").count() > 0, links.length > 0);
});

await check("the figure follows the page into the dark", async () => {
  const ink = () => page.evaluate(() => getComputedStyle(document.querySelector(".figure text")).fill);
  const light = await ink();
  await page.click(".controls [data-value=dark]");
  assert.notEqual(await ink(), light);
  await page.click(".controls [data-value=light]");
  assert.equal(await ink(), light);
});

await check("every panel is in view on a narrow screen", async () => {
  const narrow = await open({ viewport: { width: 420, height: 900 } });
  const panels = (of) => of.locator(".figure path.stroke-frame").count();
  assert.equal(await panels(narrow), await panels(page));
  const frames = narrow.locator(".figure path.stroke-frame");
  for (let i = 0; i < (await frames.count()); i++) {
    const { x, width } = await frames.nth(i).boundingBox();
    assert.ok(x >= 0 && x + width <= 420, `panel ${i}: ${x} to ${x + width}`);
  }
  await narrow.close();
});

await close(page, 10_000, "the page of a sweep");
