// The list of cases and the editor of a case: by mouse and by keys, from an empty folder on.
import { readFileSync } from "node:fs";
import { accessible, check, equal, openPage, picture, run, serve, until } from "./harness.mjs";
import { cell, cellText, fromClipboard, openCase, quiet, section, showText, toClipboard, tomlText, untilCell, untilToml } from "./harness-case.mjs";

const CASE = `# A slant well.
name = "slant"

[well]
stations = [
    [0, 0, 0],       # vertical
    [400, 0, 0],
    [1000, 30, 0],   # the end
]

[[well.hole]]
kind = "open"
to = "1000 m"
diameter = "8-1/2 in"
friction = 0.3  # a guess

[mud]
density = "1.2 sg"   # of the report

[[string]]
component = "bit"    # PDC
od = "8-1/2 in"
length = "0.3 m"

[[string]]
component = "collar" # spiral
od = "6.75 in"
id = "2.8125 in"
length = "80 m"

[[string]]
component = "drill pipe"
od = "127 mm"
id = "108.6 mm"
mass_per_length = "30 kg/m"
length = "to surface"

[operation]
kind = "trip_out"
`;
const STATIONS = "Survey stations";
const STRING = "Components of the string, from the bit up";
const CLIPBOARD = ["clipboard-read", "clipboard-write"];

async function open(files, options) {
  const served = await serve(files);
  const page = await openPage(served, options);
  return { served, page, end: async () => { quiet(page); await page.context().close(); await served.stop(); } };
}

async function opened(text = CASE, options = {}, more = {}) {
  // The text editor has the lines in view alone: all of a short case, in a tall window.
  const all = await open({ "a.toml": text, ...more }, { permissions: CLIPBOARD, height: 2200, ...options });
  await openCase(all.page, /name = "(.*)"/.exec(text)[1]);
  return all;
}

