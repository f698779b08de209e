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

/** The marker of a legend is the colour of its curve. */
export const LEGEND = { live: true, markers: { width: 0, fill: (plot, i) => plot.series[i].stroke(plot, i) } };

/** The interval with air; what hardly moves is not blown up to noise. */
export function air(low, high, dimension) {
  if (low === null || high === null) return [0, 1];
  const least = 2e-3 * Math.max(Math.abs(low), Math.abs(high)) || shown(1, dimension);
  const span = Math.max(high - low, least);
  const middle = (low + high) / 2;
  return [middle - 0.58 * span, middle + 0.58 * span];
}
