// The page of a bit test in a real browser: `node test/bit_test.mjs CHROMIUM report.html`. Figures and bottoms are drawn, what
// can be switched switches, nothing is fetched and nothing is complained about.
import assert from "node:assert/strict";
import { browse, colours, differs, picture, same, settled, SPACE, text } from "./browser.mjs";

const [executablePath, file] = process.argv.slice(2);
const { check, open, close } = await browse(executablePath, file, { args: SPACE, timeout_ms: 120_000 });

const page = await open();

await check("every speed has its curve in every figure, and its spread", async () => {
  const figures = page.locator(".figure");
  assert.equal(await figures.count(), 2);
  for (const index of [0, 1])
    for (const line of [0, 1])
      assert.ok((await figures.nth(index).locator(`path.stroke-line-${line}`).count()) > 0, `${index}, ${line}`);
  assert.equal(await page.locator(".figure path[d*=NaN]").count(), 0, "no coordinate is missing");
  assert.match(await figures.first().textContent(), /torque by weight: \d\.\d\d of the bit/);
  assert.match(await figures.nth(1).textContent(), /strength of the rock/);
});

await check("every point has its row", async () => {
  const rows = page.locator("#points tbody tr");
  assert.equal(await rows.count(), await page.locator("#bottom option").count());
  for (const row of await rows.allTextContents()) assert.match(row, /\d ± \d/);
});

await check("a bottom is drawn in space and from above", async () => {
  assert.ok((await colours(page, "canvas.space")) > 100);
  assert.ok((await colours(page, "canvas.plan")) > 100);
});

await check("another point has another bottom", async () => {
  const [space, plan] = [await picture(page, "canvas.space"), await picture(page, "canvas.plan")];
  await page.locator("#bottom select").selectOption("0");
  await settled(page);
  differs(await picture(page, "canvas.space"), space, "the other bottom in space");
  differs(await picture(page, "canvas.plan"), plan, "the other bottom from above");
});

await check("depth can be exaggerated, and looked at from above", async () => {
  const before = await picture(page, "canvas.space");
  await page.locator("#bottom .tools input").evaluate((input) => {
    input.value = 1;
    input.dispatchEvent(new Event("input"));
  });
  await settled(page);
  const deeper = await picture(page, "canvas.space");
  differs(deeper, before, "ten times the depth");
  await page.getByRole("button", { name: "From above" }).click();
  differs(await picture(page, "canvas.space"), deeper, "from above");
});

await check("the pointer is read on the map", async () => {
  const box = await page.locator("canvas.plan").boundingBox();
  await page.locator("canvas.plan").scrollIntoViewIfNeeded();
  await page.locator("canvas.plan").hover({ position: { x: 0.6 * box.width, y: 0.6 * box.height } });
  assert.match(await text(page, ".plan-holder .readout-line"), /^radius [\d.]+.mm, [\d.]+.°: [\d.]+.mm deep$/);
});

await check("units switch everywhere", async () => {
  const plan = await picture(page, "canvas.plan");
  for (const [units, force, small] of [
    ["field", "klbf", "in"],
    ["metric", "t", "mm"],
    ["si", "kN", "mm"],
  ]) {
    await page.click(`.controls [data-value=${units}]`);
    await settled(page);
    assert.match(await page.locator(".figure").first().textContent(), new RegExp(`Weight on bit, ${force}`));
    assert.match(await page.locator("#points thead").textContent(), new RegExp(`Depth of cut ${small}`));
    assert.match(await page.locator("#bottom select").textContent(), new RegExp(`\\d.${force} at`));
    assert.match(await text(page, "#bottom .colour-key"), new RegExp(`rim, ${small}`));
    if (units === "field") differs(await picture(page, "canvas.plan"), plan, "the map in inches");
  }
  same(await picture(page, "canvas.plan"), plan, "the map in millimetres");
});

await check("dark looks different, and light comes back", async () => {
  const before = await picture(page, "canvas.plan");
  await page.click(".controls [data-value=dark]");
  differs(await picture(page, "canvas.plan"), before, "the map in the dark");
  await page.click(".controls [data-value=light]");
  same(await picture(page, "canvas.plan"), before, "the map in the light");
});

await check("names are text, whatever they hold", async () => {
  const title = await page.evaluate(() => JSON.parse(document.getElementById("report").textContent).title);
  assert.equal(await text(page, "h1"), title);
  assert.equal(await page.evaluate(() => window.harmed), undefined);
});

await close(page, 20_000, "the page of a bit test");
