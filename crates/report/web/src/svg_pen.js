// Draws on SVG as one draws on a canvas: the part of it that the maps of this page need.

import { svg } from "../../../../web/components/dom.ts";

const BASE = { top: "hanging", middle: "central", bottom: "text-after-edge" };

/** A pen for an SVG picture of some size, with the names of a canvas's. */
export class SvgPen {
  fillStyle = "#000";
  strokeStyle = "#000";
  textAlign = "left";
  textBaseline = "alphabetic";
  font = "";
  #dash = [];
  #path = "";
  #moves = [];
  #saved = [];

  constructor(width, height) {
    this.picture = svg("svg", {
      viewBox: `0 0 ${width} ${height}`,
      xmlns: "http://www.w3.org/2000/svg",
      "font-family": "system-ui, sans-serif",
      "font-size": 11,
    });
  }

  #add(name, attributes, ...children) {
    const transform = this.#moves.join(" ") || null;
    this.picture.append(svg(name, { ...attributes, transform }, ...children));
  }

  save() {
    this.#saved.push([...this.#moves]);
  }

  restore() {
    this.#moves = this.#saved.pop() ?? [];
  }

  translate(x, y) {
    this.#moves.push(`translate(${x} ${y})`);
  }

  rotate(angle) {
    this.#moves.push(`rotate(${(angle * 180) / Math.PI})`);
  }

  setLineDash(dash) {
    this.#dash = dash;
  }

  beginPath() {
    this.#path = "";
  }

  moveTo(x, y) {
    this.#path += `M${x} ${y}`;
  }

  lineTo(x, y) {
    this.#path += `L${x} ${y}`;
  }

  stroke() {
    this.#add("path", { d: this.#path, fill: "none", stroke: this.strokeStyle, "stroke-dasharray": this.#dash.join(" ") || null });
  }

  fillRect(x, y, width, height) {
    this.#add("rect", { x, y, width, height, fill: this.fillStyle });
  }

  strokeRect(x, y, width, height) {
    this.#add("rect", { x, y, width, height, fill: "none", stroke: this.strokeStyle });
  }

  fillText(text, x, y) {
    const anchor = { center: "middle", right: "end" }[this.textAlign] ?? "start";
    this.#add(
      "text",
      { x, y, fill: this.fillStyle, "text-anchor": anchor, "dominant-baseline": BASE[this.textBaseline] ?? "auto" },
      text,
    );
  }

  /** A picture of pixels, given as an address. */
  image(href, x, y, width, height) {
    this.#add("image", { x, y, width, height, href, preserveAspectRatio: "none" });
  }

  /** The text of the file. */
  file() {
    const { width, height } = this.picture.viewBox.baseVal;
    this.picture.setAttribute("width", width);
    this.picture.setAttribute("height", height);
    return `<?xml version="1.0" encoding="UTF-8"?>\n${new XMLSerializer().serializeToString(this.picture)}\n`;
  }
}
