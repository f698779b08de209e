// The bottom-hole assembly in its hole, from the side and from above, with exaggerated width.

import { type Place, valueAt } from "./curve.ts";
import { svg } from "./dom.ts";
import { type Interval, ticks, tickText } from "./ticks.ts";
import { digits, quantity, shown, si, symbol } from "./units.ts";

/** Towards the high side, and to the right of it as one looks down the hole. */
export type Pair = readonly [number, number];

/** A static BHA analysis, SI; distances are from the bit. */
export interface AssemblyAtRest {
  length_m: number;
  contacts: readonly { touching: string; name: string; from_bit_m: Pair; force_N: Pair }[];
  sensors_m: readonly number[];
  parts: readonly {
    name: string;
    from_bit_m: number;
    to_bit_m: number;
    od_m: number;
    blades_m: Pair | null;
    joint_od_m: number | null;
    bend_m: number | null;
  }[];
  axis: {
    from_bit_m: readonly number[];
    hole_radius_m: readonly number[];
    offset_high_m: readonly number[];
    offset_right_m: readonly number[];
  };
}

/** Half of the height of a view over the radius of the hole. */
const AROUND = 1.6;
/** Component of a contact force in a plane above which it is marked, as a part of the force. */
const SEEN = 0.1;
/** Largest number of forces written into a view. */
const NAMED = 6;

const [LEFT, RIGHT, TOP, GAP, VIEW, BOTTOM] = [58, 10, 20, 30, 118, 34];

/**
 * Upper end of the views, m from the bit: a little above the collars and below the jointed pipe, if there is any;
 * otherwise the end of the assembly.
 */
export function viewedTo(assembly: AssemblyAtRest): number {
  const jointed = assembly.parts.find((part) => part.joint_od_m !== null)?.from_bit_m ?? 0;
  const collars = jointed > 0 ? jointed : assembly.length_m;
  return Math.min(1.1 * Math.min(collars, assembly.length_m), assembly.axis.from_bit_m.at(-1) ?? 0);
}

/** Position of a view in the picture: its plane, its middle and its two scales. */
interface View {
  side: 0 | 1;
  offset: readonly number[];
  x: Place;
  y: Place;
  to: number;
}

const points = (places: readonly Pair[]): string => places.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L");

/** A section of the string with a diameter, along the axis of the string. */
function body(assembly: AssemblyAtRest, view: View, from: number, to: number, od: number, look: string): SVGElement[] {
  const end = Math.min(to, view.to);
  if (end <= from) return [];
  const { from_bit_m } = assembly.axis;
  const places = [from, ...from_bit_m.filter((at) => at > from && at < end), end];
  const edge = (side: number): Pair[] =>
    places.map((at) => [view.x(at), view.y(valueAt(from_bit_m, view.offset, at) + (side * od) / 2)]);
  return [svg("path", { d: `M${points(edge(1))}L${points(edge(-1).reverse())}Z`, class: look })];
}

function walls(assembly: AssemblyAtRest, view: View, half: number): SVGElement[] {
  const { from_bit_m, hole_radius_m } = assembly.axis;
  const places = [...from_bit_m.filter((at) => at < view.to), view.to];
  return [1, -1].flatMap((side) => {
    const wall = places.map((at): Pair => [view.x(at), view.y(side * valueAt(from_bit_m, hole_radius_m, at))]);
    const rock: Pair[] = [
      [view.x(view.to), view.y(side * half)],
      [view.x(0), view.y(side * half)],
    ];
    return [
      svg("path", { d: `M${points([...wall, ...rock])}Z`, class: "rock" }),
      svg("path", { d: `M${points(wall)}`, class: "wall-line" }),
    ];
  });
}

/** Contacts on the side of the wall that they press in this plane; the largest with their forces. */
function touches(assembly: AssemblyAtRest, view: View): SVGElement[] {
  const { from_bit_m, hole_radius_m } = assembly.axis;
  const seen = assembly.contacts
    .map((contact) => ({ contact, at: (contact.from_bit_m[0] + contact.from_bit_m[1]) / 2, force: contact.force_N[view.side] }))
    .filter(({ contact, at, force }) => at <= view.to && Math.abs(force) >= SEEN * Math.hypot(...contact.force_N) && force !== 0)
    .sort((a, b) => Math.abs(b.force) - Math.abs(a.force));
  let taken: [number, number][] = [];
  return seen.flatMap(({ contact, at, force }, rank) => {
    const side = Math.sign(force);
    const [x, y] = [view.x(at), view.y(side * valueAt(from_bit_m, hole_radius_m, at))];
    // Screen coordinates grow downwards: towards the high side is up.
    const mark = svg("path", { d: `M${x} ${y}l-4.5 ${-side * 8}h9Z`, class: "touch" });
    mark.append(svg("title", {}, `${contact.name}, ${contact.touching}: ${quantity(Math.abs(force), "force", 3)}`));
    const text = quantity(Math.abs(force), "force", 3);
    const wide = 3.4 * text.length;
    const free = taken.every(([left, right]) => x + wide < left || x - wide > right);
    if (rank >= NAMED || !free) return [mark];
    taken = [...taken, [x - wide, x + wide]];
    const place = Math.max(x, view.x(0) + wide + 2);
    return [mark, svg("text", { x: place, y: side > 0 ? y - 11 : y + 19, class: "middle force" }, text)];
  });
}

