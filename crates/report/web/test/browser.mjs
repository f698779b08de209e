// A page in a real browser, and what is asked of every page.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

/** Opens `file` with the browser at `executablePath`; what it does by itself is written down. */
export async function browse(executablePath, file, { args = [], timeout_ms }) {
  const address = pathToFileURL(file).href;
  const browser = await chromium.launch({ executablePath, args: ["--no-sandbox", ...args] });
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
    page.setDefaultTimeout(timeout_ms);
    page.on("console", (message) => ["error", "warning"].includes(message.type()) && complaints.push(message.text()));
    page.on("pageerror", (error) => complaints.push(String(error)));
    page.on("request", (request) => requests.push(request.url()));
    await page.goto(address);
    // A page without a program of its own is ready as it is.
    await page.waitForSelector("html[data-ready], main.study");
    return page;
  }

  /** Last of all: `page` prints on more than `least` bytes of paper, fits on a screen, and was alone. */
  async function close(page, least, what) {
    await check("a page of paper is made", async () => {
      const paper = await page.pdf({ preferCSSPageSize: true, printBackground: true });
      assert.ok(paper.length > least, `${paper.length} bytes`);
    });
    for (const width of [420, 900, 1440]) {
      await check(`nothing sticks out at ${width} pixels`, async () => {
        const narrow = await open({ viewport: { width, height: 900 }, colorScheme: "dark" });
        const [content, window] = await narrow.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
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
    console.log(`      ${checks} checks of ${what}`);
  }

  return { check, open, close };
}

/** What a browser without a graphics card needs for a view in space. */
export const SPACE = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"];

/** How many different colours a canvas shows. */
export const colours = (page, selector) =>
  page.evaluate((selector) => {
    const canvas = document.querySelector(selector);
    const copy = new OffscreenCanvas(400, 200);
    const pen = copy.getContext("2d", { willReadFrequently: true });
    pen.drawImage(canvas, 0, 0, 400, 200);
    const { data } = pen.getImageData(0, 0, 400, 200);
    const seen = new Set();
    for (let i = 0; i < data.length; i += 4)
      seen.add((data[i] << 24) | (data[i + 1] << 16) | (data[i + 2] << 8) | data[i + 3]);
    return seen.size;
  }, selector);

/** What a canvas shows, smaller, as one text to compare. */
export const picture = (page, selector) =>
  page.evaluate((selector) => {
    const copy = new OffscreenCanvas(400, 200);
    const pen = copy.getContext("2d", { willReadFrequently: true });
    pen.drawImage(document.querySelector(selector), 0, 0, 400, 200);
    return pen.getImageData(0, 0, 400, 200).data.join();
  }, selector);
export const text = (page, selector) => page.locator(selector).first().textContent();
export const settled = (page) =>
  page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

/** Whether two pictures are the same; said without printing them. */
export const same = (a, b, what) => assert.ok(a === b, `${what} looks the same`);
export const differs = (a, b, what) => assert.ok(a !== b, `${what} looks different`);
