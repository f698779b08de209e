// Links that let one browser in: the file that the program opens, the printed link, and what stays in the browser.
import { chmodSync, existsSync, mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { pathToFileURL } from "node:url";
import { accessible, browser, check, equal, openPage, run, serve, until } from "./harness.mjs";

/** An empty page of a new browser, which has no cookie. */
const stranger = async () => (await (await browser()).newContext()).newPage();

/** The addresses in the history of a tab. */
async function historyOf(page) {
  const debug = await page.context().newCDPSession(page);
  const { entries } = await debug.send("Page.getNavigationHistory");
  return entries.flatMap(({ url, userTypedURL }) => [url, userTypedURL]);
}

/** The app is open, and neither its address nor the history has the code. */
async function isIn(page, served, code) {
  await page.waitForSelector("#app main");
  check(page.url().startsWith(served.url), `the app is open, not ${page.url()}`);
  const addresses = await historyOf(page);
  check(addresses.every((address) => !address.includes(code)), `the history has the code: ${addresses.join(" ")}`);
  check(!(await page.evaluate(() => document.referrer + document.cookie)).includes(code), "the page has no code");
}

await run({
  "a printed link lets in one browser, once, and the next is printed": async () => {
    const served = await serve();
    const link = await served.link();
    const code = new URL(link).hash.slice(1);
    check(code.length >= 26, "the link has a code");
    const page = await stranger();
    await page.goto(link, { waitUntil: "commit" });
    await isIn(page, served, code);
    // The same browser may load it again.
    await page.goto(link, { waitUntil: "commit" });
    await isIn(page, served, code);
    const other = await stranger();
    await other.goto(link, { waitUntil: "commit" });
    await other.getByText("This link is used up: each link lets in one browser, once").waitFor();
    check(!other.url().includes(code), "the address is replaced nevertheless");
    await accessible(other, "a used link");
    await other.goto(served.url);
    await other.getByText("Use the link that it printed").waitFor();
    await accessible(other, "a stranger");
    const next = await served.link();
    await other.goto(next, { waitUntil: "commit" });
    await isIn(other, served, new URL(next).hash.slice(1));
    await served.stop();
  },

  "a code is typed where the address has none": async () => {
    const served = await serve();
    const page = await stranger();
    await page.goto(new URL("/enter", served.url).href);
    await accessible(page, "the page of a link");
    const code = new URL(await served.link()).hash.slice(1);
    await page.getByLabel("Code").fill(code);
    await page.getByRole("button", { name: "Open" }).click();
    await isIn(page, served, code);
    await served.stop();
  },

  "the program opens a private file, whose command line has no code": async () => {
    const bin = mkdtempSync(join(tmpdir(), "wholestring-bin-"));
    const opened = join(bin, "opened");
    writeFileSync(join(bin, "xdg-open"), `#!/bin/sh\nprintf '%s' "$*" > '${opened}.part'\nmv '${opened}.part' '${opened}'\n`);
    chmodSync(join(bin, "xdg-open"), 0o755);
    const env = { ...process.env, PATH: `${bin}:${process.env.PATH}` };
    const served = await serve({}, { args: [], env });
    await until(() => existsSync(opened), "the browser is started");
    const file = readFileSync(opened, "utf8");
    check(existsSync(file), `a file is opened, not ${file}`);
    equal([statSync(file).mode & 0o777, statSync(dirname(file)).mode & 0o777], [0o600, 0o700], "its rights");
    const code = /name="code" value="(\w+)"/.exec(readFileSync(file, "utf8"))[1];
    check(!file.includes(code), "the path has no code");
    const page = await stranger();
    await page.goto(pathToFileURL(file).href, { waitUntil: "commit" });
    await isIn(page, served, code);
    await until(() => !existsSync(dirname(file)), "the file is deleted after its use");
    await served.stop();
    rmSync(bin, { recursive: true });
  },

  "a server on another port gets no cookie": async () => {
    const served = await serve();
    const page = await openPage(served);
    equal((await page.context().cookies()).map(({ domain }) => domain), [new URL(served.url).hostname], "the cookie's host");
    const cookies = [];
    const other = createServer((request, answer) => {
      cookies.push(request.headers.cookie ?? "");
      answer.writeHead(200, { "content-type": "text/html" }).end("<p>another server</p>");
    });
    await new Promise((listens) => other.listen(0, "127.0.0.1", listens));
    for (const name of ["127.0.0.1", "localhost", "other.localhost"]) {
      await page.goto(`http://${name}:${other.address().port}/`);
    }
    check(cookies.length >= 3 && cookies.every((cookie) => cookie === ""), `cookies were sent: ${cookies.join("; ")}`);
    other.close();
    // The app is still open in this browser.
    await page.goto(served.url);
    await page.waitForSelector("#app main");
    await served.stop();
  },

  "a plain address serves browsers that know no names under localhost": async () => {
    const served = await serve({}, { args: ["--no-browser", "--plain-address"] });
    const page = await openPage(served);
    equal(new URL(page.url()).hostname, "127.0.0.1", "the host");
    await served.stop();
  },
});
