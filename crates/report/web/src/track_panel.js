// One track: its curves, bands and marks in a frame with an axis of its own.

import { area, extent, inView, path, valueAt } from "../../../../web/components/curve.ts";
import { svg } from "../../../../web/components/dom.ts";
import { beyond, withoutOutliers } from "../../../../web/components/outliers.ts";
import { domain } from "../../../../web/components/ticks.ts";
import { closeTrack, drawCurve, openTrack, shoeDepths } from "../../../../web/components/track.ts";
import { digits, shown, si } from "../../../../web/components/units.ts";
import { placedOf } from "./checks.js";
import { chosen, chosenInTime, look, operations } from "./solutions.js";
import { state } from "./state.js";
import { drawnOf, isShown } from "./track.js";

/** Markers of a curve over the height of a track. */
const MARKERS = 5;

/** Whether the axis of a track leaves out single values far from all others. */
const clips = (track) => track.from === "profile" && !track.range;

/** How far the axis of a track reaches. */
function rangeOf(report, track, curves, view) {
  const columns = curves.flatMap((curve) =>
    [curve.values, curve.low, curve.high, curve.between].filter(Boolean).map((values) => [curve.depths, values]),
  );
  const ends = clips(track)
    ? withoutOutliers(
        columns.flatMap(([depths, values]) => Array.from(values.slice(...inView(depths, view)))),
        track.zero,
        report.rules.outliers,
      )
    : columns
        .map(([depths, values]) => extent(depths, values, view))
        .reduce(([low, high], end) => [Math.min(low, end[0]), Math.max(high, end[1])], [Infinity, -Infinity]);
  return domain(...ends, track.zero || track.sides, si(1, track.dimension), track.min_span);
}

/** Draws a track into a picture that shows these depths; gives the curves that it shows, and where readouts go. */
export function drawTrack(report, picture, track, box, [from, to], y) {
  const view = [from, to];
  const curves = drawnOf(report, track, view);
  const range = track.range ?? rangeOf(report, track, curves, view);
  const inside = openTrack(picture, track.dimension, range, box);
  const { x, clip } = inside;
  shoeDepths(inside, report.hole, box, view, y);
  checkBands(report, clip, box, view, y);
  if (track.sides) fillSides(report, clip, track, view, x, y);
  for (const curve of curves) {
    const { colour, dash, shape, place, hollow } = curve.well ? { colour: "var(--text)" } : look(report, curve.solved);
    const faint = !curve.well && operations(report).length > 1 && curve.solved.operation !== state.operation;
    drawCurve(inside, curve, { colour, dash, faint }, view, y);
    if (shape) clip.append(...markers(report, curve, { colour, shape, place, hollow, faint }, view, x, y));
  }
  if (track.sides) cutoff(report, clip, box, view, y);
  if (track.touches) classStrip(report, clip, track, box, view, y);
  closeTrack(picture, inside, track.title, track.dimension, box);
  if (track.sides)
    picture.append(
      svg("text", { x: box.left, y: box.top + box.height + 14, class: "side low" }, "◂ low side"),
      svg("text", { x: box.left + box.width, y: box.top + box.height + 14, class: "side high end" }, "high side ▸"),
    );
  if (curves.some((curve) => curve.between))
    picture.append(svg("text", { x: box.left, y: box.top + box.height + 14, class: "side" }, "··· between joints"));
  if (clips(track)) {
    const columns = (curve) => [curve.values, curve.between].filter(Boolean);
    const colour = (curve) => (curve.well ? "var(--text)" : look(report, curve.solved).colour);
    const shownOf = curves.map((curve) => ({ depths: curve.depths, columns: columns(curve), colour: colour(curve) }));
    picture.append(...beyond(shownOf, track.dimension, range, box, view, y));
  }
  if (track.touches)
    picture.append(
      svg(
        "text",
        { x: box.left, y: box.top + box.height + 14, class: "side" },
        "▌ always ",
        svg("tspan", { class: "sometimes" }, "▌"),
        " at times",
      ),
    );
  const text = svg("text", { x: box.left + box.width / 2, y: 48, class: "readout middle" });
  picture.append(text);
  return { text, curves };
}

