// Tracks against measured depth, which points down, side by side over one depth axis that zooms.

import { area, extent, path, valueAt } from "./curve.js";
import { el, svg } from "./dom.js";
import { listenToDepths } from "./gestures.js";
import { schematic, lies } from "./schematic.js";
import { chosen, curveName, look, operations } from "./solutions.js";
import { choose, on, state } from "./state.js";
import { isPrinting } from "./theme.js";
import { alignment, domain, roomyTicks, ticks, tickText } from "./ticks.js";
import { tracksOf } from "./track.js";
import { digits, shown, si, symbol } from "./units.js";

/** Where more of the string than this is in view, joints are too many to tell apart, m. */
const FAR_M = 400;

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
    el(
      "span",
      { class: "hint" },
      "drag to zoom, Ctrl + wheel, Shift + drag to move, click to choose a depth, double-click for all",
    ),
  );

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
      return { track, text: drawTrack(picture, track, box, [from, to], y) };
    });
    const cursor = svg("line", { x1: AXIS, x2: width, class: "cursor", visibility: "hidden" });
    const chosenLine = svg("line", { x1: AXIS, x2: width, class: "chosen", visibility: "hidden" });
    const flag = svg("text", { x: 2, class: "flag", visibility: "hidden" });
    const what = svg("g", { class: "readout" });
    const band = svg("rect", { x: AXIS, width: width - AXIS, class: "drag", visibility: "hidden" });
    const cover = svg("rect", { x: AXIS, y: HEAD, width: width - AXIS, height, class: "cover" });
    picture.append(band, chosenLine, cursor, flag, what, cover);
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
    const curves = track.curves.map((curve) => (far && curve.far ? { ...curve, ...curve.far } : curve));
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
    if (track.sides) fillSides(clip, track, view, x, y);
    for (const curve of curves) {
      const { colour, dashed } = curve.well ? { colour: "var(--text)", dashed: false } : look(report, curve.solved);
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
          class: `curve${dashed ? " dashed" : ""}${faint ? " faint" : ""}`,
        }),
      );
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

  /** The area to zero of what the reader looks at: one colour a side. */
  function fillSides(clip, track, view, x, y) {
    const solved = chosen(report, "dynamic") ?? chosen(report, "soft");
    const curve = track.curves.find((curve) => curve.solved === solved);
    if (!curve) return;
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
    const mine = track.curves.filter((curve) => curve.well || curve.solved.operation === state.operation);
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
      const { colour, dashed } = look(report, solved);
      return el(
        "span",
        { class: "key" },
        svg(
          "svg",
          { width: 26, height: 10 },
          svg("line", { x1: 1, x2: 25, y1: 5, y2: 5, stroke: colour, class: `curve${dashed ? " dashed" : ""}` }),
        ),
        curveName(report, solved),
      );
    });
    const band = report.runs.length
      ? [
          el(
            "span",
            { class: "key" },
            svg(
              "svg",
              { width: 26, height: 10 },
              svg("rect", { width: 26, height: 10, fill: "var(--line-0)", class: "band" }),
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
    return [...curves, ...band, ...side];
  }

  const keys = el("div", { class: "legend" });
  const redraw = () => {
    keys.replaceChildren(...legend());
    draw();
  };
  on("units depths operation", redraw);
  on("pointer depth", point);
  new ResizeObserver(
    () => !isPrinting() && holder.clientWidth !== Number(rows[0]?.picture.getAttribute("width")) && draw(),
  ).observe(holder);
  return { element: el("div", {}, keys, tools, holder), redraw, full };
}
