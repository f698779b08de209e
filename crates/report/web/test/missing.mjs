// The report of a run that lacks answers, in a real browser: `node test/missing.mjs CHROMIUM report.html`. The page is of a
// run of several operations by several models; of copies of it one answer after the other is taken away. Each opens on an
// operation that has numbers if any has, shows the well in space for every operation, and complains about nothing.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";
import { colours, settled, SPACE } from "./browser.mjs";

const [executablePath, file, only = ""] = process.argv.slice(2);
const text = readFileSync(file, "utf8");
const [open, shut] = [/<script [^>]*id="report"[^>]*>/, "</script>"];
const from = text.search(open) + text.match(open)[0].length;
const to = text.indexOf(shut, from);
const whole = JSON.parse(text.slice(from, to));
const all = [...new Set(whole.solved.map((solved) => solved.operation))];
const detailed = whole.models[0].name;

/** An answer that a model did not find. */
function fail(report, has) {
  for (const solved of report.solved.filter(has))
    Object.assign(solved, { key_results: [], profile: {}, wear: {}, message: Array(3).fill("no static equilibrium was found") });
  const gone = (run) => report.solved.some((solved) => has(solved) && solved.operation === run.operation && solved.model === detailed);
  report.runs = report.runs.filter((run) => !gone(run));
}

const columns = [...new Set(whole.solved.flatMap((solved) => Object.keys(solved.profile)))];
const missing = {
  nothing: () => {},
  "the most detailed answer of the operation with checks": (report) =>
    fail(report, (solved) => solved.model === detailed && solved.operation === all.at(-1)),
  "the most detailed answer of every operation": (report) => fail(report, (solved) => solved.model === detailed),
  "all answers of the first operation": (report) => fail(report, (solved) => solved.operation === all[0]),
  "all answers of the last operation, which has an error": (report) => {
    fail(report, (solved) => solved.operation === all.at(-1));
    const check = { kind: "lock_up", label: "Lock-up", severity: "error", verdict: "exceeded", sentences: Array(3).fill("the string stops"), component: "", md_m: null, to_md_m: null, value: null, limit: null, factor: 0, required: 1 };
    report.solved.filter((solved) => solved.operation === all.at(-1)).forEach((solved) => (solved.checks = [check]));
  },
  "all answers": (report) => fail(report, () => true),
  "all that was solved": (report) => Object.assign(report, { solved: [], runs: [], models: [] }),
  frames: (report) => report.runs.forEach((run) => (run.frames = null)),
  "the map of contact": (report) => report.runs.forEach((run) => (run.contact = null)),
  "the map of contact of one operation": (report) => (report.runs[0].contact = null),
  "a column of the map of contact": (report) => report.runs.forEach((run) => run.contact && (run.contact.values = {})),
  "every sample in time": (report) => report.runs.forEach((run) => Object.assign(run, { history: { time_s: { f32: "" } }, samples: 0 })),
  "the columns in time": (report) => report.runs.forEach((run) => (run.history = {})),
  "the samples of the bit": (report) => report.runs.forEach((run) => (run.drill_off = null)),
  wear: (report) => report.solved.forEach((solved) => (solved.wear = {})),
  "the hole": (report) => (report.hole = []),
  "the string": (report) => (report.string = []),
  "the well": (report) => {
    for (const key of Object.keys(report.well)) report.well[key] = key === "high" ? [[], [], []] : [];
  },
  tables: (report) => (report.page_tables = []),
  facts: (report) => (report.facts = []),
};
// A column is missing to every operation alike, of which one is looked at.
const columnKind = (column) => `the column ${column}`;
const columnKinds = new Set(columns.map(columnKind));
for (const column of columns)
  missing[columnKind(column)] = (report) => report.solved.forEach((solved) => delete solved.profile[column]);

const place = mkdtempSync(join(tmpdir(), "missing-"));
const browser = await chromium.launch({ executablePath, args: ["--no-sandbox", ...SPACE] });
const page = await (await browser.newContext({ viewport: { width: 1440, height: 1000 }, offline: true })).newPage();
page.setDefaultTimeout(60_000);
let complaints = [];
page.on("console", (message) => ["error", "warning"].includes(message.type()) && complaints.push(message.text()));
page.on("pageerror", (error) => complaints.push(String(error)));

for (const [what, take] of Object.entries(missing)) {
  if (!what.includes(only)) continue;
  const report = structuredClone(whole);
  take(report);
  const copy = join(place, "report.html");
  writeFileSync(copy, text.slice(0, from) + JSON.stringify(report).replaceAll("<", "\\u003c") + text.slice(to));
  complaints = [];
  await page.goto(pathToFileURL(copy).href);
  await page.waitForSelector("html[data-ready]");
  const has = (operation) => report.solved.some((solved) => solved.operation === operation && solved.key_results.length);
  const operations = [...new Set(report.solved.map((solved) => solved.operation))];
  const chosen = page.locator('.operations button[aria-pressed="true"]');
  if (operations.some(has) && (await chosen.count())) {
    const opened = await chosen.getAttribute("data-value");
    assert.ok(has(opened), `without ${what} it opens on ${opened}`);
    assert.ok((await page.locator(".key-result .number").count()) > 0, `without ${what} no number is shown`);
  }
  for (const operation of columnKinds.has(what) ? operations.slice(-1) : operations) {
    const button = page.locator(`.operations [data-value="${operation}"]`);
    if (await button.count()) await button.click();
    await settled(page);
    if (report.well.md_m.f32 ?? report.well.md_m.length)
      assert.ok((await colours(page, "canvas.space")) > 10, `without ${what} the well is not drawn for ${operation}`);
    const numbers = await page.locator(".key-result .number").count();
    assert.equal(numbers > 0, has(operation), `without ${what} ${operation} has ${numbers} numbers`);
  }
  for (const units of ["field", "si"]) await page.click(`.controls [data-value=${units}]`);
  assert.deepEqual(complaints, [], `without ${what}`);
}
console.log(`      ${Object.keys(missing).length} kinds of what may be missing`);
await browser.close();
rmSync(place, { recursive: true });
