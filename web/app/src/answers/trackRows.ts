// Tracks side by side over the same depths, with the drawing of hole and string next to them.

import { valueAt } from "../../../components/curve.ts";
import { svg } from "../../../components/dom.ts";
import { listenToDepths } from "../../../components/gestures.ts";
import type { Box } from "../../../components/outliers.ts";
import { type Bore, lies, schematic } from "../../../components/schematic.ts";
import type { Interval } from "../../../components/ticks.ts";
import { closeTrack, depthAxis, drawCurve, openTrack, shoeDepths } from "../../../components/track.ts";
import { digits, shown } from "../../../components/units.ts";
import { drawnOf, rangeOf, type ShownTrack } from "./shownTracks";

/** Data to draw, and callbacks for the pointer. */
export interface Drawn {
  bore: Bore;
  tracks: readonly ShownTrack[];
  full: Interval;
  view: () => Interval;
  zoom: (view: Interval) => void;
  point: (depth: number | null) => void;
}

/** A drawing whose cursor moves. */
export interface Drawing {
  pictures: SVGSVGElement[];
  /** Displays the values at a depth; none if it is null. */
  pointAt: (depth: number | null) => void;
}

const AXIS = 54;
const WELL = 80;
const GAP = 12;
const HEAD = 66;
const FOOT = 8;
const NARROWEST = 118;

/** All tracks in rows of a width in pixels. */
export function drawTracks(input: Drawn, width: number): Drawing {
  const fit = Math.max(Math.floor((width - AXIS - WELL - GAP) / (NARROWEST + GAP)), 1);
  const lines = Math.ceil(input.tracks.length / fit);
  const each = Math.ceil(input.tracks.length / lines);
  const height = lines === 1 ? 520 : 360;
  const rows = Array.from({ length: lines }, (_, i) => row(input, input.tracks.slice(i * each, (i + 1) * each), width, each, height));
  return {
    pictures: rows.map((row) => row.picture),
    pointAt: (depth) => {
      for (const row of rows) row.pointAt(depth);
    },
  };
}

function row(input: Drawn, tracks: readonly ShownTrack[], width: number, each: number, height: number) {
  const view = input.view();
  const [from, to] = view;
  const y = (depth: number): number => HEAD + ((depth - from) / (to - from)) * height;
  const total = HEAD + height + FOOT;
  const picture = svg("svg", {
    viewBox: `0 0 ${width} ${total}`,
    width,
    height: total,
    role: "img",
    "aria-label": `Against measured depth: ${tracks.map((track) => track.title).join(", ")}`,
  });
  const left = AXIS + WELL + GAP;
  const wide = (width - left - GAP * (each - 1) - 4) / each;
  depthAxis(picture, view, y, { axis: AXIS, left, right: width });
  const clipped = svg("svg", { x: 0, y: HEAD - 10, width, height: height + 18, viewBox: `0 ${HEAD - 10} ${width} ${height + 18}` });
  clipped.append(schematic(input.bore, { left: AXIS, width: WELL, top: HEAD, height }, view, y));
  picture.append(clipped);
  const readouts = tracks.map((track, i) => {
    const box: Box = { left: left + i * (wide + GAP), width: wide, top: HEAD, height };
    const inside = openTrack(picture, track.dimension, rangeOf(track, view), box);
    shoeDepths(inside, input.bore.hole, box, view, y);
    for (const curve of track.curves) drawCurve(inside, drawnOf(curve, view), curve.look, view, y);
    closeTrack(picture, inside, track.title, track.dimension, box);
    const text = svg("text", { x: box.left + box.width / 2, y: 45, class: "readout middle" });
    picture.append(text);
    return { track, text };
  });
  const cursor = svg("line", { x1: AXIS, x2: width, class: "cursor", visibility: "hidden" });
  const flag = svg("text", { x: 2, class: "flag", visibility: "hidden" });
  const readout = svg("g", { class: "readout" });
  const band = svg("rect", { x: AXIS, width: width - AXIS, class: "drag", visibility: "hidden" });
  const cover = svg("rect", { x: AXIS, y: HEAD, width: width - AXIS, height, class: "cover" });
  picture.append(band, cursor, flag, readout, cover);
  const { full, zoom, point } = input;
  listenToDepths({ cover, band, picture, head: HEAD, height, total, full, view: input.view, zoom, point, choose: point });

  function pointAt(depth: number | null): void {
    const inView = depth !== null && depth >= from && depth <= to;
    for (const element of [cursor, flag]) element.setAttribute("visibility", inView ? "visible" : "hidden");
    readout.replaceChildren();
    for (const { text } of readouts) text.replaceChildren();
    if (!inView) return;
    for (const end of ["y1", "y2"]) cursor.setAttribute(end, String(y(depth)));
    flag.setAttribute("y", String(y(depth) + 4));
    flag.textContent = digits(shown(depth, "length"), 5);
    lies(input.bore, depth).forEach((words, i) => {
      const text = words.length > 20 ? `${words.slice(0, 19)}…` : words;
      readout.append(svg("text", { x: AXIS + WELL / 2, y: 14 + 13 * i, class: "readout middle small" }, text));
    });
    for (const { track, text } of readouts) {
      const mine = track.curves.filter(({ look }) => !look.ghost);
      mine.forEach(({ curve, look }, i) => {
        const value = valueAt(curve.depths, curve.values, depth);
        const words = Number.isFinite(value) ? digits(shown(value, track.dimension)) : "–";
        text.append(svg("tspan", { fill: look.colour, dx: i ? 6 : 0 }, words));
      });
    }
  }

  return { picture, pointAt };
}
