// A strip chart: time along the page, the newest at the bottom or at the top, as on rigs.

import { AXIS, drawAxis, FONT, type DrawnLimit } from "./axis";
import { colour, Pen, Range } from "./pen";
import type { Samples } from "./samples";
import { clockText, niceAbove } from "./shown";

/** A curve of a strip: its column, the name of its colour, and whether it is a set point. */
export interface Curve {
  column: number;
  colour: string;
  isSet: boolean;
}

/** How all strips are drawn. */
export interface Way {
  /** Time in view, s. */
  window_s: number;
  /** Whether the newest sample is at the top. */
  newestAtTop: boolean;
}

/** Pixels between two lines of time. */
const LINES = 64;

/** A limit is within the scale where it is less than this many times the largest value. */
const NEAR = 1.5;

/** A strip that draws without allocation, because all buffers are allocated in advance. */
export class Strip {
  readonly range: Range;
  readonly #pen: Pen;
  readonly #curves: readonly Curve[];
  readonly #limits: readonly DrawnLimit[];
  /** Whether times are written into it: one of several strips is enough. */
  readonly #timed: boolean;
  /** SI value of the unit of the reader. */
  readonly #factor: number;
  #colours: string[] = [];
  #grid = "";
  #muted = "";
  #over = "";
  #paper = "";

  constructor(
    canvas: HTMLCanvasElement, curves: readonly Curve[], least: number,
    limits: readonly DrawnLimit[], factor: number, timed: boolean,
  ) {
    this.#pen = new Pen(canvas);
    [this.#curves, this.#limits, this.#factor, this.#timed] = [curves, limits, factor, timed];
    this.range = new Range(least);
    this.dress();
  }

  /** Updates the colours from the page. */
  dress(): void {
    this.#colours = this.#curves.map((curve) => colour(curve.colour));
    [this.#grid, this.#muted, this.#over, this.#paper] = [colour("grid"), colour("muted"), colour("over"), colour("paper")];
  }

  close(): void {
    this.#pen.close();
  }

  /** Draws the samples in view. */
  draw(samples: Samples, way: Way): void {
    const { to, width, height } = this.#pen;
    to.clearRect(0, 0, width, height);
    const rows = Math.max(Math.round(way.window_s / samples.interval_s), 1);
    const first = Math.max(samples.first, samples.next - rows);
    this.#measure(samples, first);
    const { low, high } = this.range;
    drawAxis(to, width, height, low, high, this.#factor, this.#grid, this.#muted);
    this.#times(samples.next * samples.interval_s, way);
    if (!(high > low)) return;
    for (let k = 0; k < this.#curves.length; k++) this.#curve(samples, first, rows, k, way.newestAtTop);
    this.#drawLimits();
  }

  #measure(samples: Samples, first: number): void {
    let [low, high] = [Infinity, -Infinity];
    for (let k = 0; k < this.#curves.length; k++) {
      const values = samples.columns[this.#curves[k]!.column]!;
      for (let number = first; number < samples.next; number++) {
        const value = values[samples.place(number)]!;
        if (value < low) low = value;
        if (value > high) high = value;
      }
    }
    // A limit that is near the values is on the scale; one that is far away is named at its edge.
    let top = high;
    for (const { value } of this.#limits) if (value > 0 && value < NEAR * high) top = Math.max(top, value);
    this.range.hold(low, top);
  }

  /** Lines of time. */
  #times(end_s: number, { window_s, newestAtTop }: Way): void {
    const { to, width, height } = this.#pen;
    const plot = height - AXIS;
    const step = Math.max(niceAbove((window_s * LINES) / plot), 1);
    to.lineWidth = 1;
    to.strokeStyle = this.#grid;
    to.fillStyle = this.#muted;
    to.font = FONT;
    to.beginPath();
    for (let time = Math.floor(end_s / step) * step; time > end_s - window_s && time >= 0; time -= step) {
      const part = (end_s - time) / window_s;
      const y = AXIS + Math.round(plot * (newestAtTop ? part : 1 - part)) + 0.5;
      to.moveTo(0, y);
      to.lineTo(width, y);
      if (this.#timed && y > AXIS + 12 && y < height - 2) to.fillText(clockText(time), 3, y - 3);
    }
    to.stroke();
  }

  #drawLimits(): void {
    const { to, width, height } = this.#pen;
    const { low, high } = this.range;
    let below = AXIS + 13;
    to.font = FONT;
    to.lineWidth = 1.5;
    for (const { value, label } of this.#limits) {
      const beyond = value > high;
      const x = beyond ? width : ((value - low) / (high - low)) * width;
      if (x < 0) continue;
      to.strokeStyle = to.fillStyle = this.#over;
      if (!beyond) {
        to.setLineDash([5, 3]);
        to.beginPath();
        to.moveTo(x, AXIS);
        to.lineTo(x, height);
        to.stroke();
        to.setLineDash([]);
      }
      // An arrow points to a limit beyond the scale.
      const text = beyond ? `${label} ▸` : label;
      const wide = to.measureText(text).width;
      const left = Math.max(Math.min(x - wide - 4, width - wide - 3), 2);
      to.fillStyle = this.#paper;
      to.globalAlpha = 0.8;
      to.fillRect(left - 1, below - 10, wide + 2, 13);
      to.globalAlpha = 1;
      to.fillStyle = this.#over;
      to.fillText(text, left, below);
      below += 14;
    }
  }

  /** Draws a curve, with its smallest and largest value in every row of pixels. */
  #curve(samples: Samples, first: number, rows: number, k: number, newestAtTop: boolean): void {
    const { to, width, height: whole } = this.#pen;
    const height = whole - AXIS;
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
      const row = Math.floor(((number - begin) * height) / rows);
      const next = Math.min(Math.max(Math.ceil(begin + ((row + 1) * rows) / height), number + 1), samples.next);
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
      const y = AXIS + (newestAtTop ? height - row : row);
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
