// Signs by which to find one's way in space: depths along the well, and a box with vertical depth, north and east.

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
import { el } from "./dom.js";
import { colour } from "./palette.js";
import { ticks, tickText } from "./ticks.js";
import { shown, si, symbol } from "./units.js";

/** Height of a label, of which its letters are three quarters, pixels. */
const LETTERS = 17;

/** Words that face the reader, so many pixels high; `anchor` is the part of them that lies left of their place. */
export function label(text, place, high, ink = "text", anchor = 0.5) {
  const buffer = el("canvas", {});
  const pen = buffer.getContext("2d");
  const font = "600 44px system-ui, sans-serif";
  pen.font = font;
  buffer.width = Math.ceil(pen.measureText(text).width) + 8;
  buffer.height = 56;
  pen.font = font;
  pen.textBaseline = "middle";
  pen.fillStyle = colour(ink);
  pen.fillText(text, 4, 30);
  const map = new CanvasTexture(buffer);
  // Or its colours would be taken for linear ones, and pale.
  map.colorSpace = SRGBColorSpace;
  const sprite = new Sprite(new SpriteMaterial({ map, depthTest: false, transparent: true }));
  sprite.position.set(...place);
  sprite.center.set(anchor, 0.5);
  sprite.userData.pixels = [(high * buffer.width) / buffer.height, high];
  sprite.renderOrder = 3;
  return sprite;
}

/** Corners of a box around the path between two depths, never flat. */
export function bounds(course, [from, to]) {
  const low = new Vector3(Infinity, Infinity, Infinity);
  const high = low.clone().negate();
  for (let i = 0; i <= 100; i++) {
    const at = new Vector3(...course.at(from + ((to - from) * i) / 100, {}).place);
    low.min(at);
    high.max(at);
  }
  const least = 0.22 * high.clone().sub(low).length();
  for (const axis of ["x", "y", "z"]) {
    const short = Math.max(least - (high[axis] - low[axis]), 0) / 2;
    const air = short + (axis === "y" ? 0 : 0.03 * least);
    low[axis] -= air;
    high[axis] += air;
  }
  return { low, high };
}

/** Corners, across, of the two walls of the box that lie behind the well to a reader who looks from there. */
export function walls({ low, high }, [x, , z]) {
  const [west, east] = x >= 0 ? [low.x, high.x] : [high.x, low.x];
  const [north, south] = z >= 0 ? [low.z, high.z] : [high.z, low.z];
  return [
    [west, north],
    [east, north],
    [west, south],
  ];
}

/** How far the well is from an edge of the box at a height, seen from the reader's side; endless where it does not pass. */
function gap(course, [from, to], height, along, edge) {
  const steps = 100;
  let least = Infinity;
  for (let i = 0; i <= steps; i++) {
    const [x, y, z] = course.at(from + ((to - from) * i) / steps, {}).place;
    if (Math.abs(y - height) <= (to - from) / steps) least = Math.min(least, Math.abs(along([x, z]) - along(edge)));
  }
  return least;
}

/** The signs for the depths in view, beside a hole of this radius in the scene, to a reader who looks from there. */
export function reference(course, range, radius, from) {
  const box = bounds(course, range);
  const { low, high } = box;
  const [behind, ...sides] = walls(box, from);
  // What the reader sees to the left: up crosses the way to the reader to the right.
  const along = ([x, z]) => x * from[2] - z * from[0];
  const [left, right] = sides.sort((a, b) => along(a) - along(b));
  const size = high.clone().sub(low).length();
  const unit = symbol("length");
  const marks = ticks(shown(range[0], "length"), shown(range[1], "length"), 8);
  const depths = marks.values.map((value) => {
    const { place, high } = course.at(si(value, "length"), {});
    const away = radius + 0.012 * size;
    return label(
      `${tickText(value, marks.step)} ${unit}`,
      place.map((at, axis) => at + away * high[axis]),
      LETTERS,
      "text",
      0,
    );
  });
  const lines = [];
  const edge = (a, b) => lines.push(...a, ...b);
  const down = ticks(shown(-high.y, "length"), shown(-low.y, "length"), 5);
  // Vertical depths stand to the left, or to the right where the well is much nearer to the left.
  const near = (edge) => Math.min(...down.values.map((value) => gap(course, range, -si(value, "length"), along, edge)));
  const beside = near(right) > near(left) + 0.1 * size ? right : left;
  const levels = down.values.map((value) => {
    const y = -si(value, "length");
    const at = ([x, z]) => [x, y, z];
    edge(at(behind), at(right));
    edge(at(behind), at(left));
    return label(`TVD ${tickText(value, down.step)} ${unit}`, at(beside), LETTERS, "muted", beside === left ? 1.06 : -0.06);
  });
  for (const [x, z] of [behind, right, left]) edge([x, low.y, z], [x, high.y, z]);
  const frame = new BufferGeometry();
  frame.setAttribute("position", new Float32BufferAttribute(lines, 3));
  return [
    new LineSegments(frame, new LineBasicMaterial({ color: colour("frame"), transparent: true, opacity: 0.35 })),
    // Of labels that would lie on each other the first stays.
    label("N", [(low.x + high.x) / 2, high.y, low.z - 0.04 * size], LETTERS + 2),
    label("E", [high.x + 0.04 * size, high.y, (low.z + high.z) / 2], LETTERS + 2),
    ...levels,
    ...depths,
  ];
}
