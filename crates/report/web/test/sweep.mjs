// The report of a sweep in a real browser: `node test/sweep.mjs CHROMIUM report.html`. The figure is drawn, units and
// colours switch, nothing is fetched and nothing is complained about.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const [executablePath, file] = process.argv.slice(2);
const address = pathToFileURL(file).href;
const browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
const complaints = [];
const requests = [];
let checks = 0;

async function check(name, test) {
  await test();
  checks += 1;
  console.log(`      ${name}`);
}

async function open(options) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 1000 }, offline: true, ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(60_000);
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && complaints.push(message.text()));
  page.on("pageerror", (error) => complaints.push(String(error)));
  page.on("request", (request) => requests.push(request.url()));
  await page.goto(address);
  await page.waitForSelector("html[data-ready]");
  return page;
}

let page = await open();
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
    assert.match(await page.locator("#cases thead").textContent(), new RegExp(`Hook load ${force}`));
  }
});

await check("every case has its row", async () => {
  const rows = page.locator("#cases tbody tr");
  assert.ok((await rows.count()) >= 4);
  for (const text of await rows.allTextContents()) assert.match(text, /\d/);
});

await check("the figure follows the page into the dark", async () => {
  const ink = () => page.evaluate(() => getComputedStyle(document.querySelector(".figure text")).fill);
  const light = await ink();
  await page.click(".controls [data-value=dark]");
  assert.notEqual(await ink(), light);
  await page.click(".controls [data-value=light]");
  assert.equal(await ink(), light);
});

await check("a page of paper is made", async () => {
  const paper = await page.pdf({ preferCSSPageSize: true, printBackground: true });
  assert.ok(paper.length > 10_000, `${paper.length} bytes`);
});

for (const width of [900, 1440]) {
  await check(`nothing sticks out at ${width} pixels`, async () => {
    page = await open({ viewport: { width, height: 900 }, colorScheme: "dark" });
    const [content, window] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
    assert.ok(content <= window, `${content} pixels of content`);
  });
}

await check("nothing was fetched, nothing complained", async () => {
  assert.deepEqual(
    requests.filter((url) => url !== address && !url.startsWith("data:") && !url.startsWith("blob:")),
    [],
  );
  assert.deepEqual(complaints, []);
});

await browser.close();
console.log(`      ${checks} checks of the page of a sweep`);
