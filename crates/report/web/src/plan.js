// The bottom of the hole from above, as a map in colours.

import { el } from "../../../../web/components/dom.ts";
import { colour } from "../../../../web/components/palette.ts";
import { isPrinting } from "../../../../web/components/printing.ts";
import { ticks, tickText } from "../../../../web/components/ticks.ts";
import { quantity, shown, si, symbol } from "../../../../web/components/units.ts";
import { deepestOf, depthAt, depthScale, edgesOf } from "./cells.js";
import { csv, downloads } from "./downloads.js";
import { SvgPen } from "./svg_pen.js";
import { on } from "./state.js";

const LEFT = 44;
const BOTTOM = 34;
const TOP = 18;
const RIGHT = 8;

/** Side of the map, in pixels at most and on paper. */
const WIDEST = 400;
const PAPER = 270;

/** The map of the bottom that `get` gives. */
export function plan(get, sided) {
  const canvas = el("canvas", { class: "plan", role: "img", "aria-label": "The bottom of the hole from above" });
  const readout = el("p", { class: "readout-line" }, "\u00a0");
  const save = downloads("Bottom of the hole", { svg: () => file(), csv: () => csv(...table()) });
  const holder = el("div", { class: "plan-holder" }, canvas, readout, save);
  let side = WIDEST;

  function draw() {
    const bottom = get();
    if (!bottom) return;
    side = isPrinting() ? PAPER : Math.min(Math.max((holder.clientWidth || WIDEST) - LEFT - RIGHT, 150), WIDEST);
    const ratio = Math.max(devicePixelRatio, 2);
    const [width, height] = [LEFT + side + RIGHT, TOP + side + BOTTOM];
    [canvas.width, canvas.height] = [width * ratio, height * ratio];
    canvas.style.width = `${width}px`;
    canvas.style.height = `${height}px`;
    const ink = canvas.getContext("2d");
    ink.scale(ratio, ratio);
    ink.font = "11px system-ui, sans-serif";
    const reach = 1.04 * edgesOf(bottom)[1];
    picture(ink, bottom, reach, Math.round(side * ratio));
    axes(ink, reach);
  }

  /** The map as the text of an SVG file. */
  function file() {
    const bottom = get();
    const pen = new SvgPen(LEFT + side + RIGHT, TOP + side + BOTTOM);
    pen.fillStyle = colour("paper");
    pen.fillRect(0, 0, LEFT + side + RIGHT, TOP + side + BOTTOM);
    const buffer = el("canvas", { width: 2 * side, height: 2 * side });
    const ink = buffer.getContext("2d");
    ink.scale(2, 2);
    ink.translate(-LEFT, -TOP);
    const reach = 1.04 * edgesOf(bottom)[1];
    picture(ink, bottom, reach, 2 * side);
    pen.image(buffer.toDataURL(), LEFT, TOP, side, side);
    axes(pen, reach);
    return pen.file();
  }

  /** The depth of every cell. */
  function table() {
    const { radius_m, angle_rad, depth_m } = get();
    const rows = Array.from(radius_m).flatMap((radius, ring) =>
      Array.from(angle_rad, (angle, sector) => [
        shown(radius, "diameter"),
        shown(angle, "angle"),
        shown(depth_m[ring * angle_rad.length + sector], "diameter"),
      ]),
    );
    const unit = symbol("diameter");
    return [[`radius, ${unit}`, `angle, ${symbol("angle")}`, `depth, ${unit}`], rows];
  }

  function picture(ink, bottom, reach, pixels) {
    const scale = depthScale();
    const deepest = deepestOf(bottom) || 1;
    const image = new ImageData(pixels, pixels);
    const at = (pixel) => (2 * ((pixel + 0.5) / pixels) - 1) * reach;
    for (let row = 0; row < pixels; row++)
      for (let column = 0; column < pixels; column++) {
        const depth = depthAt(bottom, -at(row), at(column));
        if (Number.isFinite(depth)) image.data.set([...scale(depth / deepest), 255], 4 * (row * pixels + column));
      }
    const buffer = new OffscreenCanvas(pixels, pixels);
    buffer.getContext("2d").putImageData(image, 0, 0);
    ink.drawImage(buffer, LEFT, TOP, side, side);
  }

  function axes(ink, reach) {
    const far = shown(reach, "diameter");
    const { values, step } = ticks(-far, far, 6);
    const part = (value) => 0.5 + si(value, "diameter") / (2 * reach);
    ink.fillStyle = colour("muted");
    ink.textAlign = "center";
    ink.textBaseline = "top";
    for (const value of values) ink.fillText(tickText(value, step), LEFT + part(value) * side, TOP + side + 5);
    const right = sided ? "to the right" : "across";
    ink.fillText(`${right}, ${symbol("diameter")}`, LEFT + side / 2, TOP + side + 19);
    ink.textAlign = "right";
    ink.textBaseline = "middle";
    for (const value of values) ink.fillText(tickText(value, step), LEFT - 6, TOP + (1 - part(value)) * side);
    if (sided) {
      ink.textAlign = "center";
      ink.textBaseline = "bottom";
      ink.fillText("high side ▴", LEFT + side / 2, TOP - 4);
    }
    ink.strokeStyle = colour("frame");
    ink.strokeRect(LEFT, TOP, side, side);
  }

  canvas.addEventListener("pointermove", (event) => {
    const bottom = get();
    if (!bottom) return;
    const bounds = canvas.getBoundingClientRect();
    const reach = 1.04 * edgesOf(bottom)[1];
    const away = (pixel) => (2 * (pixel / side) - 1) * reach;
    const right = away(event.clientX - bounds.left - LEFT);
    const high = -away(event.clientY - bounds.top - TOP);
    const depth = depthAt(bottom, high, right);
    const turn = (Math.atan2(right, high) + 2 * Math.PI) % (2 * Math.PI);
    readout.textContent = Number.isFinite(depth)
      ? `radius ${quantity(Math.hypot(high, right), "diameter", 3)}, ${quantity(turn, "angle", 3)}: ${quantity(depth, "diameter", 3)} deep`
      : "\u00a0";
  });
  canvas.addEventListener("pointerleave", () => (readout.textContent = "\u00a0"));
  new ResizeObserver(() => {
    const room = Math.min(Math.max(holder.clientWidth - LEFT - RIGHT, 150), WIDEST);
    if (!isPrinting() && holder.clientWidth && room !== side) draw();
  }).observe(holder);
  return { element: holder, draw };
}
