// The driller's seat: a string is begun, driven and displayed; the travel time of a wave; two tabs, a reload, a restart.
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { accessible, check, equal, openPage, picture, run, serve, until } from "./harness.mjs";
import { FLAGS, caseId, knob, pace, pause, runs, sit, strips, time } from "./harness-seat.mjs";

const CASES = join(dirname(fileURLToPath(import.meta.url)), "../../../cases");
const read = (name) => readFileSync(join(CASES, name), "utf8");


/*
 * A torsional wave in a plain pipe. A pipe of one section, of shear modulus G and density ρ, without joints, hangs free in
 * a vertical hole without friction and rotates. The equation of motion of its angle φ(s, t) is
 *
 *     ρ J φ_tt = G J φ_ss,    so that    c = √(G/ρ),
 *
 * for any section, because J is on both sides. The speed of its top increases by Δ rad/s at the time t₀ (a drive that follows
 * its set point at any torque). A wave Δ·H(t − t₀ − s/c) travels down the pipe, and the free end, where φ_s = 0, reflects it
 * with its sign: the speed of the bit is unchanged until t₀ + L/c, and 2Δ higher afterwards, until the wave returns from the
 * top at 3 L/c. With G = 76.923 GPa and ρ = 7860 kg/m³, c = 3128.4 m/s; L = 4000 m takes 1.2786 s.
 *
 * The mesh limits the steepness of the front. In a chain of n elements the front of a step is an Airy function: half of its
 * height is at most 1.0 (n/8)^(1/3) element travel times late if time steps are small, 0.6 % of L/c for the 200 elements of
 * 20 m here; samples are 10 ms apart, 0.8 %, with linear interpolation. The sum is within the required 2 %.
 * Damping by mass, which would move the bit before the wave arrives, and by stiffness are off, and the extra damping of a
 * start, which fades within 5 s, is over.
 */
const LENGTH_M = 4000;
const SHEAR_MODULUS_PA = 76.923e9;
const DENSITY_KG_PER_M3 = 7860;
const TRAVEL_S = LENGTH_M / Math.sqrt(SHEAR_MODULUS_PA / DENSITY_KG_PER_M3);
const PLAIN = `name = "A plain pipe"
model = ["dynamic"]

[well]
stations = [["0 m", "0 deg", "0 deg"], ["${LENGTH_M} m", "0 deg", "0 deg"]]

[[well.hole]]
kind = "open"
to = "${LENGTH_M} m"
diameter = "8.5 in"
friction = 0

[mud]
density = "1.2 sg"

[steel]
density = "${DENSITY_KG_PER_M3} kg/m3"
youngs_modulus = "200 GPa"
shear_modulus = "${SHEAR_MODULUS_PA / 1e9} GPa"

[[string]]
component = "pipe"
od = "127 mm"
id = "108.6 mm"
length = "to surface"

[operation]
kind = "rotate_off_bottom"
rpm = 60

[dynamics]
settle = "5 s"

[mesh]
element_length = "20 m"

[dynamics.damping]
mass = 0
stiffness = 0
`;

/** A well that drills, fast to compute. */
const SLANT = `name = "A slant well"
model = ["dynamic"]

[well]
stations = [["0 m", "0 deg", "0 deg"], ["400 m", "0 deg", "0 deg"], ["1000 m", "40 deg", "30 deg"], ["1600 m", "40 deg", "30 deg"]]

[[well.hole]]
kind = "casing"
to = "800 m"
diameter = "8.835 in"
friction = 0.2

[[well.hole]]
kind = "open"
to = "1600 m"
diameter = "8.5 in"
friction = 0.3

[mud]
density = "1.2 sg"

[[string]]
component = "bit"
od = "8.5 in"
length = "0.3 m"

[[string]]
component = "drill collars"
catalogue = "6-1/2 in x 2-13/16 in collar"
length = "110 m"

[[string]]
component = "drill pipe"
catalogue = "5 in 19.50 lb/ft G-105"
length = "to surface"

[bit]
torque = "3 kN.m"

[top_drive]
control = "pi"
torque_limit = "40 kN.m"

[operation]
kind = "drill"
rpm = 90
wob = "60 kN"
rop = "15 m/h"

[dynamics]
duration = "10 s"
settle = "5 s"
`;

