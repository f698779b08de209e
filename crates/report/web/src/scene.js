// The well in space with the string in it: across the hole everything is larger than along it.

import {
  AmbientLight,
  BufferGeometry,
  CanvasTexture,
  Color,
  DirectionalLight,
  DoubleSide,
  Float32BufferAttribute,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshLambertMaterial,
  PerspectiveCamera,
  Scene,
  Sprite,
  SpriteMaterial,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { Course, Tube } from "./bore.js";
import { el, select } from "./dom.js";
import { colour, diverging, sequential } from "./palette.js";
import { frameAt, poseOf, quantitiesOf, rangeOf } from "./pose.js";
import { chosenRun, spoken } from "./solutions.js";
import { choose, on, state } from "./state.js";
import { ticks, tickText } from "./ticks.js";
import { digits, shown, si, symbol } from "./units.js";

const HEIGHT = 520;
const SIDES = 10;

export function scene(report) {
  const canvas = el("canvas", { class: "space", role: "img", "aria-label": "The well in space, the string in it" });
  let renderer;
  try {
    renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
  } catch {
    return { element: el("p", { class: "warning" }, "This view needs WebGL, which this browser does not give."), redraw: () => {} };
  }
  const course = new Course(report.well);
  const world = new Scene();
  const camera = new PerspectiveCamera(38, 1, 1, 1e5);
  const orbit = new OrbitControls(camera, canvas);
  orbit.enableDamping = false;
  orbit.enableZoom = false;
  const sun = new DirectionalLight(0xffffff, 2.2);
  world.add(new AmbientLight(0xffffff, 1.6), sun);
  const deepest = report.well.md_m.at(-1);
  const widest = Math.max(...report.hole.map((section) => section.diameter_m), 0.1);
  // So that the hole is as thick as an eye can tell the sides of.
  let exaggeration = niceBelow((0.012 * deepest) / widest);
  let quantity = null;
  let frame = null;
  let playing = null;
  let items = [];

  const holder = el("div", { class: "space-holder" }, canvas);
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
  const mean = el("button", { type: "button", onclick: () => { stop(); choose({ moment: null }); } }, "Mean");
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
    ["Whole well", [0.75, 0.35, 1]],
    ["From the side", "side"],
    ["From above", [0.001, 1, 0.001]],
  ].map(([name, from]) => el("button", { type: "button", onclick: () => look(from) }, name));
  const tools = el("div", { class: "tools noprint" }, quantityHolder, el("label", {}, "Across × ", slider, factor), views, el("span", { class: "hint" }, "drag to turn, right-drag to move, Ctrl + wheel to go nearer; shows the depths in view above"));

  canvas.addEventListener(
    "wheel",
    (event) => {
      if (!event.ctrlKey && !event.metaKey) return;
      event.preventDefault();
      const offset = camera.position.clone().sub(orbit.target).multiplyScalar(Math.exp(event.deltaY * 0.002));
      camera.position.copy(orbit.target).add(offset);
      render();
    },
    { passive: false },
  );
  orbit.addEventListener("change", render);

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

  function dispose() {
    for (const item of items) {
      world.remove(item);
      item.geometry?.dispose();
      item.material.map?.dispose();
      item.material.dispose();
    }
    items = [];
  }

  function add(item) {
    items.push(item);
    world.add(item);
    return item;
  }

  /** Everything anew: hole, string, frame of reference. */
  function build() {
    dispose();
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
      const material = new MeshLambertMaterial({ color: colour(casing ? "casing" : "rock"), transparent: true, opacity: casing ? 0.16 : 0.26, side: DoubleSide, depthWrite: false });
      add(new Mesh(tube, material)).renderOrder = 2;
    }
    reference([from, to]);
    string();
    factor.textContent = ` ${digits(exaggeration, 2)}`;
    render();
  }

  let tube = null;
  let drawn = null;

  /** The string as it lies, coloured. */
  function string() {
    const run = chosenRun(report);
    frame = run?.frames && state.moment !== null ? frameAt(run.frames, state.moment) : null;
    const pose = poseOf(report, run, frame);
    const offered = quantitiesOf(pose);
    if (!offered.some(([name]) => name === quantity)) quantity = offered[0][0];
    const [, name, dimension, signed] = offered.find(([name]) => name === quantity);
    quantityHolder.replaceChildren(select("Colour: ", offered.map(([name, title]) => [name, title]), quantity, (value) => { quantity = value; string(); render(); }));
    const [from, to] = view();
    const nodes = Array.from(pose.depths, (depth, i) => [depth, i]).filter(([depth]) => depth >= from - 1 && depth <= to + 1);
    if (!tube || drawn.geometry !== tube || tube.rings !== nodes.length) {
      if (drawn) {
        world.remove(drawn);
        items = items.filter((item) => item !== drawn);
        drawn.geometry.dispose();
        drawn.material.dispose();
      }
      tube = new Tube(Math.max(nodes.length, 2), SIDES);
      drawn = add(new Mesh(tube, new MeshLambertMaterial({ vertexColors: true })));
    }
    if (!items.includes(drawn)) add(drawn);
    const values = pose.values(quantity);
    const range = rangeOf(pose, run, frame, quantity, signed);
    const paint = (value) => {
      const part = (value - range[0]) / (range[1] - range[0]);
      return (signed ? diverging(2 * part - 1) : sequential(part)).map((of) => of / 255);
    };
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
    drawKey(name, dimension, range, signed);
    moments.hidden = !run?.frames;
    if (run?.frames) {
      scrubber.max = run.frames.time_s.length - 1;
      if (frame !== null) scrubber.value = frame;
      mean.disabled = frame === null;
      time.textContent = frame === null ? "mean of the window" : `${run.frames.time_s[frame].toFixed(2)} s`;
    }
  }

  function drawKey(name, dimension, range, signed) {
    const stops = Array.from({ length: 21 }, (_, i) => {
      const part = i / 20;
      const [r, g, b] = signed ? diverging(2 * part - 1) : sequential(part);
      return `rgb(${r} ${g} ${b}) ${part * 100}%`;
    });
    const ends = range.map((value) => shown(value, dimension));
    const { values, step } = ticks(ends[0], ends[1], 4);
    key.replaceChildren(
      el("span", {}, `${name}${symbol(dimension) ? `, ${symbol(dimension)}` : ""}${signed ? " (low side −, high side +)" : ""}, ${spoken(state.operation)}`),
      el("div", { class: "ramp", style: `background:linear-gradient(to right, ${stops.join(",")})` }),
      el("div", { class: "ramp-ticks" }, values.map((value) => el("span", { style: `left:${((value - ends[0]) / (ends[1] - ends[0])) * 100}%` }, tickText(value, step)))),
    );
  }

  /** Depths along the well and a box around it with vertical depth, north and east. */
  function reference(range) {
    const out = {};
    const size = span(range).length();
    const { values, step } = ticks(shown(range[0], "length"), shown(range[1], "length"), 8);
    for (const value of values) {
      course.at(si(value, "length"), out);
      const away = 0.5 * widest * exaggeration + 0.022 * size;
      label(tickText(value, step), out.place.map((at, axis) => at + away * out.right[axis]), 0.02 * size);
    }
    const box = bounds(range);
    const [low, high] = [box.low, box.high];
    const lines = [];
    const edge = (a, b) => lines.push(...a, ...b);
    const down = ticks(shown(-high.y, "length"), shown(-low.y, "length"), 5);
    for (const value of down.values) {
      const y = -si(value, "length");
      edge([low.x, y, low.z], [high.x, y, low.z]);
      edge([low.x, y, low.z], [low.x, y, high.z]);
      label(`TVD ${tickText(value, down.step)} ${symbol("length")}`, [low.x, y, high.z], 0.018 * size, "muted");
    }
    for (const [x, z] of [[low.x, low.z], [high.x, low.z], [low.x, high.z]]) edge([x, low.y, z], [x, high.y, z]);
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new Float32BufferAttribute(lines, 3));
    add(new LineSegments(geometry, new LineBasicMaterial({ color: colour("frame"), transparent: true, opacity: 0.35 })));
    const north = [(low.x + high.x) / 2, high.y, low.z];
    label("N", north, 0.024 * size);
    label("E", [high.x, high.y, (low.z + high.z) / 2], 0.024 * size);
  }

  function label(text, place, size, ink = "text") {
    const sheet = el("canvas", {});
    const pen = sheet.getContext("2d");
    const font = "600 44px system-ui, sans-serif";
    pen.font = font;
    sheet.width = Math.ceil(pen.measureText(text).width) + 8;
    sheet.height = 56;
    pen.font = font;
    pen.textBaseline = "middle";
    pen.fillStyle = colour(ink);
    pen.fillText(text, 4, 30);
    const sprite = new Sprite(new SpriteMaterial({ map: new CanvasTexture(sheet), depthTest: false, transparent: true }));
    sprite.position.set(...place);
    sprite.scale.set((size * sheet.width) / sheet.height, size, 1);
    sprite.renderOrder = 3;
    add(sprite);
  }

  /** Corners of a box around the path between two depths, never flat. */
  function bounds([from, to]) {
    const out = {};
    const low = new Vector3(Infinity, Infinity, Infinity);
    const high = low.clone().negate();
    for (let i = 0; i <= 100; i++) {
      const at = new Vector3(...course.at(from + ((to - from) * i) / 100, out).place);
      low.min(at);
      high.max(at);
    }
    const least = 0.22 * high.clone().sub(low).length();
    for (const axis of ["x", "y", "z"]) {
      const short = Math.max(least - (high[axis] - low[axis]), 0) / 2;
      low[axis] -= short + (axis === "y" ? 0 : 0.03 * least);
      high[axis] += short + (axis === "y" ? 0 : 0.03 * least);
    }
    return { low, high };
  }

  const span = (range) => {
    const { low, high } = bounds(range);
    return high.clone().sub(low);
  };

  /** Looks at the depths in view from a direction. */
  function look(from) {
    const { low, high } = bounds(view());
    const middle = low.clone().add(high).multiplyScalar(0.5);
    const size = high.clone().sub(low).length();
    let direction = from;
    if (from === "side") {
      // Across the vertical plane in which the well goes.
      const [a, b] = [course.at(view()[0], {}).place, course.at(view()[1], {}).place];
      const [x, z] = [b[0] - a[0], b[2] - a[2]];
      const flat = Math.hypot(x, z);
      direction = flat > 0 ? [-z / flat, 0.03, x / flat] : [0, 0.03, 1];
      if (direction[2] < 0) direction = [-direction[0], 0.03, -direction[2]];
    }
    orbit.target.copy(middle);
    const wide = canvas.clientWidth / HEIGHT;
    const far = (0.56 * size) / Math.tan((camera.fov * Math.PI) / 360) / Math.min(wide, 1);
    camera.position.copy(middle).add(new Vector3(...direction).normalize().multiplyScalar(far));
    camera.near = far / 200;
    camera.far = far * 20;
    camera.updateProjectionMatrix();
    orbit.update();
    render();
  }

  function render() {
    sun.position.copy(camera.position);
    sun.target.position.copy(orbit.target);
    sun.target.updateMatrixWorld();
    renderer.render(world, camera);
  }

  function size() {
    const width = holder.clientWidth || 1200;
    renderer.setPixelRatio(Math.min(devicePixelRatio * (devicePixelRatio < 1.5 ? 1.5 : 1), 2.5));
    renderer.setSize(width, HEIGHT, false);
    camera.aspect = width / HEIGHT;
    camera.updateProjectionMatrix();
  }

  function redraw() {
    size();
    build();
    look([0.75, 0.35, 1]);
  }

  on("units operation", () => {
    stop();
    build();
  });
  on("depths", () => {
    build();
    look(camera.position.clone().sub(orbit.target).toArray());
  });
  on("moment", () => {
    string();
    render();
  });
  let width = 0;
  new ResizeObserver(() => {
    if (holder.clientWidth === width) return;
    width = holder.clientWidth;
    size();
    render();
  }).observe(holder);
  return { element: el("div", {}, tools, holder, moments, key), redraw };
}

/** 1, 2 or 5 times a power of ten that is not above. */
function niceBelow(value) {
  const power = 10 ** Math.floor(Math.log10(Math.max(value, 1)));
  return [5, 2, 1].map((m) => m * power).find((m) => m <= Math.max(value, 1)) ?? 1;
}
