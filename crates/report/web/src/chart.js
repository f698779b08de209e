// What every chart of curves or points has alike.

import { colour } from "./palette.js";
import { isPrinting } from "./theme.js";
import { digits, grouped, shown } from "./units.js";

const number = (value) => grouped(String(Number(value.toFixed(6))));

/** Width on paper, where two charts stand side by side. */
const PAPER = 364;

/** As wide as what holds the chart, or as paper. */
export const widthOf = (body) => (isPrinting() ? PAPER : Math.max(body.clientWidth, 200));

/** The axis below a chart, with its label, and the one beside it. */
export function axes(label) {
  const axis = {
    stroke: colour("muted"),
    grid: { stroke: colour("grid"), width: 1 },
    ticks: { show: false },
    font: "11px system-ui, sans-serif",
    values: (_, splits) => splits.map(number),
  };
  return [
    { ...axis, size: 30, label, labelSize: 18, labelFont: axis.font },
    { ...axis, size: 62 },
  ];
}

/** A number of a legend. */
export const legendText = (_, value) => (value === null || value === undefined ? "–" : digits(value));

/** The marker of a legend has the colour and the stroke of its curve. */
export const LEGEND = {
  live: true,
  markers: {
    width: 2,
    stroke: (plot, i) => plot.series[i].stroke(plot, i),
    dash: (plot, i) => (plot.series[i].dash ? (plot.series[i].dash[0] < 2 ? "dotted" : "dashed") : "solid"),
    fill: () => "transparent",
  },
};

/** The interval with air, no shorter than the quantity's least span, SI: what hardly moves is not blown up to drama. */
export function air(low, high, dimension, least) {
  if (low === null || high === null) return [0, 1];
  const span = Math.max(high - low, shown(least, dimension));
  const middle = (low + high) / 2;
  return [middle - 0.58 * span, middle + 0.58 * span];
}

/** Names of curves that the reader hid, by their chart. */
const hiddenBy = new Map();

/** A legend that hides curves by click and by keyboard, and keeps them hidden when the chart `name` is drawn anew. */
export function followLegend(plot, name) {
  const hidden = hiddenBy.get(name) ?? new Set();
  hiddenBy.set(name, hidden);
  plot.root.querySelectorAll(".u-legend .u-series").forEach((row, i) => {
    if (i === 0 || plot.series.length < 3) return;
    const head = row.querySelector("th");
    const { label } = plot.series[i];
    const update = () => head.setAttribute("aria-pressed", String(plot.series[i].show));
    if (hidden.has(label)) plot.setSeries(i, { show: false });
    for (const [key, value] of Object.entries({ tabindex: 0, role: "button", title: `Show or hide ${label}` }))
      head.setAttribute(key, value);
    head.addEventListener("keydown", (event) => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      head.click();
    });
    head.addEventListener("click", () => {
      if (plot.series[i].show) hidden.delete(label);
      else hidden.add(label);
      update();
    });
    update();
  });
}
