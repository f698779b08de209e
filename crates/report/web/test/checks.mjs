// Checks on the report of a run: `node test/checks.mjs CHROMIUM report.html`. A copy of the page gets checks that are known,
// whatever the run itself has, where the reader looks first.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { browse, settled, SPACE, text } from "./browser.mjs";

const [executablePath, file] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), "checks-"));
const copy = join(folder, "report.html");

const found = (kind, severity, sentence, [md_m, to_md_m] = [null, null], value = null, limit = null) => ({
  kind,
  label: kind.replaceAll("_", " ").replace(/^./, (letter) => letter.toUpperCase()),
  severity,
  verdict: severity,
  component: "",
  factor: null,
  required: null,
  md_m,
  to_md_m,
  value: value === null ? null : { value, dimension: "force" },
  limit: limit === null ? null : { value: limit, dimension: "force" },
  sentences: [sentence, sentence, sentence.replaceAll("5 kN", "1.124 klbf")],
});
const KNOWN = {
  trip_out: [
    found("goes_down", "error", "The string does not go down. </script><b>", [null, null], -258e3, 0),
    found("helical_buckling", "error", "Helically buckled, 5 kN.", [200, 400], 190e3, 95e3),
  ],
  rotate_off_bottom: [
    found("whirl", "note", "The assembly whirls.", [550, null]),
    { ...found("hoist", "ok", "The hoist carries it."), verdict: "OK", factor: 8, required: 1.25 },
  ],
  drill: [found("sinusoidal_buckling", "warning", "Sinusoidally buckled.", [300, 500], 80e3, 70e3)],
};

/** The text of a packed column with these values. */
const packed = (values) => ({ f32: Buffer.from(Float32Array.from(values).buffer).toString("base64") });
const lengthOf = (column) => (column.f32 ? Buffer.from(column.f32, "base64").length / 4 : Buffer.from(column.i16[0], "base64").length / 2);

/** Tension of one node, N, where all others bear less than 10 kN; bending at joints and between them, N.m. */
const OUTLIER = 23e6;
const [JOINT, BETWEEN] = [5e3, 1e3];

/** Columns of a string with a node far off, and with joints at every second node. */
function madeUp(profile) {
  const rows = Array.from({ length: lengthOf(profile.md_m) }, (_, i) => i);
  const even = packed(rows.map((i) => 1e4 * Math.sin(i / 9)));
  const bending = packed(rows.map((i) => (i % 2 ? JOINT : BETWEEN)));
  for (const name of Object.keys(profile)) if (name.startsWith("tension_")) profile[name] = even;
  for (const name of Object.keys(profile)) if (name.startsWith("bending_moment_")) profile[name] = bending;
  const node = Math.floor(rows.length / 2);
  profile.tension_N = packed(rows.map((i) => (i === node ? OUTLIER : 1e4 * Math.sin(i / 9))));
}

// The hoist's limit is far away: the bar would praise the load.
const page_ = readFileSync(file, "utf8").replace(
  /(<script type="application\/json" id="report">)(.*?)(<\/script>)/s,
  (_, begin, json, end) => {
    const report = JSON.parse(json);
    for (const solved of report.solved) {
      solved.checks = solved.model === "dynamic" ? KNOWN[solved.operation] : [];
      madeUp(solved.profile);
      Object.assign(solved.key_results[0], { limit: 1e7, limit_label: "hoist's capacity" });
    }
    return begin + JSON.stringify(report).replaceAll("<", "\\u003c") + end;
  },
);
writeFileSync(copy, page_);

const { check, open, close } = await browse(executablePath, copy, { args: SPACE, timeout_ms: 120_000 });
const page = await open();

await check("the answer opens on the operation with the most severe check", async () => {
  assert.equal(await page.locator('.operations [aria-pressed="true"]').getAttribute("data-value"), "trip_out");
});

await check("all checks stand on top of the answer, the most severe first, with word and shape", async () => {
  const levels = await page.locator("#answer .check .level").allTextContents();
  assert.deepEqual(
    levels.map((level) => level.trim()),
    ["Error", "Error", "Warning", "Note"],
  );
  assert.equal(await page.locator("#answer .check .level-mark").count(), 4);
  const outlines = await page
    .locator("#answer .check .level-mark path:first-child")
    .evaluateAll((paths) => new Set(paths.map((path) => path.getAttribute("d"))).size);
  assert.equal(outlines, 3, "a shape for each level");
  const list = await page.locator("#answer .check-list").boundingBox();
  const cards = await page.locator("#answer .key-results").boundingBox();
  assert.ok(list.y + list.height <= cards.y, "above the numbers");
  const first = await text(page, "#answer .check");
  for (const part of ["trip out", "The string does not go down. </script><b>"])
    assert.ok(first.includes(part), `${part} in ${first}`);
});

await check("operations say what was found of them", async () => {
  const labels = await page
    .locator(".operations button")
    .evaluateAll((buttons) => buttons.map((button) => [button.dataset.value, button.getAttribute("aria-label")]));
  assert.deepEqual(labels, [
    ["trip_out", "trip out: 2 errors"],
    ["rotate_off_bottom", null],
    ["drill", "drill: 1 warning"],
  ]);
});

