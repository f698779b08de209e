// Speed of the app: `node bench.mjs`, with a release build and no other load. Median and maximum of ROUNDS rounds.
import { readFileSync } from "node:fs";
import { openPage, run, serve, until } from "./harness.mjs";

const ROUNDS = 10;
const read = (name) => readFileSync(new URL(`../../../cases/${name}`, import.meta.url), "utf8");
const NP13 = { "np13.toml": read("np13-x1042.toml"), "np13-x1042-survey.csv": read("np13-x1042-survey.csv") };

function tell(label, times_ms) {
  const sorted = [...times_ms].sort((a, b) => a - b);
  const [median, most] = [sorted[Math.floor(sorted.length / 2)], sorted.at(-1)].map(Math.round);
  console.log(`     ${label}: ${median} ms, ${most} ms at most`);
}

await run({
  "first paint": async () => {
    const [whole, page_ms] = [[], []];
    for (let round = 0; round <= ROUNDS; round++) {
      const begun = performance.now();
      const served = await serve(NP13);
      const up_ms = performance.now() - begun;
      const page = await openPage(served);
      const painted = await page.evaluate(() => performance.getEntriesByName("first-contentful-paint")[0].startTime);
      // The first round includes the start of the browser.
      if (round > 0) whole.push(up_ms + painted);
      if (round > 0) page_ms.push(painted);
      await page.context().close();
      await served.stop();
    }
    tell("from the start of the program to the first paint", whole);
    tell("of these, the page", page_ms);
  },

  "answers": async () => {
    const served = await serve(NP13);
    const page = await openPage(served);
    const id = await page.evaluate(async () => (await (await fetch("/api/cases")).json())[0].id);
    await page.evaluate((id) => (location.hash = `#/answers/${id}`), id);
    const slider = page.getByLabel("Friction multiplier, each section's own factor", { exact: true });
    await slider.focus();
    const shown = () => page.locator("[data-drawn-ms]").getAttribute("data-drawn-ms", { timeout: 30_000 });
    const times = [];
    for (let round = 0; round < ROUNDS; round++) {
      await page.waitForTimeout(1500);
      const before = await shown();
      await page.keyboard.press("ArrowLeft");
      await until(async () => (await shown()) !== before, "the answer is drawn", 30_000);
      times.push(Number(await shown()));
    }
    tell("from a slider's step to soft and stiff string painted", times);
    console.log(`     ${await page.locator(".took").innerText()}`);
    await served.stop();
  },
});
