// What the bit takes away for what it is given: rate of penetration and torque against weight.

import uPlot from "uplot";
import { air, axes, LEGEND, legendText, widthOf } from "../../../../web/components/chart.ts";
import { el } from "../../../../web/components/dom.ts";
import { line } from "../../../../web/components/palette.ts";
import { isPrinting } from "../../../../web/components/printing.ts";
import { shownAll, symbol } from "../../../../web/components/units.ts";
import { chartRows, chartSvg } from "./chart_svg.js";
import { csv, downloads } from "./downloads.js";
import { chosenRun } from "./solutions.js";
import { on } from "./state.js";

const HEIGHT = 260;

export function drillOff(report) {
  const holder = el("div", { class: "histories" });
  const [weight, ...others] = report.drill_off_plots;
  const across = () => `${weight.title}, ${symbol(weight.dimension)}`;
  let plots = [];

  function draw() {
    plots.forEach((plot) => plot.destroy());
    plots = [];
    const samples = chosenRun(report)?.drill_off;
    if (!samples) return holder.replaceChildren();
    // Points stand in the order of their weight, as the plot wants them.
    const weights = samples[weight.column];
    const order = Array.from(weights, (_, i) => i)
      .filter((i) => Number.isFinite(weights[i]))
      .sort((a, b) => weights[a] - weights[b]);
    const values = ({ column, dimension }) => shownAll(Array.from(order, (i) => samples[column][i]), dimension);
    const cards = others.map((of) => {
      const { heading, dimension } = of;
      const body = el("div", { class: "plot" });
      const head = el("h3", {}, heading, el("span", { class: "unit" }, ` ${symbol(dimension)}`));
      let plot = null;
      head.append(
        downloads(heading, {
          svg: () => chartSvg(plot, `${heading}, ${symbol(dimension)}`, across()),
          csv: () => csv(...chartRows(plot, across(), symbol(dimension))),
        }),
      );
      const make = () => plots.push((plot = scatter(body, of, values(weight), values(of))));
      return { element: el("figure", { class: "card history" }, head, body), make };
    });
    holder.replaceChildren(...cards.map((card) => card.element));
    for (const card of cards) card.make();
  }

  function scatter(body, { title, dimension, min_span }, weights, values) {
    const point = line(0);
    return new uPlot(
      {
        width: widthOf(body),
        height: HEIGHT,
        cursor: { drag: { x: true, y: true, uni: 8 }, points: { size: 6 } },
        legend: LEGEND,
        scales: {
          x: { time: false, range: (_, low, high) => air(low, high, weight.dimension, weight.min_span) },
          y: { range: (_, low, high) => air(low, high, dimension, min_span) },
        },
        axes: axes(across()),
        series: [
          { label: `weight, ${symbol(weight.dimension)}`, value: legendText },
          {
            label: title.replace(/^./, (letter) => letter.toLowerCase()),
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
