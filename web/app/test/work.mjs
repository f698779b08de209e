// Jobs started from the page, their results, comparison and import: by mouse and by keys, over a reload of the page
// and the end of the program.
import { existsSync, readFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { accessible, check, equal, openPage, picture, run, serve, until } from "./harness.mjs";

const CASES = resolve(dirname(fileURLToPath(import.meta.url)), "../../../cases");
const text = (name) => readFileSync(join(CASES, name), "utf8");

/** A vertical well with dynamics of a given simulated time, with a checkpoint every second. */
const dynamic = (duration) =>
  text("vertical.toml")
    .replace('["trip_out", "trip_in", "rotate_off_bottom", "drill", "slide"]', '"rotate_off_bottom"')
    .replace('duration = "10 s"', `duration = "${duration}"\ncheckpoint_interval = "1 s"`);

async function open(files = {}, options = {}) {
  const served = await serve(files);
  const page = await openPage(served, options);
  const end = async () => {
    equal(page.complaints, [], "the page complains");
    await page.context().close();
    await served.stop();
  };
  return { served, page, end };
}

const show = (page, hash) => page.evaluate((to) => (location.hash = to), hash);
const jobs = (page) => page.locator("article.job");
const state = (page, place = 0) => jobs(page).nth(place).locator(".state").textContent();
const ends = (page, word, place = 0) => until(async () => (await state(page, place)) === word, `the job is ${word}`, 120_000);
const button = (page, name) => page.getByRole("button", { name });

/** Starts a command by the mouse on the work screen. */
async function start(page, command) {
  await page.getByLabel("Command").selectOption({ label: command });
  await button(page, "Start").click();
  await until(async () => (await jobs(page).count()) > 0, "a job is listed");
}

/** The frame with the page of results. */
async function frame(page) {
  const found = page.frameLocator("iframe");
  await found.locator("h1").first().waitFor({ timeout: 30_000 });
  return page.frames().find((frame) => frame.url().includes("/pages/"));
}

await run({
  async "from an empty folder to a printed plan"() {
    const { served, page, end } = await open();
    await button(page, /^Open an example/).click();
    await page.getByText("A slant well of 1200 m").click();
    await button(page, "Make the case").click();
    await until(() => existsSync(join(served.folder, "slant.toml")), "the case is written");
    await page.getByRole("link", { name: "Work", exact: true }).click();
    await start(page, "Plan");
    await ends(page, "finished");
    await jobs(page).first().getByRole("link", { name: "Results" }).click();
    const inner = await frame(page);
    await inner.evaluate(() => (window.print = () => (document.title = "printed")));
    await button(page, "Print this page").click();
    await until(async () => (await inner.title()) === "printed", "the page in the frame prints");
    const paper = await page.context().newPage();
    await paper.goto(inner.url());
    const pdf = await paper.pdf();
    check(pdf.subarray(0, 4).toString() === "%PDF" && pdf.length > 20_000, `the plan on paper is ${pdf.length} bytes`);
    await paper.close();
    await end();
  },

  async "a plan by keys alone"() {
    const { page, end } = await open({ "slant.toml": text("slant.toml") });
    await page.getByRole("link", { name: "Work", exact: true }).focus();
    await page.keyboard.press("Enter");
    await page.getByLabel("Command").waitFor();
    /** Presses Tab until an element of this name has the focus. */
    const tabTo = async (name) => {
      for (let k = 0; k < 80; k += 1) {
        await page.keyboard.press("Tab");
        const at = await page.evaluate(() => (document.activeElement?.labels?.[0] ?? document.activeElement)?.textContent?.trim() ?? "");
        if (at === name) return;
      }
      throw new Error(`Tab does not reach ${name}`);
    };
    await tabTo("Command");
    await page.keyboard.press("r");
    equal(await page.getByLabel("Command").inputValue(), "run", "a letter chooses the command");
    await tabTo("soft");
    await page.keyboard.press("Space");
    await tabTo("Start");
    await page.keyboard.press("Enter");
    await ends(page, "finished");
    await tabTo("Results");
    await page.keyboard.press("Enter");
    await frame(page);
    check((await page.getByRole("heading", { name: "Files" }).count()) === 1, "the files are listed");
    await end();
  },

  async "a job is followed over a reload, stopped and resumed"() {
    const { page, end } = await open({ "a.toml": dynamic("15000 s") });
    await show(page, "#/work");
    await start(page, "Run");
    const bar = page.locator("progress[value]").first();
    const reached = async () => Number(await bar.getAttribute("value"));
    await bar.waitFor({ timeout: 60_000 });
    const [before] = [await reached()];
    await until(async () => (await reached()) > before, "the bar moves", 20_000);
    check(/left/.test(await page.locator(".bar .what").first().textContent()), "the remaining time is displayed");
    await picture(page, "work-running");
    await page.reload();
    await bar.waitFor({ timeout: 20_000 });
    const again = await reached();
    check(again > before, `after the reload it continues from ${again}, not from ${before}`);
    await until(async () => (await reached()) > again, "the bar moves after the reload", 20_000);
    await button(page, "Stop").click();
    await ends(page, "stopped");
    await button(page, "Resume").click();
    await ends(page, "running");
    await bar.waitFor({ timeout: 60_000 });
    check((await reached()) >= again, "it continues where it stopped");
    await button(page, "Stop").click();
    await ends(page, "stopped");
    // A new start is refused as by the command line, with the possible actions.
    await start(page, "Run");
    await until(async () => (await jobs(page).count()) === 2, "a second job is listed");
    await until(async () => (await page.getByText("holds an unfinished run of this case").count()) === 1, "the refusal is displayed");
    await button(page, "Restart…").click();
    await button(page, "Replace the unfinished results").click();
    await until(async () => (await page.getByText("holds an unfinished run of this case").count()) === 0, "the refusal is gone");
    await ends(page, "running");
    await end();
  },

  async "two tabs see the same job"() {
    const { served, page, end } = await open({ "a.toml": dynamic("15000 s") });
    await show(page, "#/work");
    const other = await openPage(served);
    await show(other, "#/work");
    await start(page, "Run");
    await other.locator("progress").first().waitFor({ timeout: 20_000 });
    await button(other, "Stop").click();
    await ends(page, "stopped");
    await other.context().close();
    await end();
  },

  async "the unfinished job of a killed program is offered and completed"() {
    const { served, page } = await open({ "a.toml": dynamic("3000 s") });
    await show(page, "#/work");
    await start(page, "Run");
    await until(() => existsSync(join(served.folder, "out/Vertical well/checkpoint.bin")), "a checkpoint is written", 60_000);
    await served.kill("SIGKILL");
    await until(async () => (await page.getByText("The server does not answer").count()) > 0, "the page reports that the server is gone", 20_000);
    await page.context().close();
    await served.start();
    const next = await openPage(served);
    await show(next, "#/work");
    await until(async () => (await jobs(next).count()) === 1, "the job is known");
    equal(await state(next), "interrupted", "its state");
    await picture(next, "work-interrupted");
    await button(next, "Resume").click();
    await ends(next, "finished");
    equal(next.complaints, [], "the page complains");
    await next.context().close();
    await served.stop();
  },

  async "a page of results cannot send requests to the server"() {
    const { page, end } = await open({ "slant.toml": text("slant.toml") });
    await show(page, "#/work");
    await start(page, "Plan");
    await ends(page, "finished");
    await jobs(page).first().getByRole("link", { name: "Results" }).click();
    const inner = await frame(page);
    const found = await inner.evaluate(async () => {
      const outcome = async (work) => work().then(() => "answered", () => "refused");
      const tried = (work) => {
        try {
          return work() ?? "nothing";
        } catch {
          return "refused";
        }
      };
      return {
        origin: self.origin,
        read: await outcome(() => fetch("/api/cases")),
        write: await outcome(() => fetch("/api/jobs", { method: "POST", body: "{}" })),
        blind: await outcome(() => fetch("/api/jobs", { method: "POST", mode: "no-cors", body: "{}" })),
        beacon: navigator.sendBeacon("/api/jobs", "{}") ? "queued" : "refused",
        events: await new Promise((done) => {
          const source = new EventSource("/api/jobs/0/events");
          source.onerror = () => done("refused");
          source.onopen = () => done("answered");
        }),
        parent: tried(() => parent.document.title),
        cookie: tried(() => document.cookie),
        storage: tried(() => localStorage.length),
        top: tried(() => { top.location.href = "about:blank"; }),
      };
    });
    equal([found.origin, found.read, found.write, found.blind, found.events], ["null", "refused", "refused", "refused", "refused"], "requests of the page");
    equal([found.parent, found.cookie, found.storage, found.top], ["refused", "refused", "refused", "refused"], "access of the page");
    check((await page.url()).includes("#/results/"), "the app is still there");
    equal(await page.evaluate(async () => (await (await fetch("/api/jobs")).json()).length), 1, "jobs after the requests of the page");
    // The app follows a link of the page to a file next to it.
    await page.reload();
    const again = await frame(page);
    const download = page.waitForEvent("download");
    await again.locator('a[href="plan.xlsx"]').first().click();
    equal((await download).suggestedFilename(), "plan.xlsx", "the file that the link leads to");
    page.complaints = page.complaints.filter((complaint) => !/Content Security Policy|sandbox|Unsafe attempt|frame/i.test(complaint));
    await end();
  },

  async "results are compared"() {
    const { page, end } = await open({ "slant.toml": text("slant.toml") });
    await show(page, "#/work");
    await start(page, "Plan");
    await ends(page, "finished");
    await page.getByText("Values for this job only").click();
    await page.getByLabel(/One key with its value per line/).fill("mud.density=1.4sg");
    await button(page, "Start").click();
    await until(async () => (await jobs(page).count()) === 2, "a second job is listed");
    await ends(page, "finished");
    const boxes = page.getByRole("checkbox", { name: /^Compare / });
    await until(async () => (await boxes.count()) === 2, "two results are listed");
    for (const k of [0, 1]) await boxes.nth(k).check();
    await button(page, "Compare").click();
    await page.getByRole("heading", { name: "Inputs that differ" }).waitFor();
    await page.getByText("mud.density_kg_per_m3").waitFor();
    const row = page.locator("tr", { hasText: "mud.density_kg_per_m3" });
    equal((await row.locator("td").allTextContents()).sort(), ["1100.0", "1400.0"], "the densities");
    await page.locator("path.curve").first().waitFor();
    equal(await page.locator("path.curve").count(), 2, "curves over each other");
    await button(page, "field").click();
    await until(async () => (await page.getByText(/Hook load, klbf/).count()) > 0, "the units of the header hold");
    await accessible(page, "comparison");
    await picture(page, "compare-1440");
    await end();
  },

  async "files are questioned, reviewed and then written"() {
    const { served, page, end } = await open();
    await page.getByRole("link", { name: "Import", exact: true }).click();
    const survey = { name: "survey.csv", mimeType: "text/csv", buffer: Buffer.from("MD,Inc,Azi\n0,0,0\n1000,0,0\n1100,3,45\n") };
    await page.getByLabel("Drop files here, or choose them").setInputFiles(survey);
    await page.getByRole("alert").filter({ hasText: "has no unit" }).waitFor();
    await picture(page, "import-question");
    await page.getByLabel(/^Unit:/).selectOption("ft");
    await button(page, "Apply").click();
    await page.getByRole("heading", { name: "Resulting case" }).waitFor();
    check((await page.getByLabel("All values with their sources").inputValue()).includes('"1100 ft"'), "the mapping is shown");
    check(!existsSync(join(served.folder, "survey.toml")), "no file is written before the request");
    await accessible(page, "import");
    await picture(page, "import-shown");
    await page.getByLabel("Name of the case file").fill("well.toml");
    await page.keyboard.press("Enter");
    await until(() => existsSync(join(served.folder, "well.toml")), "the case is written");
    await until(() => page.url().includes("#/work/"), "the case is opened");
    await end();
  },

  async "files are dropped on the list of cases"() {
    const { served, page, end } = await open();
    const drop = (files) =>
      page.evaluate((files) => {
        const dataTransfer = new DataTransfer();
        for (const [name, text] of files) dataTransfer.items.add(new File([text], name));
        const area = document.querySelector("main section");
        for (const type of ["dragover", "drop"]) {
          area.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
        }
      }, files);
    await page.getByRole("button", { name: /^Open an example/ }).waitFor();
    const mine = text("vertical.toml");
    await drop([["mine.toml", mine]]);
    await until(() => page.url().includes("#/case/"), "a case is opened");
    equal(served.read("mine.toml"), mine, "it is written as it was");
    await page.getByRole("link", { name: "Cases", exact: true }).click();
    await page.getByRole("button", { name: /^Open an example/ }).waitFor();
    await drop([["mine.toml", mine], ["survey.csv", "MD (m),Inc (deg),Azi (deg)\n0,0,0\n1000,0,0\n1100,3,45\n"]]);
    await page.getByRole("heading", { name: "Resulting case" }).waitFor();
    check(existsSync(join(served.folder, "mine-2.toml")), "a name that is taken gets a number");
    check(!existsSync(join(served.folder, "survey.toml")), "no case is made from other files before the request");
    await end();
  },

  async "at all widths, light and dark"() {
    const { served, page, end } = await open({ "slant.toml": text("slant.toml"), "bad.toml": text("slant.toml").replace("friction", "frictoin") });
    await show(page, "#/work");
    const cases = page.getByLabel("Case", { exact: true });
    const good = await cases.locator("option", { hasText: "slant.toml" }).getAttribute("value");
    await cases.selectOption(good);
    await start(page, "Plan");
    await ends(page, "finished");
    await page.getByLabel("Command").selectOption({ label: "Reach" });
    await button(page, "Start").click();
    await until(async () => (await jobs(page).count()) === 2, "a second job is listed");
    await ends(page, "finished");
    const bad = await cases.locator("option", { hasText: "bad.toml" }).getAttribute("value");
    await cases.selectOption(bad);
    await button(page, "Start").click();
    await page.getByText("did you mean").first().waitFor().catch(() => page.getByText("not valid").waitFor());
    await cases.selectOption(good);
    const results = await jobs(page).getByRole("link", { name: "Results" }).first().getAttribute("href");
    for (const width of [1440, 900, 420])
      for (const theme of ["light", "dark"]) {
        const other = await openPage(served, { width, theme });
        for (const [name, hash] of [["work", "#/work"], ["results", results], ["import", "#/import"]]) {
          await show(other, hash);
          await other.locator("h1").first().waitFor();
          if (name === "results") await frame(other);
          else await other.waitForTimeout(300);
          await accessible(other, `${name} at ${width}, ${theme}`);
          const wide = await other.evaluate(() => document.documentElement.scrollWidth - innerWidth);
          check(wide <= 0, `${name} at ${width} is ${wide} px too wide`);
          await picture(other, `${name}-${width}-${theme}`);
        }
        await other.context().close();
      }
    page.complaints = page.complaints.filter((complaint) => !/422/.test(complaint));
    await end();
  },
});