await run({
  "a case is made of an example by keys alone": async () => {
    const { page, served, end } = await open({});
    await page.getByText("No case in this folder yet").waitFor();
    await accessible(page, "an empty folder");
    await page.keyboard.press("n");
    const dialog = page.getByRole("dialog", { name: "A new case" });
    await dialog.getByRole("radio").first().focus();
    await page.keyboard.press("ArrowDown");
    equal(await dialog.getByLabel("Name of the file").inputValue(), "vertical.toml", "the name that is offered");
    await accessible(page, "a new case");
    // Enter on an example makes the case.
    await page.keyboard.press("Enter");
    await page.waitForSelector(".editor");
    check(served.read("vertical.toml").includes("[well]"), "the file is there");
    await end();
  },

  "a case is copied, renamed and deleted": async () => {
    const { page, served, end } = await open({ "wells/a.toml": CASE });
    await page.getByRole("button", { name: "Copy wells/a.toml" }).click();
    equal(await page.getByLabel("Name of the file").inputValue(), "a-2.toml", "the name of the copy");
    await page.keyboard.press("Enter");
    await page.getByRole("button", { name: "Rename wells/a-2.toml" }).click();
    await page.getByLabel("Name of the file").fill("a.toml");
    await page.keyboard.press("Enter");
    await page.getByRole("alert").getByText("there is a file `a.toml` already").waitFor();
    await page.getByLabel("Name of the file").fill("b");
    await page.keyboard.press("Enter");
    await page.getByRole("article", { name: "wells/b.toml" }).waitFor();
    equal(served.read("wells/b.toml"), CASE, "the copy");
    page.complaints.length = 0; // The browser logs the status 409.
    await page.getByRole("button", { name: "Delete wells/b.toml" }).click();
    await accessible(page, "delete a case");
    await page.getByRole("button", { name: "Cancel" }).click();
    await page.getByRole("button", { name: "Delete wells/b.toml" }).click();
    await page.getByRole("button", { name: "Delete the case" }).click();
    await until(async () => (await page.getByRole("article", { name: "wells/b.toml" }).count()) === 0, "the deleted case is gone");
    equal(served.read("wells/a.toml"), CASE, "the other");
    await end();
  },

  "the grid of stations is worked by keys": async () => {
    const { page, end } = await opened();
    await section(page, "Well");
    const grid = page.getByRole("grid", { name: STATIONS });
    await grid.focus();
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("F2");
    await page.keyboard.press("Escape");
    equal(await cellText(page, STATIONS, 2, 1), "400", "Escape restores the previous text");
    await page.keyboard.type("450");
    await page.keyboard.press("Enter");
    await untilToml(page, "[450, 0, 0]");
    await page.keyboard.press("ArrowRight");
    await page.keyboard.type("0.5 rad");
    await page.keyboard.press("Tab");
    await untilToml(page, '[1000, "0.5 rad", 0],   # the end');
    await untilCell(page, STATIONS, 3, 2, "28.64789");
    // A new row after the last begins with its first cell.
    await page.keyboard.press("Control+End");
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("Home");
    await page.keyboard.type("1200");
    await page.keyboard.press("Tab");
    await untilToml(page, "[1200, 0, 0]");
    await page.keyboard.press("ArrowUp");
    await page.keyboard.press("Control+Delete");
    await until(async () => !(await tomlText(page)).includes("1000,"), "the row is deleted");
    check((await tomlText(page)).includes("# vertical"), "comments stay");
    await page.keyboard.press("Control+z");
    await untilToml(page, '[1000, "0.5 rad", 0]');
    // A range is copied, and pasted further down as new rows.
    await page.keyboard.press("Control+Home");
    await page.keyboard.press("Shift+ArrowDown");
    await page.keyboard.press("Shift+ArrowRight");
    await page.keyboard.press("Control+c");
    await until(async () => (await fromClipboard(page)) === "0\t0\n450\t0", "a range is copied");
    await toClipboard(page, "1300\t2\t3\n1400\t4\t5");
    await page.keyboard.press("Control+End");
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("Home");
    await page.keyboard.press("Control+v");
    await untilToml(page, "[1400, 4, 5]");
    check((await tomlText(page)).includes("[1300, 2, 3]"), "both rows are pasted");
    await end();
  },

  "a survey with its headings is pasted from a spreadsheet": async () => {
    const { page, end } = await opened();
    await section(page, "Well");
    await toClipboard(page, "MD (ft)\tInc (deg)\tAzi (deg)\n0\t0\t0\n1000\t0\t0\n2000\t10\t45\n3500\t30\t45\n");
    await page.getByRole("grid", { name: STATIONS }).focus();
    await page.keyboard.press("Control+v");
    await page.getByText("4 stations from 0 m to 1066.8 m.").waitFor();
    await accessible(page, "paste a survey");
    await page.getByRole("button", { name: "Replace the survey" }).click();
    await untilToml(page, "    [304.8, 0, 0],\n    [609.6, 10, 45],");
    await untilCell(page, STATIONS, 2, 1, "304.8");
    // The dogleg of the last: 20 deg in 1500 ft in one plane.
    await untilCell(page, STATIONS, 4, 4, "1.31");
    await page.getByRole("button", { name: "field", exact: true }).click();
    await untilCell(page, STATIONS, 2, 1, "1000");
    await untilCell(page, STATIONS, 4, 4, "1.33");
    check((await tomlText(page)).includes("[304.8, 0, 0]"), "the text stays as it is written");
    await cell(page, STATIONS, 2, 1).dblclick();
    await page.keyboard.press("Control+a");
    await page.keyboard.type("1100");
    await page.keyboard.press("Enter");
    await untilToml(page, '["1100 ft", 0, 0]');
    await page.getByRole("img", { name: /^Plan view, north up. The well ends/ }).waitFor();
    await page.getByRole("img", { name: /^Vertical section/ }).waitFor();
    await page.getByRole("button", { name: "SI", exact: true }).click();
    await end();
  },

  "a survey in a file is written into the case only after confirmation": async () => {
    const survey = "MD (m),Inc (deg),Azi (deg)\n0,0,0\n400,0,0\n1000,30,0\n";
    const text = CASE.replace(/stations = \[\n[^]*?\n\]/, 'survey = "s.csv"');
    const { page, served, end } = await opened(text, {}, { "s.csv": survey });
    await section(page, "Well");
    await untilCell(page, STATIONS, 3, 1, "1000");
    await page.getByText("3 stations, read from the file s.csv.").waitFor();
    const type = async () => {
      await page.getByRole("grid", { name: STATIONS }).focus();
      await page.keyboard.press("Control+Home");
      await page.keyboard.press("ArrowDown");
      await page.keyboard.type("420");
      await page.keyboard.press("Enter");
    };
    await type();
    await page.getByRole("dialog", { name: "Put the survey into the case?" }).waitFor();
    await accessible(page, "put the survey into the case");
    await page.getByRole("button", { name: "Cancel" }).click();
    equal(await tomlText(page), text, "nothing has changed");
    await type();
    await page.getByRole("button", { name: "Put them into the case" }).last().click();
    await untilToml(page, "[420, 0, 0]");
    check(!(await tomlText(page)).includes("s.csv"), "the file is not named any more");
    equal(served.read("s.csv"), survey, "the file stays");
    await page.keyboard.press("Control+z");
    await untilToml(page, 'survey = "s.csv"');
    await end();
  },

  "components are moved by keys and by the mouse, and filled from the catalogue": async () => {
    const { page, end } = await opened();
    await section(page, "String");
    await page.getByRole("img", { name: /^The string from/ }).waitFor();
    const grid = page.getByRole("grid", { name: STRING });
    await grid.focus();
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("Alt+ArrowUp");
    await untilCell(page, STRING, 1, 1, "collar");
    await until(async () => /component = "collar" # spiral[^]*component = "bit"    # PDC/.test(await tomlText(page)), "text and comments move, too");
    await page.keyboard.press("Control+z");
    await untilCell(page, STRING, 1, 1, "bit");
    // The second row is dragged below the third.
    const from = await cell(page, STRING, 2, 0).boundingBox();
    const to = await cell(page, STRING, 3, 0).boundingBox();
    await page.mouse.move(from.x + 10, from.y + 10);
    await page.mouse.down();
    await page.mouse.move(to.x + 10, to.y + 4);
    await page.mouse.move(to.x + 10, to.y + 16);
    await page.mouse.up();
    await untilCell(page, STRING, 3, 1, "collar");
    await page.keyboard.press("Control+z");
    await untilCell(page, STRING, 2, 1, "collar");
    await cell(page, STRING, 2, 1).click();
    await page.keyboard.press("Control+k");
    await page.getByRole("combobox", { name: /^Words, sizes/ }).fill("collar 6-1/2");
    await page.getByRole("option", { name: /6-1\/2 in x 2-13\/16 in collar/ }).waitFor();
    await accessible(page, "search the catalogue");
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("Enter");
    await untilToml(page, 'catalogue = "6-1/2 in x 2-13/16 in collar"');
    const text = await tomlText(page);
    check(!text.includes("6.75 in") && text.includes('component = "collar" # spiral'), "the entry takes the place of the diameters");
    await page.getByText("Valid.").waitFor();
    await end();
  },

  "either side changes the other, and undo goes over both": async () => {
    const { page, end } = await opened();
    await section(page, "Mud");
    const density = page.getByRole("textbox", { name: "Density" });
    equal(await density.inputValue(), "1200 kg/m³", "the density in the chosen units");
    await density.click();
    equal(await density.inputValue(), "1.2 sg", "the density in the form of the file");
    await density.fill("1300");
    await page.keyboard.press("Enter");
    await untilToml(page, 'density = "1300 kg/m3"   # of the report');
    // Typing in the text updates the form.
    await page.locator(".cm-content").click();
    await page.keyboard.press("Control+f");
    await page.keyboard.type("1300 kg/m3");
    await page.keyboard.press("Enter");
    await page.keyboard.press("Escape");
    await page.keyboard.type("1.4 sg");
    await until(async () => (await density.inputValue()) === "1400 kg/m³", "the form follows the text");
    await page.keyboard.press("Control+z");
    await until(async () => (await density.inputValue()) === "1300 kg/m³", "undo reverts the typed text");
    await page.keyboard.press("Control+z");
    await untilToml(page, 'density = "1.2 sg"   # of the report', "undo reverts the change of the form");
    equal(await tomlText(page), CASE, "all is as it was");
    await page.keyboard.press("Control+Shift+z");
    await page.keyboard.press("Control+y");
    await untilToml(page, "1.4 sg");
    await end();
  },

  "modified values of the panel are applied to the text of the editor, and undone": async () => {
    const { page, end } = await opened();
    const slider = page.getByLabel("Friction multiplier, each section's own factor", { exact: true });
    await slider.waitFor();
    await slider.focus();
    for (let i = 0; i < 10; i++) await page.keyboard.press("ArrowLeft");
    await page.getByRole("button", { name: "Apply to case" }).click();
    const dialog = page.getByRole("dialog", { name: "Apply to case" });
    await dialog.getByText("Friction, open hole to 1000 m").waitFor();
    await dialog.getByRole("button", { name: "Apply", exact: true }).click();
    await untilToml(page, "friction = 0.27  # a guess");
    await page.getByRole("button", { name: "Undo" }).click();
    await until(async () => (await tomlText(page)) === CASE, "undo takes all of it back");
    await end();
  },

  "a mistake is reported at its field, in the text and in a list": async () => {
    const { page, end } = await opened(CASE.replace("friction = 0.3", "friction = 7").replace('"1.2 sg"', '"1.2 bar"'));
    await page.getByText("2 errors").waitFor();
    await page.locator(".cm-lintRange-error").first().waitFor();
    equal(await page.locator(".cm-lintRange-error").allInnerTexts(), ["7", "bar"], "underlined texts");
    await page.getByRole("button", { name: "To the field mud.density" }).click();
    const density = page.getByRole("textbox", { name: "Density" });
    await until(() => density.evaluate((input) => input === document.activeElement), "the field has the focus");
    equal(await density.getAttribute("aria-invalid"), "true", "the field is marked");
    await page.locator(".field .diagnostic").getByText("`bar` is a unit of pressure, not of density").waitFor();
    await page.getByRole("button", { name: "To the text of line 15" }).click();
    await until(() => page.evaluate(() => document.activeElement.shadowRoot?.activeElement?.classList.contains("cm-content")), "the text has the focus");
    await page.getByRole("button", { name: "To the field well.hole.0.friction" }).click();
    await page.getByRole("heading", { level: 2, name: "Hole", exact: true }).waitFor();
    await accessible(page, "a case with errors");
    // With invalid TOML the form waits.
    await page.locator(".cm-content").click();
    await page.keyboard.press("Control+Home");
    await page.keyboard.type("x = \n");
    await page.getByText("The text is not valid TOML").waitFor();
    await page.getByText("a value is missing after `=`").waitFor();
    await accessible(page, "a text that is not valid TOML");
    await end();
  },

  "typed text survives a reload and the end of the server": async () => {
    const { page, served, end } = await opened();
    await section(page, "Mud");
    await page.getByRole("textbox", { name: "Density" }).fill("1350");
    await page.keyboard.press("Enter");
    await page.getByText("kept as a draft").waitFor();
    equal(served.read("a.toml"), CASE, "the file is not written");
    await page.reload();
    await page.getByText("This is a draft of").waitFor();
    await showText(page);
    await untilToml(page, "1350 kg/m3");
    await picture(page, "draft");
    await accessible(page, "a draft");
    await served.restart("SIGKILL");
    const again = await openPage(served, { height: 2200 });
    await again.getByText("unsaved draft").waitFor();
    await openCase(again, "slant");
    await again.getByText("This is a draft of").waitFor();
    await untilToml(again, "1350 kg/m3");
    await again.getByRole("button", { name: "Discard the draft" }).click();
    await until(async () => (await tomlText(again)) === CASE, "the file's text is back");
    await again.getByText("Saved.").waitFor();
    await again.keyboard.press("Control+z");
    await untilToml(again, "1350 kg/m3");
    await again.keyboard.press("Control+s");
    await until(() => served.read("a.toml").includes("1350 kg/m3"), "it is saved");
    await again.getByText("Saved.").waitFor();
    quiet(again);
    await again.context().close();
    page.complaints.length = 0;
    await end();
  },

  "a file that has changed on the disk is not written over unasked": async () => {
    const { page, served, end } = await opened();
    await section(page, "Mud");
    await page.getByRole("textbox", { name: "Density" }).fill("1350");
    await page.keyboard.press("Enter");
    await untilToml(page, "1350");
    const theirs = CASE.replace("a guess", "measured");
    served.write("a.toml", theirs);
    await page.keyboard.press("Control+s");
    const dialog = page.getByRole("dialog", { name: "The file has changed on the disk" });
    await dialog.getByText('+ density = "1350 kg/m3"   # of the report').waitFor();
    await dialog.getByText("− friction = 0.3  # measured").waitFor();
    await accessible(page, "a conflict");
    await picture(page, "conflict");
    page.complaints.length = 0; // The browser logs the status 409.
    await dialog.getByRole("button", { name: "Decide later" }).click();
    equal(served.read("a.toml"), theirs, "theirs stands");
    await page.keyboard.press("Control+s");
    await dialog.getByRole("button", { name: "Use the version of the file" }).click();
    await until(async () => (await tomlText(page)) === theirs, "theirs is shown");
    await page.keyboard.press("Control+z");
    await untilToml(page, "1350");
    served.write("a.toml", CASE);
    await page.keyboard.press("Control+s");
    await dialog.getByRole("button", { name: "Save this version" }).click();
    await until(() => served.read("a.toml").includes("1350"), "ours is saved");
    page.complaints.length = 0;
    // Without unsaved changes, the file of another program is loaded.
    served.write("a.toml", theirs);
    await page.evaluate(() => dispatchEvent(new Event("focus")));
    await page.getByText("The file was changed by another program").waitFor();
    await untilToml(page, "measured");
    await end();
  },

  "two tabs with one case: nothing of either is lost": async () => {
    const { page, served, end } = await opened();
    const other = await openPage(served, { height: 2200 });
    await openCase(other, "slant");
    for (const [tab, density] of [[page, "1350"], [other, "1400"]]) {
      await section(tab, "Mud");
      await tab.getByRole("textbox", { name: "Density" }).fill(density);
      await tab.keyboard.press("Enter");
      await untilToml(tab, density);
    }
    await page.keyboard.press("Control+s");
    await until(() => served.read("a.toml").includes("1350"), "the first tab saves");
    await other.keyboard.press("Control+s");
    const dialog = other.getByRole("dialog", { name: "The file has changed on the disk" });
    await dialog.getByText('− density = "1350 kg/m3"', { exact: false }).waitFor();
    check(served.read("a.toml").includes("1350"), "the first tab's text stands until the second decides");
    await dialog.getByRole("button", { name: "Save this version" }).click();
    await until(() => served.read("a.toml").includes("1400"), "the second tab saves");
    // The first tab has no unsaved changes: it loads the file of the second, and undo restores its own text.
    await page.evaluate(() => dispatchEvent(new Event("focus")));
    await untilToml(page, "1400");
    await page.keyboard.press("Control+z");
    await untilToml(page, "1350");
    await other.context().close();
    await end();
  },

  "no key of the case file is out of reach": async () => {
    const { page, end } = await opened();
    const schema = await page.evaluate(async () => (await fetch("/api/schema")).json());
    const isTable = (part) => part.properties !== undefined || (part.type === "array" && part.items?.properties !== undefined);
    let keys = 0;
    for (const [key, part] of Object.entries(schema.properties)) {
      if (!isTable(part)) continue;
      await section(page, key.charAt(0).toUpperCase() + key.slice(1).replaceAll("_", " "));
      const table = part.properties ?? part.items.properties;
      if (part.items) await page.getByRole("grid").first().focus();
      const closed = page.locator(".forms details:not([open]) > summary");
      while ((await closed.count()) > 0) await closed.first().click();
      const own = Object.keys(table).filter((own) => key !== "well" || (own !== "hole" && own !== "stations"));
      let lacking = own;
      await until(async () => {
        const shown = (await page.locator(".forms").innerText()).toLowerCase();
        lacking = own.filter((one) => !shown.includes(one.replaceAll("_", " ")));
        return lacking.length === 0;
      }, `of [${key}] all keys are there`).catch((error) => {
        throw new Error(`${error.message}: ${lacking.join(", ")} are missing`);
      });
      keys += own.length;
    }
    check(keys > 150, `${keys} keys`);
    // Sets a key that is hidden at first.
    await section(page, "Dynamics");
    await page.getByText(/more keys$/).first().click();
    await page.getByLabel("Find a key").fill("seed");
    await page.getByRole("button", { name: "Seed", exact: true }).click();
    await page.getByRole("textbox", { name: "Seed" }).fill("7");
    await page.keyboard.press("Enter");
    await untilToml(page, "[dynamics]\nseed = 7");
    await end();
  },

  "a pasted survey becomes a case": async () => {
    const { page, served, end } = await open({});
    await page.getByRole("button", { name: /^Paste a survey/ }).click();
    const dialog = page.getByRole("dialog", { name: "A new case from a survey" });
    await dialog.getByLabel(/^Rows with a heading/).fill("MD (ft)\tInc (deg)\tAzi (deg)\n0\t0\t0\n1000\t0\t0\n2000\t10\t45\n3500\t30\t45\n");
    await dialog.getByText("4 stations from 0 m to 1066.8 m.").waitFor();
    await accessible(page, "a case from a survey");
    await dialog.getByLabel("Name of the file").fill("mine");
    await page.keyboard.press("Enter");
    await page.getByRole("heading", { level: 1, name: "mine" }).waitFor();
    const text = served.read("mine.toml");
    for (const words of ["[304.8, 0, 0]", 'to = "1066.8 m"', 'to = "533.4 m"', 'bit_depth = "1066.8 m"', "# vertical down"]) {
      check(text.includes(words) !== words.startsWith("#"), `${words} in the text`);
    }
    await page.getByText("Valid.").waitFor();
    await page.locator(".strip tbody tr").first().waitFor();
    await end();
  },

  "cards have silhouette, verdict and key numbers, are searched and sorted": async () => {
    const read = (name) => readFileSync(new URL(`../../../cases/${name}`, import.meta.url), "utf8");
    const broken = CASE.replace('name = "slant"', 'name = "broken"').replace("friction = 0.3", "friction = 7");
    const { page, end } = await open({ "a.toml": `${CASE}\n[rig]\nhoist_capacity = "250 tf"\n`, "b.toml": read("lateral-that-cannot-be-drilled.toml"), "c.toml": broken });
    const card = (path) => page.getByRole("article", { name: path });
    await card("a.toml").getByText("OK", { exact: true }).waitFor();
    check((await card("a.toml").locator("svg polyline").count()) >= 2, "the well is drawn");
    check(/Hook load\s*\d/.test(await card("a.toml").innerText()), "the hook load is shown");
    // Verdict and sentence are those of the server.
    const cases = await page.evaluate(async () => (await fetch("/api/cases?units=si")).json());
    const { overview } = cases.find(({ path }) => path === "b.toml");
    await card("b.toml").getByText(overview.check.sentence, { exact: false }).waitFor();
    equal(overview.check.severity, "error", "severity of a lateral that cannot be drilled");
    await card("c.toml").getByText("Not valid").waitFor();
    const paths = () => page.getByRole("article").evaluateAll((all) => all.map((one) => one.getAttribute("aria-label")));
    await page.getByLabel("Order").selectOption("severity");
    equal(await paths(), ["c.toml", "b.toml", "a.toml"], "the most severe first");
    await page.keyboard.press("Escape");
    await page.locator("h1").click();
    await page.keyboard.press("/");
    await page.keyboard.type("lateral");
    equal(await paths(), ["b.toml"], "the case that was sought");
    await page.getByRole("searchbox").fill("nothing like it");
    await page.getByText("No case contains").waitFor();
    await accessible(page, "a search without a result");
    equal(await page.title(), "Cases – wholestring", "title");
    await end();
  },

  "a verdict leads to its depth and to its field, and screens of the case to each other": async () => {
    const { page, end } = await open({ "b.toml": readFileSync(new URL("../../../cases/lateral-that-cannot-be-drilled.toml", import.meta.url), "utf8") });
    await page.getByRole("link", { name: "Lateral that cannot be drilled", exact: true }).click();
    const strip = page.getByRole("region", { name: "Verdicts" });
    await strip.locator("tbody tr").first().waitFor();
    equal(await page.title(), "Lateral that cannot be drilled – Case – wholestring", "title");
    // All checks, in the order of severity.
    await strip.getByRole("button", { name: /^All \d+ checks/ }).click();
    const severities = await strip.locator("tbody tr").evaluateAll((rows) => rows.map((row) => /error|warning|note|ok/.exec(row.className)[0]));
    equal(severities, severities.toSorted((a, b) => ["error", "warning", "note", "ok"].indexOf(a) - ["error", "warning", "note", "ok"].indexOf(b)), "severities");
    await accessible(page, "all verdicts");
    await page.waitForSelector(".tracks svg");
    await strip.getByRole("button", { name: /^Buckled to a helix from 0 m/ }).first().click();
    await page.getByRole("heading", { level: 2, name: "String", exact: true }).waitFor();
    await until(() => page.evaluate(() => document.activeElement?.getAttribute("aria-label")?.startsWith("Components of the string") ?? false), "the row of the component has the focus");
    await until(async () => (await page.locator(".tracks .flag").first().getAttribute("visibility")) === "visible", "the cursor is at the depth");
    await strip.getByRole("button", { name: /^Lock-up/ }).first().click();
    await page.getByRole("heading", { level: 2, name: "Hole", exact: true }).waitFor();
    const links = page.getByRole("navigation", { name: "Screens of the case" });
    await links.getByRole("link", { name: "Answers" }).click();
    await page.getByRole("heading", { level: 1, name: /^Answers of/ }).waitFor();
    await page.getByRole("region", { name: "Verdicts" }).getByRole("button", { name: /^Lock-up/ }).first().click();
    await page.getByRole("heading", { level: 2, name: "Hole", exact: true }).waitFor();
    for (const name of ["Run", "Results", "Driller's seat", "Case"]) await links.getByRole("link", { name, exact: true }).click();
    await page.getByRole("region", { name: "Verdicts" }).locator("tbody tr").first().waitFor();
    await end();
  },

  "all sections are accessible, light and dark, wide and narrow": async () => {
    const np13 = (name) => readFileSync(new URL(`../../../cases/${name}`, import.meta.url), "utf8");
    const files = { "np13.toml": np13("np13-x1042.toml"), "np13-x1042-survey.csv": np13("np13-x1042-survey.csv"), "wells/a.toml": CASE };
    for (const theme of ["light", "dark"]) {
      for (const width of [1440, 900, 420]) {
        const { page, end } = await open(files, { width, theme });
        await page.getByRole("link", { name: "slant" }).waitFor();
        await accessible(page, `cases, ${width}, ${theme}`);
        await picture(page, `cases-${width}-${theme}`);
        await openCase(page, "NP13-X1042 at total depth");
        for (const title of ["Case", "Well", "Hole", "String", "Mud", "Operation", "Bit"]) {
          await section(page, title);
          const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
          check(wide <= 0, `${title} at ${width} is ${wide} pixels wider than the window`);
          await accessible(page, `${title}, ${width}, ${theme}`);
          await picture(page, `${title.toLowerCase()}-${width}-${theme}`);
        }
        await end();
      }
    }
  },
});
