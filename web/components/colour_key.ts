// Colour key of a view.

import { el } from "./dom.ts";
import type { ColourScale } from "./palette.ts";
import { type Interval, ticks, tickText } from "./ticks.ts";
import { shown } from "./units.ts";

/** A title, a ramp of colours over a range, and round numbers below it. */
export function colourKey(words: string, dimension: string, range: Interval, scale: ColourScale): HTMLElement[] {
  const stops = Array.from({ length: 21 }, (_, i) => `rgb(${scale(i / 20).join(" ")}) ${i * 5}%`);
  const [low, high] = [shown(range[0], dimension), shown(range[1], dimension)];
  const { values, step } = ticks(low, high, 4);
  return [
    el("span", {}, words),
    el("div", { class: "ramp", style: `background:linear-gradient(to right, ${stops.join(",")})` }),
    el(
      "div",
      { class: "ramp-ticks" },
      values.map((value) =>
        el("span", { style: `left:${((value - low) / (high - low)) * 100}%` }, tickText(value, step)),
      ),
    ),
  ];
}