function view(assembly: AssemblyAtRest, side: 0 | 1, top: number, width: number, to: number, half: number): SVGElement[] {
  const wide = width - LEFT - RIGHT;
  const frame: View = {
    side,
    offset: side === 0 ? assembly.axis.offset_high_m : assembly.axis.offset_right_m,
    x: (at) => LEFT + (at / to) * wide,
    y: (offset) => top + VIEW / 2 - (offset / half) * (VIEW / 2),
    to,
  };
  const clip = svg("svg", { x: LEFT, y: top, width: wide, height: VIEW, viewBox: `${LEFT} ${top} ${wide} ${VIEW}` });
  clip.append(...walls(assembly, frame, half));
  for (const part of assembly.parts) clip.append(...body(assembly, frame, part.from_bit_m, part.to_bit_m, part.od_m, "body"));
  for (const { from_bit_m, to_bit_m, blades_m } of assembly.parts) {
    if (!blades_m) continue;
    const middle = (from_bit_m + to_bit_m) / 2;
    clip.append(...body(assembly, frame, middle - blades_m[1] / 2, middle + blades_m[1] / 2, blades_m[0], "blades"));
  }
  const axis = assembly.axis.from_bit_m.flatMap((at, i): Pair[] => (at <= to ? [[frame.x(at), frame.y(frame.offset[i] ?? NaN)]] : []));
  clip.append(svg("path", { d: `M${points(axis)}`, class: "string-axis" }));
  for (const at of assembly.sensors_m)
    if (at <= to) clip.append(svg("line", { x1: frame.x(at), x2: frame.x(at), y1: top, y2: top + VIEW, class: "chosen" }));
  for (const { bend_m } of assembly.parts) {
    if (bend_m === null || bend_m > to) continue;
    const [x, y] = [frame.x(bend_m), frame.y(valueAt(assembly.axis.from_bit_m, frame.offset, bend_m))];
    clip.append(svg("path", { d: `M${x} ${y - 5}l5 5l-5 5l-5 -5Z`, class: "bend" }, svg("title", {}, "bend")));
  }
  clip.append(...touches(assembly, frame));
  const scale: Interval = [shown(-half, "diameter"), shown(half, "diameter")];
  const marks = ticks(scale[0], scale[1], 4);
  return [
    svg("text", { x: LEFT, y: top - 6, class: "title" }, side === 0 ? "From the side, high side up" : "From above, right side up"),
    ...marks.values.map((value) =>
      svg("text", { x: LEFT - 6, y: frame.y(si(value, "diameter")) + 4, class: "tick end" }, tickText(value, marks.step)),
    ),
    clip,
    svg("rect", { x: LEFT, y: top, width: wide, height: VIEW, class: "frame" }),
  ];
}

/** Both views, for a width in pixels. */
export function assemblyViews(assembly: AssemblyAtRest, width: number): SVGSVGElement {
  const to = viewedTo(assembly);
  const radii = assembly.axis.hole_radius_m.filter((_, i) => (assembly.axis.from_bit_m[i] ?? Infinity) <= to);
  const half = AROUND * Math.max(...radii, 1e-3);
  const height = TOP + 2 * VIEW + GAP + BOTTOM;
  const times = VIEW / (2 * half) / ((width - LEFT - RIGHT) / to);
  const picture = svg("svg", {
    viewBox: `0 0 ${width} ${height}`,
    width,
    height,
    role: "img",
    "aria-label": "The assembly in its hole, from the side and from above",
  });
  picture.append(...view(assembly, 0, TOP, width, to, half), ...view(assembly, 1, TOP + VIEW + GAP, width, to, half));
  const marks = ticks(0, shown(to, "length"), 8);
  const bottom = TOP + 2 * VIEW + GAP;
  for (const value of marks.values) {
    const at = LEFT + (si(value, "length") / to) * (width - LEFT - RIGHT);
    picture.append(svg("text", { x: at, y: bottom + 14, class: "tick middle" }, tickText(value, marks.step)));
  }
  const words = `Distance from the bit, ${symbol("length")}; across in ${symbol("diameter")}, ${digits(times, 2)} times as wide as long`;
  picture.append(svg("text", { x: LEFT, y: bottom + 29, class: "unit" }, words));
  return picture;
}
