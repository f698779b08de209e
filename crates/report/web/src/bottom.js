// The bottom of the hole: in space, and from above as a map.

import {
  BufferGeometry,
  Color,
  DoubleSide,
  Float32BufferAttribute,
  FrontSide,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshLambertMaterial,
  Vector3,
} from "three";
import { colourKey } from "../../../../web/components/colour_key.ts";
import { el } from "../../../../web/components/dom.ts";
import { colour } from "../../../../web/components/palette.ts";
import { label } from "../../../../web/components/reference.ts";
import { LOOK_AROUND, noSpace, stage } from "../../../../web/components/stage.ts";
import { ticks, tickText } from "../../../../web/components/ticks.ts";
import { digits, shown, si, symbol } from "../../../../web/components/units.ts";
import { deepestOf, depthScale, edgesOf } from "./cells.js";
import { plan } from "./plan.js";
import { on } from "./state.js";

const HEIGHT = 460;

/** From above and in front. */
const FROM = [-0.35, 0.95, 0.9];

/** A view of the bottom that `get` gives, none where it gives none; `sided` says whether its high side means something. */
export function bottomView(get, sided) {
  const space = stage("The bottom of the hole in space", HEIGHT, 0.9);
  const map = plan(get, sided);
  const key = el("div", { class: "colour-key" });
  let exaggeration = 1;
  let shown = null;
  const factor = el("output", {});
  const slider = el("input", {
    type: "range",
    min: 0,
    max: 1.3,
    step: 0.01,
    "aria-label": "Exaggeration of depth",
    oninput: () => {
      exaggeration = 10 ** Number(slider.value);
      build();
    },
  });
  const views = [
    ["At an angle", FROM],
    ["From above", [0, 1, 0.001]],
    ["From the side", [0, 0.12, 1]],
  ].map(([name, from]) => el("button", { type: "button", onclick: () => look(from) }, name));
  const tools = el(
    "div",
    { class: "tools noprint" },
    el("label", {}, "Depth × ", slider, factor),
    views,
    el("span", { class: "hint" }, LOOK_AROUND),
  );

  /** Everything anew. */
  function build() {
    const bottom = get();
    if (!bottom) return;
    const [, outer] = edgesOf(bottom);
    const deepest = deepestOf(bottom);
    const unit = symbol("diameter");
    key.replaceChildren(...colourKey(`Depth below the rim, ${unit}`, "diameter", [0, deepest], depthScale()));
    if (!space) return;
    space.remove();
    space.add(relief(bottom, deepest, exaggeration));
    space.add(wall(bottom, exaggeration));
    signs(outer, sided ? topOf(bottom) * exaggeration : null).forEach(space.add);
    factor.textContent = ` ${digits(exaggeration, 2)}`;
    space.render();
  }

  function look(from) {
    const bottom = get();
    if (!bottom || !space) return;
    const [, outer] = edgesOf(bottom);
    const deep = deepestOf(bottom) * exaggeration;
    const high = bottom.depth_m.reduce((least, depth) => (depth < least ? depth : least), 0) * exaggeration;
    const round = Array.from({ length: 24 }, (_, k) => (k * Math.PI) / 12);
    const hole = round.flatMap((angle) => [high, deep].map((down) => place(outer, angle, down)));
    const beside = [-1, 1].map((side) => [0.7 * side * outer, 0, 1.25 * outer]);
    if (sided) beside.push([0, 0.2 * outer - high, -outer]);
    // What is near takes more room: the middle of the picture lies on the reader's side of the axis.
    space.lookAt([...hole, ...beside], from, new Vector3(0, -(high + deep) / 2, 0.22 * outer));
  }

  /** Another bottom, seen as far off as it is large. */
  function change() {
    const bottom = get();
    shown = bottom;
    if (!bottom) return;
    // Grooves are a few millimetres deep in a hole of decimetres.
    const steep = (0.3 * edgesOf(bottom)[1]) / (deepestOf(bottom) || 1);
    exaggeration = [10, 5, 2].find((times) => times <= steep) ?? 1;
    slider.value = Math.log10(exaggeration);
    build();
    look(FROM);
  }

  function redraw() {
    map.draw();
    if (space) space.size();
    // The same bottom stays as the reader has turned it.
    if (get() === shown) build();
    else change();
  }

  on("units", () => {
    map.draw();
    build();
  });
  on("operation", () => {
    map.draw();
    change();
  });
  const parts = space ? [tools, el("div", { class: "bottom" }, space.holder, map.element)] : [noSpace(), map.element];
  return { element: el("div", {}, parts, key), redraw };
}

/** A place by its distances towards the high side, to the right and down: the high side lies away from the reader. */
const place = (radius, angle, down) => [radius * Math.sin(angle), -down, -radius * Math.cos(angle)];

