// Connection of a page to a live string: received and sent messages.

import { lineTo } from "#asked";
import type { Layout, Pace, SetPoints, Status } from "../api/live";
import { OPEN, type Line } from "../api/line";
import type { UnitSet } from "../settings.svelte";
import { Samples } from "./samples";

const SAMPLES = 1;
const HEAD_BYTES = 24;

/** Time until a page reconnects, ms. */
const AGAIN = [250, 500, 1000, 2000, 4000];

/** State of the whole string at one time. */
export interface Frame {
  time_s: number;
  nodes: number;
  epoch: number;
  /** Column after column. */
  values: Float32Array;
}

/** A live string as this page sees it. */
export class Connection {
  layout = $state.raw<Layout | null>(null);
  status = $state.raw<Status | null>(null);
  connected = $state(false);
  /** Message of the last refusal, until the next request. */
  refused = $state<string | null>(null);
  samples: Samples | null = null;
  frame: Frame | null = null;
  /** Number of received frames. */
  frames = 0;
  readonly id: string;
  #socket: Line | null = null;
  #tries = 0;
  #timer = 0;
  #closed = false;
  #units: UnitSet | null = null;

  constructor(id: string) {
    this.id = id;
    this.#open();
  }

  #open(): void {
    const socket = lineTo(this.id);
    this.#socket = socket;
    socket.onopen = () => {
      this.connected = true;
      this.#tries = 0;
      if (this.samples) this.#send({ have: { epoch: this.samples.epoch, next: this.samples.next } });
      if (this.#units) this.#send({ units: this.#units });
    };
    socket.onmessage = ({ data }) => {
      if (typeof data === "string") this.#hear(data);
      else this.#take(data);
    };
    socket.onclose = () => {
      this.connected = false;
      if (this.#closed || this.status?.state === "ended") return;
      this.#timer = window.setTimeout(() => this.#open(), AGAIN[Math.min(this.#tries++, AGAIN.length - 1)]);
    };
  }

  #hear(text: string): void {
    const message = JSON.parse(text) as
      | ({ type: "layout" } & Layout)
      | ({ type: "status" } & Status)
      | { type: "refused"; message: string };
    if (message.type === "status") this.status = message;
    else if (message.type === "refused") this.refused = message.message;
    else if (!this.layout) {
      this.samples = new Samples(message.samples.length, message.samples_kept, message.sample_interval_s);
      this.layout = message;
    }
  }

  #take(data: ArrayBuffer): void {
    const head = new DataView(data, 0, HEAD_BYTES);
    const [kind, count, epoch] = [head.getUint32(0, true), head.getUint32(4, true), head.getUint32(8, true)];
    const place = head.getFloat64(16, true);
    const values = new Float32Array(data, HEAD_BYTES);
    if (kind === SAMPLES) this.samples?.add(epoch, place, count, values);
    else {
      this.frame = { time_s: place, nodes: count, epoch, values };
      this.frames++;
    }
  }

  #say(message: object): void {
    this.refused = null;
    this.#send(message);
  }

  #send(message: object): void {
    if (this.#socket?.readyState === OPEN) this.#socket.send(JSON.stringify(message));
  }

  /** The units of the server's sentences. */
  units(units: UnitSet): void {
    this.#units = units;
    this.#send({ units });
  }

  set(set: SetPoints): void {
    this.#say({ set });
  }

  pace(pace: Pace): void {
    this.#say({ pace });
  }

  run(runs: boolean): void {
    this.#say({ run: runs });
  }

  step(seconds: number): void {
    this.#say({ step: seconds });
  }

  close(): void {
    this.#closed = true;
    clearTimeout(this.#timer);
    this.#socket?.close();
  }
}
