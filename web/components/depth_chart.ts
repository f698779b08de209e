// Loads against the depth of the bit, which points down: a broomstick. Each line has its label at its end.

import { extent, path, type Place, valueAt } from "./curve.ts";
import { svg } from "./dom.ts";
import type { Dash } from "./marker.ts";
import type { Box } from "./outliers.ts";
import { domain, type Interval, ticks, tickText } from "./ticks.ts";
import { hideTip, showTip, type TipRow } from "./tip.ts";
import { closeTrack, depthAxis, openTrack } from "./track.ts";
import { quantity, shown, si, symbol } from "./units.ts";

/** A line of a chart, SI. */
export interface DepthLine {
  name: string;
  /** Label at its end; none if empty. */
  end: string;
  depths: readonly number[];
  values: readonly number[];
  colour: string;
  dash?: Dash;
  /** Whether it is the curve before a change. */
  ghost?: boolean;
}

/** A load that must not be exceeded, SI. */
export interface LoadLimit {
  name: string;
  value: number;
}

/** Content of a chart. */
export interface DepthChart {
  title: string;
  dimension: string;
  lines: readonly DepthLine[];
  limits: readonly LoadLimit[];
  /** All depths. */
  depths: Interval;
  /** Depth of the case, m. */
  now: number | null;
  /** Least span of the axis, SI. */
  leastSpan: number;
}

const AXIS = 54;
const HEAD = 62;
const LETTER = 5.8;
const ROW = 13;
const ROWS = 4;
const FOOT = 8 + ROW * ROWS;

/** Labels of the ends of lines in rows below the chart; without space, labels that are only a number are dropped first. */
function endNames(lines: readonly DepthLine[], x: Place, box: Box): SVGElement[] {
  const rows: (readonly [from: number, to: number])[][] = Array.from({ length: ROWS }, () => []);
  const bottom = box.top + box.height;
  const named = (line: DepthLine): number => (/\p{L}/u.test(line.end) ? 0 : 1);
  const ends = lines
    .filter((line) => line.end !== "" && !line.ghost)
    .map((line) => ({ line, value: line.values.findLast(Number.isFinite) ?? NaN }))
    .filter(({ value }) => Number.isFinite(value))
    .sort((a, b) => named(a.line) - named(b.line) || a.value - b.value);
  return ends.flatMap(({ line, value }) => {
    const wide = LETTER * line.end.length;
    const at = Math.min(Math.max(x(value), box.left + wide / 2), box.left + box.width - wide / 2);
    const room = [at - wide / 2 - 3, at + wide / 2 + 3] as const;
    const row = rows.findIndex((taken) => taken.every(([from, to]) => room[1] < from || room[0] > to));
    if (row < 0) return [];
    rows[row]?.push(room);
    const y = bottom + 14 + ROW * row;
    return [
      svg("line", { x1: x(value), x2: at, y1: bottom, y2: y - 9, stroke: line.colour, class: "leader" }),
      svg("text", { x: at, y, fill: line.colour, class: "end-name middle" }, line.end),
    ];
  });
}

function limitLine({ name, value }: LoadLimit, x: Place, box: Box): SVGElement[] {
  const at = x(value);
  const bottom = box.top + box.height;
  return [
    svg("line", { x1: at, x2: at, y1: box.top, y2: bottom, class: "limit-line" }),
    svg("text", { x: at - 4, y: box.top + 12, class: "limit-name end" }, name),
  ];
}

/** The chart, for a width and height in pixels. */
export function depthChart(chart: DepthChart, width: number, height: number): SVGSVGElement {
  const { title, dimension, lines, limits, depths, now } = chart;
  const box: Box = { left: AXIS, width: width - AXIS - 8, top: HEAD, height: height - HEAD - FOOT };
  const y: Place = (depth) => box.top + ((depth - depths[0]) / (depths[1] - depths[0])) * box.height;
  const ends = lines.map((line) => extent(line.depths, line.values, depths));
  const low = Math.min(...ends.map((end) => end[0]));
  const high = Math.max(...ends.map((end) => end[1]));
  const range = domain(
    low,
    // A distant limit would compress the lines, so it is drawn only if it is near.
    Math.max(high, ...limits.map(({ value }) => value).filter((value) => value < 1.6 * high)),
    false,
    si(1, dimension),
    chart.leastSpan,
  );
  const picture = svg("svg", {
    viewBox: `0 0 ${width} ${height}`,
    width,
    height,
    role: "img",
    "aria-label": `${title} against bit depth: ${lines.filter((line) => !line.ghost).map((line) => line.name).join(", ")}`,
  });
  depthAxis(picture, depths, y, { axis: AXIS, left: AXIS, right: box.left + box.width, count: 8 });
  const inside = openTrack(picture, dimension, range, box);
  if (now !== null && now > depths[0] && now <= depths[1])
    inside.clip.append(svg("line", { x1: box.left, x2: box.left + box.width, y1: y(now), y2: y(now), class: "chosen" }));
  for (const line of lines)
    inside.clip.append(
      svg("path", {
        d: path(line.depths, line.values, depths, inside.x, y),
        stroke: line.colour,
        class: `curve${line.ghost ? " ghost" : ""}`,
        "stroke-dasharray": line.dash?.join(" "),
      }),
    );
  for (const limit of limits) if (limit.value <= range[1]) inside.clip.append(...limitLine(limit, inside.x, box));
  closeTrack(picture, inside, title, dimension, box);
  picture.append(...endNames(lines, inside.x, box));
  const away = limits.filter((limit) => limit.value > range[1]);
  if (away.length > 0) {
    const words = away.map(({ name, value }) => `${name} ${quantity(value, dimension)} ▸`).join(", ");
    picture.append(svg("text", { x: box.left + box.width, y: box.top + box.height - 6, class: "limit-name end" }, words));
  }
  const cover = svg("rect", { x: box.left, y: box.top, width: box.width, height: box.height, class: "cover" });
  picture.append(cover);
  cover.addEventListener("pointermove", (event) => {
    const bounds = cover.getBoundingClientRect();
    const depth = depths[0] + ((event.clientY - bounds.top) / bounds.height) * (depths[1] - depths[0]);
    const rows = lines.filter((line) => !line.ghost).map((line): TipRow => {
      const value = valueAt(line.depths, line.values, depth);
      return { colour: line.colour, text: `${line.name}: ${Number.isFinite(value) ? quantity(value, dimension) : "–"}` };
    });
    showTip(event, `Bit at ${quantity(depth, "length", 5)}`, rows);
  });
  cover.addEventListener("pointerleave", hideTip);
  return picture;
}

/** The same numbers as a table for readers who cannot see the lines: headings and rows at round depths. */
export function depthTable(chart: DepthChart): { heads: string[]; rows: string[][] } {
  const lines = chart.lines.filter((line) => !line.ghost);
  const [from, to] = chart.depths;
  const { values, step } = ticks(shown(from, "length"), shown(to, "length"), 8);
  const cell = (line: DepthLine, depth: number): string => {
    const value = valueAt(line.depths, line.values, si(depth, "length"));
    return Number.isFinite(value) ? quantity(value, chart.dimension) : "–";
  };
  return {
    heads: [`Bit depth, ${symbol("length")}`, ...lines.map((line) => line.name)],
    rows: values.map((depth) => [tickText(depth, step), ...lines.map((line) => cell(line, depth))]),
  };
}
