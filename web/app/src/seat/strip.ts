// A strip chart: time down the page, the latest at the bottom, as on rigs.

import { colour, Pen, Range } from "./pen";
import type { Samples } from "./samples";
import { clockText, niceAbove } from "./shown";

/** A curve of a strip: its column, the name of its colour, and whether it is a set point. */
export interface Curve {
  column: number;
  colour: string;
  isSet: boolean;
}

/** Pixels between two lines of time. */
const LINES = 64;

/** A strip that draws without allocation, because all buffers are allocated in advance. */
export class Strip {
  readonly range: Range;
  readonly #pen: Pen;
  readonly #curves: readonly Curve[];
  #colours: string[] = [];
  #grid = "";
  #muted = "";

  constructor(canvas: HTMLCanvasElement, curves: readonly Curve[], least: number) {
    this.#pen = new Pen(canvas);
    this.#curves = curves;
    this.range = new Range(least);
    this.dress();
  }

  /** Updates the colours from the page. */
  dress(): void {
    this.#colours = this.#curves.map((curve) => colour(curve.colour));
    [this.#grid, this.#muted] = [colour("grid"), colour("muted")];
  }

  close(): void {
    this.#pen.close();
  }

  /** Draws the last seconds; returns whether the range has changed. */
  draw(samples: Samples, window_s: number): boolean {
    const { to, width, height } = this.#pen;
    to.clearRect(0, 0, width, height);
    const rows = Math.max(Math.round(window_s / samples.interval_s), 1);
    const first = Math.max(samples.first, samples.next - rows);
    const changed = this.#measure(samples, first);
    const end_s = samples.next * samples.interval_s;
    this.#lines(end_s, window_s);
    if (!(this.range.high > this.range.low)) return changed;
    for (let k = 0; k < this.#curves.length; k++) this.#curve(samples, first, rows, k);
    return changed;
  }

  #measure(samples: Samples, first: number): boolean {
    let [low, high] = [Infinity, -Infinity];
    for (let k = 0; k < this.#curves.length; k++) {
      const values = samples.columns[this.#curves[k]!.column]!;
      for (let number = first; number < samples.next; number++) {
        const value = values[samples.place(number)]!;
        if (value < low) low = value;
        if (value > high) high = value;
      }
    }
    return this.range.hold(low, high);
  }

  #lines(end_s: number, window_s: number): void {
    const { to, width, height } = this.#pen;
    const step = Math.max(niceAbove((window_s * LINES) / height), 1);
    to.lineWidth = 1;
    to.strokeStyle = this.#grid;
    to.fillStyle = this.#muted;
    to.font = "10.5px system-ui, sans-serif";
    to.beginPath();
    for (let part = 1; part < 4; part++) {
      const x = Math.round((width * part) / 4) + 0.5;
      to.moveTo(x, 0);
      to.lineTo(x, height);
    }
    for (let at = Math.floor(end_s / step) * step; at > end_s - window_s && at >= 0; at -= step) {
      const y = Math.round(height * (1 - (end_s - at) / window_s)) + 0.5;
      to.moveTo(0, y);
      to.lineTo(width, y);
      if (y > 12 && y < height - 2) to.fillText(clockText(at), 3, y - 3);
    }
    to.stroke();
  }

  /** Draws a curve, with its smallest and largest value in every row of pixels. */
  #curve(samples: Samples, first: number, rows: number, k: number): void {
    const { to, width, height } = this.#pen;
    const { column, isSet } = this.#curves[k]!;
    const values = samples.columns[column]!;
    const scale = width / (this.range.high - this.range.low);
    const begin = samples.next - rows;
    to.strokeStyle = this.#colours[k]!;
    to.lineWidth = isSet ? 1 : 1.5;
    to.globalAlpha = isSet ? 0.6 : 1;
    to.beginPath();
    let open = false;
    let number = first;
    while (number < samples.next) {
      const y = Math.floor(((number - begin) * height) / rows);
      const next = Math.min(Math.max(Math.ceil(begin + ((y + 1) * rows) / height), number + 1), samples.next);
      let [low, high, last] = [Infinity, -Infinity, NaN];
      for (; number < next; number++) {
        const value = values[samples.place(number)]!;
        if (value < low) low = value;
        if (value > high) high = value;
        last = value;
      }
      if (low > high) {
        open = false;
        continue;
      }
      const x = (low - this.range.low) * scale;
      if (open) to.lineTo(x, y);
      else to.moveTo(x, y);
      open = true;
      if (high > low) {
        to.lineTo((high - this.range.low) * scale, y);
        to.lineTo((last - this.range.low) * scale, y);
      }
    }
    to.stroke();
    to.globalAlpha = 1;
  }
}
