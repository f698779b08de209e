// The well and the string as shapes in space.

import { BufferAttribute, BufferGeometry } from "three";
import { below } from "./curve.js";

/** A place on the path: its coordinates and the directions to the high side and to the right, in the scene's axes. */
export class Course {
  constructor(well) {
    this.well = well;
  }

  /** Writes east, up and south (x, y, z) of the path, the high side and the right side at a depth into `out`. */
  at(depth, out) {
    const { md_m, north_m, east_m, tvd_m, high } = this.well;
    const next = Math.min(Math.max(below(md_m, depth), 1), md_m.length - 1);
    const part = (depth - md_m[next - 1]) / (md_m[next] - md_m[next - 1] || 1);
    const mix = (values) => values[next - 1] + part * (values[next] - values[next - 1]);
    out.place = [mix(east_m), -mix(tvd_m), -mix(north_m)];
    out.high = unit([mix(high[1]), -mix(high[2]), -mix(high[0])]);
    const run = [east_m, tvd_m, north_m].map((values) => values[next] - values[next - 1]);
    const along = unit([run[0], -run[1], -run[2]]);
    out.right = unit(cross(along, out.high));
    return out;
  }
}

const unit = (v) => {
  const size = Math.hypot(...v) || 1;
  return v.map((x) => x / size);
};
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** A tube of rings, each with a place, two directions across and a radius; its colours may change. */
export class Tube extends BufferGeometry {
  constructor(rings, sides) {
    super();
    this.rings = rings;
    this.sides = sides;
    const count = rings * sides;
    this.setAttribute("position", new BufferAttribute(new Float32Array(3 * count), 3));
    this.setAttribute("normal", new BufferAttribute(new Float32Array(3 * count), 3));
    this.setAttribute("color", new BufferAttribute(new Float32Array(3 * count).fill(1), 3));
    const faces = [];
    for (let i = 0; i + 1 < rings; i++)
      for (let k = 0; k < sides; k++) {
        const [a, b] = [i * sides + k, i * sides + ((k + 1) % sides)];
        faces.push(a, b, a + sides, b, b + sides, a + sides);
      }
    this.setIndex(faces);
    this.turns = Array.from({ length: sides }, (_, k) => [
      Math.cos((2 * Math.PI * k) / sides),
      Math.sin((2 * Math.PI * k) / sides),
    ]);
  }

  ring(i, place, high, right, radius) {
    const { position, normal } = this.attributes;
    for (let k = 0; k < this.sides; k++) {
      const [c, s] = this.turns[k];
      const at = 3 * (i * this.sides + k);
      for (let axis = 0; axis < 3; axis++) {
        const out = c * high[axis] + s * right[axis];
        normal.array[at + axis] = out;
        position.array[at + axis] = place[axis] + radius * out;
      }
    }
  }

  paint(i, red, green, blue) {
    const { color } = this.attributes;
    for (let k = 0; k < this.sides; k++) color.array.set([red, green, blue], 3 * (i * this.sides + k));
  }

  changed() {
    for (const attribute of Object.values(this.attributes)) attribute.needsUpdate = true;
    this.computeBoundingSphere();
  }
}
