// A quantity along the moving string, depth down the page.

import { AXIS, drawAxis, FONT } from "./axis";
import type { Frame } from "./connection.svelte";
import { colour, Pen, Range } from "./pen";
import { niceAbove, numberText } from "./shown";

/** Returns the value of a profile at a node of a frame. */
export type ValueAt = (frame: Frame, node: number) => number;

const LINES = 56;

/** A profile that draws without allocation. */
export class Profile {
  readonly range: Range;
  readonly #pen: Pen;
  readonly #value: ValueAt;
  readonly #colour: string;
  /** Whether depths are written into it: one of several profiles is enough. */
  readonly #deep: boolean;
  #line = "";
  #grid = "";
  #muted = "";
  #zero = "";

  constructor(canvas: HTMLCanvasElement, value: ValueAt, colour: string, least: number, deep: boolean) {
    this.#pen = new Pen(canvas);
    this.#value = value;
    [this.#colour, this.#deep] = [colour, deep];
    this.range = new Range(least);
    this.dress();
  }

  dress(): void {
    this.#line = colour(this.#colour);
    [this.#grid, this.#muted, this.#zero] = [colour("grid"), colour("muted"), colour("frame")];
  }

  close(): void {
    this.#pen.close();
  }

  /** Whether it must be drawn although nothing has moved. */
  get emptied(): boolean {
    return this.#pen.emptied;
  }

  /** Draws it between two depths. `length` and `factor` are the SI values of the reader's units of depth and quantity. */
  draw(frame: Frame, from_m: number, to_m: number, length: number, factor: number): void {
    const { to, width, height: whole } = this.#pen;
    const height = whole - AXIS;
    this.#pen.emptied = false;
    const { values, nodes } = frame;
    to.clearRect(0, 0, width, whole);
    let [low, high] = [Infinity, -Infinity];
    for (let node = 0; node < nodes; node++) {
      const md = values[node]!;
      if (md < from_m || md > to_m) continue;
      const value = this.#value(frame, node);
      if (value < low) low = value;
      if (value > high) high = value;
    }
    this.range.hold(low, high);
    const { low: least, high: most } = this.range;
    drawAxis(to, width, whole, least, most, factor, this.#grid, this.#muted);
    this.#lines(from_m, to_m, length);
    if (!(most > least)) return;
    const scale = width / (most - least);
    if (least < 0 && most > 0) {
      to.strokeStyle = this.#zero;
      to.beginPath();
      to.moveTo(-least * scale, AXIS);
      to.lineTo(-least * scale, whole);
      to.stroke();
    }
    to.strokeStyle = this.#line;
    to.lineWidth = 1.5;
    to.beginPath();
    let open = false;
    for (let node = 0; node < nodes; node++) {
      const md = values[node]!;
      if (md < from_m || md > to_m) continue;
      const x = (this.#value(frame, node) - least) * scale;
      const y = AXIS + ((md - from_m) / (to_m - from_m)) * height;
      if (open) to.lineTo(x, y);
      else to.moveTo(x, y);
      open = true;
    }
    to.stroke();
  }

  #lines(from_m: number, to_m: number, factor: number): void {
    const { to, width, height: whole } = this.#pen;
    const height = whole - AXIS;
    const step = niceAbove((((to_m - from_m) / factor) * LINES) / height);
    to.lineWidth = 1;
    to.strokeStyle = this.#grid;
    to.fillStyle = this.#muted;
    to.font = FONT;
    to.beginPath();
    for (let at = Math.ceil(from_m / factor / step) * step; at * factor < to_m; at += step) {
      const y = AXIS + Math.round(((at * factor - from_m) / (to_m - from_m)) * height) + 0.5;
      to.moveTo(0, y);
      to.lineTo(width, y);
      if (this.#deep && y > AXIS + 12) to.fillText(numberText(at, 1), 3, y - 3);
    }
    to.stroke();
  }
}
