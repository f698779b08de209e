// Drawing of hole and string next to the tracks.

import type { Place } from "./curve.ts";
import { svg } from "./dom.ts";
import type { Box } from "./outliers.ts";
import type { Interval } from "./ticks.ts";
import { quantity } from "./units.ts";

/** A section of the hole, SI. */
export interface HoleSection {
  kind: "casing" | "open";
  from_m: number;
  to_m: number;
  diameter_m: number;
  friction: number;
}

/** A component of the string, SI. */
export interface StringPart {
  name: string;
  from_m: number;
  to_m: number;
  od_m: number;
  /** Over joints or blades. */
  contact_od_m: number;
}

/** Hole and string to draw, from the surface down. */
export interface Bore {
  hole: readonly HoleSection[];
  string: readonly StringPart[];
}

/** Longer than any bit, m. */
const LONGEST_BIT_M = 5;

const name = (section: HoleSection): string => (section.kind === "casing" ? "casing" : "open hole");

/** Hole and string at a depth, in a few words. */
export function lies(bore: Bore, depth: number): string[] {
  const within = (part: { from_m: number; to_m: number }): boolean => depth >= part.from_m && depth <= part.to_m;
  const section = bore.hole.find(within);
  const part = bore.string.find(within);
  return [
    section && `${name(section)} ${quantity(section.diameter_m, "diameter")}`,
    part && `${part.name} ${quantity(part.od_m, "diameter")}`,
  ].filter((words) => words !== undefined);
}

/** The drawing between two depths. */
export function schematic(bore: Bore, { left, width, top, height }: Box, [from, to]: Interval, y: Place): SVGGElement {
  const middle = left + width / 2;
  const widest = Math.max(...bore.hole.map((s) => s.diameter_m), ...bore.string.map((p) => p.contact_od_m));
  const half = (diameter: number): number => ((width - 22) / 2) * (diameter / widest);
  const group = svg("g", { "clip-path": `inset(0)` });
  const clip = (depth: number): number => Math.min(Math.max(y(depth), top - 12), top + height + 12);
  for (const section of bore.hole) {
    if (section.to_m < from || section.from_m > to) continue;
    const [y1, y2, w] = [clip(section.from_m), clip(section.to_m), half(section.diameter_m)];
    const tip = svg(
      "title",
      {},
      `${name(section)} ${quantity(section.diameter_m, "diameter")}, ${quantity(section.from_m, "length", 5)} to ${quantity(section.to_m, "length", 5)}, friction ${section.friction}`,
    );
    const look = section.kind === "casing" ? "bore" : "rock";
    group.append(svg("rect", { x: middle - w, y: y1, width: 2 * w, height: Math.max(y2 - y1, 0), class: look }, tip));
    for (const side of [-1, 1]) {
      const x = middle + side * w;
      group.append(svg("line", { x1: x, x2: x, y1, y2, class: section.kind === "casing" ? "casing" : "wall" }));
      if (section.kind === "casing" && section.to_m < to)
        group.append(svg("path", { d: `M${x} ${y2}h${side * 8}L${x} ${y2 - 9}Z`, class: "shoe" }));
    }
  }
  // The last component may be plain pipe instead of a bit.
  const last = bore.string.at(-1);
  const bit = last && last.to_m - last.from_m < LONGEST_BIT_M ? last : null;
  for (const part of bore.string) {
    if (part.to_m < from || part.from_m > to) continue;
    const [y1, y2, w] = [clip(part.from_m), clip(part.to_m), Math.max(half(part.od_m), 1.5)];
    const tip = svg(
      "title",
      {},
      `${part.name}, OD ${quantity(part.od_m, "diameter")}, ${quantity(part.from_m, "length", 5)} to ${quantity(part.to_m, "length", 5)}`,
    );
    const kind = /pipe/i.test(part.name) && !/heavy/i.test(part.name) ? "pipe" : "tool";
    const shape =
      part === bit
        ? svg("path", {
            d: `M${middle - w} ${Math.min(y1, y2 - 5)}h${2 * w}v${Math.max(y2 - y1, 5) * 0.5}L${middle} ${y2 + 3}L${middle - w} ${y2 - Math.max(y2 - y1, 5) * 0.5}Z`,
            class: "bit",
          })
        : svg("rect", { x: middle - w, y: y1, width: 2 * w, height: Math.max(y2 - y1, 0.7), class: kind });
    shape.append(tip);
    group.append(shape);
  }
  return group;
}
