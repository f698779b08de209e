// What the bit takes away for what it is given: rate of penetration and torque against weight.

import uPlot from "uplot";
import { air, axes, LEGEND, legendText, widthOf } from "./chart.js";
import { chartRows, chartSvg } from "./chart_svg.js";
import { el } from "./dom.js";
import { csv, downloads } from "./downloads.js";
import { line } from "./palette.js";
import { chosenRun } from "./solutions.js";
import { on } from "./state.js";
import { isPrinting } from "./theme.js";
import { shownAll, symbol } from "./units.js";

const HEIGHT = 260;

/** Least span of the weight's axis, N. */
const LEAST_WEIGHT = 1e4;

/** Column, title, dimension, name, and the least span of the axis, SI. */
const PLOTS = [
  ["rate_m_per_s", "Rate of penetration against weight", "rate of penetration", "rate of penetration", 5e-4],
  ["torque_N_m", "Torque against weight", "torque", "torque on bit", 500],
];

export function drillOff(report) {
  const holder = el("div", { class: "histories" });
  let plots = [];

  function draw() {
    plots.forEach((plot) => plot.destroy());
    plots = [];
    const samples = chosenRun(report)?.drill_off;
    if (!samples) return holder.replaceChildren();
    // Points stand in the order of their weight, as the plot wants them.
    const order = Array.from(samples.weight_N, (_, i) => i)
      .filter((i) => Number.isFinite(samples.weight_N[i]))
      .sort((a, b) => samples.weight_N[a] - samples.weight_N[b]);
    const column = (name, dimension) => shownAll(Array.from(order, (i) => samples[name][i]), dimension);
    const weights = column("weight_N", "force");
    const cards = PLOTS.map(([name, title, dimension, label, least]) => {
      const body = el("div", { class: "plot" });
      const head = el("h3", {}, title, el("span", { class: "unit" }, ` ${symbol(dimension)}`));
      let plot = null;
      const across = `Weight on bit, ${symbol("force")}`;
      head.append(
        downloads(title, {
          svg: () => chartSvg(plot, `${title}, ${symbol(dimension)}`, across),
          csv: () => csv(...chartRows(plot, across, symbol(dimension))),
        }),
      );
      const make = () => plots.push((plot = scatter(body, weights, column(name, dimension), dimension, label, least)));
      return { element: el("figure", { class: "card history" }, head, body), make };
    });
    holder.replaceChildren(...cards.map((card) => card.element));
    for (const card of cards) card.make();
  }

  function scatter(body, weights, values, dimension, label, least) {
    const point = line(0);
    return new uPlot(
      {
        width: widthOf(body),
        height: HEIGHT,
        cursor: { drag: { x: true, y: true, uni: 8 }, points: { size: 6 } },
        legend: LEGEND,
        scales: {
          x: { time: false, range: (_, low, high) => air(low, high, "force", LEAST_WEIGHT) },
          y: { range: (_, low, high) => air(low, high, dimension, least) },
        },
        axes: axes(`Weight on bit, ${symbol("force")}`),
        series: [
          { label: `weight, ${symbol("force")}`, value: legendText },
          {
            label,
            stroke: point,
            paths: () => null,
            points: { show: true, size: 3.5, width: 0, fill: `color-mix(in srgb, ${point} 55%, transparent)` },
            value: legendText,
          },
        ],
      },
      [weights, values],
      body,
    );
  }

  on("units operation", draw);
  let width = 0;
  new ResizeObserver(() => {
    if (isPrinting() || holder.clientWidth === width) return;
    width = holder.clientWidth;
    for (const plot of plots) plot.setSize({ width: widthOf(plot.root.parentElement), height: HEIGHT });
  }).observe(holder);
  const words = el("p", { class: "note" }, "Each point is a sample of the window of the statistics.");
  return { element: el("div", { class: "drill-off" }, holder, words), redraw: draw };
}
