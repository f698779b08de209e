// Results while typing: tracks, broomstick, limits, assembly and what-if sliders, by mouse and by keys.
import { readFileSync } from "node:fs";
import { accessible, check, equal, openPage, picture, run, serve, until } from "./harness.mjs";

const CASES = new URL("../../../cases/", import.meta.url);
const read = (name) => readFileSync(new URL(name, CASES), "utf8");

/** The well of the timings. */
const NP13 = { "np13.toml": read("np13-x1042.toml"), "np13-x1042-survey.csv": read("np13-x1042-survey.csv") };

const SLANT = `# A slant well.
name = "slant"

[well]
stations = [[0, 0, 0], [400, 0, 0], [1000, 30, 0]]

[[well.hole]]
kind = "casing"
to = "500 m"
diameter = "8.835 in"
friction = 0.2  # cased

[[well.hole]]
kind = "open"
to = "1000 m"
diameter = "8-1/2 in"
friction = 0.3  # a guess

[mud]
density = "1.2 sg"

[rig]
hoist_capacity = "1500 kN"
top_drive_torque = "30 kN.m"

[[string]]
component = "bit"
od = "8-1/2 in"
length = "0.3 m"

[[string]]
component = "collar"
od = "6.75 in"
id = "2.8125 in"
length = "80 m"

[[string]]
component = "drill pipe"
od = "127 mm"
id = "108.6 mm"
mass_per_length = "30 kg/m"
length = "to surface"

[bit]
torque = "3 kN.m"

[operation]
kind = ["trip_out", "drill"]
bit_depth = "1000 m"
rpm = 120
wob = "50 kN"
rop = "10 m/h"
`;

/** The same with a fitted factor, and a plan with low and high friction. */
const CALIBRATED = `${SLANT.replace("0.3  # a guess", "0.31  # fitted on the readings")}
[plan.friction]
low = 0.15
high = 0.4
`;

/** The two sliders of friction. */
const MULTIPLIER = "Friction multiplier, each section's own factor";
const UNIFORM = "Friction, one factor for all sections";

/** Opens the answers of a case, and waits until all of them are drawn. */
async function openAnswers(served, name, options) {
  const page = await openPage(served, options);
  // The machine may be shared with builds.
  page.setDefaultTimeout(30_000);
  const id = await page.evaluate(async (name) => {
    const cases = await (await fetch("/api/cases")).json();
    return cases.find(({ path }) => path === name).id;
  }, name);
  await page.evaluate((id) => (location.hash = `#/answers/${id}`), id);
  await page.waitForSelector(".answers, main > .warning");
  return page;
}

const drawn = async (page) => {
  await page.waitForSelector(".tracks svg");
  await page.waitForSelector(".depth-chart svg");
  await page.waitForSelector(".assembly-views svg");
  await settled(page);
};

/** Waits until no request is pending. */
const settled = (page) => until(() => page.evaluate(() => document.querySelector(".answers")?.dataset.solving === "false"), "all is solved", 30_000);

/** A displayed number of the table, of the soft or of the stiff string. */
const keyNumber = async (page, row, model) => {
  const text = await page.locator(".key-numbers tr", { hasText: row }).locator("td").nth(model === "soft" ? 0 : 1).innerText();
  return Number(text.split("was")[0].replaceAll("\u2212", "-").replace(/[^\d.\-].*$/s, ""));
};

const ghosts = (page) => page.locator(".tracks .curve.ghost").count();

