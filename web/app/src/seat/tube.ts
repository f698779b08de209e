// A tube of rings whose numbers are updated in place.

import { BufferAttribute, BufferGeometry, DynamicDrawUsage } from "three";

/** Rings with a number of sides; each is rewritten when the string moves. */
export class Tube extends BufferGeometry {
  readonly rings: number;
  readonly sides: number;
  readonly #places: Float32Array;
  readonly #normals: Float32Array;
  readonly #colours: Float32Array;
  readonly #cos: Float32Array;
  readonly #sin: Float32Array;

  constructor(rings: number, sides: number) {
    super();
    [this.rings, this.sides] = [rings, sides];
    const count = 3 * rings * sides;
    [this.#places, this.#normals] = [new Float32Array(count), new Float32Array(count)];
    this.#colours = new Float32Array(count).fill(1);
    const turn = (part: (angle: number) => number) =>
      Float32Array.from({ length: sides }, (_, k) => part((2 * Math.PI * k) / sides));
    [this.#cos, this.#sin] = [turn(Math.cos), turn(Math.sin)];
    for (const [name, array] of [["position", this.#places], ["normal", this.#normals], ["color", this.#colours]] as const)
      this.setAttribute(name, new BufferAttribute(array, 3).setUsage(DynamicDrawUsage));
    const faces = new Uint32Array(6 * Math.max(rings - 1, 0) * sides);
    let place = 0;
    for (let i = 0; i + 1 < rings; i++)
      for (let k = 0; k < sides; k++) {
        const [a, b] = [i * sides + k, i * sides + ((k + 1) % sides)];
        faces.set([a, b, a + sides, b, b + sides, a + sides], place);
        place += 6;
      }
    this.setIndex(new BufferAttribute(faces, 1));
  }

  /** Writes a ring: position on the course, offsets to the high side and to the right, and radius. */
  ring(i: number, course: Float32Array, high: number, right: number, radius: number): void {
    const [places, normals, sides] = [this.#places, this.#normals, this.sides];
    let to = 3 * i * sides;
    for (let k = 0; k < sides; k++) {
      const [c, s] = [this.#cos[k]!, this.#sin[k]!];
      for (let axis = 0; axis < 3; axis++, to++) {
        const [h, r] = [course[3 + axis]!, course[6 + axis]!];
        const out = c * h + s * r;
        normals[to] = out;
        places[to] = course[axis]! + high * h + right * r + radius * out;
      }
    }
  }

  /** Paints a ring with a colour of a table of red, green and blue. */
  paint(i: number, table: Float32Array, entry: number): void {
    let to = 3 * i * this.sides;
    for (let k = 0; k < this.sides; k++)
      for (let axis = 0; axis < 3; axis++, to++) this.#colours[to] = table[3 * entry + axis]!;
  }

  /** Displays the first rings, in their current state. */
  changed(rings: number): void {
    this.setDrawRange(0, 6 * Math.max(rings - 1, 0) * this.sides);
    for (const name of ["position", "normal", "color"]) this.attributes[name]!.needsUpdate = true;
  }
}
