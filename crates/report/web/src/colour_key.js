// What the colours of a view mean.

import { el } from "./dom.js";
import { ticks, tickText } from "./ticks.js";
import { shown } from "./units.js";

/** The words over a ramp of colours from the one end of a range to the other, and round numbers below it. */
export function colourKey(words, dimension, range, scale) {
  const stops = Array.from({ length: 21 }, (_, i) => `rgb(${scale(i / 20).join(" ")}) ${i * 5}%`);
  const ends = range.map((value) => shown(value, dimension));
  const { values, step } = ticks(ends[0], ends[1], 4);
  return [
    el("span", {}, words),
    el("div", { class: "ramp", style: `background:linear-gradient(to right, ${stops.join(",")})` }),
    el(
      "div",
      { class: "ramp-ticks" },
      values.map((value) =>
        el("span", { style: `left:${((value - ends[0]) / (ends[1] - ends[0])) * 100}%` }, tickText(value, step)),
      ),
    ),
  ];
}
