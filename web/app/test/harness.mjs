// Common parts of the browser tests: a served folder, a browser, and the count of tests.
//
// WHOLESTRING is the path of the program; by default, the last build of cargo. WHOLESTRING_PAGE=FOLDER takes the page
// from a folder (`npm run bundle` writes it to crates/app/assets) instead of from the program. SCREENSHOTS=FOLDER
// stores screenshots.
import { spawn } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { get } from "node:http";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { createInterface } from "node:readline";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

const HERE = dirname(fileURLToPath(import.meta.url));
const ROOT = resolve(HERE, "../../..");
const AXE = createRequire(import.meta.url).resolve("axe-core/axe.min.js");
const FLAGS = [
  "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
  "--disable-background-networking", "--disable-component-update", "--disable-sync",
];

/** The program under test. */
export function program() {
  if (process.env.WHOLESTRING) return process.env.WHOLESTRING;
  const target = process.env.CARGO_TARGET_DIR ?? join(ROOT, "target");
  const built = ["debug", "release"].map((profile) => join(target, profile, "wholestring")).filter(existsSync);
  if (built.length === 0) fail(`there is no program in ${target}: run \`cargo build -p wholestring-cli --features app\` first`);
  return built.sort((a, b) => statSync(b).mtimeMs - statSync(a).mtimeMs)[0];
}

/** Ends the test with a sentence. */
export function fail(sentence) {
  console.error(sentence);
  process.exit(1);
}

/** A served folder with these files, at `url`; `link` lets one browser in. `restart` ends the program and restarts it on the folder. */
export async function serve(files = {}, { args = ["--no-browser"], env = process.env } = {}) {
  const folder = mkdtempSync(join(tmpdir(), "wholestring-app-"));
  for (const [name, text] of Object.entries(files)) {
    mkdirSync(dirname(join(folder, name)), { recursive: true });
    writeFileSync(join(folder, name), text);
  }
  const served = { folder, url: "", child: null };
  // Each link that the program prints admits one browser, once; the next one is printed after its use.
  const links = [];
  served.link = async () => {
    await until(() => links.length > 0, "the program prints a link");
    return links.shift();
  };
  served.start = async () => {
    const child = spawn(program(), ["app", folder, "--port", "0", ...args], { stdio: ["ignore", "pipe", "inherit"], env });
    served.child = child;
    children.add(child);
    child.once("exit", () => children.delete(child));
    links.length = 0;
    const lines = createInterface({ input: child.stdout });
    served.url = await new Promise((found, lost) => {
      lines.on("line", (line) => {
        const link = /^http:\/\/\S+$/.exec(line)?.[0];
        if (link) links.push(link);
        if (link) found(new URL("/", link).href);
      });
      child.once("exit", (code) => lost(new Error(`the program ended with ${code} before it served`)));
    });
  };
  served.kill = (signal = "SIGTERM") =>
    new Promise((ended) => {
      if (served.child.exitCode !== null || served.child.signalCode !== null) return ended();
      served.child.once("exit", ended);
      served.child.kill(signal);
    });
  served.restart = async (signal) => {
    await served.kill(signal);
    await served.start();
  };
  served.read = (name) => readFileSync(join(folder, name), "utf8");
  served.write = (name, text) => writeFileSync(join(folder, name), text);
  served.stop = async () => {
    await served.kill();
    rmSync(folder, { recursive: true, force: true });
  };
  await served.start();
  return served;
}

/** Running servers, which are ended with the test. */
const children = new Set();
process.once("exit", () => children.forEach((child) => child.kill("SIGKILL")));

let launched = null;
/** Open pages, for the screenshot of a failure. */
const pages = new Set();

/** The browser, one for all tests. */
export async function browser(flags = []) {
  const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
  if (!existsSync(executablePath)) fail(`there is no browser at ${executablePath}`);
  launched ??= await chromium.launch({ executablePath, args: [...FLAGS, ...flags] });
  return launched;
}