await check("no card praises a number that has an error", async () => {
  const card = page.locator(".key-result").first();
  assert.match(await card.locator("h3").textContent(), /Hook load/);
  const said = await card.textContent();
  assert.match(said, /Error: see the check above/);
  assert.doesNotMatch(said, /of the limit: OK/);
  const bar = (place) => page.evaluate((place) => getComputedStyle(document.querySelectorAll(".key-result")[place].querySelector(".used")).backgroundColor, place);
  const over = await page.evaluate(() => {
    const probe = document.body.appendChild(document.createElement("i"));
    probe.style.background = "var(--over)";
    return getComputedStyle(probe).backgroundColor;
  });
  assert.equal(await bar(0), over);
  // What nothing was found of is judged as it was.
  await page.click(".operations [data-value=rotate_off_bottom]");
  await settled(page);
  assert.match(await page.locator(".key-result").first().textContent(), /of the limit: OK/);
  assert.notEqual(await bar(0), over);
});

await check("the tracks shade the stretches of the chosen operation", async () => {
  const shaded = async (operation) => {
    await page.click(`.operations [data-value=${operation}]`);
    await settled(page);
    return page.evaluate(() => {
      const total = JSON.parse(document.getElementById("report").textContent).string.at(-1).to_m;
      const track = [...document.querySelectorAll(".tracks > svg > svg")].find((track) => track.querySelector(".curve"));
      const [, top, , height] = track.getAttribute("viewBox").split(" ").map(Number);
      return [...track.querySelectorAll(".found")].map((band) => {
        const [y, tall] = ["y", "height"].map((name) => Number(band.getAttribute(name)));
        return [band.getAttribute("class"), ...[y, y + tall].map((at) => Math.round(((at - top) / height) * total))];
      });
    });
  };
  assert.deepEqual(await shaded("trip_out"), [["found level-error", 200, 400]]);
  assert.deepEqual(await shaded("drill"), [["found level-warning", 300, 500]]);
  // A place has a mark at the edge alone.
  assert.deepEqual(await shaded("rotate_off_bottom"), []);
  assert.ok((await page.locator(".tracks .found-bar.level-note").count()) >= 8);
});

await check("a check leads to its operation and its depths", async () => {
  await page.locator(".check", { hasText: "Helically" }).getByRole("button").last().click();
  await settled(page);
  assert.equal(await page.locator('.operations [aria-pressed="true"]').getAttribute("data-value"), "trip_out");
  const depths = await page.locator("#tracks input").evaluateAll((inputs) => inputs.map((input) => Number(input.value)));
  assert.deepEqual(depths, [180, 420]);
  await page.getByRole("button", { name: "All depths" }).click();
});

await check("the pointer says what was found there", async () => {
  const cover = page.locator(".tracks .cover").first();
  await cover.scrollIntoViewIfNeeded();
  const box = await cover.boundingBox();
  await page.mouse.move(box.x + 300, box.y + 0.5 * box.height);
  assert.match(await text(page, ".tip"), /Error: Helical buckling/);
});

await check("sentence, place and table of a check follow the reader's units", async () => {
  const line = () => page.locator(".check", { hasText: "Helically" }).textContent();
  assert.match(await line(), /buckled, 5 kN\..*200\u00a0m to 400\u00a0m/);
  await page.click(".controls [data-value=field]");
  await settled(page);
  assert.match(await line(), /buckled, 1\.124 klbf\..*656\u00a0ft to 1,312\u00a0ft/);
  assert.doesNotMatch(await line(), /\u00a0m|kN/);
  assert.match(await page.locator(".check-table tbody").first().textContent(), /klbf|ft/);
  await page.click(".controls [data-value=si]");
});

/** Lines of the tip over the track with this title, in the middle of its depths. */
async function tipOver(title) {
  const head = page.locator(".tracks .title", { hasText: title });
  await head.evaluate((head) => head.ownerSVGElement.scrollIntoView({ block: "center" }));
  const box = await head.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + 250);
  await settled(page);
  return page.locator(".tip > *").allTextContents();
}

await check("one node far off flattens no track, and stands at its edge in numbers", async () => {
  const told = await page.locator(".tracks .beyond-value").allTextContents();
  assert.equal(told.length, 1, JSON.stringify(told));
  assert.match(told[0], /^2[23]\W?\d{3}$/, "23 MN in kN");
  const arrows = await page.locator(".tracks .beyond").count();
  const solved = await page.locator(".legend button.key").count();
  assert.equal(arrows, solved, "an arrow for each curve");
  const broken = await page.locator(".tracks path[d*=NaN], .tracks [y*=NaN]").count();
  assert.equal(broken, 0);
});

await check("bending is drawn at the joints and between them, and legend and pointer name both", async () => {
  const dotted = page.locator(".tracks .curve.between");
  const many = await page.locator(".legend button.key").count();
  assert.equal(await dotted.count(), many);
  await page.locator(".legend .key", { hasText: "between the joints" }).waitFor();
  const said = await tipOver("Bending moment");
  const values = (where) => said.filter((line) => line.includes(`, ${where} the joints:`)).map((line) => line.match(/: ([\d.]+)/)[1]);
  assert.deepEqual([...new Set(values("at"))], ["5.000"], JSON.stringify(said));
  assert.deepEqual([...new Set(values("between"))], ["1.000"]);
  // From near one curve has every node.
  for (const [end, depth] of [["from", "300"], ["to", "400"]]) {
    await page.fill(`[aria-label="Depths in view, ${end}"]`, depth);
    await page.locator(`[aria-label="Depths in view, ${end}"]`).press("Enter");
  }
  await settled(page);
  assert.equal(await dotted.count(), 0);
  assert.equal(await page.locator(".legend .key", { hasText: "between the joints" }).count(), 0);
  await page.click("text=All depths");
  await settled(page);
  assert.equal(await dotted.count(), many);
});

await close(page, 20_000, "checks on the page");
rmSync(folder, { recursive: true });
