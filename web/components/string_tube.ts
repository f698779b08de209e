// The string in space as a tube, coloured by a quantity.

import { Color, Mesh, MeshLambertMaterial } from "three";
import { type Course, Tube, type Vector } from "./bore.ts";
import type { ColourScale } from "./palette.ts";

const SIDES = 10;

/** The string at a depth: its offset to the high side and to the right, its radius, m, and the part of the scale, 0 to 1. */
export interface Ring {
  depth: number;
  high: number;
  right: number;
  radius: number;
  part: number;
}

/** A tube of a number of rings, at least two. */
export function stringMesh(rings: number): { mesh: Mesh; tube: Tube } {
  const tube = new Tube(Math.max(rings, 2), SIDES);
  return { mesh: new Mesh(tube, new MeshLambertMaterial({ vertexColors: true })), tube };
}

/** Sets the rings of the tube; rings without a number are grey. */
export function layString(tube: Tube, course: Course, rings: readonly Ring[], exaggeration: number, scale: ColourScale): void {
  const tint = new Color();
  rings.forEach(({ depth, high, right, radius, part }, i) => {
    const at = course.at(depth);
    const [up, aside] = [high * exaggeration || 0, right * exaggeration || 0];
    const place = at.place.map((coordinate, axis) => coordinate + up * (at.high[axis] ?? 0) + aside * (at.right[axis] ?? 0)) as Vector;
    tube.ring(i, place, at.high, at.right, radius * exaggeration);
    const [red, green, blue] = Number.isFinite(part) ? scale(part).map((byte) => byte / 255) : [0.5, 0.5, 0.5];
    tint.setRGB(red ?? 0.5, green ?? 0.5, blue ?? 0.5, "srgb");
    tube.paint(i, tint.r, tint.g, tint.b);
  });
  tube.changed();
}
