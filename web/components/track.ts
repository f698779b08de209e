// One track: a frame with its own axis over depths shared with others, and its curves.

import { area, path, type Place } from "./curve.ts";
import { svg } from "./dom.ts";
import type { Dash } from "./marker.ts";
import type { Box } from "./outliers.ts";
import { alignment, type Interval, roomyTicks, ticks, tickText } from "./ticks.ts";
import { shown, si, symbol } from "./units.ts";

/** A curve of a track, SI. */
export interface TrackCurve {
  depths: ArrayLike<number>;
  values: ArrayLike<number>;
  /** A band around it. */
  low?: ArrayLike<number> | undefined;
  high?: ArrayLike<number> | undefined;
  /** Smallest values between joints, if the curve has the values at the joints. */
  between?: ArrayLike<number> | undefined;
}

/** Look of a curve. */
export interface CurveLook {
  colour: string;
  dash?: Dash | undefined;
  /** Whether it is not in focus. */
  faint?: boolean;
  /** Whether it is the curve before a change. */
  ghost?: boolean;
}

/** The inside of a track: positions of values, and the element for its content. */
export interface TrackInside {
  x: Place;
  clip: SVGSVGElement;
}

/** Numbers and lines of the axis of a track; content of `clip` ends at the frame, which `closeTrack` draws. */
export function openTrack(picture: SVGElement, dimension: string, range: Interval, box: Box): TrackInside {
  const x: Place = (value) => box.left + ((value - range[0]) / (range[1] - range[0])) * box.width;
  const clip = svg("svg", {
    x: box.left,
    y: box.top,
    width: box.width,
    height: box.height,
    viewBox: `${box.left} ${box.top} ${box.width} ${box.height}`,
  });
  const scale = roomyTicks(shown(range[0], dimension), shown(range[1], dimension), box.width);
  for (const value of scale.values) {
    const at = x(si(value, dimension));
    const place = alignment(at - box.left, box.width);
    picture.append(
      svg("line", { x1: at, x2: at, y1: box.top, y2: box.top + box.height, class: value === 0 ? "zero" : "grid" }),
      svg("text", { x: at, y: box.top - 7, class: `tick ${place}` }, tickText(value, scale.step)),
    );
  }
  return { x, clip };
}

/** The frame around what was drawn, its title and its unit. */
export function closeTrack(picture: SVGElement, { clip }: TrackInside, title: string, dimension: string, box: Box): void {
  const middle = box.left + box.width / 2;
  picture.append(
    clip,
    svg("rect", { x: box.left, y: box.top, width: box.width, height: box.height, class: "frame" }),
    svg("text", { x: middle, y: 16, class: "title middle" }, title),
    svg("text", { x: middle, y: 31, class: "unit middle" }, symbol(dimension)),
  );
}

/** The last path of each column, so that unchanged paths are not computed again. */
const made = new WeakMap<object, { key: string; d: string }>();

function pathOf(depths: ArrayLike<number>, values: ArrayLike<number>, view: Interval, x: Place, y: Place): string {
  // Both scales are linear, so two points determine each.
  const key = [...view, x(0), x(1e6), y(0), y(1e6)].join(" ");
  const known = made.get(values);
  if (known?.key === key) return known.d;
  const d = path(depths, values, view, x, y);
  made.set(values, { key, d });
  return d;
}

/** Draws a curve with its band. */
export function drawCurve({ x, clip }: TrackInside, curve: TrackCurve, look: CurveLook, view: Interval, y: Place): void {
  const more = `${look.faint ? " faint" : ""}${look.ghost ? " ghost" : ""}`;
  if (curve.low && curve.high)
    clip.append(svg("path", { d: area(curve.depths, curve.low, curve.high, view, x, y), fill: look.colour, class: `band${more}` }));
  clip.append(
    svg("path", {
      d: pathOf(curve.depths, curve.values, view, x, y),
      stroke: look.colour,
      class: `curve${more}`,
      "stroke-dasharray": look.dash?.join(" "),
    }),
  );
  if (curve.between)
    clip.append(
      svg("path", { d: pathOf(curve.depths, curve.between, view, x, y), stroke: look.colour, class: `curve between${more}` }),
    );
}

/** A line across at the end of each casing in view. */
export function shoeDepths(
  { clip }: TrackInside,
  hole: readonly { kind: string; to_m: number }[],
  box: Box,
  [from, to]: Interval,
  y: Place,
): void {
  for (const { kind, to_m } of hole) {
    if (kind !== "casing" || to_m <= from || to_m >= to) continue;
    const at = y(to_m);
    clip.append(svg("line", { x1: box.left, x2: box.left + box.width, y1: at, y2: at, class: "shoe-depth" }));
  }
}

/** Measured depths left of `axis`, and lines at them from `left` to `right`. */
export function depthAxis(
  picture: SVGElement,
  [from, to]: Interval,
  y: Place,
  { axis, left, right, count = 12 }: { axis: number; left: number; right: number; count?: number },
): void {
  const { values, step } = ticks(shown(from, "length"), shown(to, "length"), count);
  for (const value of values) {
    const at = y(si(value, "length"));
    picture.append(
      svg("line", { x1: left, x2: right, y1: at, y2: at, class: "grid" }),
      svg("text", { x: axis - 8, y: at + 4, class: "tick end" }, tickText(value, step)),
    );
  }
  picture.append(
    svg("text", { x: 0, y: 16, class: "title" }, "MD"),
    svg("text", { x: 0, y: 31, class: "unit" }, symbol("length")),
  );
}
