// The engine for a worker: the counterpart of crates/browser/src/page.rs.

interface Exports extends WebAssembly.Exports {
  memory: WebAssembly.Memory;
  room(bytes: number): number;
  left(): number;
  left_bytes(): number;
  ask(): number;
  begin(requestBytes: number): number;
  keep(): number;
  kept(): number;
  attend(): void;
  hear(): void;
  go_on(budget_ms: number): number;
  news(): number;
}

/** An answer: its HTTP status and its bytes. */
export interface Left {
  status: number;
  bytes: ArrayBuffer;
}

/** Calls of the engine, other than messages to live strings. */
export type Call = "ask" | "begin" | "keep" | "kept";

const TEXT = 1;
const writer = new TextEncoder();
const reader = new TextDecoder();

export class Engine {
  readonly #exports: Exports;
  /** Reason why it ended, if it did. */
  complaint = "";

  constructor(module: WebAssembly.Module) {
    const page = {
      now_ms: () => performance.now(),
      complain: (place: number, bytes: number) => (this.complaint = reader.decode(new Uint8Array(this.#exports.memory.buffer, place, bytes))),
    };
    // Imports of libraries that are never called here.
    const imports: WebAssembly.Imports = { page };
    for (const { module: from, name } of WebAssembly.Module.imports(module)) {
      if (from === "page") continue;
      imports[from] ??= {};
      imports[from][name] = () => {
        throw new Error(`the import ${name} was called`);
      };
    }
    this.#exports = new WebAssembly.Instance(module, imports).exports as Exports;
  }

  #give(...parts: Uint8Array[]): void {
    const bytes = parts.reduce((sum, part) => sum + part.length, 0);
    let place = this.#exports.room(bytes);
    for (const part of parts) {
      new Uint8Array(this.#exports.memory.buffer, place, part.length).set(part);
      place += part.length;
    }
  }

  #left(): ArrayBuffer {
    const place = this.#exports.left();
    return this.#exports.memory.buffer.slice(place, place + this.#exports.left_bytes()) as ArrayBuffer;
  }

  /** Calls the engine with a request as JSON; `bytes` are those of a saved string, if any. */
  call(call: Call, request: string, bytes?: ArrayBuffer): Left {
    const head = writer.encode(request);
    const rest = bytes ? new Uint8Array(bytes) : new Uint8Array();
    if (call === "kept") {
      this.#give(rest);
      return { status: this.#exports.kept(), bytes: this.#left() };
    }
    this.#give(head, rest);
    const status = call === "begin" ? this.#exports.begin(head.length) : this.#exports[call]();
    return { status, bytes: this.#left() };
  }

  /** Attaches a new viewer to the live string. */
  attend(): void {
    this.#exports.attend();
  }

  /** Sends a message to the live string; returns the reason of a refusal. */
  hear(text: string): string {
    this.#give(writer.encode(text));
    this.#exports.hear();
    return reader.decode(this.#left());
  }

  /** Advances the live string for at most a time, ms; returns the time until the next step is due, ms. */
  goOn(budget_ms: number): number {
    return this.#exports.go_on(budget_ms);
  }

  /** The next message of the live string; null if there is none. */
  news(): string | ArrayBuffer | null {
    const kind = this.#exports.news();
    if (kind === 0) return null;
    const bytes = this.#left();
    return kind === TEXT ? reader.decode(bytes) : bytes;
  }
}
