// The browser version of the app: served as files under its own path; its results are compared with those of the program.
//
// PLAYGROUND names the folder; without it, target/playground, as `cargo xtask playground` makes it.
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { gunzipSync } from "node:zlib";
import { accessible, check, equal, fail, openPage, picture, program, run, serve, until } from "./harness.mjs";
import { openCase, showText, tomlText } from "./harness-case.mjs";

const ROOT = resolve(dirname(fileURLToPath(import.meta.url)), "../../..");
const FOLDER = process.env.PLAYGROUND ?? join(ROOT, "target/playground");
const UNDER = "/somewhere/below/";
// Without WebGL, because software rendering of the view in space would disturb the measurement of the engine.
const FLAGS = ["--disable-3d-apis"];
if (!existsSync(join(FOLDER, "engine.bin"))) fail(`there is no page in ${FOLDER}: run \`cargo xtask playground\` first`);

/** A file server without the MIME type of WebAssembly and without compression. */
const server = createServer((request, answer) => {
  const name = request.url.startsWith(UNDER) ? request.url.slice(UNDER.length).split("?")[0] || "index.html" : "";
  const file = join(FOLDER, name);
  if (name === "" || !existsSync(file)) return answer.writeHead(404).end();
  const type = { html: "text/html", js: "text/javascript", css: "text/css" }[name.split(".").at(-1)] ?? "application/octet-stream";
  answer.writeHead(200, { "content-type": type }).end(readFileSync(file));
});
await new Promise((listens) => server.listen(0, "127.0.0.1", listens));
const served = { url: `http://127.0.0.1:${server.address().port}${UNDER}` };

/** An instance of the module of the engine. */
async function instance() {
  const module = await WebAssembly.compile(gunzipSync(readFileSync(join(FOLDER, "engine.bin"))));
  const imports = { page: { now_ms: () => performance.now(), complain: () => {} } };
  for (const { module: from, name } of WebAssembly.Module.imports(module)) (imports[from] ??= {})[name] ??= () => fail(`the import ${name} was called`);
  const { exports: it } = await WebAssembly.instantiate(module, imports);
  const give = (text) => {
    const bytes = new TextEncoder().encode(text);
    // An allocation may grow the memory, which then has another buffer.
    const place = it.room(bytes.length);
    new Uint8Array(it.memory.buffer, place, bytes.length).set(bytes);
    return bytes.length;
  };
  const left = () => Buffer.from(new Uint8Array(it.memory.buffer, it.left(), it.left_bytes()));
  return { it, give, left };
}

/** The engine, with the calls of the page. */
async function engine() {
  const { it, give, left } = await instance();
  return (request) => {
    give(JSON.stringify(request));
    const status = it.ask();
    const body = JSON.parse(left().toString());
    check(status === 200, `${request.asks}: ${status} ${JSON.stringify(body).slice(0, 400)}`);
    return body;
  };
}

/** Time for which a string is driven, s, in whole seconds. */
const DRIVEN_S = 8;
const SAMPLES_PER_S = 100;
/** Number of rows, index of the first and bytes of a message of samples; undefined for other messages. */
const samplesOf = (bytes) => (bytes.readUInt32LE(0) === 1 ? { rows: bytes.readUInt32LE(4), first: bytes.readDoubleLE(16), values: bytes.subarray(24) } : null);

/** Samples of a live string of the engine, as bytes. */
async function drivenAlone(text) {
  const { it, give, left } = await instance();
  const status = it.begin(give(JSON.stringify({ asks: "", id: "a", file: "case.toml", body: { case: "a", text } })));
  check(status === 200, left().toString());
  give(JSON.stringify({ step: DRIVEN_S }));
  it.hear();
  const taken = [];
  for (let rows = 0; rows < DRIVEN_S * SAMPLES_PER_S; ) {
    it.go_on(100);
    for (let kind = it.news(); kind !== 0; kind = it.news()) {
      const samples = kind === 2 ? samplesOf(left()) : null;
      if (!samples) continue;
      taken.push(samples.values);
      rows = samples.first + samples.rows;
    }
  }
  return Buffer.concat(taken);
}