/** Rings of points with one more at either edge, so that the relief reaches as far as the bottom does. */
function ringsOf(bottom) {
  const [inner, outer] = edgesOf(bottom);
  const sectors = bottom.angle_rad.length;
  const last = bottom.radius_m.length - 1;
  const cells = (ring) => bottom.depth_m.subarray(ring * sectors, (ring + 1) * sectors);
  const rings = Array.from(bottom.radius_m, (radius, ring) => [radius, cells(ring)]);
  const first = cells(0);
  const known = first.filter(Number.isFinite);
  const middle = known.reduce((sum, depth) => sum + depth, 0) / known.length;
  // All sectors meet on the axis.
  rings.unshift(inner > 0 ? [inner, first] : [0, first.map(() => middle)]);
  rings.push([outer, cells(last)]);
  return rings;
}

/** The relief, coloured by depth, open where nothing is known. */
function relief(bottom, deepest, exaggeration) {
  const rings = ringsOf(bottom);
  const sectors = bottom.angle_rad.length;
  const scale = depthScale();
  const tint = new Color();
  const [places, colours, faces] = [[], [], []];
  for (const [radius, depths] of rings)
    depths.forEach((depth, k) => {
      const down = Number.isFinite(depth) ? depth : 0;
      places.push(...place(radius, bottom.angle_rad[k], down * exaggeration));
      const [red, green, blue] = scale(down / (deepest || 1)).map((of) => of / 255);
      tint.setRGB(red, green, blue, "srgb");
      colours.push(tint.r, tint.g, tint.b);
    });
  const known = (ring, k) => Number.isFinite(rings[ring][1][k]);
  for (let ring = 0; ring + 1 < rings.length; ring++)
    for (let k = 0; k < sectors; k++) {
      const next = (k + 1) % sectors;
      if (![known(ring, k), known(ring, next), known(ring + 1, k), known(ring + 1, next)].every(Boolean)) continue;
      const [a, b] = [ring * sectors + k, ring * sectors + next];
      faces.push(a, b, a + sectors, b, b + sectors, a + sectors);
    }
  const shape = new BufferGeometry();
  shape.setAttribute("position", new Float32BufferAttribute(places, 3));
  shape.setAttribute("color", new Float32BufferAttribute(colours, 3));
  shape.setIndex(faces);
  shape.computeVertexNormals();
  return new Mesh(shape, new MeshLambertMaterial({ vertexColors: true, side: DoubleSide }));
}

/** Depths of the outermost cells. */
const rimOf = (bottom) => bottom.depth_m.subarray((bottom.radius_m.length - 1) * bottom.angle_rad.length);

/** Depth of the highest splinter on the wall, or of the rim. */
const topOf = (bottom) => Math.min(0, ...rimOf(bottom).filter(Number.isFinite));

/** The wall of the hole about the relief, up to the rim and its splinters; the reader looks through the near side. */
function wall(bottom, exaggeration) {
  const [, outer] = edgesOf(bottom);
  const sectors = bottom.angle_rad.length;
  const rim = rimOf(bottom);
  const top = topOf(bottom) * exaggeration - 0.02 * outer;
  const [places, faces] = [[], []];
  rim.forEach((depth, k) => {
    const angle = bottom.angle_rad[k];
    places.push(...place(outer, angle, top));
    places.push(...place(outer, angle, (Number.isFinite(depth) ? depth : 0) * exaggeration));
    const [a, b] = [2 * k, 2 * ((k + 1) % sectors)];
    faces.push(a, a + 1, b, b, a + 1, b + 1);
  });
  const shape = new BufferGeometry();
  shape.setAttribute("position", new Float32BufferAttribute(places, 3));
  shape.setIndex(faces);
  shape.computeVertexNormals();
  return new Mesh(shape, new MeshLambertMaterial({ color: colour("rock"), side: FrontSide }));
}

/** A round length beside the hole; over a wall that has its top there, where its high side is. */
function signs(outer, top) {
  const { values, step } = ticks(0, shown(1.4 * outer, "diameter"), 3);
  const length = si(values.at(-1), "diameter");
  const away = 1.12 * outer;
  const [left, right] = [-length / 2, length / 2];
  const end = 0.025 * outer;
  const lines = [left, 0, away, right, 0, away];
  for (const x of [left, right]) lines.push(x, 0, away - end, x, 0, away + end);
  const shape = new BufferGeometry();
  shape.setAttribute("position", new Float32BufferAttribute(lines, 3));
  const size = 0.075 * outer;
  const words = `${tickText(values.at(-1), step)} ${symbol("diameter")}`;
  return [
    new LineSegments(shape, new LineBasicMaterial({ color: colour("text") })),
    label(words, [0, 0, away + 1.1 * size], 18),
    ...(top === null ? [] : [label("high side", [0, 1.2 * size - top, -outer], 18)]),
  ];
}
