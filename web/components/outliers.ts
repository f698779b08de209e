// Values so far from all others that an axis that includes them would flatten the curves.

import { inView, type Place } from "./curve.ts";
import { svg } from "./dom.ts";
import type { Interval } from "./ticks.ts";
import { digits, shown } from "./units.ts";

/** Rule for outliers, from the program that made the page. */
export interface OutlierRule {
  tail: number;
  times_as_long: number;
  fewest: number;
}

/** Position of a track in a picture. */
export interface Box {
  left: number;
  width: number;
  top: number;
  height: number;
}

/**
 * The interval that an axis must include, without outliers, by the rule of all figures (`figure/outliers.rs`): the inner
 * interval contains all but the lowest and the highest `tail` of the values, and zero if the axis includes it; a value is
 * an outlier if its distance from the inner interval is more than `times_as_long` minus one of its lengths.
 */
export function withoutOutliers(values: readonly number[], zero: boolean, rule: OutlierRule): Interval {
  const { tail, times_as_long, fewest } = rule;
  const sorted = Float64Array.from(values.filter(Number.isFinite)).sort();
  const last = sorted.length - 1;
  const [least, most] = [sorted[0], sorted[last]];
  if (least === undefined || most === undefined) return [Infinity, -Infinity];
  if (sorted.length < fewest) return [least, most];
  const cut = Math.ceil(tail * sorted.length);
  let [low, high] = [sorted[cut] as number, sorted[last - cut] as number];
  if (zero) [low, high] = [Math.min(low, 0), Math.max(high, 0)];
  const far = (times_as_long - 1) * (high - low);
  if (far === 0) return [least, most];
  return [sorted.find((value) => low - value <= far) ?? least, sorted.findLast((value) => value - high <= far) ?? most];
}

/** Length of an arrow and half of its width, pixels. */
const ARROW = 7;
const HALF = 4;

/** A curve that may exceed its axis. */
export interface Reaching {
  depths: ArrayLike<number>;
  columns: readonly ArrayLike<number>[];
  colour: string;
}

/**
 * An arrow at the edge of a track for the outermost point of every run of points beyond it, and the value of the
 * outermost of all.
 */
export function beyond(
  curves: readonly Reaching[],
  dimension: string,
  range: Interval,
  box: Box,
  view: Interval,
  y: Place,
): SVGElement[] {
  return ([-1, 1] as const).flatMap((side) => {
    const outside = (value: number): boolean => (side > 0 ? value > range[1] : value < range[0]);
    const edge = side > 0 ? box.left + box.width : box.left;
    const drawn: SVGElement[] = [];
    let outermost: { value: number; at: number } | null = null;
    for (const { depths, columns, colour } of curves) {
      const [first, end] = inView(depths, view);
      for (const values of columns) {
        let most: { value: number; depth: number } | null = null;
        for (let i = first; i <= end; i++) {
          const [value, depth] = [values[i] as number, depths[i] as number];
          const out = i < end && outside(value) && depth >= view[0] && depth <= view[1];
          if (out && (most === null || side * value > side * most.value)) most = { value, depth };
          if (out || most === null) continue;
          const at = y(most.depth);
          const back = edge - side * ARROW;
          const d = `M${edge} ${at}L${back} ${at - HALF}V${at + HALF}Z`;
          drawn.push(svg("path", { d, fill: colour, class: "beyond" }));
          if (!outermost || side * most.value > side * outermost.value) outermost = { value: most.value, at };
          most = null;
        }
      }
    }
    if (outermost) {
      const at = Math.min(Math.max(outermost.at, box.top + 8), box.top + box.height - 8);
      const place = { x: edge - side * (ARROW + 3), y: at + 4, class: `beyond-value${side > 0 ? " end" : ""}` };
      drawn.push(svg("text", place, digits(shown(outermost.value, dimension))));
    }
    return drawn;
  });
}
