// The page of a calibration in a real browser: `node test/calibrate.mjs CHROMIUM report.html`. Readings against predictions and
// their bands, and what is asked of every page that prints as a report.
import assert from "node:assert/strict";
import { browse } from "./browser.mjs";
import { checkSheets, read } from "./sheets.mjs";

const [executablePath, file] = process.argv.slice(2);
const browser = await browse(executablePath, file, { timeout_ms: 60_000 });
const { check, close } = browser;

const page = await browser.open({ colorScheme: "light" });
const parts = await read(page);
const part = (title) => parts.find((part) => part.title === title);

await check("what was found stands first, with its error and its interval", async () => {
  const { rows } = parts[0];
  assert.equal(parts[0].title, "Fitted parameters");
  for (const [name, value, error, interval] of rows) {
    const [low, high] = interval.split(" to ").map(Number);
    if (name.startsWith("friction")) assert.ok(low < Number(value) && Number(value) < high && Number(error) > 0, `${name} ${value} ${interval}`);
  }
  assert.ok(rows.length >= 2);
});

await check("each band has its readings, in the colour of its line", async () => {
  const figure = page.locator(".in-si section:has(> h2:text-is('Measured and predicted')) figure svg").first();
  const bands = await figure.locator("[fill-opacity]").count();
  assert.ok(bands >= 6, `${bands} bands`);
  const readings = part("Readings").rows.length;
  const marks = await figure.locator("path").count();
  assert.ok(marks > 10 && readings > 10, `${marks} marks of ${readings} readings`);
});

await check("a reading is in its band or not, in a word", async () => {
  const last = part("Readings").rows.map((row) => row.at(-1));
  for (const word of last) assert.match(word, /^(yes|no|outlier)$/);
  assert.ok(last.filter((word) => word === "yes").length > 0.5 * last.length);
});

await checkSheets(browser, page, file, { figures: 3, sheets: 6 });
await close(page, 20_000, "the page of a calibration");
