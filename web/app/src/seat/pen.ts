// A canvas with a pen in the colours of the page, at the resolution of the screen.

/** The value of a colour of the page. */
export const colour = (name: string): string =>
  getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();

/** A canvas that fits the available space. */
export class Pen {
  readonly canvas: HTMLCanvasElement;
  readonly to: CanvasRenderingContext2D;
  width = 0;
  height = 0;
  /** Whether the canvas was emptied by a change of its size. */
  emptied = true;
  readonly #watch: ResizeObserver;

  constructor(canvas: HTMLCanvasElement) {
    this.canvas = canvas;
    const context = canvas.getContext("2d");
    if (!context) throw new Error("this browser does not support canvas drawing");
    this.to = context;
    this.#watch = new ResizeObserver(() => this.#fit());
    this.#watch.observe(canvas);
    this.#fit();
  }

  #fit(): void {
    const { clientWidth, clientHeight } = this.canvas;
    const sharp = Math.min(devicePixelRatio, 2);
    [this.width, this.height] = [clientWidth, clientHeight];
    this.canvas.width = Math.round(clientWidth * sharp);
    this.canvas.height = Math.round(clientHeight * sharp);
    this.to.setTransform(sharp, 0, 0, sharp, 0, 0);
    this.emptied = true;
  }

  close(): void {
    this.#watch.disconnect();
  }
}

/** Displayed range of values: widened at once, narrowed only when most of it is empty. */
export class Range {
  low = NaN;
  high = NaN;
  readonly least: number;

  constructor(least: number) {
    this.least = least;
  }

  /** Includes these values; returns whether the range has changed. */
  hold(low: number, high: number): boolean {
    if (!(low <= high)) return false;
    const span = Math.max(high - low, this.least);
    const fits = low >= this.low && high <= this.high;
    if (fits && span > 0.35 * (this.high - this.low)) return false;
    const middle = 0.5 * (low + high);
    const step = 10 ** Math.floor(Math.log10(span)) / 2;
    const [from, to] = [
      Math.floor((middle - 0.6 * span) / step) * step,
      Math.ceil((middle + 0.6 * span) / step) * step,
    ];
    // The scale of non-negative values starts at zero if that is near.
    const begin = from < 0 && low >= 0 ? 0 : from > 0 && from < 0.4 * to ? 0 : from;
    if (begin === this.low && to === this.high) return false;
    [this.low, this.high] = [begin, to];
    return true;
  }
}