/** The same of a live string of the program. */
async function drivenNatively(text) {
  const native = await serve({ "case.toml": text });
  try {
    const page = await openPage(native);
    const taken = await page.evaluate(
      async ({ driven, most }) => {
        const [{ id: caseId }] = await (await fetch("/api/cases")).json();
        const headers = { "content-type": "application/json" };
        const { id } = await (await fetch("/api/live", { method: "POST", headers, body: JSON.stringify({ case: caseId }) })).json();
        const socket = new WebSocket(`ws://${location.host}/api/live/${id}/socket`);
        socket.binaryType = "arraybuffer";
        socket.onopen = () => socket.send(JSON.stringify({ step: driven }));
        return new Promise((all) => {
          const taken = [];
          socket.onmessage = ({ data }) => {
            if (typeof data === "string") return;
            const [head, place] = [new Uint32Array(data, 0, 2), new Float64Array(data, 16, 1)];
            if (head[0] !== 1) return;
            taken.push([...new Uint8Array(data, 24)]);
            if (place[0] + head[1] >= most) all(taken.flat());
          };
        });
      },
      { driven: DRIVEN_S, most: DRIVEN_S * SAMPLES_PER_S },
    );
    await page.context().close();
    return Buffer.from(taken);
  } finally {
    await native.stop();
  }
}

