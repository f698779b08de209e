// One track: its curves, bands and marks in a frame with an axis of its own.

import { area, extent, inView, path, valueAt } from "./curve.js";
import { svg } from "./dom.js";
import { placedOf } from "./findings.js";
import { beyond, withoutOutliers } from "./outliers.js";
import { chosen, chosenInTime, look, operations } from "./solutions.js";
import { state } from "./state.js";
import { alignment, domain, roomyTicks, tickText } from "./ticks.js";
import { drawnOf, isShown } from "./track.js";
import { shown, si, symbol } from "./units.js";

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
  const x = (value) => box.left + ((value - range[0]) / (range[1] - range[0])) * box.width;
  const clip = svg("svg", {
    x: box.left,
    y: box.top,
    width: box.width,
    height: box.height,
    viewBox: `${box.left} ${box.top} ${box.width} ${box.height}`,
  });
  const scale = roomyTicks(shown(range[0], track.dimension), shown(range[1], track.dimension), box.width);
  for (const value of scale.values) {
    const at = x(si(value, track.dimension));
    const place = alignment(at - box.left, box.width);
    picture.append(
      svg("line", { x1: at, x2: at, y1: box.top, y2: box.top + box.height, class: value === 0 ? "zero" : "grid" }),
      svg("text", { x: at, y: box.top - 7, class: `tick ${place}` }, tickText(value, scale.step)),
    );
  }
  for (const section of report.hole.filter(
    (section) => section.kind === "casing" && section.to_m > from && section.to_m < to,
  ))
    clip.append(
      svg("line", {
        x1: box.left,
        x2: box.left + box.width,
        y1: y(section.to_m),
        y2: y(section.to_m),
        class: "shoe-depth",
      }),
    );
  findingBands(report, clip, box, view, y);
  if (track.sides) fillSides(report, clip, track, view, x, y);
  for (const curve of curves) {
    const { colour, dash, shape, place, hollow } = curve.well ? { colour: "var(--text)" } : look(report, curve.solved);
    const faint = !curve.well && operations(report).length > 1 && curve.solved.operation !== state.operation;
    if (curve.low && curve.high)
      clip.append(
        svg("path", {
          d: area(curve.depths, curve.low, curve.high, view, x, y),
          fill: colour,
          class: faint ? "band faint" : "band",
        }),
      );
    clip.append(
      svg("path", {
        d: path(curve.depths, curve.values, view, x, y),
        stroke: colour,
        class: `curve${faint ? " faint" : ""}`,
        "stroke-dasharray": dash?.join(" "),
      }),
    );
    if (curve.between)
      clip.append(
        svg("path", {
          d: path(curve.depths, curve.between, view, x, y),
          stroke: colour,
          class: `curve between${faint ? " faint" : ""}`,
        }),
      );
    if (shape) clip.append(...markers(report, curve, { colour, shape, place, hollow, faint }, view, x, y));
  }
  if (track.touches) classStrip(report, clip, track, box, view, y);
  const middle = box.left + box.width / 2;
  picture.append(
    clip,
    svg("rect", { x: box.left, y: box.top, width: box.width, height: box.height, class: "frame" }),
    svg("text", { x: middle, y: 16, class: "title middle" }, track.title),
    svg("text", { x: middle, y: 31, class: "unit middle" }, symbol(track.dimension)),
  );
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
  const text = svg("text", { x: middle, y: 48, class: "readout middle" });
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

/** Stretches and places of findings of the chosen operation, light over the track, and a bar at its edge. */
function findingBands(report, clip, box, [from, to], y) {
  for (const { level, md_m, to_md_m } of placedOf(report)) {
    if (md_m > to || (to_md_m ?? md_m) < from) continue;
    const [top, end] = [y(md_m), y(to_md_m ?? md_m)];
    const height = Math.max(end - top, 2);
    const at = { y: top, height };
    const stretch = to_md_m !== null;
    if (stretch) clip.append(svg("rect", { x: box.left, width: box.width, ...at, class: `found level-${level}` }));
    clip.append(svg("rect", { x: box.left + box.width - 5, width: 5, ...at, class: `found-bar level-${level}` }));
    if (level !== "error" && stretch)
      // Bars of lesser findings have gaps, so that they are distinguished without colour.
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
