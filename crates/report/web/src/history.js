// Time histories that zoom and pan together.

import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { air, axes, followLegend, LEGEND, legendText, widthOf } from "../../../../web/components/chart.ts";
import { below } from "../../../../web/components/curve.ts";
import { el } from "../../../../web/components/dom.ts";
import { dashOf } from "../../../../web/components/marker.ts";
import { colour, line } from "../../../../web/components/palette.ts";
import { isPrinting } from "../../../../web/components/printing.ts";
import { quantity, shown, shownAll, symbol } from "../../../../web/components/units.ts";
import { chartRows, chartSvg } from "./chart_svg.js";
import { csv, downloads } from "./downloads.js";
import { chosenAtRest, chosenRun, modelName, readable } from "./solutions.js";
import { choose, on, state } from "./state.js";

const SYNC = uPlot.sync("time");

const HEIGHT = 216;

/** Height on paper, where four stand on a page. */
const ON_PAPER = 196;

/** Histories of these plots; with what the chosen node did where `follows` says so. */
export function history(report, timePlots, follows) {
  const holder = el("div", { class: "histories" });
  let plots = [];
  let following = false;

  /** Plots of the chosen operation, with their data. */
  function shownPlots(run) {
    const columns = run.history;
    if (!columns.time_s) return [];
    const fixed = timePlots
      .map((plot) => ({ ...plot, columns: plot.columns.filter(([name]) => columns[name]) }))
      .filter((plot) => plot.columns.length)
      .filter((plot) => plot.columns.some(([name]) => columns[name].some((value) => value !== 0)))
      .map((plot) => ({ ...plot, times: columns.time_s, values: plot.columns.map(([name]) => columns[name]) }));
    const node = follows ? nodePlot(run) : null;
    return node ? [...fixed, node] : fixed;
  }

  let channel = report.node_channels[0].column;

  /** What the chosen node did: from frames where they were kept, from the map of contact otherwise. */
  function nodePlot(run) {
    const { frames, contact } = run;
    if (frames?.channels[channel]) {
      const nodes = frames.md_m.length;
      const node = nearest(frames.md_m, state.depth);
      const { title, dimension, min_span } = report.node_channels.find(({ column }) => column === channel);
      const values = Float32Array.from(frames.time_s, (_, k) => frames.channels[channel][k * nodes + node]);
      return {
        title: `${title} at ${quantity(frames.md_m[node], "length", 5)}`,
        dimension,
        min_span,
        columns: [[channel, "node"]],
        times: frames.time_s,
        values: [values],
        chooses: report.node_channels.filter(({ column }) => frames.channels[column]),
      };
    }
    const [{ column, title, dimension, min_span }] = report.contact_plots;
    if (contact?.values[column]) {
      const stretches = contact.md_m.length;
      const stretch = nearest(contact.md_m, state.depth);
      const values = Float32Array.from(contact.time_s, (_, k) => contact.values[column][k * stretches + stretch]);
      return {
        title: `${title} around ${quantity(contact.md_m[stretch], "length", 5)}`,
        dimension,
        min_span,
        columns: [[column, title.toLowerCase()]],
        times: contact.time_s,
        values: [values],
      };
    }
    return null;
  }

  function draw() {
    plots.forEach((plot) => plot.destroy());
    plots = [];
    const run = chosenRun(report);
    const cards = run ? shownPlots(run).map((plot) => card(plot, run)) : [];
    holder.replaceChildren(...cards.map((card) => card.element));
    for (const { plot, body, it } of cards) plots.push((it.made = make(plot, body, run)));
  }

  function card(plot, run) {
    const body = el("div", { class: "plot" });
    const unit = symbol(plot.dimension);
    const head = el(
      "h3",
      {},
      plot.points && plot.columns.length === 1
        ? plot.columns[0][1].replace(/^./, (letter) => letter.toUpperCase())
        : plot.title,
      unit && el("span", { class: "unit" }, ` ${unit}`),
    );
    if (plot.chooses)
      head.append(
        el(
          "select",
          {
            class: "noprint",
            "aria-label": "Quantity of the chosen node",
            onchange: (event) => {
              channel = event.target.value;
              draw();
            },
          },
          plot.chooses.map(({ column, title }) => el("option", { value: column, selected: column === channel }, title)),
        ),
      );
    const it = { plot, body, made: null };
    const title = () => `${readable(run.operation)}: ${plot.title}`;
    head.append(
      downloads(title, {
        svg: () => chartSvg(it.made, `${title()}${unit ? `, ${unit}` : ""}`, "Time, s"),
        csv: () => csv(...chartRows(it.made, "time, s", unit)),
      }),
    );
    return { ...it, it, element: el("figure", { class: "card history" }, head, body) };
  }

  function make(plot, body, run) {
    const rest = atRest(plot);
    const data = [Array.from(plot.times), ...plot.values.map((values) => shownAll(values, plot.dimension))];
    const series = plot.columns.map(([, label], i) => {
      const set = label === "set";
      return {
        label,
        stroke: line(set ? 6 : ([0, 2, 3][i] ?? i)),
        width: set ? 1.2 : 1.4,
        // The second stroke is that of the equilibrium.
        dash: set ? dashOf(4) : (dashOf([0, 2, 3][i] ?? i) ?? undefined),
        spanGaps: Boolean(plot.points),
        points: { show: false },
        value: legendText,
      };
    });
    if (rest !== null) {
      data.push(data[0].map(() => rest.value));
      series.push({
        label: rest.name,
        stroke: line(1),
        width: 1.4,
        dash: [7, 4],
        points: { show: false },
        value: legendText,
      });
    }
    const view = state.times ?? [0, Math.max(endOf(run), 1e-3)];
    const made = new uPlot(
      {
        width: widthOf(body),
        height: isPrinting() ? ON_PAPER : HEIGHT,
        cursor: {
          sync: { key: SYNC.key, scales: ["x", null] },
          drag: { x: true, y: false, uni: 8 },
          points: { size: 6 },
        },
        legend: LEGEND,
        scales: {
          x: { time: false, min: view[0], max: view[1] },
          y: { dir: plot.points ? -1 : 1, range: (_, low, high) => air(low, high, plot.dimension, plot.min_span) },
        },
        axes: axes("Time, s"),
        series: [{ label: "time, s", value: (_, value) => (value === null ? "–" : value.toFixed(2)) }, ...series],
        hooks: {
          setScale: [(plot, key) => key === "x" && follow(plot)],
          drawClear: [(plot) => settling(plot, run)],
          draw: [(plot) => notes(plot, run)],
        },
      },
      data,
      body,
    );
    listen(made);
    followLegend(made, `${run.operation} ${plot.title.replace(/ (at|around) .*/, "")}`);
    return made;
  }

  /** The number in equilibrium for this plot and whose it is, where there is one. */
  function atRest(plot) {
    const solved = chosenAtRest(report);
    if (!plot.at_surface || !solved) return null;
    const value = solved.profile[plot.at_surface]?.[0];
    return Number.isFinite(value) ? { name: modelName(report, solved), value: shown(value, plot.dimension) } : null;
  }

  /** Keeps all plots on the same times. */
  function follow(plot) {
    if (following || plot.scales.x.min == null || plots.length === 0) return;
    following = true;
    const { min, max } = plot.scales.x;
    const run = chosenRun(report);
    const end = endOf(run);
    for (const other of plots) if (other !== plot) other.setScale("x", { min, max });
    choose({ times: min <= 1e-6 && max >= end - 1e-6 ? null : [min, max] });
    following = false;
  }

  /** What is before the window of the statistics is grey. */
  function settling(plot, run) {
    const { ctx, bbox } = plot;
    const to = plot.valToPos(run.window_s, "x", true);
    const right = Math.min(Math.max(to, bbox.left), bbox.left + bbox.width);
    ctx.save();
    ctx.fillStyle = colour("settling");
    ctx.fillRect(bbox.left, bbox.top, right - bbox.left, bbox.height);
    ctx.restore();
  }

  /** What the schedule notes, as far as there is room. */
  function notes(plot, run) {
    const { ctx, bbox } = plot;
    const ratio = devicePixelRatio;
    let free = -Infinity;
    ctx.save();
    ctx.font = `${10 * ratio}px system-ui, sans-serif`;
    ctx.textAlign = "left";
    ctx.fillStyle = colour("muted");
    ctx.strokeStyle = colour("muted");
    ctx.setLineDash([2 * ratio, 3 * ratio]);
    const pointed = state.moment === null ? [] : [[state.moment, ""]];
    for (const [time, note] of [...run.notes, ...pointed]) {
      const x = plot.valToPos(time, "x", true);
      if (x < bbox.left || x > bbox.left + bbox.width) continue;
      ctx.beginPath();
      ctx.moveTo(x, bbox.top);
      ctx.lineTo(x, bbox.top + bbox.height);
      ctx.stroke();
      const wide = ctx.measureText(note).width;
      if (note && x > free && x + wide < bbox.left + bbox.width) {
        ctx.fillText(note, x + 3 * ratio, bbox.top + 11 * ratio);
        free = x + wide + 8 * ratio;
      }
    }
    ctx.restore();
  }

  /** Ctrl + wheel zooms about the pointer, Shift + drag moves. */
  function listen(plot) {
    const { over } = plot;
    const end = () => endOf(chosenRun(report));
    const set = (min, max) => {
      const low = Math.max(min, 0);
      const high = Math.min(max, end());
      if (high - low > 1e-3) plot.setScale("x", { min: low, max: high });
    };
    over.addEventListener(
      "wheel",
      (event) => {
        if (!event.ctrlKey && !event.metaKey) return;
        event.preventDefault();
        const at = plot.posToVal(event.clientX - over.getBoundingClientRect().left, "x");
        const by = Math.exp(event.deltaY * 0.002);
        set(at + (plot.scales.x.min - at) * by, at + (plot.scales.x.max - at) * by);
      },
      { passive: false },
    );
    over.addEventListener(
      "mousedown",
      (event) => {
        if (!event.shiftKey) return;
        event.stopImmediatePropagation();
        const from = event.clientX;
        const { min, max } = plot.scales.x;
        const move = (event) => {
          const by = ((from - event.clientX) / over.clientWidth) * (max - min);
          const kept = Math.min(Math.max(by, -min), end() - max);
          set(min + kept, max + kept);
        };
        addEventListener("mousemove", move);
        addEventListener("mouseup", () => removeEventListener("mousemove", move), { once: true });
      },
      { capture: true },
    );
    over.addEventListener("dblclick", () => plot.setScale("x", { min: 0, max: end() }));
  }

  on(follows ? "units operation depth" : "units operation", draw);
  on("times", () => {
    if (following) return;
    const run = chosenRun(report);
    if (!run) return;
    const [min, max] = state.times ?? [0, endOf(run)];
    following = true;
    for (const plot of plots) plot.setScale("x", { min, max });
    following = false;
  });
  on("moment", () => plots.forEach((plot) => plot.redraw(false, false)));
  let width = 0;
  new ResizeObserver(() => {
    if (isPrinting() || holder.clientWidth === width) return;
    width = holder.clientWidth;
    for (const plot of plots) plot.setSize({ width: widthOf(plot.root.parentElement), height: HEIGHT });
  }).observe(holder);
  const hint = el(
    "p",
    { class: "hint noprint" },
    "drag to zoom, Ctrl + wheel, Shift + drag to move, double-click for all times; grey: before the window of the statistics",
  );
  return { element: el("div", {}, hint, holder), redraw: draw };
}

/** The last moment of a run; 0 of one that took no sample. */
const endOf = (run) => run?.history.time_s?.at(-1) ?? 0;

/** The index whose depth is nearest. */
export function nearest(depths, depth) {
  if (depths.length < 2) return 0;
  const next = Math.min(Math.max(below(depths, depth ?? 0), 1), depths.length - 1);
  return Math.abs(depths[next] - depth) < Math.abs(depths[next - 1] - depth) ? next : next - 1;
}
