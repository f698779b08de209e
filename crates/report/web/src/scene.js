// The well in space with the string in it: across the hole everything is larger than along it.

import { Color, DoubleSide, Mesh, MeshLambertMaterial } from "three";
import { Course, Tube } from "./bore.js";
import { colourKey } from "./colour_key.js";
import { el, select } from "./dom.js";
import { csv, downloads } from "./downloads.js";
import { colour, colourScale } from "./palette.js";
import { frameAt, poseOf, quantitiesOf, rangeOf } from "./pose.js";
import { bounds, reference, walls } from "./reference.js";
import { chosenRun, readable } from "./solutions.js";
import { LOOK_AROUND, noSpace, stage } from "./stage.js";
import { choose, on, state } from "./state.js";
import { digits, shown, symbol } from "./units.js";

const HEIGHT = 600;
const SIDES = 10;

export function scene(report) {
  const space = stage("The well in space, the string in it", HEIGHT);
  if (!space) return { element: noSpace(), redraw: () => {} };
  const course = new Course(report.well);
  const deepest = report.well.md_m.at(-1);
  const widest = Math.max(...report.hole.map((section) => section.diameter_m), 0.1);
  // So that the hole is as thick as an eye can tell the sides of.
  let exaggeration = niceBelow((0.03 * deepest) / widest);
  let quantity = null;
  let frame = null;
  let playing = null;

  const key = el("div", { class: "colour-key" });
  const time = el("output", {});
  const scrubber = el("input", {
    type: "range",
    min: 0,
    step: 1,
    "aria-label": "Moment",
    oninput: () => {
      const run = chosenRun(report);
      choose({ moment: run.frames.time_s[Number(scrubber.value)] });
    },
  });
  const play = el("button", { type: "button", onclick: () => (playing ? stop() : start()) }, "Play");
  const mean = el(
    "button",
    {
      type: "button",
      onclick: () => {
        stop();
        choose({ moment: null });
      },
    },
    "Mean",
  );
  const moments = el("div", { class: "moments" }, play, mean, scrubber, time);
  const factor = el("output", {});
  const slider = el("input", {
    type: "range",
    min: 0,
    max: 3.7,
    step: 0.01,
    value: Math.log10(exaggeration),
    "aria-label": "Exaggeration across the hole",
    oninput: () => {
      exaggeration = 10 ** Number(slider.value);
      build();
    },
  });
  const quantityHolder = el("span", {});
  const views = [
    ["From the side", () => across(0.02)],
    ["From above", () => [0.001, 1, 0.001]],
  ].map(([name, from]) => el("button", { type: "button", onclick: () => look(from()) }, name));
  const whole = () => {
    choose({ depths: null });
    look(across(0.3));
  };
  views.unshift(el("button", { type: "button", onclick: whole }, "Whole well"));
  const tools = el(
    "div",
    { class: "tools noprint" },
    quantityHolder,
    el("label", {}, "Across × ", slider, factor),
    views,
    downloads("The well in space", { png: () => space.canvas, csv: () => csv(...table()) }),
    el("span", { class: "hint" }, `${LOOK_AROUND}; shows the depths in view above`),
  );

  function start() {
    play.textContent = "Stop";
    playing = setInterval(() => {
      const { frames } = chosenRun(report);
      const next = (Number(scrubber.value) + 1) % frames.time_s.length;
      choose({ moment: frames.time_s[next] });
    }, 80);
  }

  function stop() {
    clearInterval(playing);
    playing = null;
    play.textContent = "Play";
  }

  const view = () => state.depths ?? [report.well.md_m[0], deepest];

  /** Depths at which rings of the hole stand. */
  function depthsOf([from, to]) {
    const within = Array.from(report.well.md_m).filter((depth) => depth > from && depth < to);
    const step = (to - from) / 300;
    const even = Array.from({ length: 301 }, (_, i) => from + i * step);
    return [...even, ...within].sort((a, b) => a - b);
  }

  /** Everything anew: hole, string, frame of reference. */
  function build() {
    space.remove();
    const [from, to] = view();
    const out = {};
    for (const section of report.hole) {
      const range = [Math.max(section.from_m, from), Math.min(section.to_m, to)];
      if (range[1] <= range[0]) continue;
      const depths = depthsOf(range);
      const tube = new Tube(depths.length, 28);
      depths.forEach((depth, i) => {
        course.at(depth, out);
        tube.ring(i, out.place, out.high, out.right, (section.diameter_m / 2) * exaggeration);
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
      space.add(new Mesh(tube, material)).renderOrder = 2;
    }
    reference(course, [from, to], (widest / 2) * exaggeration, across(0.3)).forEach(space.add);
    string();
    factor.textContent = ` ${digits(exaggeration, 2)}`;
    space.render();
  }

  let tube = null;
  let drawn = null;

  /** The string as it lies, coloured. */
  function string() {
    const run = chosenRun(report);
    frame = run?.frames && state.moment !== null ? frameAt(run.frames, state.moment) : null;
    const pose = poseOf(report, run, frame);
    const offered = quantitiesOf(report, pose);
    if (!offered.some(({ column }) => column === quantity)) quantity = offered[0].column;
    const { title, dimension, signed } = offered.find(({ column }) => column === quantity);
    quantityHolder.replaceChildren(
      select(
        "Colour: ",
        offered.map(({ column, title }) => [column, title]),
        quantity,
        (value) => {
          quantity = value;
          string();
          space.render();
        },
      ),
    );
    const [from, to] = view();
    const nodes = Array.from(pose.depths, (depth, i) => [depth, i]).filter(
      ([depth]) => depth >= from - 1 && depth <= to + 1,
    );
    if (!tube || drawn.geometry !== tube || tube.rings !== nodes.length) {
      if (drawn) space.remove([drawn]);
      tube = new Tube(Math.max(nodes.length, 2), SIDES);
      drawn = space.add(new Mesh(tube, new MeshLambertMaterial({ vertexColors: true })));
    }
    if (!space.has(drawn)) space.add(drawn);
    const values = pose.values(quantity);
    const range = rangeOf(pose, run, frame, quantity, signed);
    const scale = colourScale(signed);
    const paint = (value) => scale((value - range[0]) / (range[1] - range[0])).map((of) => of / 255);
    const out = {};
    const tint = new Color();
    const parts = report.string;
    nodes.forEach(([depth, i], ring) => {
      course.at(Math.min(depth, deepest), out);
      const [high, right] = [pose.high[i] * exaggeration || 0, pose.right[i] * exaggeration || 0];
      const place = out.place.map((at, axis) => at + high * out.high[axis] + right * out.right[axis]);
      const part = parts.find((part) => depth <= part.to_m) ?? parts.at(-1);
      tube.ring(ring, place, out.high, out.right, ((part?.od_m ?? 0.12) / 2) * exaggeration);
      const [red, green, blue] = Number.isFinite(values[i]) ? paint(values[i]) : [0.5, 0.5, 0.5];
      tint.setRGB(red, green, blue, "srgb");
      tube.paint(ring, tint.r, tint.g, tint.b);
    });
    tube.changed();
    const unit = symbol(dimension) ? `, ${symbol(dimension)}` : "";
    const sides = signed ? " (low side −, high side +)" : "";
    key.replaceChildren(...colourKey(`${title}${unit}${sides}, ${readable(state.operation)}`, dimension, range, scale));
    moments.hidden = !run?.frames;
    if (run?.frames) {
      scrubber.max = run.frames.time_s.length - 1;
      if (frame !== null) scrubber.value = frame;
      mean.disabled = frame === null;
      time.textContent = frame === null ? "mean of the window" : `${run.frames.time_s[frame].toFixed(2)} s`;
    }
  }

  /** The string as it is drawn, for a file. */
  function table() {
    const pose = poseOf(report, chosenRun(report), frame);
    const { title, dimension } = quantitiesOf(report, pose).find(({ column }) => column === quantity);
    const values = pose.values(quantity);
    const heads = [
      `md, ${symbol("length")}`,
      `to the high side, ${symbol("diameter")}`,
      `to the right, ${symbol("diameter")}`,
      `${title}, ${symbol(dimension)}`,
    ];
    const rows = Array.from(pose.depths, (depth, i) => [
      shown(depth, "length"),
      shown(pose.high[i], "diameter"),
      shown(pose.right[i], "diameter"),
      shown(values[i], dimension),
    ]);
    return [heads, rows];
  }

  /** Places along the path in view. */
  function along() {
    const [from, to] = view();
    return Array.from({ length: 41 }, (_, i) => course.at(from + ((to - from) * i) / 40, {}).place);
  }

  /** Across the vertical plane in which the well goes, so much from above. */
  function across(above) {
    const [a, b] = view().map((depth) => course.at(depth, {}).place);
    const [x, z] = [b[0] - a[0], b[2] - a[2]];
    const flat = Math.hypot(x, z);
    if (flat < 1e-3) return [0.6, above, 0.8];
    const side = x - z < 0 ? -1 : 1;
    return [(-z / flat) * side, above, (x / flat) * side];
  }

  /** Looks at the depths in view from a direction. */
  function look(direction) {
    const { low, high } = bounds(course, view());
    const middle = low.clone().add(high).multiplyScalar(0.5);
    const corners = walls({ low, high }, across(0.3)).flatMap(([x, z]) => [low.y, high.y].map((y) => [x, y, z]));
    const places = [...corners, ...along()];
    // Depths stand to the right of the well, vertical depths to the left of the box.
    space.lookAt(places, direction, middle, [84, 16]);
    space.holder.dataset.spans = space.spans(places).map((part) => part.toFixed(2)).join(" ");
  }

  function redraw() {
    space.size();
    build();
    look(across(0.3));
  }

  on("units operation", () => {
    stop();
    build();
  });
  on("depths", () => {
    build();
    look(space.from().toArray());
  });
  on("moment", () => {
    string();
    space.render();
  });
  return { element: el("div", {}, tools, space.holder, moments, key), redraw };
}

/** 1, 2 or 5 times a power of ten that is not above. */
function niceBelow(value) {
  const power = 10 ** Math.floor(Math.log10(Math.max(value, 1)));
  return [5, 2, 1].map((m) => m * power).find((m) => m <= Math.max(value, 1)) ?? 1;
}