/** Markers along a curve, each curve's at depths of its own. */
function markers(report, curve, { colour, shape, place, hollow, faint }, [from, to], x, y) {
  const part = (k) => (k + (place + (hollow ? 1.5 : 1)) / (operations(report).length + 1.5)) / MARKERS;
  return Array.from({ length: MARKERS }, (_, k) => from + part(k) * (to - from))
    .map((depth) => [depth, valueAt(curve.depths, curve.values, depth)])
    .filter(([depth, value]) => Number.isFinite(value) && depth <= curve.depths.at(-1))
    .map(([depth, value]) =>
      svg("path", {
        d: shape,
        transform: `translate(${x(value).toFixed(1)} ${y(depth).toFixed(1)})`,
        fill: hollow ? "var(--paper)" : colour,
        stroke: hollow ? colour : "var(--paper)",
        class: `marker${faint ? " faint" : ""}`,
      }),
    );
}

/** Stretches and places of the checks of the chosen operation, light over the track, and a bar at its edge. */
function checkBands(report, clip, box, [from, to], y) {
  for (const { severity: level, md_m, to_md_m } of placedOf(report)) {
    if (md_m > to || (to_md_m ?? md_m) < from) continue;
    const [top, end] = [y(md_m), y(to_md_m ?? md_m)];
    const height = Math.max(end - top, 2);
    const at = { y: top, height };
    const stretch = to_md_m !== null;
    if (stretch) clip.append(svg("rect", { x: box.left, width: box.width, ...at, class: `found level-${level}` }));
    clip.append(svg("rect", { x: box.left + box.width - 5, width: 5, ...at, class: `found-bar level-${level}` }));
    if (level !== "error" && stretch)
      // Bars of lesser checks have gaps, so that they are distinguished without colour.
      for (let gap = top + 6; gap < end; gap += level === "warning" ? 10 : 6)
        clip.append(svg("rect", { x: box.left + box.width - 5, width: 5, y: gap, height: 3, fill: "var(--paper)" }));
  }
}

/** The area to zero of what the reader looks at: one colour a side. */
function fillSides(report, clip, track, view, x, y) {
  const solved = chosen(report)[0];
  const curve = track.curves.find((curve) => curve.solved === solved);
  if (!curve || !isShown(curve)) return;
  const zero = new Float32Array(curve.values.length);
  const part = (keep) => curve.values.map((value) => (keep(value) ? value : 0));
  clip.append(
    svg("path", {
      d: area(
        curve.depths,
        zero,
        part((v) => v > 0),
        view,
        x,
        y,
      ),
      class: "high-side",
    }),
    svg("path", {
      d: area(
        curve.depths,
        part((v) => v < 0),
        zero,
        view,
        x,
        y,
      ),
      class: "low-side",
    }),
  );
}

/** The depth at which the side force of the curve in colour changes sides. */
function cutoff(report, clip, box, [from, to], y) {
  const depth = chosen(report)[0]?.cutoff_depth_m ?? null;
  if (depth === null || depth < from || depth > to) return;
  const [left, right] = [box.left, box.left + box.width];
  const label = `cut-off ${digits(shown(depth, "length"), 5)}`;
  clip.append(
    svg("line", { x1: left, x2: right, y1: y(depth), y2: y(depth), class: "cut-off" }),
    svg("text", { x: right - 4, y: y(depth) - 4, class: "side end" }, label),
  );
}

/** How much of the time the string touches, in three classes, along the left edge. */
function classStrip(report, clip, track, box, view, y) {
  const solved = chosenInTime(report);
  const curve = track.curves.find((curve) => curve.solved === solved);
  if (!curve) return;
  const classOf = (part) => (part < 0.01 ? 0 : part <= 0.99 ? 1 : 2);
  let start = 0;
  const { depths, values } = curve;
  for (let i = 1; i <= values.length; i++) {
    if (i < values.length && classOf(values[i]) === classOf(values[start])) continue;
    const kind = classOf(values[start]);
    const [y1, y2] = [y(depths[start]), y(depths[Math.min(i, values.length - 1)])];
    if (kind > 0 && y2 > box.top && y1 < box.top + box.height)
      clip.append(
        svg("rect", {
          x: box.left,
          y: y1,
          width: 6,
          height: Math.max(y2 - y1, 0.7),
          class: kind === 2 ? "always" : "sometimes",
        }),
      );
    start = i;
  }
}
