// Tracks against measured depth, which points down, side by side over one depth axis that zooms.

import { area, extent, path, valueAt } from "./curve.js";
import { el, svg } from "./dom.js";
import { csv, downloads, svgFile } from "./downloads.js";
import { findingsOf, kindText } from "./findings.js";
import { listenToDepths } from "./gestures.js";
import { schematic, lies } from "./schematic.js";
import { LEVELS } from "./levels.js";
import { chosen, curveId, curveName, look, operations, spoken } from "./solutions.js";
import { choose, on, state } from "./state.js";
import { isPrinting } from "./theme.js";
import { hideTip, showTip } from "./tip.js";
import { alignment, domain, roomyTicks, ticks, tickText } from "./ticks.js";
import { tracksOf } from "./track.js";
import { digits, quantity, shown, si, symbol } from "./units.js";

/** Where more of the string than this is in view, joints are too many to tell apart, m. */
const FAR_M = 400;

/** Markers of a curve over the height of a track. */
const MARKERS = 5;

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

  /** Whether the reader wants to see a curve. */
  const seen = (curve) => curve.well || !state.hidden.has(curveId(curve.solved));

  /** Every value of the depths in view, for a file. */
  function table() {
    const [from, to] = view();
    const rows = all.flatMap((track) =>
      track.curves.filter(seen).flatMap((curve) => {
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
    depthAxis(picture, [from, to], y, width, left);
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
      return { track, box, text: drawTrack(picture, track, box, [from, to], y) };
    });
    const cursor = svg("line", { x1: AXIS, x2: width, class: "cursor", visibility: "hidden" });
    const chosenLine = svg("line", { x1: AXIS, x2: width, class: "chosen", visibility: "hidden" });
    const flag = svg("text", { x: 2, class: "flag", visibility: "hidden" });
    const what = svg("g", { class: "readout" });
    const band = svg("rect", { x: AXIS, width: width - AXIS, class: "drag", visibility: "hidden" });
    const cover = svg("rect", { x: AXIS, y: HEAD, width: width - AXIS, height, class: "cover" });
    picture.append(band, chosenLine, cursor, flag, what, cover);
    cover.addEventListener("pointermove", (event) => tell(event, picture, readouts, [from, to], height));
    cover.addEventListener("pointerleave", hideTip);
    listenToDepths({ cover, band, picture, head: HEAD, height, total, full, view, zoom });
    return { picture, y, readouts, cursor, chosenLine, flag, what };
  }

  function depthAxis(picture, [from, to], y, width, left) {
    const { values, step } = ticks(shown(from, "length"), shown(to, "length"), 12);
    for (const value of values) {
      const at = y(si(value, "length"));
      picture.append(
        svg("line", { x1: left, x2: width, y1: at, y2: at, class: "grid" }),
        svg("text", { x: AXIS - 8, y: at + 4, class: "tick end" }, tickText(value, step)),
      );
    }
    picture.append(
      svg("text", { x: 0, y: 16, class: "title" }, "MD"),
      svg("text", { x: 0, y: 31, class: "unit" }, symbol("length")),
    );
  }

  /** Where readouts go. */
  function drawTrack(picture, track, box, [from, to], y) {
    const view = [from, to];
    const far = to - from > FAR_M;
    const curves = track.curves
      .filter(seen)
      .map((curve) => (far && curve.far ? { ...curve, ...curve.far } : curve));
    let range = track.range;
    if (!range) {
      const ends = curves.flatMap((curve) =>
        [curve.values, curve.low, curve.high].filter(Boolean).map((values) => extent(curve.depths, values, view)),
      );
      range = domain(
        Math.min(...ends.map((end) => end[0])),
        Math.max(...ends.map((end) => end[1])),
        track.zero || track.sides,
        si(1, track.dimension),
        track.least_span,
      );
    }
    const x = (value) => box.left + ((value - range[0]) / (range[1] - range[0])) * box.width;
    const clip = svg("svg", {
      x: box.left,
      y: box.top,
      width: box.width,
      height: box.height,
      viewBox: `${box.left} ${box.top} ${box.width} ${box.height}`,
    });
    const scale = roomyTicks(shown(range[0], track.dimension), shown(range[1], track.dimension), box.width);
    for (const value of scale.values) {
      const at = x(si(value, track.dimension));
      const place = alignment(at - box.left, box.width);
      picture.append(
        svg("line", { x1: at, x2: at, y1: box.top, y2: box.top + box.height, class: value === 0 ? "zero" : "grid" }),
        svg("text", { x: at, y: box.top - 7, class: `tick ${place}` }, tickText(value, scale.step)),
      );
    }
    for (const section of report.hole.filter(
      (section) => section.kind === "casing" && section.to_m > from && section.to_m < to,
    ))
      clip.append(
        svg("line", {
          x1: box.left,
          x2: box.left + box.width,
          y1: y(section.to_m),
          y2: y(section.to_m),
          class: "shoe-depth",
        }),
      );
    findingBands(clip, box, view, y);
    if (track.sides) fillSides(clip, track, view, x, y);
    for (const curve of curves) {
      const { colour, dash, shape, place } = curve.well ? { colour: "var(--text)" } : look(report, curve.solved);
      const faint = !curve.well && operations(report).length > 1 && curve.solved.operation !== state.operation;
      if (curve.low && curve.high)
        clip.append(
          svg("path", {
            d: area(curve.depths, curve.low, curve.high, view, x, y),
            fill: colour,
            class: faint ? "band faint" : "band",
          }),
        );
      clip.append(
        svg("path", {
          d: path(curve.depths, curve.values, view, x, y),
          stroke: colour,
          class: `curve${faint ? " faint" : ""}`,
          "stroke-dasharray": dash?.join(" "),
        }),
      );
      if (shape) clip.append(...markers(curve, { colour, shape, place, faint }, view, x, y));
    }
    if (track.touches) classStrip(clip, track, box, view, y);
    const middle = box.left + box.width / 2;
    picture.append(
      clip,
      svg("rect", { x: box.left, y: box.top, width: box.width, height: box.height, class: "frame" }),
      svg("text", { x: middle, y: 16, class: "title middle" }, track.title),
      svg("text", { x: middle, y: 31, class: "unit middle" }, symbol(track.dimension)),
    );
    if (track.sides)
      picture.append(
        svg("text", { x: box.left, y: box.top + box.height + 14, class: "side low" }, "◂ low side"),
        svg("text", { x: box.left + box.width, y: box.top + box.height + 14, class: "side high end" }, "high side ▸"),
      );
    if (track.swings && far)
      picture.append(svg("text", { x: box.left, y: box.top + box.height + 14, class: "side" }, "joint to joint"));
    if (track.touches)
      picture.append(
        svg(
          "text",
          { x: box.left, y: box.top + box.height + 14, class: "side" },
          "▌ always ",
          svg("tspan", { class: "sometimes" }, "▌"),
          " at times",
        ),
      );
    const text = svg("text", { x: middle, y: 48, class: "readout middle" });
    picture.append(text);
    return text;
  }

  /** Markers along a curve, each curve's at depths of its own. */
  function markers(curve, { colour, shape, place, faint }, [from, to], x, y) {
    const part = (k) => (k + (place + (curve.solved.model === "soft" ? 1.5 : 1)) / (operations(report).length + 1.5)) / MARKERS;
    return Array.from({ length: MARKERS }, (_, k) => from + part(k) * (to - from))
      .map((depth) => [depth, valueAt(curve.depths, curve.values, depth)])
      .filter(([depth, value]) => Number.isFinite(value) && depth <= curve.depths.at(-1))
      .map(([depth, value]) =>
        svg("path", {
          d: shape,
          transform: `translate(${x(value).toFixed(1)} ${y(depth).toFixed(1)})`,
          fill: curve.solved.model === "soft" ? "var(--paper)" : colour,
          stroke: curve.solved.model === "soft" ? colour : "var(--paper)",
          class: `marker${faint ? " faint" : ""}`,
        }),
      );
  }

  /** Stretches and places of findings of the chosen operation, light over the track, and a bar at its edge. */
  function findingBands(clip, box, [from, to], y) {
    for (const { level, md_m, to_md_m } of placed()) {
      if (md_m > to || (to_md_m ?? md_m) < from) continue;
      const [top, end] = [y(md_m), y(to_md_m ?? md_m)];
      const height = Math.max(end - top, 2);
      const at = { y: top, height };
      const stretch = to_md_m !== null;
      if (stretch) clip.append(svg("rect", { x: box.left, width: box.width, ...at, class: `found level-${level}` }));
      clip.append(svg("rect", { x: box.left + box.width - 5, width: 5, ...at, class: `found-bar level-${level}` }));
      if (level !== "error" && stretch)
        // Bars of lesser findings have gaps, so that no colour is needed to tell them.
        for (let gap = top + 6; gap < end; gap += level === "warning" ? 10 : 6)
          clip.append(svg("rect", { x: box.left + box.width - 5, width: 5, y: gap, height: 3, fill: "var(--paper)" }));
    }
  }

  /** The findings of the chosen operation that have a place, the least grave first. */
  const placed = () =>
    findingsOf(report, state.operation)
      .filter((finding) => finding.md_m !== null)
      .reverse();

  /** Names and values of the track under the pointer, and what was found at its depth. */
  function tell(event, picture, readouts, [from, to], height) {
    const bounds = picture.getBoundingClientRect();
    const scale = picture.viewBox.baseVal.width / bounds.width;
    const at = (event.clientX - bounds.left) * scale;
    const depth = from + (((event.clientY - bounds.top) * scale - HEAD) / height) * (to - from);
    const under = readouts.find(({ box }) => at >= box.left && at <= box.left + box.width);
    const rows = (under?.track.curves ?? []).filter(seen).map((curve) => {
      const value = valueAt(curve.depths, curve.values, depth);
      const name = curve.well ? "well" : curveName(report, curve.solved);
      return {
        colour: curve.well ? "var(--text)" : look(report, curve.solved).colour,
        text: `${name}: ${Number.isFinite(value) ? quantity(value, under.track.dimension) : "–"}`,
        class: !curve.well && curve.solved.operation === state.operation ? "mine" : null,
      };
    });
    const reach = 0.006 * (to - from);
    for (const finding of placed().reverse()) {
      const { level, kind, md_m, to_md_m } = finding;
      if (depth < md_m - reach || depth > (to_md_m ?? md_m) + reach) continue;
      const [word, ink] = LEVELS[level];
      rows.push({ colour: `var(--${ink})`, text: `${word}: ${kindText(kind)}` });
    }
    if (rows.length === 0) return hideTip();
    showTip(event, [under?.track.title, `MD ${quantity(depth, "length", 5)}`].filter(Boolean).join(", "), rows);
  }

  /** The area to zero of what the reader looks at: one colour a side. */
  function fillSides(clip, track, view, x, y) {
    const solved = chosen(report, "dynamic") ?? chosen(report, "soft");
    const curve = track.curves.find((curve) => curve.solved === solved);
    if (!curve || !seen(curve)) return;
    const zero = new Float32Array(curve.values.length);
    const part = (keep) => curve.values.map((value) => (keep(value) ? value : 0));
    clip.append(
      svg("path", {
        d: area(
          curve.depths,
          zero,
          part((v) => v > 0),
          view,
          x,
          y,
        ),
        class: "high-side",
      }),
      svg("path", {
        d: area(
          curve.depths,
          part((v) => v < 0),
          zero,
          view,
          x,
          y,
        ),
        class: "low-side",
      }),
    );
  }

  /** How much of the time the string touches, in three classes, along the left edge. */
  function classStrip(clip, track, box, view, y) {
    const solved = chosen(report, "dynamic");
    const curve = track.curves.find((curve) => curve.solved === solved);
    if (!curve) return;
    const classOf = (part) => (part < 0.01 ? 0 : part <= 0.99 ? 1 : 2);
    let start = 0;
    const { depths, values } = curve;
    for (let i = 1; i <= values.length; i++) {
      if (i < values.length && classOf(values[i]) === classOf(values[start])) continue;
      const kind = classOf(values[start]);
      const [y1, y2] = [y(depths[start]), y(depths[Math.min(i, values.length - 1)])];
      if (kind > 0 && y2 > box.top && y1 < box.top + box.height)
        clip.append(
          svg("rect", {
            x: box.left,
            y: y1,
            width: 6,
            height: Math.max(y2 - y1, 0.7),
            class: kind === 2 ? "always" : "sometimes",
          }),
        );
      start = i;
    }
  }

  /** What the tracks show at the depth that is pointed at. */
  function point() {
    const [from, to] = view();
    for (const { y, readouts, cursor, chosenLine, flag, what } of rows) {
      const at = (line, depth) => {
        const seen = depth !== null && depth >= from && depth <= to;
        line.setAttribute("visibility", seen ? "visible" : "hidden");
        if (seen) for (const end of ["y1", "y2"]) line.setAttribute(end, y(depth));
        return seen;
      };
      at(chosenLine, state.depth);
      const seen = at(cursor, state.pointer);
      flag.setAttribute("visibility", seen ? "visible" : "hidden");
      flag.setAttribute("y", seen ? y(state.pointer) + 4 : 0);
      flag.textContent = seen ? digits(shown(state.pointer, "length"), 5) : "";
      what.replaceChildren(
        ...(seen ? lies(report, state.pointer) : []).map((text, i) =>
          svg(
            "text",
            { x: AXIS + WELL / 2, y: 34 + 13 * i, class: "readout middle small" },
            text.length > 24 ? `${text.slice(0, 23)}…` : text,
          ),
        ),
      );
      for (const { track, text } of readouts) text.replaceChildren(...(seen ? values(track) : []));
    }
  }

  function values(track) {
    const mine = track.curves.filter((curve) => seen(curve) && (curve.well || curve.solved.operation === state.operation));
    return mine.map((curve, i) => {
      const value = valueAt(curve.depths, curve.values, state.pointer);
      const fill = curve.well ? "var(--text)" : look(report, curve.solved).colour;
      return svg(
        "tspan",
        { fill, dx: i ? 6 : 0 },
        Number.isFinite(value) ? digits(shown(value, track.dimension)) : "–",
      );
    });
  }

  function legend() {
    const curves = report.solved.map((solved) => {
      const { colour, dash, shape } = look(report, solved);
      const id = curveId(solved);
      const hidden = state.hidden.has(id);
      const name = curveName(report, solved);
      return el(
        "button",
        {
          type: "button",
          class: "key",
          "aria-pressed": String(!hidden),
          title: hidden ? `Show ${name}` : `Hide ${name}`,
          onclick: () => {
            const next = new Set(state.hidden);
            if (!next.delete(id)) next.add(id);
            choose({ hidden: next });
            // What was drawn anew keeps the keyboard's place.
            keys.querySelector(`[data-curve="${id}"]`)?.focus();
          },
          "data-curve": id,
        },
        svg(
          "svg",
          { width: 30, height: 12 },
          svg("line", { x1: 1, x2: 29, y1: 6, y2: 6, stroke: colour, class: "curve", "stroke-dasharray": dash?.join(" ") }),
          shape &&
            svg("path", {
              d: shape,
              transform: "translate(15 6)",
              fill: solved.model === "soft" ? "var(--paper)" : colour,
              stroke: solved.model === "soft" ? colour : "var(--paper)",
              class: "marker",
            }),
        ),
        name,
      );
    });
    const found = [...new Set(placed().map((finding) => finding.level))].reverse().map((level) =>
      el(
        "span",
        { class: "key" },
        svg(
          "svg",
          { width: 20, height: 12 },
          svg("rect", { width: 20, height: 12, class: `found level-${level}` }),
          svg("rect", { x: 15, width: 5, height: 12, class: `found-bar level-${level}` }),
        ),
        `${LEVELS[level][0].toLowerCase()} here, ${spoken(state.operation)}`,
      ),
    );
    const band = report.runs.length
      ? [
          el(
            "span",
            { class: "key" },
            svg(
              "svg",
              { width: 26, height: 10 },
              svg("rect", { width: 26, height: 10, fill: "var(--muted)", class: "band" }),
            ),
            "5–95 % of the time",
          ),
        ]
      : [];
    const side = ["high", "low"].map((name) =>
      el(
        "span",
        { class: "key" },
        svg("svg", { width: 14, height: 10 }, svg("rect", { width: 14, height: 10, class: `${name}-side` })),
        `on the ${name} side`,
      ),
    );
    return [...curves, ...band, ...side, ...found];
  }

  const keys = el("div", { class: "legend" });
  const redraw = () => {
    keys.replaceChildren(...legend());
    draw();
  };
  on("units depths operation hidden", redraw);
  on("pointer depth", point);
  new ResizeObserver(
    () => !isPrinting() && holder.clientWidth !== Number(rows[0]?.picture.getAttribute("width")) && draw(),
  ).observe(holder);
  return { element: el("div", {}, keys, tools, holder), redraw, full, zoomTo };
}