await run({
  "the answers of a case are those of the server": async () => {
    const served = await serve(NP13);
    const page = await openAnswers(served, "np13.toml");
    await drawn(page);
    const answers = await page.evaluate(async () => {
      const id = location.hash.split("/").pop();
      const { text } = await (await fetch(`/api/cases/${id}`)).json();
      const body = JSON.stringify({ text });
      const answer = await fetch(`/api/cases/${id}/answer`, { method: "POST", headers: { "content-type": "application/json" }, body });
      return (await answer.json()).operations.map((one) => one.surface_torque_N_m);
    });
    for (const [i, model] of ["soft", "stiff"].entries()) {
      const number = await keyNumber(page, "Torque at the surface", model);
      check(Math.abs(number - answers[i] / 1e3) < 0.006, `${model}: ${number} kN·m are shown, ${answers[i]} N·m answered`);
    }
    equal(await ghosts(page), 0, "curves from before");
    check((await page.locator(".took").innerText()).includes("drawn"), "the time that it took is shown");
    await accessible(page, "answers");
    equal(page.complaints, [], "complaints");
    await page.context().close();
    await served.stop();
  },

  "a slider is moved by keys, and the text stays": async () => {
    const served = await serve(NP13);
    const page = await openAnswers(served, "np13.toml");
    await drawn(page);
    const before = await keyNumber(page, "Torque at the surface", "stiff");
    const slider = page.getByLabel(MULTIPLIER, { exact: true });
    await slider.focus();
    for (let i = 0; i < 20; i++) await page.keyboard.press("ArrowLeft");
    await until(async () => (await ghosts(page)) > 0, "the answer of the text is drawn pale", 30_000);
    await settled(page);
    const after = await keyNumber(page, "Torque at the surface", "stiff");
    check(after < 0.9 * before, `with less friction the torque is ${after}, with that of the text ${before}`);
    const words = await page.locator(".key-numbers").innerText();
    check(words.includes(`was ${before}`), `the number of the text is shown too: ${words}`);
    await until(async () => (await page.locator(".depth-chart .curve.ghost").count()) > 0, "the broomstick of the text is pale", 30_000);
    equal(served.read("np13.toml"), NP13["np13.toml"], "the file");
    await accessible(page, "answers with other values");
    await page.getByRole("button", { name: "Reset all" }).press("Enter");
    await until(async () => (await ghosts(page)) === 0, "nothing is pale any more");
    equal(await keyNumber(page, "Torque at the surface", "stiff"), before, "the torque again");
    equal(page.complaints, [], "complaints");
    await page.context().close();
    await served.stop();
  },

  "every slider changes the answer by mouse": async () => {
    const served = await serve({ "slant.toml": SLANT });
    const page = await openAnswers(served, "slant.toml");
    await drawn(page);
    for (const [label, row, model] of [
      [MULTIPLIER, "Torque at the surface", "soft"],
      ["Weight on bit", "Hook load", "soft"],
      ["Mud density", "Hook load", "stiff"],
      ["Bit depth", "Hook load", "soft"],
    ]) {
      const before = await keyNumber(page, row, model);
      const slider = page.getByLabel(label, { exact: true });
      await slider.scrollIntoViewIfNeeded();
      const box = await slider.boundingBox();
      await page.mouse.move(box.x + box.width * 0.5, box.y + box.height / 2);
      await page.mouse.down();
      for (const part of [0.45, 0.4, 0.35, 0.3]) await page.mouse.move(box.x + box.width * part, box.y + box.height / 2);
      await page.mouse.up();
      await until(async () => (await keyNumber(page, row, model)) !== before, `${label} changes the answer`, 30_000);
      await page.getByRole("button", { name: `reset ${label}` }).click();
      await until(async () => (await keyNumber(page, row, model)) === before, `${label}: the answer of the text again`, 30_000);
    }
    // Coulomb friction does not depend on the speed of rotation alone, but on the ratio of rotation and axial motion.
    const slider = page.getByLabel("Rotary speed", { exact: true });
    await slider.focus();
    await page.keyboard.press("Home");
    await settled(page);
    check((await page.locator(".slider", { hasText: "Rotary speed" }).innerText()).includes("was 120"), "it was 120 rpm");
    equal(page.complaints, [], "complaints");
    await page.context().close();
    await served.stop();
  },

  "modified values are applied after a preview of the changes, and that is undone": async () => {
    const served = await serve({ "slant.toml": CALIBRATED });
    const page = await openAnswers(served, "slant.toml");
    await drawn(page);
    const apply = page.getByRole("button", { name: "Apply to case" });
    check(await apply.isDisabled(), "there is nothing to apply at first");
    await page.getByLabel("Weight on bit", { exact: true }).focus();
    await page.keyboard.press("End");
    await page.getByLabel(MULTIPLIER, { exact: true }).focus();
    for (let i = 0; i < 20; i++) await page.keyboard.press("ArrowLeft");
    await settled(page);
    await until(async () => /casing to 500 m: 0.2 → 0.1\d/.test(await page.locator(".sections").innerText()), "sections say their factors", 30_000);
    await apply.click();
    const dialog = page.getByRole("dialog", { name: "Apply to case" });
    await dialog.getByRole("table").waitFor();
    equal(served.read("slant.toml"), CALIBRATED, "the file while the dialog asks");
    const rows = await dialog.locator("tbody tr").allInnerTexts();
    equal(rows.length, 5, `changes: ${rows}`);
    check(rows.some((row) => /^Friction, open hole to 1000 m\s+0.31\s+0.2\d+/.test(row)), `a row for each section: ${rows}`);
    check(rows.some((row) => /^Plan, high friction\s+0.4\s+0.3\d+/.test(row)), `the levels of the plan go along: ${rows}`);
    const fate = dialog.getByLabel("fitted on the readings");
    equal(await fate.inputValue(), "mark", "a comment that would be false");
    equal(await dialog.getByLabel("cased").inputValue(), "keep", "a comment that stays true");
    await accessible(page, "preview of the changes");
    await picture(page, "apply");
    await dialog.getByRole("button", { name: "Apply", exact: true }).click();
    await until(() => served.read("slant.toml") !== CALIBRATED, "the file is written", 30_000);
    const text = served.read("slant.toml");
    check(/^friction = 0\.1\d+  # cased$/m.test(text), `the casing's own factor, its comment kept: ${text}`);
    check(/^friction = 0\.2\d+  # was 0\.31: fitted on the readings$/m.test(text), `the rock's own factor: ${text}`);
    check(/^wob = "100 kN"$/m.test(text), `the weight in the file: ${text}`);
    await until(async () => (await ghosts(page)) === 0, "the case has the modified values", 30_000);
    await page.getByRole("button", { name: "Undo" }).click();
    await until(() => served.read("slant.toml") === CALIBRATED, "the file is restored", 30_000);
    equal(page.complaints, [], "complaints");
    await page.context().close();
    await served.stop();
  },

  "a plan with low and high keeps the sliders of friction within them": async () => {
    const served = await serve({ "slant.toml": CALIBRATED });
    const page = await openAnswers(served, "slant.toml");
    await drawn(page);
    await page.getByRole("group", { name: "Friction factors" }).getByRole("button", { name: "one for all" }).click();
    const slider = page.getByLabel(UNIFORM, { exact: true });
    for (const [key, factor] of [["Home", "0.15"], ["End", "0.4"]]) {
      await slider.focus();
      await page.keyboard.press(key);
      await settled(page);
      await until(async () => (await page.locator(".sections").innerText()).includes(`casing to 500 m: 0.2 → ${factor}`), `${key}: all sections have ${factor}`, 30_000);
      equal(await page.locator(".answers > .warning").count(), 0, "refusals");
    }
    await page.getByRole("group", { name: "Friction factors" }).getByRole("button", { name: "each section's own" }).click();
    for (const key of ["Home", "End"]) {
      await page.getByLabel(MULTIPLIER, { exact: true }).focus();
      await page.keyboard.press(key);
      await settled(page);
      equal(await page.locator(".answers > .warning").count(), 0, "refusals");
    }
    equal(page.complaints, [], "complaints");
    await page.context().close();
    await served.stop();
  },

  "numbers and sentences are in the units of the case until the reader chooses others": async () => {
    const served = await serve({ "field.toml": SLANT.replace('name = "slant"', 'name = "slant"\nunits = "field"').replace("30 kN.m", "4 kN.m") });
    const page = await openAnswers(served, "field.toml");
    await drawn(page);
    const limits = page.locator("section[aria-labelledby=limits-title]");
    const text = () => limits.innerText();
    await until(async () => /klbf/.test(await text()), "the case's units", 30_000);
    check(!/ kN| m\b/.test((await text()).replaceAll("\u00a0", " ")), `field units alone: ${await text()}`);
    await page.getByRole("group", { name: "Units" }).getByRole("button", { name: "SI" }).click();
    await until(async () => !/klbf|\bft\b/.test(await text()) && /kN/.test(await text()), "SI alone", 30_000);
    equal(page.complaints, [], "complaints");
    await page.context().close();
    await served.stop();
  },

  "the cursor shows values by mouse and by keys, depths zoom": async () => {
    const served = await serve({ "slant.toml": SLANT });
    const page = await openAnswers(served, "slant.toml");
    await drawn(page);
    const cover = page.locator(".tracks .cover").first();
    await cover.scrollIntoViewIfNeeded();
    const box = await cover.boundingBox();
    await page.mouse.move(box.x + 200, box.y + box.height / 2);
    await until(async () => (await page.locator(".tracks .readout tspan").count()) > 4, "the values at the pointer");
    const at = async () => Number((await page.locator(".tracks .flag").first().textContent()).replace(",", ""));
    check(Math.abs((await at()) - 500) < 6, `the cursor is at ${await at()} m, half of 1000`);
    await page.mouse.down();
    await page.mouse.move(box.x + 200, box.y + box.height * 0.9, { steps: 4 });
    await page.mouse.up();
    await until(async () => Math.abs(Number(await page.getByLabel("Depths from").inputValue()) - 500) < 6, "depths from 500 m on");
    await page.getByRole("button", { name: "All depths" }).click();
    equal(await page.getByLabel("Depths from").inputValue(), "0", "depths from the surface on");
    await page.getByLabel("Cursor at").focus();
    await page.keyboard.press("Home");
    for (let i = 0; i < 40; i++) await page.keyboard.press("ArrowRight");
    await until(async () => Math.abs((await at()) - 100) < 3, "the cursor at 100 m by keys");
    const words = await page.locator(".values").innerText();
    check(/Tension: soft string .*kN, stiff string .*kN;/.test(words), `values in words: ${words}`);
    equal(page.complaints, [], "complaints");
    await page.context().close();
    await served.stop();
  },

  "operations are chosen, units follow the header": async () => {
    const served = await serve({ "slant.toml": SLANT });
    const page = await openAnswers(served, "slant.toml");
    await drawn(page);
    const choice = page.getByRole("group", { name: "Operation" });
    equal(await choice.getByRole("button").allInnerTexts(), ["trip out", "drill"], "operations");
    await choice.getByRole("button", { name: "trip out" }).click();
    await settled(page);
    equal(await keyNumber(page, "Torque at the surface", "soft"), 0, "the torque of a string that does not turn");
    await until(async () => (await page.locator("section", { hasText: "Static BHA analysis" }).innerText()).includes("trip out"), "the assembly of that operation", 30_000);
    const newton = await keyNumber(page, "Hook load", "soft");
    await page.getByRole("group", { name: "Units" }).getByRole("button", { name: "field" }).click();
    const pounds = await keyNumber(page, "Hook load", "soft");
    check(Math.abs(pounds * 4.4482216 - newton) < 0.05, `${pounds} klbf are ${newton} kN`);
    check((await page.locator(".tracks .unit").allTextContents()).includes("klbf"), "tracks have the units");
    check((await page.locator(".depth-chart .unit").allTextContents()).includes("ft·lbf"), "the broomstick has them");
    equal(page.complaints, [], "complaints");
    await page.context().close();
    await served.stop();
  },

  "limits have reserves, the broomstick has limits and numbers": async () => {
    const served = await serve({ "slant.toml": SLANT });
    const page = await openAnswers(served, "slant.toml");
    await drawn(page);
    const limits = page.locator("section", { hasText: "Limits" }).last();
    const words = await page.locator("section[aria-labelledby=limits-title]").innerText();
    check(/Hoist\s.*\+\d+ %/s.test(words) || words.includes("more than 10 times"), `the hoist has a reserve: ${words}`);
    check(words.includes("Not checked:"), "checks that were not possible are listed");
    const names = await page.locator(".depth-chart .limit-name").allTextContents();
    check(names.some((name) => name.startsWith("hoist")) && names.some((name) => name.startsWith("top drive")), `limits of the rig: ${names}`);
    const ends = await page.locator(".depth-chart .end-name").allTextContents();
    check(ends.includes("rotate off bottom") && ends.some((end) => end.startsWith("trip out")) && ends.some((end) => end.startsWith("trip in")), `ends of lines: ${ends}`);
    // The hook load of trip in is below that of rotating, that of trip out above.
    await page.getByText("Hook load, without block in numbers").click();
    await page.locator(".depth-chart + details table td").first().waitFor();
    const last = await page.locator(".depth-chart + details table tr").last().locator("td").allInnerTexts();
    const heads = await page.locator(".depth-chart + details table th").allInnerTexts();
    const value = (name) => parseFloat(last[heads.findIndex((head) => head.startsWith(name))]);
    check(value("trip in") < value("rotate off bottom") && value("rotate off bottom") < value("trip out"), `loads at the deepest bit: ${last}`);
    await accessible(page, "answers with the table of the broomstick");
    check(await limits.isVisible(), "limits are shown");
    await page.context().close();
    await served.stop();
  },

  "an operation without an equilibrium has a message in its place": async () => {
    const served = await serve({ "rolls.toml": SLANT.replace('wob = "50 kN"', 'wob = "300 kN"') });
    const page = await openAnswers(served, "rolls.toml");
    await drawn(page);
    const words = await page.locator("section[aria-labelledby=answers-title]").innerText();
    check(words.includes("The stiff string has no answer: No static equilibrium"), `the message: ${words}`);
    equal(await page.locator(".key-numbers thead th").allInnerTexts(), ["Quantity", "soft string"], "columns of the numbers");
    await accessible(page, "an operation without an equilibrium");
    equal(page.complaints, [], "complaints");
    await page.context().close();
    await served.stop();
  },

  "a text that is not valid has no answer": async () => {
    const served = await serve({ "broken.toml": SLANT.replace("friction = 0.3", 'friction = "much"') });
    const page = await openAnswers(served, "broken.toml");
    await page.getByText("The case is not valid").waitFor();
    equal(await page.locator(".tracks").count(), 0, "tracks");
    await accessible(page, "a case that is not valid");
    await page.context().close();
    await served.stop();
  },

  "a lost server is reported, and the request is repeated": async () => {
    const served = await serve({ "slant.toml": SLANT });
    const page = await openAnswers(served, "slant.toml");
    await drawn(page);
    await served.kill();
    await page.getByLabel("Mud density", { exact: true }).focus();
    await page.keyboard.press("ArrowRight");
    await page.getByText("The server does not answer").waitFor();
    check(await page.getByRole("button", { name: "Try again" }).isVisible(), "one may try again");
    equal(await page.locator(".tracks svg").count() > 0, true, "the last answer stays");
    await page.context().close();
    await served.stop();
  },

  "the well is drawn in space with the string in it": async () => {
    const served = await serve({ "slant.toml": SLANT });
    const page = await openAnswers(served, "slant.toml", { flags: ["--use-angle=swiftshader"] });
    await drawn(page);
    await page.getByText("The well with the string in it").click();
    await page.waitForSelector("canvas.space");
    // Another quantity changes the colours of the string only.
    const keep = (name) =>
      page.evaluate(async (name) => {
        await new Promise((wake) => setTimeout(wake, 500));
        const canvas = document.querySelector("canvas.space");
        const copy = Object.assign(document.createElement("canvas"), { width: canvas.width, height: canvas.height });
        const pen = copy.getContext("2d");
        pen.drawImage(canvas, 0, 0);
        globalThis[name] = pen.getImageData(0, 0, copy.width, copy.height).data;
      }, name);
    await keep("sideForce");
    await page.getByLabel("Colour").selectOption("tension_N");
    await keep("tension");
    const percent = await page.evaluate(() => {
      const { sideForce, tension } = globalThis;
      const differs = (i) => [0, 1, 2].some((k) => Math.abs(tension[i + k] - sideForce[i + k]) > 24);
      let other = 0;
      for (let i = 0; i < tension.length; i += 4) if (differs(i)) other++;
      return (400 * other) / tension.length;
    });
    check(percent > 0.1 && percent < 20, `another quantity changes ${percent.toFixed(2)} % of the view`);
    equal(page.complaints, [], "complaints");
    await page.context().close();
    await served.stop();
  },

  "it fits on screens, light and dark": async () => {
    const served = await serve(NP13);
    for (const width of [1440, 900, 420])
      for (const theme of ["light", "dark"]) {
        const page = await openAnswers(served, "np13.toml", { width, theme });
        await drawn(page);
        await page.getByLabel(MULTIPLIER, { exact: true }).focus();
        for (let i = 0; i < 10; i++) await page.keyboard.press("ArrowLeft");
        await until(async () => (await ghosts(page)) > 0, "the answer of the text is drawn pale", 30_000);
        await settled(page);
        await until(async () => (await page.locator(".depth-chart .curve.ghost").count()) > 0, "all is drawn", 30_000);
        const [content, window] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
        check(content <= window, `${content} pixels of content at ${width}`);
        await accessible(page, `${width} ${theme}`);
        await picture(page, `answers-${width}-${theme}`);
        await page.context().close();
      }
    await served.stop();
  },
});
