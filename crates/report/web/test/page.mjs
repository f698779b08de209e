// The report in a real browser: `node test/page.mjs CHROMIUM report.html`. Everything draws, what can be switched
// switches, nothing is fetched and nothing is complained about.
import assert from "node:assert/strict";
import { browse, colours, differs, picture, same, settled, SPACE, text } from "./browser.mjs";

const [executablePath, file] = process.argv.slice(2);
const { check, open, close } = await browse(executablePath, file, {
  args: SPACE,
  timeout_ms: 120_000,
});

const page = await open();

await check("five answers", async () => {
  assert.equal(await page.locator(".answer").count(), 5);
  for (const number of await page.locator(".answer .number").allTextContents()) assert.match(number, /\d|none/);
});

await check("every track has a curve", async () => {
  const tracks = await page.evaluate(() =>
    [...document.querySelectorAll(".tracks > svg > svg")]
      .filter((track) => track.querySelector(".curve"))
      .map((track) => [...track.querySelectorAll(".curve")].map((curve) => curve.getAttribute("d").length)),
  );
  assert.equal(tracks.length, 8, `${tracks.length} tracks`);
  for (const curves of tracks) assert.ok(Math.max(...curves) > 20, "a curve has points");
  const broken = await page.locator(".tracks path[d*=NaN], .tracks [y*=NaN]").count();
  assert.equal(broken, 0, "no coordinate is missing");
});

await check("no two numbers of an axis overlap", async () => {
  const overlaps = await page.evaluate(() => {
    const found = [];
    for (const picture of document.querySelectorAll(".tracks > svg")) {
      const ticks = [...picture.querySelectorAll(".tick")].filter((tick) => tick.getAttribute("y") < 82);
      const boxes = ticks.map((tick) => [tick.getBoundingClientRect(), tick.textContent]);
      boxes.sort(([a], [b]) => a.left - b.left);
      for (let i = 1; i < boxes.length; i++)
        if (boxes[i][0].left < boxes[i - 1][0].right) found.push(`${boxes[i - 1][1]} and ${boxes[i][1]}`);
    }
    return found;
  });
  assert.deepEqual(overlaps, []);
});

await check("every time history is drawn", async () => {
  const count = await page.locator(".history canvas").count();
  assert.ok(count >= 6, `${count} histories`);
  for (let i = 0; i < count; i++) {
    await page.evaluate((i) => document.querySelectorAll(".history canvas")[i].setAttribute("id", `history-${i}`), i);
    assert.ok((await colours(page, `#history-${i}`)) > 4, `history ${i} is not blank`);
  }
});

await check("the soft string stands beside hook load and torque", async () => {
  const legends = await page.locator(".history .u-legend").allTextContents();
  assert.equal(legends.filter((legend) => legend.includes("soft string")).length, 2, JSON.stringify(legends));
});

await check("the map of contact is drawn", async () => {
  const side = await picture(page, "canvas.map");
  assert.ok((await colours(page, "canvas.map")) > 10);
  await page.click("[data-value=contact_force]");
  differs(await picture(page, "canvas.map"), side, "the other quantity");
});

await check("the well is drawn in space", async () => {
  assert.ok((await colours(page, "canvas.space")) > 50);
});

await check("the scrubber moves the string, and Mean takes it back", async () => {
  const before = await picture(page, "canvas.space");
  await page.locator(".moments input").evaluate((input) => {
    input.value = Math.floor(input.max / 2);
    input.dispatchEvent(new Event("input"));
  });
  await settled(page);
  const at = await picture(page, "canvas.space");
  differs(at, before, "the moment");
  assert.match(await text(page, ".moments output"), /^\d+\.\d\d s$/);
  await page.locator(".moments button", { hasText: "Mean" }).click();
  await settled(page);
  same(await picture(page, "canvas.space"), before, "the mean");
});

await check("exaggeration and colours change the view", async () => {
  const before = await picture(page, "canvas.space");
  await page.locator("#scene .tools input").evaluate((input) => {
    input.value = 3;
    input.dispatchEvent(new Event("input"));
  });
  const thicker = await picture(page, "canvas.space");
  differs(thicker, before, "a thicker string");
  await page.locator("#scene .tools select").selectOption("tension_N");
  differs(await picture(page, "canvas.space"), thicker, "another colour");
});

await check("units switch everywhere, by their factors", async () => {
  const number = async () => {
    const [, digits, unit] = (await text(page, ".answer .number")).match(/^([\d\u202f.\u2212]+)\u00a0(\S+)$/);
    return [Number(digits.replaceAll("\u202f", "").replace("\u2212", "-")), unit];
  };
  const seen = {};
  for (const units of ["field", "metric", "si"]) {
    await page.click(`.controls [data-value=${units}]`);
    await settled(page);
    seen[units] = {
      hook: await number(),
      track: await text(page, ".tracks .unit.middle"),
      axis: await text(page, ".tracks text.unit"),
      history: await text(page, ".history .unit"),
      table: await text(page, "#results tbody .unit"),
      dogleg: (await page.locator(".tracks .unit.middle").allTextContents()).at(-1),
    };
  }
  const [kN, t, klbf] = ["si", "metric", "field"].map((units) => seen[units].hook[0]);
  assert.ok(Math.abs((klbf * 4.4482216) / kN - 1) < 1e-3, `${klbf} klbf is ${kN} kN`);
  assert.ok(Math.abs((t * 9.80665) / kN - 1) < 1e-3, `${t} t is ${kN} kN`);
  for (const place of ["track", "history", "table"])
    assert.deepEqual(
      ["si", "metric", "field"].map((units) => seen[units][place].trim()),
      ["kN", "t", "klbf"],
      place,
    );
  assert.deepEqual(
    ["si", "metric", "field"].map((units) => seen[units].axis),
    ["m", "m", "ft"],
  );
  assert.deepEqual([seen.si.dogleg, seen.field.dogleg], ["°/30 m", "°/100 ft"]);
});

