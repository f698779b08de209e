// A quantity along the moving string, depth down the page.

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
  #line = "";
  #grid = "";
  #muted = "";
  #zero = "";

  constructor(canvas: HTMLCanvasElement, value: ValueAt, colour: string, least: number) {
    this.#pen = new Pen(canvas);
    this.#value = value;
    this.#colour = colour;
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

  /** Draws it between two depths; their labels are in the unit of the reader, of `factor` metres. */
  draw(frame: Frame, from_m: number, to_m: number, factor: number): boolean {
    const { to, width, height } = this.#pen;
    const { values, nodes } = frame;
    to.clearRect(0, 0, width, height);
    let [low, high] = [Infinity, -Infinity];
    for (let node = 0; node < nodes; node++) {
      const md = values[node]!;
      if (md < from_m || md > to_m) continue;
      const value = this.#value(frame, node);
      if (value < low) low = value;
      if (value > high) high = value;
    }
    const changed = this.range.hold(low, high);
    this.#lines(from_m, to_m, factor);
    const { low: least, high: most } = this.range;
    if (!(most > least)) return changed;
    const scale = width / (most - least);
    if (least < 0 && most > 0) {
      to.strokeStyle = this.#zero;
      to.beginPath();
      to.moveTo(-least * scale, 0);
      to.lineTo(-least * scale, height);
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
      const y = ((md - from_m) / (to_m - from_m)) * height;
      if (open) to.lineTo(x, y);
      else to.moveTo(x, y);
      open = true;
    }
    to.stroke();
    return changed;
  }

  #lines(from_m: number, to_m: number, factor: number): void {
    const { to, width, height } = this.#pen;
    const step = niceAbove((((to_m - from_m) / factor) * LINES) / height);
    to.lineWidth = 1;
    to.strokeStyle = this.#grid;
    to.fillStyle = this.#muted;
    to.font = "10.5px system-ui, sans-serif";
    to.beginPath();
    for (let at = Math.ceil(from_m / factor / step) * step; at * factor < to_m; at += step) {
      const y = Math.round(((at * factor - from_m) / (to_m - from_m)) * height) + 0.5;
      to.moveTo(0, y);
      to.lineTo(width, y);
      if (y > 12) to.fillText(numberText(at, 1), 3, y - 3);
    }
    to.stroke();
  }
}
