// Power spectral densities of the signals that the case asks for.

import uPlot from "uplot";
import { axes, followLegend, LEGEND, legendText, widthOf } from "../../../../web/components/chart.ts";
import { el } from "../../../../web/components/dom.ts";
import { dashOf } from "../../../../web/components/marker.ts";
import { line } from "../../../../web/components/palette.ts";
import { isPrinting } from "../../../../web/components/printing.ts";
import { quantity, symbol, shown } from "../../../../web/components/units.ts";
import { chartRows, chartSvg } from "./chart_svg.js";
import { csv, downloads } from "./downloads.js";
import { chosenRun, readable } from "./solutions.js";
import { on } from "./state.js";

const HEIGHT = 260;

/** The unit of a density of a signal with this dimension. */
function densityUnit(dimension) {
  const unit = symbol(dimension);
  if (unit === "") return "1/Hz";
  return /^\p{L}+$/u.test(unit) ? `${unit}²/Hz` : `(${unit})²/Hz`;
}

export function spectra(report) {
  const holder = el("div", { class: "histories" });
  let plots = [];

  /** Signals of the chosen operation, each with the densities of all its nodes. */
  function signals() {
    const groups = new Map();
    for (const of of chosenRun(report)?.spectra ?? []) {
      const key = `${of.signal} ${of.md_m !== null}`;
      if (!groups.has(key)) groups.set(key, []);
      groups.get(key).push(of);
    }
    // A signal that does not move has no density that a logarithm has a place for.
    const moves = (of) => of.density.slice(1).some((value) => value > 0);
    return [...groups.values()].filter((group) => group.some(moves));
  }

  function draw() {
    plots.forEach((plot) => plot.destroy());
    plots = [];
    const cards = signals().map(card);
    holder.replaceChildren(...cards.map((card) => card.element));
    for (const card of cards) plots.push(card.make());
  }

  function card(group) {
    const [{ signal, dimension, md_m }] = group;
    const at = group.length === 1 && md_m !== null ? ` at ${quantity(md_m, "length", 5)}` : "";
    const title = `Density of ${readable(signal)}${at}`;
    const unit = densityUnit(dimension);
    const body = el("div", { class: "plot" });
    let plot = null;
    const head = el(
      "h3",
      {},
      title,
      el("span", { class: "unit" }, ` ${unit}`),
      downloads(title, {
        svg: () => chartSvg(plot, `${title}, ${unit}`, "Frequency, Hz"),
        csv: () => csv(...chartRows(plot, "frequency, Hz", unit)),
      }),
    );
    const make = () => (plot = chart(body, group, dimension, `${chosenRun(report).operation} ${signal}`));
    return { element: el("figure", { class: "card history" }, head, body), make };
  }

  function chart(body, group, dimension, name) {
    // The density at rest is the mean's, which a logarithm has no place for; it goes with the square of the unit.
    const frequencies = Array.from(group[0].frequency_Hz).slice(1);
    const factor = dimension ? shown(1, dimension) ** 2 : 1;
    const columns = group.map((of) =>
      Array.from(of.density)
        .slice(1)
        .map((value) => (value > 0 ? value * factor : null)),
    );
    const single = group.length === 1 && group[0].md_m === null;
    const values = columns.flat().filter((value) => value !== null);
    const most = Math.max(...values);
    // Nine decades below the highest is rounding.
    const least = Math.max(Math.min(...values), most * 1e-9);
    const [below, beside] = axes("Frequency, Hz");
    // Of many decades every few.
    const every = Math.max(Math.ceil(Math.log10(most / least) / 6), 1);
    const whole = (value) => Math.abs(Math.log10(value) - Math.round(Math.log10(value))) < 1e-6;
    const decades = (_, splits) => splits.map((value) => (whole(value) && Math.round(Math.log10(value)) % every === 0 ? value : null));
    const power = (plot, splits) => decades(plot, splits).map((value) => (value === null ? "" : `1e${Math.round(Math.log10(value))}`));
    const made = new uPlot(
      {
        width: widthOf(body),
        height: HEIGHT,
        cursor: { drag: { x: true, y: false, uni: 8 }, points: { size: 6 } },
        legend: LEGEND,
        scales: {
          x: { time: false, distr: 3, range: (_, from, to) => [from, to] },
          y: { distr: 3, range: () => [least / 1.5, most * 1.5] },
        },
        axes: [
          { ...below, grid: { ...below.grid, filter: decades }, values: (_, splits) => splits.map((value) => (value === null ? "" : String(Number(value.toPrecision(3))))) },
          { ...beside, grid: { ...beside.grid, filter: decades }, values: power },
        ],
        series: [
          { label: "frequency, Hz", value: legendText },
          ...group.map((of, i) => ({
            label: single ? readable(of.signal) : `at ${quantity(of.md_m, "length", 5)}`,
            stroke: line(i),
            dash: dashOf(i) ?? undefined,
            width: 1.4,
            points: { show: false },
            value: legendText,
          })),
        ],
      },
      [frequencies, ...columns],
      body,
    );
    followLegend(made, `spectrum ${name}`);
    return made;
  }

  on("units operation", draw);
  let width = 0;
  new ResizeObserver(() => {
    if (isPrinting() || holder.clientWidth === width) return;
    width = holder.clientWidth;
    for (const plot of plots) plot.setSize({ width: widthOf(plot.root.parentElement), height: HEIGHT });
  }).observe(holder);
  const hint = el("p", { class: "hint noprint" }, "of the window of the statistics; drag to zoom, double-click for all");
  return { element: el("div", {}, hint, holder), redraw: draw };
}
