// The path of the well in the axes of the scene (x east, y up, z south), with lookup by depth without allocation.

import type { Layout } from "../api/live";

/** Axis of the hole at a depth: position, and the directions to the high side and to the right. */
export class Course {
  /** x, y, z of the position, the high side and the right side. */
  readonly at = new Float32Array(9);
  readonly #md: Float32Array;
  /** Position and high side of every point, six numbers each. */
  readonly #points: Float32Array;
  #next = 1;

  constructor({ md_m, north_m, east_m, tvd_m, high }: Layout["path"]) {
    this.#md = Float32Array.from(md_m);
    this.#points = new Float32Array(6 * md_m.length);
    for (let i = 0; i < md_m.length; i++) {
      this.#points.set([east_m[i]!, -tvd_m[i]!, -north_m[i]!, high[1][i]!, -high[2][i]!, -high[0][i]!], 6 * i);
    }
  }

  get deepest(): number {
    return this.#md[this.#md.length - 1]!;
  }

  /** Moves to a depth; fast if it is near the last one. */
  go(depth: number): Float32Array {
    const [md, points, at] = [this.#md, this.#points, this.at];
    while (this.#next > 1 && md[this.#next - 1]! > depth) this.#next--;
    while (this.#next < md.length - 1 && md[this.#next]! < depth) this.#next++;
    const next = this.#next;
    const part = (depth - md[next - 1]!) / (md[next]! - md[next - 1]! || 1);
    const [a, b] = [6 * (next - 1), 6 * next];
    for (let k = 0; k < 6; k++) at[k] = points[a + k]! + part * (points[b + k]! - points[a + k]!);
    const size = Math.hypot(at[3]!, at[4]!, at[5]!) || 1;
    for (let k = 3; k < 6; k++) at[k] = at[k]! / size;
    const [x, y, z] = [points[b]! - points[a]!, points[b + 1]! - points[a + 1]!, points[b + 2]! - points[a + 2]!];
    const long = Math.hypot(x, y, z) || 1;
    at[6] = (y * at[5]! - z * at[4]!) / long;
    at[7] = (z * at[3]! - x * at[5]!) / long;
    at[8] = (x * at[4]! - y * at[3]!) / long;
    return at;
  }
}
