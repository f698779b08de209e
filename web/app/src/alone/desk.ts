// Workers of the page: each has an engine of its own, and answers one request after the other.

import { ApiError } from "../api/client";
import type { Call, Left } from "./engine";
import type { FromWorker, ToWorker } from "./messages";

/** The engine, compressed. It is unpacked here, so that any server of files will do. */
const ENGINE = "engine.bin";

async function fetchEngine(): Promise<WebAssembly.Module> {
  const response = await fetch(new URL(ENGINE, document.baseURI));
  if (!response.ok || !response.body) throw new ApiError(response.status, "unreachable", `The engine (${ENGINE}) does not lie beside this page.`);
  const unpacked = response.body.pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compileStreaming(new Response(unpacked, { headers: { "content-type": "application/wasm" } }));
}

let module: Promise<WebAssembly.Module> | null = null;
function compiled(): Promise<WebAssembly.Module> {
  module ??= fetchEngine().catch((problem: unknown) => {
    module = null;
    throw problem;
  });
  return module;
}

interface Asked {
  call: Call;
  request: string;
  bytes: ArrayBuffer | undefined;
  answered: (left: Left) => void;
  failed: (problem: unknown) => void;
}

/** A worker. */
export class Desk {
  /** What is told by a live string, and why it has ended. */
  told: ((what: string | ArrayBuffer) => void) | null = null;
  ended: ((why: string) => void) | null = null;
  #worker: Worker | null = null;
  #asked = new Map<number, Asked>();
  #queue: number[] = [];
  #number = 0;
  #busy = false;

  /** Asks; where nobody wants to know any more, what goes on is given up. */
  async ask(call: Call, request: object, bytes?: ArrayBuffer, signal?: AbortSignal): Promise<Left> {
    const engine = await compiled();
    signal?.throwIfAborted();
    const number = this.#number++;
    return new Promise((answered, failed) => {
      this.#asked.set(number, { call, request: JSON.stringify(request), bytes, answered, failed });
      this.#queue.push(number);
      signal?.addEventListener("abort", () => this.#giveUp(number), { once: true });
      this.#next(engine);
    });
  }

  #next(engine: WebAssembly.Module): void {
    const number = this.#queue[0];
    const asked = number === undefined ? undefined : this.#asked.get(number);
    if (this.#busy || number === undefined || !asked) return;
    this.#worker ??= this.#begin(engine);
    this.#busy = true;
    this.say({ number, call: asked.call, request: asked.request, ...(asked.bytes ? { bytes: asked.bytes } : {}) });
  }

  #begin(engine: WebAssembly.Module): Worker {
    const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
    worker.onmessage = ({ data }: MessageEvent<FromWorker>) => this.#hear(data);
    worker.onerror = ({ message }) => {
      for (const number of [...this.#asked.keys()]) this.#done(number, (asked) => asked.failed(new ApiError(500, "failed", message)));
      this.end();
    };
    worker.postMessage({ module: engine } satisfies ToWorker);
    return worker;
  }

  #hear(data: FromWorker): void {
    if ("told" in data) this.told?.(data.told);
    else if (!("number" in data)) {
      this.ended?.(data.ended);
      this.end();
    } else if ("ended" in data) {
      // Another begins with the next request.
      this.end();
      this.ended?.(data.ended);
      this.#done(data.number, (asked) => asked.failed(new ApiError(500, "failed", data.ended)));
    } else this.#done(data.number, (asked) => asked.answered(data));
  }

  #done(number: number, of: (asked: Asked) => void): void {
    const asked = this.#asked.get(number);
    this.#asked.delete(number);
    this.#queue = this.#queue.filter((other) => other !== number);
    this.#busy = false;
    if (asked) of(asked);
    void compiled().then((engine) => this.#next(engine));
  }

  #giveUp(number: number): void {
    if (!this.#asked.has(number)) return;
    const going = this.#busy && this.#queue[0] === number;
    const aborted = (asked: Asked) => asked.failed(new DOMException("nobody waits for it", "AbortError"));
    if (going) {
      this.end();
      this.#done(number, aborted);
      return;
    }
    const asked = this.#asked.get(number);
    this.#asked.delete(number);
    this.#queue = this.#queue.filter((other) => other !== number);
    if (asked) aborted(asked);
  }

  /** Says something to the worker. */
  say(message: ToWorker): void {
    this.#worker?.postMessage(message);
  }

  /** Ends the worker, whatever it does. */
  end(): void {
    this.#worker?.terminate();
    this.#worker = null;
    this.#busy = false;
  }
}

const reader = new TextDecoder();

/** What an answer says: what was asked for, or why not. */
export function said<T>({ status, bytes }: Left): T {
  const told: unknown = JSON.parse(reader.decode(bytes));
  if (status === 200) return told as T;
  const { error } = told as { error: { kind: string; message: string; diagnostics?: ApiError["diagnostics"] } };
  throw new ApiError(status, error.kind, error.message, error.diagnostics ?? []);
}
