// A column against depth as a path, with no more points than the pixels resolve.

import type { Interval } from "./ticks.ts";

/** Numbers of a column, from the surface down; NaN for missing ones. */
export type Column = Float32Array | Float64Array | number[];

/** Position of a value along an axis, pixels. */
export type Place = (value: number) => number;

/** The number at an existing index. */
const entry = (column: ArrayLike<number>, index: number): number => column[index] as number;

/** First index whose depth is not above `depth`. */
export function below(depths: ArrayLike<number>, depth: number): number {
  let low = 0;
  let high = depths.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (entry(depths, middle) < depth) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Indices in view between two depths, with one more on either side. */
export function inView(depths: ArrayLike<number>, [from, to]: Interval): [number, number] {
  return [Math.max(below(depths, from) - 1, 0), Math.min(below(depths, to) + 1, depths.length)];
}

/** The value at a depth, between its neighbours. */
export function valueAt(depths: ArrayLike<number>, values: ArrayLike<number>, depth: number): number {
  const last = depths.length - 1;
  if (last < 0 || depth < entry(depths, 0) - 1 || depth > entry(depths, last) + 1) return NaN;
  if (last === 0) return entry(values, 0);
  const next = Math.min(Math.max(below(depths, depth), 1), last);
  const span = entry(depths, next) - entry(depths, next - 1);
  const part = span > 0 ? Math.min(Math.max((depth - entry(depths, next - 1)) / span, 0), 1) : 0;
  return entry(values, next - 1) + part * (entry(values, next) - entry(values, next - 1));
}

/** Smallest and largest of the values in view. */
export function extent(depths: ArrayLike<number>, values: ArrayLike<number>, view: Interval): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  const [first, end] = inView(depths, view);
  for (let i = first; i < end; i++) {
    if (entry(values, i) < low) low = entry(values, i);
    if (entry(values, i) > high) high = entry(values, i);
  }
  return [low, high];
}

/** Rounds to a tenth of a pixel; `toFixed` takes several times as long. */
const tenth = (value: number): number => Math.round(10 * value) / 10;
const point = (x: number, y: number): string => `${tenth(x)} ${tenth(y)}`;

/** A path of the values in view; only the extremes of several points in one row of pixels. */
export function path(
  depths: ArrayLike<number>,
  values: ArrayLike<number>,
  view: Interval,
  x: Place,
  y: Place,
): string {
  const [first, end] = inView(depths, view);
  const thin = end - first > 2 * Math.abs(y(view[1]) - y(view[0]));
  let text = "";
  let pen = "M";
  const add = (i: number): void => {
    text += pen + point(x(entry(values, i)), y(entry(depths, i)));
    pen = "L";
  };
  let i = first;
  while (i < end) {
    if (!Number.isFinite(values[i])) {
      pen = "M";
      i++;
      continue;
    }
    if (!thin) {
      add(i++);
      continue;
    }
    const row = Math.round(y(entry(depths, i)));
    let [low, high, last] = [i, i, i];
    while (last + 1 < end && Math.round(y(entry(depths, last + 1))) === row && Number.isFinite(values[last + 1])) {
      last++;
      if (entry(values, last) < entry(values, low)) low = last;
      if (entry(values, last) > entry(values, high)) high = last;
    }
    for (const k of new Set([i, Math.min(low, high), Math.max(low, high), last])) add(k);
    i = last + 1;
  }
  return text;
}

/** The area between two columns. */
export function area(
  depths: ArrayLike<number>,
  lows: ArrayLike<number>,
  highs: ArrayLike<number>,
  view: Interval,
  x: Place,
  y: Place,
): string {
  const [first, end] = inView(depths, view);
  const step = Math.max(Math.floor((end - first) / (2 * Math.abs(y(view[1]) - y(view[0])) + 1)), 1);
  const there = [];
  const back = [];
  for (let i = first; i < end; i += step) {
    // The widest of the omitted rows is kept.
    let [low, high] = [Infinity, -Infinity];
    for (let k = i; k < Math.min(i + step, end); k++) {
      if (entry(lows, k) < low) low = entry(lows, k);
      if (entry(highs, k) > high) high = entry(highs, k);
    }
    if (!(low <= high)) continue;
    there.push(point(x(high), y(entry(depths, i))));
    back.push(point(x(low), y(entry(depths, i))));
  }
  return there.length > 1 ? `M${there.join("L")}L${back.reverse().join("L")}Z` : "";
}

/** The largest value within `reach` of each depth. */
export function largestNear(depths: ArrayLike<number>, values: ArrayLike<number>, reach: number): Float32Array {
  const largest = new Float32Array(values.length);
  let from = 0;
  for (let i = 0; i < values.length; i++) {
    while (entry(depths, from) < entry(depths, i) - reach) from++;
    let high = -Infinity;
    for (let k = from; k < values.length && entry(depths, k) <= entry(depths, i) + reach; k++)
      high = Math.max(high, entry(values, k));
    largest[i] = high;
  }
  return largest;
}

/** The row with the largest value within `reach` of each depth, such as that of a joint. */
export function rowOfLargest(depths: ArrayLike<number>, values: ArrayLike<number>, reach: number): Uint32Array {
  let [from, to] = [0, 0];
  return Uint32Array.from(values, (_, i) => {
    while (entry(depths, from) < entry(depths, i) - reach) from++;
    while (to < values.length && entry(depths, to) <= entry(depths, i) + reach) to++;
    let row = from;
    for (let k = from; k < to; k++) if (entry(values, k) >= entry(values, row)) row = k;
    return row;
  });
}
