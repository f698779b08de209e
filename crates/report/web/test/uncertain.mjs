// The page of a reach of uncertain numbers in a real browser: `node test/uncertain.mjs CHROMIUM report.html`. Bands, what
// stops the samples and what they are owed to, and what is asked of every page that prints as a report.
import assert from "node:assert/strict";
import { browse } from "./browser.mjs";
import { checkSheets, read } from "./sheets.mjs";

const [executablePath, file] = process.argv.slice(2);
const browser = await browse(executablePath, file, { timeout_ms: 60_000 });
const { check, close } = browser;

const page = await browser.open({ colorScheme: "light" });
const parts = await read(page);

await check("samples have their sections, and each leads to its own table", async () => {
  for (const [title, name] of [
    ["Uncertain inputs", "reach_uncertain_samples.csv"],
    ["Limits that stop the samples", "reach_uncertain_stops.csv"],
    ["Bands", "reach_uncertain.csv"],
    ["Sobol indices", "reach_uncertain_indices.csv"],
  ]) {
    const part = parts.find((of) => of.title === title);
    assert.ok(part, `${title} in ${parts.map((of) => of.title)}`);
    assert.ok(part.files.includes(name), `${title}: ${part.files}`);
  }
});

await check("the samples that something stops are all of them", async () => {
  const { rows } = parts.find((of) => of.title === "Limits that stop the samples");
  assert.equal(rows.reduce((sum, row) => sum + Number(row.at(-1)), 0), 20);
});

await checkSheets(browser, page, file, { figures: 2, sheets: 6 });
await close(page, 10_000, "the page of a reach of uncertain numbers");
