// A figure that the page holds in each set of units, alive: its legend hides curves, its points say what they show.

import { el } from "../../../../web/components/dom.ts";
import { hideTip, showTip } from "../../../../web/components/tip.ts";
import { svgFile } from "./downloads.js";
import { on, state } from "./state.js";

/** Points as the picture holds them: x, y and row, one after the other. */
function spots(text) {
  const numbers = text.split(" ").map(Number);
  return Array.from({ length: Math.floor(numbers.length / 3) }, (_, i) => {
    const [x, y, row] = numbers.slice(3 * i, 3 * i + 3);
    return { x, y, row };
  });
}

/**
 * The figure `name`; where there is none, `otherwise`. `describe` gives title, rows of text and an address for a row of the
 * table that a point shows.
 */
export function figure(name, otherwise, describe = null) {
  const holder = el("div", { class: "figure-holder" });
  const hidden = new Set();

  /** What belongs to a hidden key of the legend is hidden. */
  function hide(picture) {
    const keys = (element) => element.dataset.keys.split(" ").filter(Boolean);
    for (const series of picture.querySelectorAll(".series"))
      series.toggleAttribute("hidden", keys(series).some((key) => hidden.has(key)));
    for (const key of picture.querySelectorAll(".legend-key")) {
      const off = hidden.has(key.dataset.keys);
      key.setAttribute("aria-pressed", String(!off));
      key.classList.toggle("off", off);
    }
  }

  function wake(picture) {
    for (const key of picture.querySelectorAll(".legend-key")) {
      const mine = [...picture.querySelectorAll(".series")];
      if (!mine.some((series) => series.dataset.keys.split(" ").includes(key.dataset.keys))) continue;
      const toggle = () => {
        if (!hidden.delete(key.dataset.keys)) hidden.add(key.dataset.keys);
        hide(picture);
      };
      const attributes = { tabindex: 0, role: "button", "aria-label": `Show or hide ${key.textContent.trim()}` };
      for (const [attribute, value] of Object.entries(attributes)) key.setAttribute(attribute, value);
      key.addEventListener("click", toggle);
      key.addEventListener("keydown", (event) => {
        if (event.key !== "Enter" && event.key !== " ") return;
        event.preventDefault();
        toggle();
      });
    }
    if (describe) for (const group of picture.querySelectorAll(".spots")) group.append(...spots(group.dataset.spots).map(point));
    hide(picture);
  }

  /** What a point shows: its place, and the row that it belongs to. */
  function point({ x, y, row }) {
    const spot = document.createElementNS("http://www.w3.org/2000/svg", "circle");
    for (const [name, value] of Object.entries({ class: "spot", cx: x, cy: y, r: 4.5 })) spot.setAttribute(name, value);
    const { title, href } = describe(row);
    spot.setAttribute("aria-label", title);
    if (href) {
      spot.setAttribute("role", "link");
      spot.setAttribute("tabindex", 0);
      spot.classList.add("leads");
      const go = () => location.assign(href);
      spot.addEventListener("click", go);
      spot.addEventListener("keydown", (event) => event.key === "Enter" && go());
    }
    const show = (event) => {
      const { title, rows } = describe(row);
      const box = spot.getBoundingClientRect();
      showTip({ clientX: event.clientX ?? box.right, clientY: event.clientY ?? box.bottom }, title, rows);
    };
    for (const kind of ["pointerenter", "pointermove", "focus"]) spot.addEventListener(kind, show);
    for (const kind of ["pointerleave", "blur"]) spot.addEventListener(kind, hideTip);
    return spot;
  }

  const narrow = matchMedia("screen and (max-width: 800px)");

  function draw() {
    const slim = narrow.matches && document.getElementById(`${name}-narrow-${state.units}`);
    const template = slim || document.getElementById(`${name}-${state.units}`);
    const copy = template?.content.cloneNode(true);
    holder.replaceChildren(...(copy?.firstElementChild ? [copy] : [otherwise]));
    const picture = holder.querySelector("svg");
    if (picture) wake(picture);
  }
  on("units", draw);
  narrow.addEventListener("change", draw);
  draw();
  return {
    element: holder,
    /** The figure as the text of an SVG file. */
    file: () => svgFile([...holder.querySelectorAll("svg")]),
    there: () => holder.querySelector("svg") !== null,
  };
}
