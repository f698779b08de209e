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
    for (const width of [900, 1440]) {
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
