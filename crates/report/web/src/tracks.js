// Tracks against measured depth, which points down, side by side over one depth axis that zooms.

import { valueAt } from "../../../../web/components/curve.ts";
import { el, svg } from "../../../../web/components/dom.ts";
import { listenToDepths } from "../../../../web/components/gestures.ts";
import { isPrinting } from "../../../../web/components/printing.ts";
import { schematic, lies } from "../../../../web/components/schematic.ts";
import { hideTip, showTip } from "../../../../web/components/tip.ts";
import { depthAxis } from "../../../../web/components/track.ts";
import { depthText, digits, quantity, shown, si, symbol } from "../../../../web/components/units.ts";
import { csv, downloads, svgFile } from "./downloads.js";
import { placedOf } from "./checks.js";
import { inkOf, SEVERITIES } from "./severities.js";
import { curveName, look } from "./solutions.js";
import { choose, on, state } from "./state.js";
import { isShown, sized, tracksOf } from "./track.js";
import { trackLegend } from "./track_legend.js";
import { drawTrack } from "./track_panel.js";

/** Width on paper, so that letters are of a size to be read there. */
const PAPER = 700;

/** Width of a track at least, and there. */
const NARROWEST = 126;
const ON_PAPER = 120;

const AXIS = 54;
const WELL = 88;
const GAP = 14;
const HEAD = 82;
const FOOT = 20;

