// Hours in the driller's seat: `node endurance.mjs` runs NP13-X1042 for 8 simulated hours (HOURS=N: so many) as fast as it
// can, with the seat open in a browser, and prints the memory of the program and of the page. Neither may grow by more
// than 5 % after the first hour, and at the end the page has the time of the program. Run by hand, as it takes minutes.
import { readFileSync } from "node:fs";
import { check, openPage, run, serve } from "./harness.mjs";
import { FLAGS, pace, pause, runs, sit, strips, time } from "./harness-seat.mjs";

const HOURS = Number(process.env.HOURS ?? 8);
const LOOKS_AN_HOUR = 4;
const MOST_GROWTH = 0.05;
const megabytes = (bytes) => (bytes / 1e6).toFixed(1);

/** Memory of a process, bytes (Linux). */
const held = (pid) => 1024 * Number(/VmRSS:\s+(\d+) kB/.exec(readFileSync(`/proc/${pid}/status`, "utf8"))[1]);

/** Memory of the objects of the page after garbage collection, bytes. */
async function heap(session) {
  await session.send("HeapProfiler.collectGarbage");
  const { metrics } = await session.send("Performance.getMetrics");
  return metrics.find(({ name }) => name === "JSHeapUsedSize").value;
}

/**
 * Relative increase of the peak of the last quarter over that of the first, after an hour in which buffers fill. The
 * memory of a page varies by a seventh with data in transfer; a leak raises its peaks.
 */
function growth(looks, valueOf) {
  const after = looks.slice(Math.min(LOOKS_AN_HOUR, Math.floor(looks.length / 4)));
  const part = Math.max(1, Math.floor(after.length / 4));
  return Math.max(...after.slice(-part).map(valueOf)) / Math.max(...after.slice(0, part).map(valueOf)) - 1;
}

await run({
  [`${HOURS} simulated hours at full speed`]: async () => {
    const text = readFileSync(new URL("../../../cases/np13-x1042.toml", import.meta.url), "utf8");
    const served = await serve({ "case.toml": text, "np13-x1042-survey.csv": readFileSync(new URL("../../../cases/np13-x1042-survey.csv", import.meta.url)) });
    const page = await openPage(served, { flags: FLAGS });
    const session = await page.context().newCDPSession(page);
    await session.send("Performance.enable");
    await sit(page);
    await pace(page, "max");
    await runs(page);
    const begun = Date.now();
    const looks = [];
    for (let look = 1; look <= HOURS * LOOKS_AN_HOUR; look++) {
      const until_s = (look * 3600) / LOOKS_AN_HOUR;
      while ((await time(page)) < until_s) await page.waitForTimeout(200);
      looks.push({ program: held(served.child.pid), page: await heap(session) });
      const { program, page: objects } = looks.at(-1);
      console.log(`     ${(until_s / 3600).toFixed(2)} h after ${((Date.now() - begun) / 1000).toFixed(0)} s: program ${megabytes(program)} MB, page ${megabytes(objects)} MB`);
    }
    await pause(page);
    const [{ time_s }] = await page.evaluate(async () => (await fetch("/api/live")).json());
    const seen = await time(page);
    const last = (await strips(page)).at(-1).time_s;
    console.log(`     the program is at ${time_s} s, the page at ${seen} s, its charts at ${last} s`);
    check(Math.abs(seen - time_s) < 1e-6 && Math.abs(last - time_s) < 0.02, "the times of the page and of the program differ");
    for (const key of ["program", "page"]) {
      const more = growth(looks, (look) => look[key]);
      console.log(`     ${key}: ${(100 * more).toFixed(1)} % more at the end than after the first hour`);
      check(more < MOST_GROWTH, `the ${key} grew by ${(100 * more).toFixed(1)} %`);
    }
    await served.stop();
  },
});
