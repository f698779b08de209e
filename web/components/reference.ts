// Reference marks in space: depths along the well, and a box with vertical depth, north and east.

import {
  BufferGeometry,
  CanvasTexture,
  Float32BufferAttribute,
  LineBasicMaterial,
  LineSegments,
  SRGBColorSpace,
  Sprite,
  SpriteMaterial,
  Vector3,
} from "three";
import type { Course, Vector } from "./bore.ts";
import { el } from "./dom.ts";
import { colour } from "./palette.ts";
import { type Interval, ticks, tickText } from "./ticks.ts";
import { shown, si, symbol } from "./units.ts";

/** A box around a part of the path. */
export interface Bounds {
  low: Vector3;
  high: Vector3;
}

/** East and south. */
type Across = [number, number];

/** Height of a label, pixels; its letters are three quarters of it. */
const LETTERS = 17;

/** Text that faces the viewer, with a height in pixels; `anchor` is the part of it left of its position. */
export function label(text: string, place: Vector, high: number, ink = "text", anchor = 0.5): Sprite {
  const buffer = el("canvas", {});
  const pen = buffer.getContext("2d");
  if (!pen) throw new Error("this browser does not support canvas drawing");
  const font = "600 44px system-ui, sans-serif";
  pen.font = font;
  buffer.width = Math.ceil(pen.measureText(text).width) + 8;
  buffer.height = 56;
  pen.font = font;
  pen.textBaseline = "middle";
  pen.fillStyle = colour(ink);
  pen.fillText(text, 4, 30);
  const map = new CanvasTexture(buffer);
  // Otherwise its colours would be interpreted as linear, and look pale.
  map.colorSpace = SRGBColorSpace;
  const sprite = new Sprite(new SpriteMaterial({ map, depthTest: false, transparent: true }));
  sprite.position.set(...place);
  sprite.center.set(anchor, 0.5);
  sprite.userData.pixels = [(high * buffer.width) / buffer.height, high];
  sprite.renderOrder = 3;
  return sprite;
}

/** Corners of a box around the path between two depths, never flat. */
export function bounds(course: Course, [from, to]: Interval): Bounds {
  const low = new Vector3(Infinity, Infinity, Infinity);
  const high = low.clone().negate();
  for (let i = 0; i <= 100; i++) {
    const at = new Vector3(...course.at(from + ((to - from) * i) / 100).place);
    low.min(at);
    high.max(at);
  }
  const least = 0.22 * high.clone().sub(low).length();
  for (const axis of ["x", "y", "z"] as const) {
    const short = Math.max(least - (high[axis] - low[axis]), 0) / 2;
    const air = short + (axis === "y" ? 0 : 0.03 * least);
    low[axis] -= air;
    high[axis] += air;
  }
  return { low, high };
}

/** Horizontal corners of the two walls of the box behind the well, seen from a direction. */
export function walls({ low, high }: Bounds, [x, , z]: Vector): [Across, Across, Across] {
  const [west, east] = x >= 0 ? ([low.x, high.x] as const) : ([high.x, low.x] as const);
  const [north, south] = z >= 0 ? ([low.z, high.z] as const) : ([high.z, low.z] as const);
  return [
    [west, north],
    [east, north],
    [west, south],
  ];
}

/** Distance of the well from an edge of the box at a height, seen from the viewer; infinite if it does not pass. */
function gap(
  course: Course,
  [from, to]: Interval,
  height: number,
  along: (at: Across) => number,
  edge: Across,
): number {
  const steps = 100;
  let least = Infinity;
  for (let i = 0; i <= steps; i++) {
    const [x, y, z] = course.at(from + ((to - from) * i) / steps).place;
    if (Math.abs(y - height) <= (to - from) / steps) least = Math.min(least, Math.abs(along([x, z]) - along(edge)));
  }
  return least;
}

/** The marks for the depths in view, next to a hole of this radius in the scene, seen from a direction. */
export function reference(course: Course, range: Interval, radius: number, from: Vector): (LineSegments | Sprite)[] {
  const box = bounds(course, range);
  const { low, high } = box;
  const [behind, one, other] = walls(box, from);
  // Direction to the left of the view: the cross product of up and the direction to the viewer points right.
  const along = ([x, z]: Across): number => x * from[2] - z * from[0];
  const [left, right] = along(one) <= along(other) ? [one, other] : [other, one];
  const size = high.clone().sub(low).length();
  const unit = symbol("length");
  const marks = ticks(shown(range[0], "length"), shown(range[1], "length"), 8);
  const depths = marks.values.map((value) => {
    const { place, high } = course.at(si(value, "length"));
    const away = radius + 0.012 * size;
    return label(
      `${tickText(value, marks.step)} ${unit}`,
      [place[0] + away * high[0], place[1] + away * high[1], place[2] + away * high[2]],
      LETTERS,
      "text",
      0,
    );
  });
  const lines: number[] = [];
  const edge = (a: Vector, b: Vector): void => {
    lines.push(...a, ...b);
  };
  const down = ticks(shown(-high.y, "length"), shown(-low.y, "length"), 5);
  // Vertical depths are on the left, or on the right if the well is much nearer to the left.
  const near = (edge: Across): number => Math.min(...down.values.map((value) => gap(course, range, -si(value, "length"), along, edge)));
  const beside = near(right) > near(left) + 0.1 * size ? right : left;
  const levels = down.values.map((value) => {
    const y = -si(value, "length");
    const at = ([x, z]: Across): Vector => [x, y, z];
    edge(at(behind), at(right));
    edge(at(behind), at(left));
    return label(`TVD ${tickText(value, down.step)} ${unit}`, at(beside), LETTERS, "muted", beside === left ? 1.06 : -0.06);
  });
  for (const [x, z] of [behind, right, left]) edge([x, low.y, z], [x, high.y, z]);
  const frame = new BufferGeometry();
  frame.setAttribute("position", new Float32BufferAttribute(lines, 3));
  return [
    new LineSegments(frame, new LineBasicMaterial({ color: colour("frame"), transparent: true, opacity: 0.35 })),
    // Of overlapping labels the first is kept.
    label("N", [(low.x + high.x) / 2, high.y, low.z - 0.04 * size], LETTERS + 2),
    label("E", [high.x + 0.04 * size, high.y, (low.z + high.z) / 2], LETTERS + 2),
    ...levels,
    ...depths,
  ];
}
