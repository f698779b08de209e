// A worker: an engine, and the loop that advances its live string, if it has one.

import { Engine } from "./engine";
import type { FromWorker, ToWorker } from "./messages";

/** Time for which the string is advanced between two checks for messages of the page, ms. */
const BUDGET = 12;

let engine: Engine | null = null;
/** Whether a viewer is attached, and has processed the last message. */
let attended = false;
let timer: ReturnType<typeof setTimeout> | undefined;
const next = new MessageChannel();
/** Whether the next turn is scheduled. */
let due = false;
next.port1.onmessage = () => {
  due = false;
  turn();
};

/** Schedules another turn, after pending messages of the page. */
function soon(): void {
  if (!due) next.port2.postMessage(null);
  due = true;
}

function post(message: FromWorker, moved: Transferable[] = []): void {
  postMessage(message, { transfer: moved });
}

/** Returns the reason why the engine ended; it cannot be used again. */
function ended(problem: unknown): string {
  const why = engine?.complaint || String(problem);
  engine = null;
  return `internal error of the engine: ${why}`;
}

function tell(): void {
  if (!attended || !engine) return;
  for (let news = engine.news(); news !== null; news = engine.news()) {
    if (typeof news === "string") {
      post({ message: news });
      continue;
    }
    attended = false;
    post({ message: news }, [news]);
    // Samples and the frame after them are sent together.
    const frame = engine.news();
    if (frame !== null) post({ message: frame }, typeof frame === "string" ? [] : [frame]);
    return;
  }
}

function turn(): void {
  clearTimeout(timer);
  if (!engine) return;
  try {
    const wait = engine.goOn(BUDGET);
    tell();
    if (wait === 0) soon();
    else if (wait !== Infinity) timer = setTimeout(turn, wait);
  } catch (problem) {
    post({ ended: ended(problem) });
  }
}

onmessage = ({ data }: MessageEvent<ToWorker>) => {
  if ("module" in data) {
    engine = new Engine(data.module);
  } else if ("number" in data) {
    const { number, call, request, bytes } = data;
    try {
      if (!engine) throw new Error("the engine has ended");
      const left = engine.call(call, request, bytes);
      post({ number, ...left }, [left.bytes]);
      if (call === "begin" && left.status === 200) soon();
    } catch (problem) {
      post({ number, ended: ended(problem) });
    }
  } else if ("say" in data) {
    const refused = engine?.hear(data.say) ?? "";
    if (refused !== "") post({ message: refused });
    soon();
  } else {
    if ("attend" in data) engine?.attend();
    attended = true;
    tell();
  }
};
