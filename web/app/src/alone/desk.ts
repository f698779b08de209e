// Workers of the page: each has its own engine, and answers one request at a time.

import { ApiError } from "../api/client";
import type { Call, Left } from "./engine";
import type { FromWorker, ToWorker } from "./messages";

/** The compressed engine, unpacked here so that any file server is sufficient. */
const ENGINE = "engine.bin";

async function fetchEngine(): Promise<WebAssembly.Module> {
  const response = await fetch(new URL(ENGINE, document.baseURI));
  if (!response.ok || !response.body) throw new ApiError(response.status, "unreachable", `The engine file (${ENGINE}) is missing in the folder of this page.`);
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

interface Pending {
  call: Call;
  request: string;
  bytes: ArrayBuffer | undefined;
  answered: (left: Left) => void;
  failed: (problem: unknown) => void;
}

/** A worker. */
export class Desk {
  /** Called with each message of a live string, and with the reason when it ends. */
  onMessage: ((message: string | ArrayBuffer) => void) | null = null;
  ended: ((why: string) => void) | null = null;
  #worker: Worker | null = null;
  #pending = new Map<number, Pending>();
  #queue: number[] = [];
  #number = 0;
  #busy = false;

  /** Sends a request; `signal` cancels it. */
  async ask(call: Call, request: object, bytes?: ArrayBuffer, signal?: AbortSignal): Promise<Left> {
    const engine = await compiled();
    signal?.throwIfAborted();
    const number = this.#number++;
    return new Promise((answered, failed) => {
      this.#pending.set(number, { call, request: JSON.stringify(request), bytes, answered, failed });
      this.#queue.push(number);
      signal?.addEventListener("abort", () => this.#giveUp(number), { once: true });
      this.#next(engine);
    });
  }

  #next(engine: WebAssembly.Module): void {
    const number = this.#queue[0];
    const request = number === undefined ? undefined : this.#pending.get(number);
    if (this.#busy || number === undefined || !request) return;
    this.#worker ??= this.#begin(engine);
    this.#busy = true;
    this.say({ number, call: request.call, request: request.request, ...(request.bytes ? { bytes: request.bytes } : {}) });
  }

  #begin(engine: WebAssembly.Module): Worker {
    const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
    worker.onmessage = ({ data }: MessageEvent<FromWorker>) => this.#hear(data);
    worker.onerror = ({ message }) => {
      for (const number of [...this.#pending.keys()]) this.#done(number, (request) => request.failed(new ApiError(500, "failed", message)));
      this.end();
    };
    worker.postMessage({ module: engine } satisfies ToWorker);
    return worker;
  }

  #hear(data: FromWorker): void {
    if ("message" in data) this.onMessage?.(data.message);
    else if (!("number" in data)) {
      this.ended?.(data.ended);
      this.end();
    } else if ("ended" in data) {
      // The next request starts another worker.
      this.end();
      this.ended?.(data.ended);
      this.#done(data.number, (request) => request.failed(new ApiError(500, "failed", data.ended)));
    } else this.#done(data.number, (request) => request.answered(data));
  }

  #done(number: number, settle: (request: Pending) => void): void {
    const request = this.#pending.get(number);
    this.#pending.delete(number);
    this.#queue = this.#queue.filter((other) => other !== number);
    this.#busy = false;
    if (request) settle(request);
    void compiled().then((engine) => this.#next(engine));
  }

  #giveUp(number: number): void {
    if (!this.#pending.has(number)) return;
    const going = this.#busy && this.#queue[0] === number;
    const aborted = (request: Pending) => request.failed(new DOMException("the request was cancelled", "AbortError"));
    if (going) {
      this.end();
      this.#done(number, aborted);
      return;
    }
    const request = this.#pending.get(number);
    this.#pending.delete(number);
    this.#queue = this.#queue.filter((other) => other !== number);
    if (request) aborted(request);
  }

  /** Sends a message to the worker. */
  say(message: ToWorker): void {
    this.#worker?.postMessage(message);
  }

  /** Terminates the worker, whatever its state. */
  end(): void {
    this.#worker?.terminate();
    this.#worker = null;
    this.#busy = false;
  }
}

const reader = new TextDecoder();

/** Returns the result in an answer, or throws its error. */
export function unpack<T>({ status, bytes }: Left): T {
  const body: unknown = JSON.parse(reader.decode(bytes));
  if (status === 200) return body as T;
  const { error } = body as { error: { kind: string; message: string; diagnostics?: ApiError["diagnostics"] } };
  throw new ApiError(status, error.kind, error.message, error.diagnostics ?? []);
}
