// Round numbers along an axis.

import { grouped } from "./units.ts";

/** Round numbers and their step. */
export interface Scale {
  values: number[];
  step: number;
}

/** The two ends of an interval. */
export type Interval = readonly [number, number];

/** Round numbers from `from` to `to`, about `count` of them. */
export function ticks(from: number, to: number, count: number): Scale {
  const span = to - from;
  if (!(span > 0) || !Number.isFinite(span)) return { values: [from], step: 1 };
  const rough = span / Math.max(count, 1);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 2.5, 5, 10].map((m) => m * power).find((s) => s >= rough * 0.999) ?? 10 * power;
  const values = [];
  for (let k = Math.ceil(from / step - 1e-9); k * step <= to + step * 1e-9; k++) values.push(k * step);
  return { values, step };
}

/** Parts of a text to the left of its position. */
const LEFT_OF = { start: 0, middle: 0.5, end: 1 };

/** Alignment of a number above a track of a width in pixels: inwards at an edge. */
export const alignment = (at: number, width: number): keyof typeof LEFT_OF =>
  at < 8 ? "start" : at > width - 8 ? "end" : "middle";

/** As many round numbers as fit next to each other in a width in pixels, in the font of a track. */
export function roomyTicks(from: number, to: number, width: number): Scale {
  const LETTER = 6.2;
  const APART = 5;
  for (let count = Math.floor(width / 24); count > 1; count--) {
    const scale = ticks(from, to, count);
    let free = -Infinity;
    const fits = scale.values.every((value) => {
      const at = ((value - from) / (to - from)) * width;
      const wide = LETTER * tickText(value, scale.step).length;
      const left = at - LEFT_OF[alignment(at, width)] * wide;
      const room = free <= left;
      free = left + wide + APART;
      return room;
    });
    if (fits) return scale;
  }
  return ticks(from, to, 1);
}

/** A tick as text, with no more decimals than the step requires. */
export function tickText(value: number, step: number): string {
  const rounded = Math.abs(value) < step * 1e-6 ? 0 : value;
  let decimals = 0;
  while (decimals < 8 && Math.abs(step * 10 ** decimals - Math.round(step * 10 ** decimals)) > 1e-6) decimals++;
  return grouped(rounded.toFixed(decimals));
}

/**
 * The interval with margins, extended to zero if the values are on one side of it and near; without values, or with zeros
 * only, the interval up to `one`. It is no shorter than `least`, so that nearly constant curves look flat.
 */
export function domain(low: number, high: number, withZero: boolean, one: number, least: number): Interval {
  if (!(low <= high) || (low === 0 && high === 0)) return [0, one];
  if (withZero || (low > 0 && low < 0.35 * high)) low = Math.min(low, 0);
  if (withZero || (high < 0 && high > 0.35 * low)) high = Math.max(high, 0);
  const short = least - (high - low);
  if (short > 0) {
    // Values on the other side of zero are rounding errors.
    const rounding = 1e-3 * least;
    if (low >= -rounding && low < short / 2) return [0, Math.max(high, least)];
    if (high <= rounding && -high < short / 2) return [Math.min(low, -least), 0];
    return [low - short / 2, high + short / 2];
  }
  const span = high - low || Math.abs(high) * 0.2 || 1;
  const air = 0.05 * span;
  return [low === 0 ? 0 : low - air, high === 0 ? 0 : high + air];
}
