// Common parts of all charts of curves or points.

import type uPlot from "uplot";
import { colour } from "./palette.ts";
import { isPrinting } from "./printing.ts";
import { digits, grouped, shown } from "./units.ts";

const number = (value: number): string => grouped(String(Number(value.toFixed(6))));

/** Width on paper, with two charts side by side. */
const PAPER = 364;

/** Width of the element with the chart, or of paper. */
export const widthOf = (body: HTMLElement): number => (isPrinting() ? PAPER : Math.max(body.clientWidth, 200));

/** The horizontal axis of a chart, with its label, and the vertical one. */
export function axes(label: string): uPlot.Axis[] {
  const axis: uPlot.Axis = {
    stroke: colour("muted"),
    grid: { stroke: colour("grid"), width: 1 },
    ticks: { show: false },
    font: "11px system-ui, sans-serif",
    values: (_: uPlot, splits: number[]) => splits.map(number),
  };
  return [
    { ...axis, size: 30, label, labelSize: 18, labelFont: "11px system-ui, sans-serif" },
    { ...axis, size: 62 },
  ];
}

/** A number of a legend. */
export const legendText = (_: uPlot, value: number | null | undefined): string =>
  value === null || value === undefined ? "–" : digits(value);

/** The marker of a legend has the colour and the stroke of its curve. */
export const LEGEND: uPlot.Legend = {
  live: true,
  markers: {
    width: 2,
    stroke: (plot, i) => {
      const source = plot.series[i]?.stroke;
      const stroke = typeof source === "function" ? source(plot, i) : source;
      return typeof stroke === "string" ? stroke : "";
    },
    dash: (plot, i) => {
      const [first] = plot.series[i]?.dash ?? [];
      return first === undefined ? "solid" : first < 2 ? "dotted" : "dashed";
    },
    fill: () => "transparent",
  },
};

/** The interval with margins, no shorter than the least span of the quantity, SI, so that nearly constant curves look flat. */
export function air(low: number | null, high: number | null, dimension: string, least: number): [number, number] {
  if (low === null || high === null) return [0, 1];
  const span = Math.max(high - low, shown(least, dimension));
  const middle = (low + high) / 2;
  return [middle - 0.58 * span, middle + 0.58 * span];
}

/** Names of curves that the reader hid, by their chart. */
const hiddenBy = new Map<string, Set<string>>();

/** A legend that hides curves by click and by keyboard, and keeps them hidden when the chart `name` is drawn anew. */
export function followLegend(plot: uPlot, name: string): void {
  const hidden = hiddenBy.get(name) ?? new Set<string>();
  hiddenBy.set(name, hidden);
  plot.root.querySelectorAll(".u-legend .u-series").forEach((row, i) => {
    if (i === 0 || plot.series.length < 3) return;
    const head = row.querySelector("th");
    const series = plot.series[i];
    if (!head || !series) return;
    const label = String(series.label);
    const update = (): void => head.setAttribute("aria-pressed", String(series.show));
    if (hidden.has(label)) plot.setSeries(i, { show: false });
    for (const [key, value] of Object.entries({ tabindex: 0, role: "button", title: `Show or hide ${label}` }))
      head.setAttribute(key, String(value));
    head.addEventListener("keydown", (event) => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      head.click();
    });
    head.addEventListener("click", () => {
      if (series.show) hidden.delete(label);
      else hidden.add(label);
      update();
    });
    update();
  });
}
