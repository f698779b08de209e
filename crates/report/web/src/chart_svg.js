// A chart of curves or points as SVG: what uPlot paints, in lines and letters.

import { svg } from "../../../../web/components/dom.ts";
import { colour } from "../../../../web/components/palette.ts";
import { ticks, tickText } from "../../../../web/components/ticks.ts";
import { svgFile } from "./downloads.js";

const [WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM] = [720, 320, 78, 16, 46, 46];
const LETTERS = { "font-family": "system-ui, sans-serif", "font-size": 12 };

/** Powers of ten between two values. */
function decades(from, to) {
  const values = [];
  for (let power = Math.ceil(Math.log10(from) - 1e-9); 10 ** power <= to * (1 + 1e-9); power++) values.push(10 ** power);
  return values.map((value) => [value, `1e${Math.round(Math.log10(value))}`]);
}

/** How a scale of a chart places values, and its marks. */
function scaleOf(scale, [start, end], count) {
  const logarithmic = scale.distr === 3;
  const map = logarithmic ? Math.log10 : (value) => value;
  const [from, to] = [map(scale.min), map(scale.max)];
  const at = (value) => start + ((map(value) - from) / (to - from)) * (end - start);
  const round = ticks(scale.min, scale.max, count);
  const marks = logarithmic
    ? decades(scale.min, scale.max)
    : round.values.map((value) => [value, tickText(value, round.step)]);
  return { at, marks };
}

/** The chart as the text of an SVG file, under a title. */
export function chartSvg(plot, title, xTitle) {
  const down = plot.scales.y.dir === -1;
  const x = scaleOf(plot.scales.x, [LEFT, WIDTH - RIGHT], 8);
  const y = scaleOf(plot.scales.y, down ? [TOP, HEIGHT - BOTTOM] : [HEIGHT - BOTTOM, TOP], 5);
  const picture = svg("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, xmlns: "http://www.w3.org/2000/svg", ...LETTERS });
  const grid = colour("grid");
  const text = (attributes, content) => svg("text", { fill: colour("text"), ...attributes }, content);
  for (const [value, mark] of x.marks) {
    picture.append(svg("line", { x1: x.at(value), x2: x.at(value), y1: TOP, y2: HEIGHT - BOTTOM, stroke: grid }));
    picture.append(text({ x: x.at(value), y: HEIGHT - BOTTOM + 17, "text-anchor": "middle" }, mark));
  }
  for (const [value, mark] of y.marks) {
    picture.append(svg("line", { x1: LEFT, x2: WIDTH - RIGHT, y1: y.at(value), y2: y.at(value), stroke: grid }));
    picture.append(text({ x: LEFT - 7, y: y.at(value) + 4, "text-anchor": "end" }, mark));
  }
  const inside = svg("svg", {
    x: LEFT,
    y: TOP,
    width: WIDTH - LEFT - RIGHT,
    height: HEIGHT - TOP - BOTTOM,
    viewBox: `${LEFT} ${TOP} ${WIDTH - LEFT - RIGHT} ${HEIGHT - TOP - BOTTOM}`,
  });
  let key = LEFT;
  plot.series.forEach((series, i) => {
    if (i === 0 || !series.show) return;
    const ink = typeof series.stroke === "function" ? series.stroke(plot, i) : series.stroke;
    const values = plot.data[i];
    const there = Array.from(plot.data[0], (at, k) => [at, values[k]]).filter(
      ([at, value]) => value !== null && Number.isFinite(value) && at >= plot.scales.x.min && at <= plot.scales.x.max,
    );
    if (series.points?.show === true)
      for (const [at, value] of there)
        inside.append(svg("circle", { cx: x.at(at).toFixed(1), cy: y.at(value).toFixed(1), r: 1.8, fill: ink }));
    else
      inside.append(
        svg("path", {
          d: there.map(([at, value], k) => `${k ? "L" : "M"}${x.at(at).toFixed(1)} ${y.at(value).toFixed(1)}`).join(""),
          fill: "none",
          stroke: ink,
          "stroke-width": series.width ?? 1.4,
          "stroke-dasharray": series.dash?.join(" "),
        }),
      );
    if (plot.series.length > 2) {
      const dash = series.dash?.join(" ");
      picture.append(svg("line", { x1: key, x2: key + 22, y1: 34, y2: 34, stroke: ink, "stroke-width": 2, "stroke-dasharray": dash }));
      picture.append(text({ x: key + 27, y: 38 }, series.label));
      key += 42 + 6.4 * series.label.length;
    }
  });
  picture.append(
    inside,
    svg("rect", {
      x: LEFT,
      y: TOP,
      width: WIDTH - LEFT - RIGHT,
      height: HEIGHT - TOP - BOTTOM,
      fill: "none",
      stroke: colour("frame"),
    }),
    text({ x: LEFT, y: 18, "font-weight": 600 }, title),
    text({ x: (LEFT + WIDTH - RIGHT) / 2, y: HEIGHT - 10, "text-anchor": "middle" }, xTitle),
  );
  // Looks are read from what is on the page.
  picture.style.position = "absolute";
  document.body.append(picture);
  const file = svgFile([picture]);
  picture.remove();
  return file;
}

/** Heads and rows of what a chart shows, of its times in view. */
export function chartRows(plot, xTitle, unit) {
  const shown = plot.series.map((series, i) => i).filter((i) => i === 0 || plot.series[i].show);
  const name = (i) => (i === 0 ? xTitle : `${plot.series[i].label}${unit ? `, ${unit}` : ""}`);
  const { min, max } = plot.scales.x;
  const rows = Array.from(plot.data[0], (_, k) => shown.map((i) => plot.data[i][k]));
  return [shown.map(name), rows.filter(([at]) => at >= min && at <= max)];
}