await check("zooming one track zooms all, the map and the string with them", async () => {
  const cover = page.locator(".tracks .cover").first();
  await cover.scrollIntoViewIfNeeded();
  const map = await picture(page, "canvas.map");
  const box = await cover.boundingBox();
  await page.mouse.move(box.x + 300, box.y + 0.4 * box.height);
  await page.mouse.down();
  await page.mouse.move(box.x + 300, box.y + 0.6 * box.height, { steps: 4 });
  await page.mouse.up();
  const depths = await page
    .locator("#tracks input")
    .evaluateAll((inputs) => inputs.map((input) => Number(input.value)));
  const total = await page.evaluate(() => JSON.parse(document.getElementById("report").textContent).string.at(-1).to_m);
  assert.ok(
    Math.abs(depths[0] / total - 0.4) < 0.02 && Math.abs(depths[1] / total - 0.6) < 0.02,
    `${depths} of ${total}`,
  );
  differs(await picture(page, "canvas.map"), map, "a part of the map");
  await page.getByRole("button", { name: "All depths" }).click();
  await settled(page);
  same(await picture(page, "canvas.map"), map, "all of the map");
});

await check("Shift and drag moves the depths in view", async () => {
  const read = () => page.locator("#tracks input").evaluateAll((inputs) => inputs.map((input) => Number(input.value)));
  const total = (await read())[1];
  const cover = page.locator(".tracks .cover").first();
  const box = await cover.boundingBox();
  const y = (part) => box.y + part * box.height;
  await page.mouse.move(box.x + 300, y(0.3));
  await page.mouse.down();
  await page.mouse.move(box.x + 300, y(0.5), { steps: 3 });
  await page.mouse.up();
  await page.keyboard.down("Shift");
  await page.mouse.move(box.x + 300, y(0.8));
  await page.mouse.down();
  await page.mouse.move(box.x + 300, y(0.3), { steps: 5 });
  await page.mouse.up();
  await page.keyboard.up("Shift");
  const [from, to] = (await read()).map((depth) => depth / total);
  // Half of what was in view, a fifth of all, further down.
  assert.ok(Math.abs(from - 0.4) < 0.02 && Math.abs(to - 0.6) < 0.02, `${from} to ${to}`);
  await page.getByRole("button", { name: "All depths" }).click();
});

await check("the pointer is read on every track", async () => {
  const box = await page.locator(".tracks .cover").first().boundingBox();
  await page.mouse.move(box.x + 300, box.y + 0.5 * box.height);
  const readouts = await page.locator(".tracks .readout.middle:not(.small)").allTextContents();
  assert.ok(readouts.length === 8 && readouts.every((readout) => /\d/.test(readout)), JSON.stringify(readouts));
});

await check("time histories zoom together", async () => {
  const before = await picture(page, ".history:nth-of-type(3) canvas");
  const over = page.locator(".history .u-over").first();
  await over.scrollIntoViewIfNeeded();
  const box = await over.boundingBox();
  await page.mouse.move(box.x + 0.3 * box.width, box.y + 50);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.7 * box.width, box.y + 52, { steps: 4 });
  await page.mouse.up();
  await settled(page);
  differs(await picture(page, ".history:nth-of-type(3) canvas"), before, "a part of the time");
  await over.dblclick();
  await settled(page);
  same(await picture(page, ".history:nth-of-type(3) canvas"), before, "all of the time");
});

await check("what the bit does is drawn", async () => {
  const titles = await page.locator("#bit h3").allTextContents();
  for (const title of ["Rate of penetration", "Weight on bit", "Torque on bit", "Torque against weight"])
    assert.ok(
      titles.some((of) => of.startsWith(title)),
      `${title} in ${titles}`,
    );
  const count = await page.locator("#bit canvas").count();
  for (let i = 0; i < count; i++) {
    await page.evaluate((i) => document.querySelectorAll("#bit canvas")[i].setAttribute("id", `bit-${i}`), i);
    assert.ok((await colours(page, `#bit-${i}`)) > 4, `${titles[i]} is not blank`);
  }
  assert.equal(await page.locator("#bottom").count(), 0, "no bottom without solid rock");
});

await check("another operation has its own answer, and no bit where it does not drill", async () => {
  const before = await page.locator(".answer .number").allTextContents();
  await page.locator(".operations button").first().click();
  await settled(page);
  assert.notDeepEqual(await page.locator(".answer .number").allTextContents(), before);
  assert.ok(!(await page.locator("#bit").isVisible()), "a trip drills nothing");
});

await check("dark looks different, and light comes back", async () => {
  const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const light = await ground();
  await page.click(".controls [data-value=dark]");
  assert.notEqual(await ground(), light);
  await page.click(".controls [data-value=light]");
  assert.equal(await ground(), light);
});

await check("names are text, whatever they hold", async () => {
  const title = await page.evaluate(() => JSON.parse(document.getElementById("report").textContent).title);
  assert.equal(await text(page, "h1"), title);
  assert.equal(await page.evaluate(() => window.harmed), undefined);
});

await close(page, 20_000, "the page");