/** Answer of the program for a case of `cases/`. */
function natively(name) {
  const folder = mkdtempSync(join(tmpdir(), "wholestring-alone-"));
  try {
    const file = join(ROOT, "cases", `${name}.toml`);
    execFileSync(program(), ["run", file, "--quiet", "--set", 'model=["soft", "stiff"]', "-o", join(folder, "out")]);
    return JSON.parse(readFileSync(join(folder, "out/summary.json"), "utf8")).operations;
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

const begin = async (options = {}) => {
  const page = await openPage(served, { flags: FLAGS, ...options });
  page.setDefaultTimeout(60_000);
  await page.getByRole("link", { name: "Cases", exact: true }).waitFor();
  await page.getByRole("article").first().waitFor();
  return page;
};

/** A displayed number of the table of soft and stiff string. */
const keyNumber = async (page, row, model) => {
  const text = await page.locator(".key-numbers tr", { hasText: row }).locator("td").nth(model === "soft" ? 0 : 1).innerText();
  return Number(text.split("was")[0].replaceAll("\u2212", "-").replace(/[^\d.\-].*$/s, ""));
};
const settled = (page) => until(() => page.evaluate(() => document.querySelector(".answers[data-solving]")?.dataset.solving === "false"), "all is solved", 90_000);

await run({
  "soft and stiff string are those of the program": async () => {
    const ask = await engine();
    for (const name of ["slant", "well-b-2235"]) {
      const text = readFileSync(join(ROOT, `cases/${name}.toml`), "utf8");
      const found = ask({ asks: "answer", file: `${name}.toml`, body: { text, models: ["soft", "stiff"] } }).operations;
      const expected = natively(name);
      equal(found.map((one) => [one.model, one.operation]), expected.map((one) => [one.model, one.operation]), "operations");
      for (const [k, one] of found.entries())
        for (const key of ["hook_load_N", "surface_torque_N_m"]) {
          const [a, b] = [one[key], expected[k][key]];
          check(a === b, `${name}, ${one.model} ${one.operation}: ${key} ${a}, the program has ${b}`);
        }
      const assembly = ask({ asks: "assembly", file: `${name}.toml`, body: { text } });
      const curves = ask({ asks: "broomstick", file: `${name}.toml`, body: { text } }).curves;
      check(assembly.length_m > 0 && curves.length > 0, `${name}: assembly and broomstick are answered`);
    }
  },

  "a live string is that of the program": async () => {
    // With sliding, sticking and whirling, a difference in the last digit soon reaches the first.
    const text = readFileSync(join(ROOT, "cases/well-b-2235.toml"), "utf8");
    const [alone, native] = [await drivenAlone(text), await drivenNatively(text)];
    // The last message may have more rows than expected.
    const bytes = Math.min(alone.length, native.length);
    const numbers = bytes / 4;
    check(numbers >= DRIVEN_S * SAMPLES_PER_S * 10 && alone.some((byte) => byte !== 0), `${numbers} numbers`);
    check(alone.subarray(0, bytes).equals(native.subarray(0, bytes)), `of ${numbers} numbers some are not the program's`);
    console.log(`     ${numbers} numbers of ${DRIVEN_S} s, all the same`);
  },

  "a case is edited, answered, and there again after a reload": async () => {
    const page = await begin();
    console.log(`     the list of cases ${((await page.evaluate(() => performance.now())) / 1000).toFixed(2)} s after the request of the page`);
    check((await page.locator("main").innerText()).includes("require the program"), "the page lists the functions that require the program");
    equal(await page.getByRole("link", { name: "Work", exact: true }).count(), 0, "links to work");
    await picture(page, "alone-cases");
    await openCase(page, "Slant well");
    await page.getByRole("navigation", { name: "Sections of the case" }).getByRole("button", { name: "Mud", exact: true }).click();
    const density = page.locator('[data-key="mud.density"]');
    await density.fill("1.31 sg");
    await density.press("Tab");
    await until(async () => (await tomlText(page)).includes("1.31"), "the text has the value typed in the form");
    await page.waitForSelector(".key-numbers");
    await settled(page);
    await page.getByRole("button", { name: "drill", exact: true }).click();
    await picture(page, "alone-case");
    const toml = readFileSync(join(ROOT, "cases/slant.toml"), "utf8");
    const ask = await engine();
    const changed = ask({ asks: "edit", file: "slant.toml", body: { text: toml, changes: [{ set: "mud.density", to: "1.31 sg" }] } }).text;
    for (const model of ["soft", "stiff"]) {
      const { operations } = ask({ asks: "answer", file: "slant.toml", body: { text: changed, models: [model] } });
      const expected = operations.find((one) => one.operation === "drill");
      const number = await keyNumber(page, "Hook load", model);
      check(Math.abs(number - expected.hook_load_N / 1e3) < 0.06, `${model}: ${number} kN is shown, ${expected.hook_load_N} N expected`);
    }
    await page.getByRole("button", { name: "Save", exact: true }).click();
    await until(async () => (await page.locator(".toolbar").innerText()).includes("Saved."), "it is saved");
    await page.reload();
    await showText(page);
    await until(async () => (await tomlText(page)).includes("1.31"), "it is there after a reload");
    await accessible(page, "case alone");
    equal(page.complaints, [], "complaints");
    await page.context().close();
  },

  "a string of 2235 m is driven": async () => {
    const page = await begin();
    await page.evaluate(() => (location.hash = "#/seat/well-b-2235.toml"));
    await page.getByRole("button", { name: /^Begin/ }).first().click();
    await page.getByRole("button", { name: "Run", exact: true }).waitFor();
    const time = async () => Number(await page.locator(".clock").getAttribute("data-time"));
    await page.getByRole("button", { name: "Run", exact: true }).click();
    await until(async () => (await time()) > 1, "it moves", 60_000);
    await page.getByRole("button", { name: "Count" }).click();
    const measure = async (pace, seconds) => {
      await page.getByRole("group", { name: "Pace" }).getByRole("button", { name: pace, exact: true }).click();
      await new Promise((wake) => setTimeout(wake, 1000));
      const [from, since] = [await time(), Date.now()];
      await new Promise((wake) => setTimeout(wake, 1000 * seconds));
      return (1000 * ((await time()) - from)) / (Date.now() - since);
    };
    const [real, most] = [await measure("1×", 10), await measure("max", 10)];
    console.log(`     ${real.toFixed(2)} × real time at the pace 1, ${most.toFixed(1)} × at the fastest`);
    const { updates, frames } = await page.evaluate(() => document.documentElement.dataset);
    console.log(`     ${frames} pictures in a second, ${updates} of them with news`);
    check(real > 0 && most > 0 && Number(updates) > 0, "it moves, and is seen to move");
    const speed = page.getByRole("textbox", { name: "Rotary speed, set" });
    await speed.fill("90");
    await speed.press("Enter");
    await until(async () => (await page.locator(".moments").innerText()).includes("1 change"), "the change is recorded");
    await page.getByRole("button", { name: "Pause" }).click();
    await page.getByRole("button", { name: "Run", exact: true }).waitFor();
    await picture(page, "alone-seat");
    const before = await time();
    await page.locator(".moments select").selectOption({ index: 0 });
    await page.getByRole("button", { name: "Rewind" }).click();
    await until(async () => (await time()) < before, "it is taken back");
    await page.getByRole("button", { name: "Keep in this browser" }).click();
    await page.locator(".said", { hasText: "Kept in its current state" }).waitFor();
    await page.getByRole("button", { name: "End", exact: true }).click();
    await page.getByRole("button", { name: "Restart" }).click();
    await page.getByRole("button", { name: "Continue" }).click();
    await page.getByRole("button", { name: "Run", exact: true }).waitFor();
    equal(page.complaints.filter((one) => !one.includes("WebGL")), [], "complaints");
    await page.context().close();
  },

  "it fits a telephone": async () => {
    const page = await begin({ width: 420, height: 900 });
    await picture(page, "alone-cases-420");
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    check(wide <= 420, `the list is ${wide} px wide`);
    await accessible(page, "cases alone");
    await page.evaluate(() => (location.hash = "#/answers/slant.toml"));
    await page.waitForSelector(".key-numbers");
    await settled(page);
    await picture(page, "alone-answers-420");
    await page.context().close();
  },
});
