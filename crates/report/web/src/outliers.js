// Values so far from all others that an axis that reached them would flatten what it is about.

import { inView } from "./curve.js";
import { svg } from "./dom.js";
import { digits, shown } from "./units.js";

/**
 * The interval that an axis has to reach, without outliers, by the rule of all figures (`figure/outliers.rs`): the inner
 * interval holds all but the lowest and the highest `tail` of the values, and zero where the axis goes there; a value is an
 * outlier where it is further from the inner interval than `times_as_long` less one of its lengths.
 */
export function withoutOutliers(values, zero, { tail, times_as_long, fewest }) {
  const sorted = Float64Array.from(values.filter(Number.isFinite)).sort();
  const last = sorted.length - 1;
  if (last < 0) return [Infinity, -Infinity];
  const whole = [sorted[0], sorted[last]];
  if (sorted.length < fewest) return whole;
  const cut = Math.ceil(tail * sorted.length);
  let [low, high] = [sorted[cut], sorted[last - cut]];
  if (zero) [low, high] = [Math.min(low, 0), Math.max(high, 0)];
  const far = (times_as_long - 1) * (high - low);
  if (far === 0) return whole;
  return [sorted.find((value) => low - value <= far), sorted.findLast((value) => value - high <= far)];
}

/** Length of an arrow and half of its width, pixels. */
const ARROW = 7;
const HALF = 4;

/**
 * An arrow at the edge of a track for the outermost point of every run of points beyond it, and at the outermost of all its
 * value in numbers. `curves` have columns of values and a colour.
 */
export function beyond(curves, dimension, range, box, view, y) {
  return [-1, 1].flatMap((side) => {
    const outside = (value) => (side > 0 ? value > range[1] : value < range[0]);
    const edge = side > 0 ? box.left + box.width : box.left;
    const drawn = [];
    let outermost = null;
    for (const { depths, columns, colour } of curves) {
      const [first, end] = inView(depths, view);
      for (const values of columns) {
        let most = null;
        for (let i = first; i <= end; i++) {
          const out = i < end && outside(values[i]) && depths[i] >= view[0] && depths[i] <= view[1];
          if (out && (most === null || side * values[i] > side * values[most])) most = i;
          if (out || most === null) continue;
          const at = y(depths[most]);
          const back = edge - side * ARROW;
          const d = `M${edge} ${at}L${back} ${at - HALF}V${at + HALF}Z`;
          drawn.push(svg("path", { d, fill: colour, class: "beyond" }));
          if (!outermost || side * values[most] > side * outermost.value) outermost = { value: values[most], at };
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
