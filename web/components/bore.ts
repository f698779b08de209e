// The well and the string as shapes in space.

import { BufferAttribute, BufferGeometry } from "three";
import { below } from "./curve.ts";

/** East, up and south. */
export type Vector = [number, number, number];

/** The path: at least two measured depths, their coordinates, and north, east and down of the high side there. */
export interface Path {
  md_m: ArrayLike<number>;
  north_m: ArrayLike<number>;
  east_m: ArrayLike<number>;
  tvd_m: ArrayLike<number>;
  high: readonly [ArrayLike<number>, ArrayLike<number>, ArrayLike<number>];
}

/** A position on the path, and the directions to the high side and to the right. */
export interface Spot {
  place: Vector;
  high: Vector;
  right: Vector;
}

/** Positions along the path, in the axes of the scene. */
export class Course {
  readonly well: Path;

  constructor(well: Path) {
    this.well = well;
  }

  /** Position and directions at a depth. */
  at(depth: number): Spot {
    const { md_m, north_m, east_m, tvd_m, high } = this.well;
    const next = Math.min(Math.max(below(md_m, depth), 1), md_m.length - 1);
    const entry = (values: ArrayLike<number>, index: number): number => values[index] as number;
    const part = (depth - entry(md_m, next - 1)) / (entry(md_m, next) - entry(md_m, next - 1) || 1);
    const step = (values: ArrayLike<number>): number => entry(values, next) - entry(values, next - 1);
    const mix = (values: ArrayLike<number>): number => entry(values, next - 1) + part * step(values);
    const up = unit([mix(high[1]), -mix(high[2]), -mix(high[0])]);
    const along = unit([step(east_m), -step(tvd_m), -step(north_m)]);
    return { place: [mix(east_m), -mix(tvd_m), -mix(north_m)], high: up, right: unit(cross(along, up)) };
  }
}

const unit = ([x, y, z]: Vector): Vector => {
  const size = Math.hypot(x, y, z) || 1;
  return [x / size, y / size, z / size];
};
const cross = (a: Vector, b: Vector): Vector => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** A tube of rings, each with a position, two directions across and a radius; its colours may change. */
export class Tube extends BufferGeometry {
  readonly rings: number;
  readonly sides: number;
  readonly #turns: [number, number][];
  readonly #position: Float32Array;
  readonly #normal: Float32Array;
  readonly #colour: Float32Array;

  constructor(rings: number, sides: number) {
    super();
    this.rings = rings;
    this.sides = sides;
    const count = 3 * rings * sides;
    this.#position = new Float32Array(count);
    this.#normal = new Float32Array(count);
    this.#colour = new Float32Array(count).fill(1);
    this.setAttribute("position", new BufferAttribute(this.#position, 3));
    this.setAttribute("normal", new BufferAttribute(this.#normal, 3));
    this.setAttribute("color", new BufferAttribute(this.#colour, 3));
    const faces: number[] = [];
    for (let i = 0; i + 1 < rings; i++)
      for (let k = 0; k < sides; k++) {
        const [a, b] = [i * sides + k, i * sides + ((k + 1) % sides)] as const;
        faces.push(a, b, a + sides, b, b + sides, a + sides);
      }
    this.setIndex(faces);
    this.#turns = Array.from({ length: sides }, (_, k) => [
      Math.cos((2 * Math.PI * k) / sides),
      Math.sin((2 * Math.PI * k) / sides),
    ]);
  }

  ring(i: number, place: Vector, high: Vector, right: Vector, radius: number): void {
    this.#turns.forEach(([c, s], k) => {
      const at = 3 * (i * this.sides + k);
      for (const axis of [0, 1, 2] as const) {
        const out = c * high[axis] + s * right[axis];
        this.#normal[at + axis] = out;
        this.#position[at + axis] = place[axis] + radius * out;
      }
    });
  }

  paint(i: number, red: number, green: number, blue: number): void {
    for (let k = 0; k < this.sides; k++) this.#colour.set([red, green, blue], 3 * (i * this.sides + k));
  }

  changed(): void {
    for (const attribute of Object.values(this.attributes)) attribute.needsUpdate = true;
    this.computeBoundingSphere();
  }
}
