// Contact over depth and time, as a map.

import { choice, el } from "../../../../web/components/dom.ts";
import { colour, colourScale } from "../../../../web/components/palette.ts";
import { isPrinting } from "../../../../web/components/printing.ts";
import { ticks, tickText } from "../../../../web/components/ticks.ts";
import { digits, quantity, shown, si, symbol } from "../../../../web/components/units.ts";
import { csv, downloads } from "./downloads.js";
import { nearest } from "./history.js";
import { chosenRun } from "./solutions.js";
import { choose, on, state } from "./state.js";
import { SvgPen } from "./svg_pen.js";

const LEFT = 58;
const RIGHT = 96;
const TOP = 10;
const BOTTOM = 34;
const HEIGHT = 430;

/** Width on paper. */
const PAPER = 700;

/** The value below which so large a part of the magnitudes lies. */
function percentile(values, part) {
  const sizes = values
    .filter(Number.isFinite)
    .map(Math.abs)
    .sort((a, b) => a - b);
  return sizes[Math.floor(part * (sizes.length - 1))] || 1;
}

export function contactMap(report) {
  const plots = report.contact_plots;
  let plot = plots[0];
  const canvas = el("canvas", { class: "map", role: "img", "aria-label": "Contact over depth and time" });
  const readout = el("p", { class: "readout-line" }, "\u00a0");
  const holder = el("div", { class: "map-holder" }, canvas);
  const tools = el(
    "div",
    { class: "tools noprint" },
    choice(
      "What the map shows",
      plots.map(({ column, title, sides }) => [column, sides ? `${title}, by side` : title]),
      plot.column,
      (value) => {
        plot = plots.find(({ column }) => column === value);
        draw();
      },
    ),
    downloads("Contact over depth and time", { svg: () => file(), csv: () => csv(...table()) }),
    el("span", { class: "hint" }, "follows the depths and times in view above; click to choose a depth and a time"),
  );

  const views = (run) => ({
    depths: state.depths ?? [0, run.contact.md_m.at(-1)],
    times: state.times ?? [run.contact.from_s, run.contact.time_s.at(-1)],
  });

  function draw() {
    const run = chosenRun(report);
    if (!run?.contact?.values[plot.column]) return;
    const ratio = Math.max(devicePixelRatio, 2);
    const width = isPrinting() ? PAPER : holder.clientWidth || 1200;
    canvas.width = width * ratio;
    canvas.height = HEIGHT * ratio;
    canvas.style.aspectRatio = `${width} / ${HEIGHT}`;
    const ink = canvas.getContext("2d");
    ink.scale(ratio, ratio);
    ink.font = "11px system-ui, sans-serif";
    paintAll(ink, run, width, (...what) => picture(ink, ...what));
  }

  /** All of the map with a pen; `paintPicture` paints what has pixels. */
  function paintAll(ink, run, width, paintPicture) {
    const { depths, times } = views(run);
    const box = { left: LEFT, top: TOP, width: width - LEFT - RIGHT, height: HEIGHT - TOP - BOTTOM };
    const largest = percentile(Array.from(run.contact.values[plot.column]), 0.985);
    const signed = plot.sides;
    const scaled = colourScale(signed);
    const paint = (value) => scaled(signed ? 0.5 + (0.5 * value) / largest : value / largest);
    paintPicture(run, box, depths, times, paint);
    axes(ink, box, depths, times, run);
    scale(ink, box, largest, paint);
  }

  /** The map as the text of an SVG file. */
  function file() {
    const run = chosenRun(report);
    const width = 1000;
    const pen = new SvgPen(width, HEIGHT);
    pen.fillStyle = colour("paper");
    pen.fillRect(0, 0, width, HEIGHT);
    paintAll(pen, run, width, (run, box, ...what) => {
      const buffer = el("canvas", { width: box.width * 2, height: box.height * 2 });
      const ink = buffer.getContext("2d");
      ink.scale(2, 2);
      ink.translate(-box.left, -box.top);
      picture(ink, run, box, ...what);
      pen.image(buffer.toDataURL(), box.left, box.top, box.width, box.height);
    });
    return pen.file();
  }

  /** The map as rows, of what is in view. */
  function table() {
    const { contact } = chosenRun(report);
    const { depths, times } = views(chosenRun(report));
    const rows = [];
    contact.time_s.forEach((time, k) => {
      if (time < times[0] || time > times[1]) return;
      contact.md_m.forEach((depth, i) => {
        if (depth < depths[0] || depth > depths[1]) return;
        const at = k * contact.md_m.length + i;
        const forces = plots.map(({ column, dimension }) => shown(contact.values[column][at], dimension));
        rows.push([time, shown(depth, "length"), ...forces]);
      });
    });
    const heads = plots.map(({ title, dimension }) => `${title.toLowerCase()}, ${symbol(dimension)}`);
    return [["time, s", `md, ${symbol("length")}`, ...heads], rows];
  }

  function picture(ink, run, box, [d0, d1], [t0, t1], paint) {
    const { contact } = run;
    const stretches = contact.md_m.length;
    const image = new ImageData(contact.time_s.length, Math.round(box.height));
    for (let row = 0; row < image.height; row++) {
      const stretch = nearest(contact.md_m, d0 + ((row + 0.5) / image.height) * (d1 - d0));
      for (let k = 0; k < image.width; k++) {
        const [r, g, b] = paint(contact.values[plot.column][k * stretches + stretch] || 0);
        image.data.set([r, g, b, 255], 4 * (row * image.width + k));
      }
    }
    const buffer = new OffscreenCanvas(image.width, image.height);
    buffer.getContext("2d").putImageData(image, 0, 0);
    ink.save();
    ink.beginPath();
    ink.rect(box.left, box.top, box.width, box.height);
    ink.clip();
    ink.imageSmoothingEnabled = false;
    const x = (time) => box.left + ((time - t0) / (t1 - t0)) * box.width;
    let from = contact.from_s;
    contact.time_s.forEach((to, k) => {
      ink.drawImage(buffer, k, 0, 1, image.height, x(from), box.top, x(to) - x(from) + 0.5, box.height);
      from = to;
    });
    ink.restore();
  }

  function axes(ink, box, [d0, d1], [t0, t1], run) {
    const y = (depth) => box.top + ((depth - d0) / (d1 - d0)) * box.height;
    const x = (time) => box.left + ((time - t0) / (t1 - t0)) * box.width;
    ink.fillStyle = ink.strokeStyle = colour("muted");
    ink.textBaseline = "middle";
    ink.textAlign = "right";
    const down = ticks(shown(d0, "length"), shown(d1, "length"), 9);
    for (const value of down.values) ink.fillText(tickText(value, down.step), box.left - 8, y(si(value, "length")));
    ink.textAlign = "center";
    ink.textBaseline = "top";
    const along = ticks(t0, t1, 12);
    for (const value of along.values) ink.fillText(tickText(value, along.step), x(value), box.top + box.height + 6);
    ink.fillText("time, s", box.left + box.width / 2, box.top + box.height + 20);
    ink.save();
    ink.translate(9, box.top + box.height / 2);
    ink.rotate(-Math.PI / 2);
    ink.fillText(`MD, ${symbol("length")}`, 0, -4);
    ink.restore();
    ink.strokeStyle = colour("frame");
    ink.strokeRect(box.left, box.top, box.width, box.height);
    const dashed = (x1, y1, x2, y2) => {
      ink.beginPath();
      ink.moveTo(x1, y1);
      ink.lineTo(x2, y2);
      ink.stroke();
    };
    ink.strokeStyle = colour("text");
    ink.setLineDash([4, 4]);
    if (run.window_s > t0 && run.window_s < t1) {
      dashed(x(run.window_s), box.top, x(run.window_s), box.top + box.height);
      ink.textAlign = "left";
      ink.fillStyle = colour("text");
      ink.fillText("window ▸", x(run.window_s) + 4, box.top + 4);
    }
    ink.setLineDash([1, 3]);
    for (const { kind, to_m } of report.hole)
      if (kind === "casing" && to_m > d0 && to_m < d1) {
        dashed(box.left, y(to_m), box.left + box.width, y(to_m));
        ink.textAlign = "left";
        ink.fillStyle = colour("text");
        ink.fillText("shoe", box.left + 4, y(to_m) - 13);
      }
    ink.setLineDash([]);
    if (state.depth !== null && state.depth > d0 && state.depth < d1)
      dashed(box.left, y(state.depth), box.left + box.width, y(state.depth));
    if (state.moment !== null && state.moment > t0 && state.moment < t1)
      dashed(x(state.moment), box.top, x(state.moment), box.top + box.height);
  }

  function scale(ink, box, largest, paint) {
    const left = box.left + box.width + 14;
    const from = plot.sides ? -largest : 0;
    const steps = 120;
    for (let i = 0; i < steps; i++) {
      const [r, g, b] = paint(from + ((i + 0.5) / steps) * (largest - from));
      ink.fillStyle = `rgb(${r} ${g} ${b})`;
      ink.fillRect(left, box.top + box.height * (1 - (i + 1) / steps), 12, box.height / steps + 0.6);
    }
    ink.strokeStyle = colour("frame");
    ink.strokeRect(left, box.top, 12, box.height);
    const marks = ticks(shown(from, plot.dimension), shown(largest, plot.dimension), 6);
    ink.fillStyle = colour("muted");
    ink.textAlign = "left";
    ink.textBaseline = "middle";
    for (const value of marks.values) {
      const part = (si(value, plot.dimension) - from) / (largest - from);
      ink.fillText(tickText(value, marks.step), left + 17, box.top + box.height * (1 - part));
    }
    ink.fillText(symbol(plot.dimension), left, box.top + box.height + 12);
    if (plot.sides) {
      ink.save();
      ink.textAlign = "center";
      ink.translate(left + 66, box.top + box.height * 0.25);
      ink.rotate(-Math.PI / 2);
      ink.fillText("high side", 0, 0);
      ink.restore();
      ink.save();
      ink.textAlign = "center";
      ink.translate(left + 66, box.top + box.height * 0.75);
      ink.rotate(-Math.PI / 2);
      ink.fillText("low side", 0, 0);
      ink.restore();
    }
  }

  /** Depth and time under the pointer; null outside the map. */
  function place(event) {
    const run = chosenRun(report);
    if (!run?.contact) return null;
    const bounds = canvas.getBoundingClientRect();
    const { depths, times } = views(run);
    const across = (event.clientX - bounds.left - LEFT) / (bounds.width - LEFT - RIGHT);
    const down = (event.clientY - bounds.top - TOP) / (bounds.height - TOP - BOTTOM);
    if (across < 0 || across > 1 || down < 0 || down > 1) return null;
    return { depth: depths[0] + down * (depths[1] - depths[0]), moment: times[0] + across * (times[1] - times[0]) };
  }

  canvas.addEventListener("pointermove", (event) => {
    const at = place(event);
    choose({ pointer: at?.depth ?? null });
    if (!at) return void (readout.textContent = "\u00a0");
    const { contact } = chosenRun(report);
    const k = Math.min(
      Math.max(
        Array.from(contact.time_s).findIndex((time) => time >= at.moment),
        0,
      ),
      contact.time_s.length - 1,
    );
    const value = contact.values[plot.column][k * contact.md_m.length + nearest(contact.md_m, at.depth)];
    const side = !plot.sides || Math.abs(value) === 0 ? "" : value > 0 ? ", high side" : ", low side";
    readout.textContent = `MD ${quantity(at.depth, "length", 5)}, ${digits(at.moment, 4)} s: ${quantity(Math.abs(value), plot.dimension, 3)}${side}`;
  });
  canvas.addEventListener("pointerleave", () => {
    choose({ pointer: null });
    readout.textContent = "\u00a0";
  });
  canvas.addEventListener("click", (event) => {
    const at = place(event);
    if (at) choose(at);
  });
  on("units operation depths times depth moment", draw);
  let width = 0;
  new ResizeObserver(() => {
    if (holder.clientWidth === width) return;
    width = holder.clientWidth;
    draw();
  }).observe(holder);
  return { element: el("div", {}, tools, holder, readout), redraw: draw };
}
