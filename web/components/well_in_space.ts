// The hole in space and its views, exaggerated across the hole.

import { DoubleSide, Mesh, MeshLambertMaterial } from "three";
import { type Course, Tube, type Vector } from "./bore.ts";
import { colour } from "./palette.ts";
import { bounds, walls } from "./reference.ts";
import type { HoleSection } from "./schematic.ts";
import type { Stage } from "./stage.ts";
import type { Interval } from "./ticks.ts";

/** Elevation of the view of the whole well. */
export const ABOVE = 0.3;

/** Number of rings of the hole in view. */
const RINGS = 300;
const SIDES = 28;

/** The largest of 1, 2 or 5 times a power of ten that is not above a number. */
function niceBelow(value: number): number {
  const power = 10 ** Math.floor(Math.log10(Math.max(value, 1)));
  return [5, 2, 1].map((m) => m * power).find((m) => m <= Math.max(value, 1)) ?? 1;
}

/** Exaggeration at which the sides of the hole can be distinguished. */
export const exaggerationFor = (deepest: number, widest: number): number => niceBelow((0.03 * deepest) / widest);

/** Depths of the rings of the hole. */
function depthsOf(course: Course, [from, to]: Interval): number[] {
  const within = Array.from(course.well.md_m).filter((depth) => depth > from && depth < to);
  const even = Array.from({ length: RINGS + 1 }, (_, i) => from + (i * (to - from)) / RINGS);
  return [...even, ...within].sort((a, b) => a - b);
}

/** The transparent wall of each section in view. */
export function holeTubes(course: Course, hole: readonly HoleSection[], [from, to]: Interval, exaggeration: number): Mesh[] {
  return hole.flatMap((section) => {
    const range: Interval = [Math.max(section.from_m, from), Math.min(section.to_m, to)];
    if (range[1] <= range[0]) return [];
    const depths = depthsOf(course, range);
    const tube = new Tube(depths.length, SIDES);
    depths.forEach((depth, i) => {
      const { place, high, right } = course.at(depth);
      tube.ring(i, place, high, right, (section.diameter_m / 2) * exaggeration);
    });
    tube.changed();
    const casing = section.kind === "casing";
    const material = new MeshLambertMaterial({
      color: colour(casing ? "casing" : "rock"),
      transparent: true,
      opacity: casing ? 0.16 : 0.26,
      side: DoubleSide,
      depthWrite: false,
    });
    const mesh = new Mesh(tube, material);
    mesh.renderOrder = 2;
    return [mesh];
  });
}

/** Direction across the vertical plane of the well, with an elevation. */
export function across(course: Course, view: Interval, above: number): Vector {
  const [a, b] = [course.at(view[0]).place, course.at(view[1]).place];
  const [x, z] = [b[0] - a[0], b[2] - a[2]];
  const flat = Math.hypot(x, z);
  if (flat < 1e-3) return [0.6, above, 0.8];
  const side = x - z < 0 ? -1 : 1;
  return [(-z / flat) * side, above, (x / flat) * side];
}

/** Looks at the depths in view from a direction, including the box around them and its labels. */
export function lookAtWell(space: Stage, course: Course, view: Interval, direction: Vector): void {
  const { low, high } = bounds(course, view);
  const middle = low.clone().add(high).multiplyScalar(0.5);
  const corners = walls({ low, high }, across(course, view, ABOVE)).flatMap(([x, z]): Vector[] => [
    [x, low.y, z],
    [x, high.y, z],
  ]);
  const [from, to] = view;
  const along = Array.from({ length: 41 }, (_, i) => course.at(from + ((to - from) * i) / 40).place);
  const places = [...corners, ...along];
  // Depths are on the right of the well, vertical depths on the left of the box.
  space.lookAt(places, direction, middle, [84, 16]);
  space.holder.dataset.spans = space
    .spans(places)
    .map((part) => part.toFixed(2))
    .join(" ");
}