/** A page of the server. Complaints of the page are collected in `page.complaints`. */
export async function openPage(served, { width = 1440, height = 900, theme = "light", permissions = [], flags = [] } = {}) {
  const context = await (await browser(flags)).newContext({ viewport: { width, height }, permissions, colorScheme: theme });
  const page = await context.newPage();
  pages.add(page);
  page.once("close", () => pages.delete(page));
  page.complaints = [];
  page.on("pageerror", (error) => page.complaints.push(String(error)));
  page.on("console", (message) => message.type() === "error" && page.complaints.push(message.text()));
  if (process.env.WHOLESTRING_PAGE) await context.route((url) => !url.pathname.startsWith("/api/"), fromFolder);
  // The page of a link sends its form before it is loaded.
  await page.goto(served.link ? await served.link() : served.url, { waitUntil: "commit" });
  page.setDefaultTimeout(20_000);
  await page.waitForSelector("#app main");
  return page;
}

/** The page from a folder, with the headers of the program. */
async function fromFolder(route) {
  const { pathname, port, host } = new URL(route.request().url());
  const file = join(resolve(process.env.WHOLESTRING_PAGE), pathname === "/" ? "index.html" : pathname);
  if (!existsSync(file)) return route.continue();
  const type = { html: "text/html", js: "text/javascript", css: "text/css" }[file.split(".").at(-1)] ?? "application/octet-stream";
  // Not by name: Node leaves names under `localhost` to the system.
  const { headers } = await new Promise((got, lost) => get({ host: "127.0.0.1", port, path: "/app.css", headers: { host } }, got).once("error", lost));
  const policy = headers["content-security-policy"];
  return route.fulfill({ body: readFileSync(file), headers: { "content-type": type, ...(policy ? { "content-security-policy": policy } : {}) } });
}

/** Fails if axe-core finds a violation in the page. */
export async function accessible(page, label) {
  // Evaluated by the debugger, so that the policy of the page against foreign scripts remains in force.
  await page.evaluate(readFileSync(AXE, "utf8"));
  const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
  const lines = violations.map(({ id, help, nodes }) => `${id}: ${help}\n    ${nodes.slice(0, 5).map(({ html, failureSummary }) => `${html.slice(0, 200)}\n      ${failureSummary.replaceAll("\n", " ")}`).join("\n    ")}`);
  if (lines.length > 0) throw new Error(`${label}: axe-core finds\n  ${lines.join("\n  ")}`);
}

/** Stores a screenshot, if SCREENSHOTS is set. */
export async function picture(page, name) {
  const folder = process.env.SCREENSHOTS;
  if (!folder) return;
  mkdirSync(folder, { recursive: true });
  await page.screenshot({ path: join(folder, `${name}.png`), fullPage: true });
}

/** Fails with a sentence if a condition is false. */
export function check(holds, sentence) {
  if (!holds) throw new Error(sentence);
}

export function equal(found, expected, label) {
  const [a, b] = [JSON.stringify(found), JSON.stringify(expected)];
  check(a === b, `${label}: ${a}, expected ${b}`);
}

/** Waits until a condition is true, for at most a time. */
export async function until(holds, sentence, limit_ms = 15_000) {
  const end = Date.now() + limit_ms;
  for (;;) {
    if (await holds()) return;
    if (Date.now() > end) throw new Error(`${sentence}: not so after ${limit_ms / 1000} s`);
    await new Promise((wake) => setTimeout(wake, 40));
  }
}

/** Runs tests one by one, prints how many passed, and ends the process. ONLY=WORD selects tests by name. */
export async function run(tests) {
  let [passed, failed] = [0, 0];
  const chosen = Object.entries(tests).filter(([name]) => name.includes(process.env.ONLY ?? ""));
  for (const [name, test] of chosen) {
    const begun = Date.now();
    try {
      await test();
      passed += 1;
      console.log(`ok   ${name} (${((Date.now() - begun) / 1000).toFixed(1)} s)`);
    } catch (error) {
      failed += 1;
      console.error(`FAIL ${name}\n  ${error.stack ?? error}`);
      for (const page of pages) {
        if (page.complaints.length > 0) console.error(`  the page complained: ${page.complaints.slice(0, 5).join("; ")}`);
        await picture(page, `failed-${failed}`).catch(() => {});
        await page.context().close().catch(() => {});
      }
    }
  }
  await launched?.close();
  console.log(`${passed} passed, ${failed} failed`);
  process.exit(failed > 0 || passed === 0 ? 1 : 0);
}
