// A worker: an engine, and where it has a live string, what takes that forward.

import { Engine } from "./engine";
import type { FromWorker, ToWorker } from "./messages";

/** So long the string goes on between two looks at what the page says, ms. */
const BUDGET = 12;

let engine: Engine | null = null;
/** Whether somebody looks at the string, and has taken what was given last. */
let attended = false;
let timer: ReturnType<typeof setTimeout> | undefined;
const next = new MessageChannel();
/** Whether a turn is on its way. */
let due = false;
next.port1.onmessage = () => {
  due = false;
  turn();
};

/** Takes another turn, once the page was heard. */
function soon(): void {
  if (!due) next.port2.postMessage(null);
  due = true;
}

function post(message: FromWorker, moved: Transferable[] = []): void {
  postMessage(message, { transfer: moved });
}

/** Why the engine ended: it cannot be asked again. */
function ended(problem: unknown): string {
  const why = engine?.complaint || String(problem);
  engine = null;
  return `the engine has met a mistake of its own: ${why}`;
}

function tell(): void {
  if (!attended || !engine) return;
  for (let news = engine.news(); news !== null; news = engine.news()) {
    if (typeof news === "string") {
      post({ told: news });
      continue;
    }
    attended = false;
    post({ told: news }, [news]);
    // Samples and the frame after them go together.
    const frame = engine.news();
    if (frame !== null) post({ told: frame }, typeof frame === "string" ? [] : [frame]);
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
      if (!engine) throw new Error("it has ended");
      const left = engine.call(call, request, bytes);
      post({ number, ...left }, [left.bytes]);
      if (call === "begin" && left.status === 200) soon();
    } catch (problem) {
      post({ number, ended: ended(problem) });
    }
  } else if ("say" in data) {
    const refused = engine?.hear(data.say) ?? "";
    if (refused !== "") post({ told: refused });
    soon();
  } else {
    if ("attend" in data) engine?.attend();
    attended = true;
    tell();
  }
};
