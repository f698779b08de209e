// The well in space with the string in it: across the hole everything is larger than along it.

import { Course } from "../../../../web/components/bore.ts";
import { colourKey } from "../../../../web/components/colour_key.ts";
import { el, select } from "../../../../web/components/dom.ts";
import { colourScale } from "../../../../web/components/palette.ts";
import { reference } from "../../../../web/components/reference.ts";
import { LOOK_AROUND, noSpace, stage } from "../../../../web/components/stage.ts";
import { layString, stringMesh } from "../../../../web/components/string_tube.ts";
import { digits, shown, symbol } from "../../../../web/components/units.ts";
import { ABOVE, across, exaggerationFor, holeTubes, lookAtWell } from "../../../../web/components/well_in_space.ts";
import { csv, downloads } from "./downloads.js";
import { frameAt, poseOf, quantitiesOf, rangeOf } from "./pose.js";
import { chosenRun, readable } from "./solutions.js";
import { choose, on, state } from "./state.js";

const HEIGHT = 600;

export function scene(report) {
  const space = stage("The well in space, the string in it", HEIGHT);
  if (!space) return { element: noSpace(), redraw: () => {} };
  const course = new Course(report.well);
  const deepest = report.well.md_m.at(-1);
  const widest = Math.max(...report.hole.map((section) => section.diameter_m), 0.1);
  // So that the hole is as thick as an eye can tell the sides of.
  let exaggeration = exaggerationFor(deepest, widest);
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
    ["From the side", () => across(course, view(), 0.02)],
    ["From above", () => [0.001, 1, 0.001]],
  ].map(([name, from]) => el("button", { type: "button", onclick: () => look(from()) }, name));
  const whole = () => {
    choose({ depths: null });
    look(across(course, view(), ABOVE));
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

  /** Everything anew: hole, string, frame of reference. */
  function build() {
    space.remove();
    const [from, to] = view();
    holeTubes(course, report.hole, [from, to], exaggeration).forEach(space.add);
    reference(course, [from, to], (widest / 2) * exaggeration, across(course, [from, to], ABOVE)).forEach(space.add);
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
    const offered = pose ? quantitiesOf(report, pose) : [];
    if (!offered.length) return withoutString();
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
      const made = stringMesh(nodes.length);
      tube = made.tube;
      drawn = space.add(made.mesh);
    }
    if (!space.has(drawn)) space.add(drawn);
    const values = pose.values(quantity);
    const range = rangeOf(pose, run, frame, quantity, signed);
    const scale = colourScale(signed);
    const parts = report.string;
    const rings = nodes.map(([depth, i]) => {
      const part = parts.find((part) => depth <= part.to_m) ?? parts.at(-1);
      return {
        depth: Math.min(depth, deepest),
        high: pose.high[i],
        right: pose.right[i],
        radius: (part?.od_m ?? 0.12) / 2,
        part: (values[i] - range[0]) / (range[1] - range[0]),
      };
    });
    layString(tube, course, rings, exaggeration, scale);
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

  /** The hole alone, of an operation that no model has an answer of. */
  function withoutString() {
    if (drawn) space.remove([drawn]);
    [tube, drawn] = [null, null];
    quantityHolder.replaceChildren();
    moments.hidden = true;
    key.replaceChildren(`${state.operation ? `${readable(state.operation)}: ` : ""}no model has an answer; the hole without the string`);
  }

  /** The string as it is drawn, for a file. */
  function table() {
    const pose = poseOf(report, chosenRun(report), frame);
    if (!drawn) return [[`md, ${symbol("length")}`], []];
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

  const look = (direction) => lookAtWell(space, course, view(), direction);

  function redraw() {
    space.size();
    build();
    look(across(course, view(), ABOVE));
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