/** The tracks of a report, drawn into a section that they fill. */
export function tracks(report) {
  const all = tracksOf(report);
  const deepest = Math.max(
    report.well.md_m.at(-1) ?? 0,
    ...report.solved.map((solved) => solved.profile.md_m?.at(-1) ?? 0),
  );
  const full = [0, deepest];
  const view = () => state.depths ?? full;
  const holder = el("div", { class: "tracks" });
  let rows = [];

  const inputs = ["from", "to"].map((label, end) =>
    el("input", {
      type: "number",
      "aria-label": `Depths in view, ${label}`,
      step: "any",
      onchange: (event) => {
        const depths = [...view()];
        depths[end] = si(Number(event.target.value), "length");
        zoom(depths);
      },
    }),
  );
  const unitText = el("span", {});
  const reset = el("button", { type: "button", onclick: () => zoom(full) }, "All depths");
  const tools = el(
    "div",
    { class: "tools noprint" },
    el("label", {}, "Depths from ", inputs[0]),
    el("label", {}, "to ", inputs[1]),
    unitText,
    reset,
    downloads("Along the hole", { svg: () => svgFile(rows.map((row) => row.picture)), csv: () => csv(...table()) }),
    el(
      "span",
      { class: "hint" },
      "drag to zoom, Ctrl + wheel, Shift + drag to move, click to choose a depth, double-click for all",
    ),
  );

  /** Every value of the depths in view, for a file. */
  function table() {
    const [from, to] = view();
    const rows = all.flatMap((track) =>
      track.curves.filter(isShown).flatMap((curve) => {
        const { solved, depths, values, low, high } = curve;
        const number = (column, i) => (column ? shown(column[i], track.dimension) : null);
        const who = solved ? [solved.operation, solved.model] : ["", ""];
        return Array.from(depths, (depth, i) => [depth, i])
          .filter(([depth]) => depth >= from && depth <= to)
          .map(([depth, i]) => [
            track.title,
            symbol(track.dimension),
            ...who,
            shown(depth, "length"),
            number(values, i),
            number(low, i),
            number(high, i),
          ]);
      }),
    );
    return [["quantity", "unit", "operation", "model", `md, ${symbol("length")}`, "value", "p05", "p95"], rows];
  }

  /** Shows an interval of depths, or what is around a depth. */
  function zoomTo({ md_m, to_md_m }) {
    const length = Math.max((to_md_m ?? md_m) - md_m, 0.02 * deepest);
    zoom([md_m - 0.1 * length, (to_md_m ?? md_m) + 0.1 * length]);
    holder.scrollIntoView({ block: "nearest" });
  }

  function zoom([from, to]) {
    const [low, high] = [Math.max(Math.min(from, to), full[0]), Math.min(Math.max(from, to), full[1])];
    if (!(high - low >= 2)) return;
    choose({ depths: low <= full[0] && high >= full[1] ? null : [low, high] });
  }

  function draw() {
    const width = isPrinting() ? PAPER : holder.clientWidth || 1360;
    const narrowest = isPrinting() ? ON_PAPER : NARROWEST;
    const fit = Math.max(Math.floor((width - AXIS - WELL - GAP) / (narrowest + GAP)), 1);
    const lines = Math.ceil(all.length / Math.min(fit, all.length));
    const each = Math.ceil(all.length / lines);
    const height = lines === 1 ? 640 : isPrinting() ? 370 : 500;
    rows = Array.from({ length: lines }, (_, i) => row(all.slice(i * each, (i + 1) * each), width, each, height));
    holder.replaceChildren(...rows.map((row) => row.picture));
    const [from, to] = view();
    inputs[0].value = shown(from, "length").toFixed(1);
    inputs[1].value = shown(to, "length").toFixed(1);
    unitText.textContent = symbol("length");
    reset.disabled = state.depths === null;
    point();
  }

  /** One line of tracks over the same depths. */
  function row(tracks, width, each, height) {
    const [from, to] = view();
    const y = (depth) => HEAD + ((depth - from) / (to - from)) * height;
    const total = HEAD + height + FOOT;
    const picture = svg("svg", {
      viewBox: `0 0 ${width} ${total}`,
      width,
      height: total,
      role: "img",
      "aria-label": tracks.map((track) => track.title).join(", "),
    });
    const left = AXIS + WELL + GAP;
    const wide = (width - left - GAP * (each - 1) - 2) / each;
    depthAxis(picture, [from, to], y, { axis: AXIS, left, right: width });
    const well = { left: AXIS, width: WELL, top: HEAD, height };
    const clipped = svg("svg", {
      x: 0,
      y: HEAD - 10,
      width,
      height: height + 18,
      viewBox: `0 ${HEAD - 10} ${width} ${height + 18}`,
    });
    clipped.append(schematic(report, well, [from, to], y));
    picture.append(clipped, svg("text", { x: AXIS + WELL / 2, y: 16, class: "title middle" }, "Hole, string"));
    const readouts = tracks.map((track, i) => {
      const box = { left: left + i * (wide + GAP), width: wide, top: HEAD, height };
      return { track, box, ...drawTrack(report, picture, track, box, [from, to], y) };
    });
    const cursor = svg("line", { x1: AXIS, x2: width, class: "cursor", visibility: "hidden" });
    const chosenLine = svg("line", { x1: AXIS, x2: width, class: "chosen", visibility: "hidden" });
    const chosenName = svg("text", { x: width - 4, class: "side end", visibility: "hidden" });
    const flag = svg("text", { x: 2, class: "flag", visibility: "hidden" });
    const what = svg("g", { class: "readout" });
    const band = svg("rect", { x: AXIS, width: width - AXIS, class: "drag", visibility: "hidden" });
    const cover = svg("rect", { x: AXIS, y: HEAD, width: width - AXIS, height, class: "cover" });
    picture.append(band, chosenLine, chosenName, cursor, flag, what, cover);
    cover.addEventListener("pointermove", (event) => showReadout(event, picture, readouts, [from, to], height));
    cover.addEventListener("pointerleave", hideTip);
    const point = (pointer) => choose({ pointer });
    listenToDepths({ cover, band, picture, head: HEAD, height, total, full, view, zoom, point, choose: (depth) => choose({ depth }) });
    return { picture, y, readouts, cursor, chosenLine, chosenName, flag, what };
  }

  /** Names and values of the track under the pointer, and what was found at its depth. */
  function showReadout(event, picture, readouts, [from, to], height) {
    const bounds = picture.getBoundingClientRect();
    const scale = picture.viewBox.baseVal.width / bounds.width;
    const at = (event.clientX - bounds.left) * scale;
    const depth = from + (((event.clientY - bounds.top) * scale - HEAD) / height) * (to - from);
    const under = readouts.find(({ box }) => at >= box.left && at <= box.left + box.width);
    const rows = (under?.curves ?? []).flatMap((curve) => {
      const name = curve.well ? "well" : curveName(report, curve.solved);
      const line = (values, where) => {
        const value = sized(under.track, valueAt(curve.depths, values, depth));
        return {
          colour: curve.well ? "var(--text)" : look(report, curve.solved).colour,
          text: `${name}${where}: ${Number.isFinite(value) ? quantity(value, under.track.dimension) : "–"}`,
          class: !curve.well && curve.solved.operation === state.operation ? "mine" : null,
        };
      };
      if (!curve.between) return [line(curve.values, "")];
      return [line(curve.values, ", at the joints"), line(curve.between, ", between the joints")];
    });
    const reach = 0.006 * (to - from);
    for (const check of placedOf(report).reverse()) {
      const { severity: level, label, md_m, to_md_m } = check;
      if (depth < md_m - reach || depth > (to_md_m ?? md_m) + reach) continue;
      const [word] = SEVERITIES[level];
      rows.push({ colour: inkOf(level), text: `${word}: ${label}` });
    }
    if (rows.length === 0) return hideTip();
    showTip(event, [under?.track.title, `MD ${quantity(depth, "length", 5)}`].filter(Boolean).join(", "), rows);
  }

  /** What the tracks show at the depth that is pointed at. */
  function point() {
    const [from, to] = view();
    for (const { y, readouts, cursor, chosenLine, chosenName, flag, what } of rows) {
      const at = (line, depth) => {
        const inView = depth !== null && depth >= from && depth <= to;
        line.setAttribute("visibility", inView ? "visible" : "hidden");
        if (inView) for (const end of ["y1", "y2"]) line.setAttribute(end, y(depth));
        return inView;
      };
      const hasChosen = at(chosenLine, state.depth);
      chosenName.setAttribute("visibility", hasChosen ? "visible" : "hidden");
      // Over the line; below it where it is at the top.
      const line = hasChosen ? y(state.depth) : 0;
      chosenName.setAttribute("y", line < HEAD + 16 ? line + 13 : line - 4);
      chosenName.textContent = hasChosen ? `chosen depth ${depthText(state.depth)}` : "";
      const inView = at(cursor, state.pointer);
      flag.setAttribute("visibility", inView ? "visible" : "hidden");
      flag.setAttribute("y", inView ? y(state.pointer) + 4 : 0);
      flag.textContent = inView ? digits(shown(state.pointer, "length"), 5) : "";
      what.replaceChildren(
        ...(inView ? lies(report, state.pointer) : []).map((text, i) =>
          svg(
            "text",
            { x: AXIS + WELL / 2, y: 34 + 13 * i, class: "readout middle small" },
            text.length > 24 ? `${text.slice(0, 23)}…` : text,
          ),
        ),
      );
      for (const { track, curves, text } of readouts) text.replaceChildren(...(inView ? values(track, curves) : []));
    }
  }

  /** Values of the chosen operation at the depth that is pointed at. */
  function values(track, curves) {
    const mine = curves.filter((curve) => curve.well || curve.solved.operation === state.operation);
    return mine.map((curve, i) => {
      const value = sized(track, valueAt(curve.depths, curve.values, state.pointer));
      const fill = curve.well ? "var(--text)" : look(report, curve.solved).colour;
      return svg(
        "tspan",
        { fill, dx: i ? 6 : 0 },
        Number.isFinite(value) ? digits(shown(value, track.dimension)) : "–",
      );
    });
  }

  const keys = el("div", { class: "legend" });
  const redraw = () => {
    draw();
    const between = rows.some((row) => row.readouts.some(({ curves }) => curves.some((curve) => curve.between)));
    keys.replaceChildren(...trackLegend(report, between));
  };
  on("units depths operation hidden", redraw);
  on("pointer depth", point);
  new ResizeObserver(
    () => !isPrinting() && holder.clientWidth !== Number(rows[0]?.picture.getAttribute("width")) && draw(),
  ).observe(holder);
  return { element: el("div", {}, keys, tools, holder), redraw, full, zoomTo };
}