async function seated(text, { width, height, theme, flags = FLAGS, files = {} } = {}) {
  const served = await serve({ "case.toml": text, ...files });
  const page = await openPage(served, { width, height, theme, flags });
  await sit(page);
  return { served, page };
}

await run({
  "a step of rotary speed reaches the bit after its travel time": async () => {
    const { served, page } = await seated(PLAIN);
    await pace(page, "5×");
    await runs(page);
    await until(async () => (await time(page)) > 5.5, "the string runs", 60_000);
    await pause(page);
    const field = page.getByRole("textbox", { name: "Rotary speed, set" });
    await field.fill("90");
    await field.press("Enter");
    const from = await time(page);
    await runs(page);
    await until(async () => (await time(page)) > from + 2.5 * TRAVEL_S, "the wave has come", 60_000);
    await pause(page);
    const rows = await strips(page);
    const [set, bit] = ["rotary_speed_set_rad_per_s", "bit_rotary_speed_rad_per_s"];
    const change = rows.findIndex((row, i) => i > 0 && row[set] > rows[i - 1][set] + 1);
    check(change > 0, "the set point has a step");
    const [before, step] = [rows[change - 1][set], rows[change][set] - rows[change - 1][set]];
    check(Math.abs(step - Math.PI) < 1e-3, `the step is ${step} rad/s`);
    // The set point changes at the end of the previous sample.
    const begun = rows[change - 1].time_s;
    const half = rows.findIndex((row, i) => i > change && row[bit] > before + step);
    check(half > 0, "the bit turns faster");
    const [a, b] = [rows[half - 1], rows[half]];
    const arrived = a.time_s + ((before + step - a[bit]) / (b[bit] - a[bit])) * (b.time_s - a.time_s);
    const error = (arrived - begun) / TRAVEL_S - 1;
    console.log(`     L/c = ${TRAVEL_S.toFixed(4)} s, seen after ${(arrived - begun).toFixed(4)} s: ${(100 * error).toFixed(2)} %`);
    check(Math.abs(error) < 0.02, `the wave comes after ${arrived - begun} s, expected ${TRAVEL_S} s within 2 %`);
    // Until just before, the speed of the bit is unchanged; afterwards, it is twice the step higher.
    for (const row of rows) {
      if (row.time_s < begun + 0.95 * TRAVEL_S) check(Math.abs(row[bit] - before) < 0.05 * step, `at ${row.time_s} s the bit turns by ${row[bit]} rad/s`);
    }
    const after = rows.filter((row) => row.time_s > begun + 1.3 * TRAVEL_S && row.time_s < begun + 2.3 * TRAVEL_S);
    const mean = after.reduce((sum, row) => sum + row[bit], 0) / after.length;
    check(Math.abs((mean - before) / (2 * step) - 1) < 0.02, `the bit turns by ${mean - before} rad/s faster, expected ${2 * step}`);
    equal(page.complaints, [], "complaints");
    await served.stop();
  },

  "knobs turn by key, wheel and pointer, and numbers are typed": async () => {
    const { served, page } = await seated(SLANT);
    const dial = knob(page, "Rotary speed");
    const value = async () => Math.round(Number(await dial.getAttribute("aria-valuenow")));
    await dial.focus();
    const before = await value();
    await page.keyboard.press("ArrowUp");
    await until(async () => (await value()) === before + 1, "one more by key");
    await page.keyboard.press("PageUp");
    await until(async () => (await value()) === before + 11, "ten more by key");
    await dial.hover();
    await page.mouse.wheel(0, 100);
    await until(async () => (await value()) === before + 10, "one less by wheel");
    const box = await dial.boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2, box.y - 20, { steps: 4 });
    await page.mouse.up();
    const turned = await value();
    check(turned > before + 20, `the pointer turned it to ${turned}`);
    await page.getByRole("button", { name: "Step 0.1 s" }).click();
    await until(async () => (await time(page)) > 0.05, "it steps");
    const recording = await page.evaluate(async () => {
      const [{ id }] = await (await fetch("/api/live")).json();
      return (await fetch(`/api/live/${id}/recording`)).json();
    });
    const set = (recording.at(-1).set.rotary_speed_rad_per_s * 30) / Math.PI;
    check(Math.abs(set - turned) < 1e-6, `the engine was set to ${set} rev/min, the knob is at ${turned}`);
    // Weight and block replace each other.
    const block = page.getByRole("textbox", { name: "Block, down, set" });
    await block.fill("-0.05");
    await block.press("Enter");
    await page.keyboard.press("Escape");
    await page.getByRole("button", { name: "Step 0.1 s" }).click();
    await page.locator(".knob.idle", { hasText: "Weight on bit" }).waitFor();
    // Friction goes up, the controller changes.
    const friction = page.getByRole("textbox", { name: "Friction, set" });
    await friction.fill("0.35");
    await friction.press("Enter");
    await page.getByLabel("Top drive").selectOption("soft-torque");
    await page.getByRole("button", { name: "Step 0.1 s" }).click();
    await page.getByText("4 changes recorded").or(page.getByText("3 changes recorded")).waitFor();
    await page.locator(".knob", { hasText: "Friction" }).locator("output", { hasText: "0.350" }).waitFor();
    equal(page.complaints, [], "complaints");
    await served.stop();
  },

  "space runs and pauses, a dot steps, rewind and branch go back": async () => {
    const { served, page } = await seated(SLANT);
    await page.locator("h1").click();
    await page.keyboard.press(" ");
    await pace(page, "10×");
    await until(async () => (await time(page)) > 12, "it runs", 60_000);
    await page.locator("h1").click();
    await page.keyboard.press(" ");
    await page.getByRole("button", { name: "Run", exact: true }).waitFor();
    const there = await time(page);
    await page.keyboard.press(".");
    await until(async () => (await time(page)) > there + 0.05, "it steps");
    check((await time(page)) < there + 0.2, "a step is a step");
    const moments = page.getByLabel("Checkpoint");
    check((await moments.locator("option").count()) >= 2, "there are checkpoints");
    await moments.selectOption({ index: 0 });
    await page.getByRole("button", { name: "Branch" }).click();
    await page.waitForURL(/string=/);
    await until(async () => (await time(page)) === 0, "the branch begins at the checkpoint", 30_000);
    await page.goBack();
    await until(async () => (await time(page)) > 12, "the original string is unchanged", 30_000);
    await page.getByLabel("Checkpoint").selectOption({ index: 0 });
    await page.getByRole("button", { name: "Rewind" }).click();
    await until(async () => (await time(page)) === 0, "it is taken back");
    equal(page.complaints, [], "complaints");
    await served.stop();
  },

  "recorded changes are repeated, and become the schedule of the case": async () => {
    const { served, page } = await seated(SLANT);
    const field = page.getByRole("textbox", { name: "Rotary speed, set" });
    await page.getByRole("button", { name: "Step 0.1 s" }).click();
    await until(async () => (await time(page)) > 0.05, "it steps");
    await field.fill("120");
    await field.press("Enter");
    await page.getByText("1 change recorded").waitFor();
    await page.getByRole("button", { name: "Save as schedule" }).click();
    await page.getByText("1 line written into the schedule").waitFor();
    const link = page.getByRole("link", { name: "Open the case" });
    equal(await link.getAttribute("href"), `#/case/${await caseId(page)}`, "link to the case");
    const draft = await page.evaluate(async () => {
      const [{ id }] = await (await fetch("/api/cases")).json();
      return (await (await fetch(`/api/cases/${id}`)).json()).draft.text;
    });
    check(/\[\[operation\.schedule\]\][\s\S]*rpm = 120/.test(draft), draft);
    equal(served.read("case.toml"), SLANT, "the file, which is not saved");
    await page.getByLabel("Checkpoint").selectOption({ index: 0 });
    await page.getByRole("button", { name: "Replay from it" }).click();
    await page.getByText("1 to be repeated").waitFor();
    await runs(page);
    await until(async () => (await time(page)) > 0.6, "it runs");
    await pause(page);
    const rows = await strips(page);
    check(rows.some((row) => Math.abs(row.rotary_speed_set_rad_per_s - 4 * Math.PI) < 1e-3), "the speed is set again");
    equal(page.complaints, [], "complaints");
    await served.stop();
  },

  "values out of range are refused with a sentence, in the units of the reader": async () => {
    const { served, page } = await seated(SLANT);
    const type = async (name, text) => {
      const field = page.getByRole("textbox", { name: `${name}, set` });
      await field.fill(text);
      await field.press("Enter");
    };
    const refused = page.locator(".messages [role=alert]");
    await type("Weight on bit", "5000");
    await refused.getByText(/too light for the requested weight on bit: 5000 kN requested, \d+(\.\d+)? kN available.*It was not set/).waitFor();
    await page.getByRole("group", { name: "Units" }).getByRole("button", { name: "field" }).click();
    await type("Weight on bit", "2000");
    await refused.getByText(/out of range: expected 0 klbf to 1124 klbf. It was not set/).waitFor();
    await type("Rotary speed", "1200");
    await refused.getByText("The rotary speed of 1200 rpm is out of range: expected 0 rpm to 1000 rpm. It was not set").waitFor();
    await until(async () => Math.round(Number(await knob(page, "Rotary speed").getAttribute("aria-valuenow"))) === 90, "the set point is unchanged");
    await type("Rotary speed", "fast");
    await page.getByText("“fast” is no number").waitFor();
    const ramp = page.getByLabel("Ramp");
    await ramp.fill("-3");
    await ramp.press("Enter");
    await refused.getByText("The ramp of -3 s is out of range").waitFor();
    await page.getByText("0 changes recorded").waitFor();
    equal(page.complaints, [], "complaints");
    await served.stop();
  },

  "lamps agree with each other after a rewind and in a stall": async () => {
    const { served, page } = await seated(SLANT.replace("40 kN.m", "4 kN.m"));
    const lamps = () => page.locator("[data-lamp]").evaluateAll((all) => all.map((lamp) => lamp.dataset.severity));
    equal(await lamps(), ["none", "none", "none"], "lamps before the first sample");
    await page.getByRole("button", { name: "Count" }).waitFor();
    await pace(page, "max");
    await runs(page);
    await page.locator('.alarms[data-severity="error"]').waitFor({ timeout: 60_000 });
    await until(async () => (await time(page)) > 12, "it runs", 60_000);
    await pause(page);
    await until(async () => (await lamps())[2] === "error", "the top drive's lamp has the severity of its alarm");
    equal(await lamps(), ["none", "none", "error"], "lamps in a stall");
    await page.locator(".alarms button").click();
    await page.locator("#alarm-list").getByText("The top drive stalls").first().waitFor();
    await page.locator("#alarm-list").getByText("Not measured while the top drive stalls").first().waitFor();
    await accessible(page, "alarms");
    await picture(page, "seat-stall");
    await page.getByLabel("Checkpoint").selectOption({ index: 0 });
    await page.getByRole("button", { name: "Rewind" }).click();
    await until(async () => (await time(page)) === 0, "it is rewound");
    await until(async () => (await lamps()).join() === "none,none,none", "all lamps are dark");
    equal(await page.locator(".alarms").getAttribute("data-alarms"), "0", "alarms after the rewind");
    equal(page.complaints, [], "complaints");
    await served.stop();
  },

  "charts without a meaning are left out, and unchanging ones hidden": async () => {
    const { served, page } = await seated(PLAIN);
    const charts = () => page.locator("[data-strip]").evaluateAll((all) => all.map((chart) => chart.dataset.strip));
    equal(await charts(), ["Hook load", "Torque", "Rotary speed", "Block"], "charts of a string that rotates off bottom");
    await pace(page, "max");
    await runs(page);
    await until(async () => !(await charts()).includes("Block"), "the block's chart is hidden", 60_000);
    await page.getByRole("button", { name: "Show 1 unchanging" }).click();
    await until(async () => (await charts()).includes("Block"), "it is shown on request");
    await page.getByRole("button", { name: "newest ↑" }).click();
    await page.reload();
    await page.getByRole("button", { name: "newest ↑", pressed: true }).waitFor();
    equal(await page.locator('[data-readout="weight"]').count(), 0, "read-outs of a weight on bit");
    await served.stop();
  },

  "a reload finds the string, and two tabs see one": async () => {
    const { served, page } = await seated(SLANT);
    await runs(page);
    await until(async () => (await time(page)) > 2, "it runs", 30_000);
    await page.reload();
    await page.getByRole("button", { name: "Pause" }).waitFor({ timeout: 30_000 });
    check((await time(page)) > 2, "it continued meanwhile");
    const rows = await strips(page);
    check(rows[0].time_s < 0.1, `the first that is seen after the reload is of ${rows[0].time_s} s`);
    const times = rows.map((row) => row.time_s);
    check(times.every((time, i) => i === 0 || time > times[i - 1]), "no sample is there twice");
    const other = await page.context().newPage();
    await other.goto(page.url());
    await other.getByRole("button", { name: "Pause" }).waitFor({ timeout: 30_000 });
    await page.getByText("seen on 2 pages").waitFor();
    await pause(other);
    await page.getByRole("button", { name: "Run", exact: true }).waitFor();
    await until(async () => (await time(page)) === (await time(other)), "both have the same time");
    const field = other.getByRole("textbox", { name: "Rotary speed, set" });
    await field.fill("130");
    await field.press("Enter");
    await other.getByRole("button", { name: "Step 0.1 s" }).click();
    // It is returned in single precision.
    const set = async () => Number(await knob(page, "Rotary speed").getAttribute("aria-valuenow"));
    await until(async () => Math.abs((await set()) - 130) < 1e-3, "the other tab's knob follows");
    await other.close();
    equal(page.complaints, [], "complaints");
    await served.stop();
  },

  "a program that was ended has kept the string": async () => {
    const { served, page } = await seated(SLANT);
    await runs(page);
    await until(async () => (await time(page)) > 1, "it runs", 30_000);
    await served.restart("SIGTERM");
    const again = await openPage(served, { flags: FLAGS });
    const id = await caseId(again);
    await again.evaluate((id) => (location.hash = `#/seat/${id}`), id);
    await again.getByRole("button", { name: "Continue" }).click();
    await again.getByRole("button", { name: "Run", exact: true }).waitFor({ timeout: 30_000 });
    check((await time(again)) > 1, "it continues from its last time");
    await served.stop();
  },

  "frames and updates are counted at ten times real time": async () => {
    const text = read("np13-x1042.toml").replace("[dynamics]", '[mesh]\nelement_length = "3.2 m"\n\n[dynamics]');
    const files = { "np13-x1042-survey.csv": read("np13-x1042-survey.csv") };
    const { served, page } = await seated(text, { files });
    await pace(page, "10×");
    await runs(page);
    await page.getByRole("button", { name: "Count" }).click();
    await until(async () => (await time(page)) > 40, "it runs", 120_000);
    const found = [];
    for (let second = 0; second < 10; second++) {
      await page.waitForTimeout(1000);
      found.push(
        await page.evaluate(() => {
          const { frames, updates, drawing } = document.documentElement.dataset;
          const reached = document.querySelector("[data-reached]").dataset.reached;
          return { frames: Number(frames), updates: Number(updates), drawing: Number(drawing), reached: Number(reached) };
        }),
      );
    }
    const middle = (key) => found.map((one) => one[key]).sort((a, b) => a - b)[Math.floor(found.length / 2)];
    const [frames, updates, drawing, reached] = ["frames", "updates", "drawing", "reached"].map(middle);
    console.log(`     ${frames} frames and ${updates} updates in a second, ${drawing} ms each, at ${reached.toFixed(2)} × real time`);
    await picture(page, "seat-np13");
    if (process.env.MEASURE === "1") {
      check(frames >= 30, `${frames} frames in a second`);
      check(updates >= 20, `${updates} updates in a second`);
      check(reached > 9.5, `${reached} × real time`);
    }
    await served.stop();
  },

  "the seat is accessible and has its looks at every width": async () => {
    const served = await serve({ "case.toml": SLANT });
    for (const [theme, width, height] of [
      ["light", 1440, 900], ["dark", 1440, 900], ["light", 1920, 1080], ["light", 900, 900], ["dark", 900, 900], ["light", 420, 900], ["dark", 420, 900],
    ]) {
      const page = await openPage(served, { width, height, theme, flags: FLAGS });
      await sit(page, theme === "light" && width === 1440);
      if (theme === "light" && width === 1440) {
        await pace(page, "5×");
        await runs(page);
        await until(async () => (await time(page)) > 15, "it runs", 60_000);
      }
      await page.waitForTimeout(1500);
      await accessible(page, `${theme}, ${width}`);
      const over = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
      check(over <= 0, `at ${width} px the page is ${over} px too wide`);
      const scrolls = await page.evaluate(() => document.documentElement.scrollHeight - document.documentElement.clientHeight);
      if (width >= 1440) check(scrolls <= 0, `at ${width} × ${height} the page is ${scrolls} px too high`);
      await picture(page, `seat-${width}-${theme}`);
      equal(page.complaints, [], "complaints");
      await page.context().close();
    }
    await served.stop();
  },
});
