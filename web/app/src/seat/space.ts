// The moving string in its hole in space, exaggerated across the hole.

import {
  AmbientLight,
  Box3,
  Color,
  DirectionalLight,
  DoubleSide,
  Mesh,
  MeshLambertMaterial,
  PerspectiveCamera,
  Scene,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Layout } from "../api/live";
import type { Frame } from "./connection.svelte";
import { Course } from "./course";
import { colour, Range } from "./pen";
import type { ValueAt } from "./profile";
import { Tube } from "./tube";

const SIDES = 7;
const HOLE_SIDES = 20;
const HOLE_RINGS = 240;
const COLOURS = 256;
const AMOUNTS = Array.from({ length: 10 }, (_, i) => `amount-${i}`);
const SIGNED = ["low-side-strong", "low-side", "middle", "high-side", "high-side-strong"];

/** A table of the colours of a scale, red, green and blue per entry. */
function table(signed: boolean): Float32Array {
  const stops = (signed ? SIGNED : AMOUNTS).map((name) => new Color(colour(name)));
  const made = new Float32Array(3 * COLOURS);
  const mixed = new Color();
  for (let i = 0; i < COLOURS; i++) {
    const place = (i / (COLOURS - 1)) * (stops.length - 1);
    const low = Math.min(Math.floor(place), stops.length - 2);
    mixed.lerpColors(stops[low]!, stops[low + 1]!, place - low).toArray(made, 3 * i);
  }
  return made;
}

/** Quantity of the colours of the string. */
export interface Paint {
  value: ValueAt;
  signed: boolean;
  least: number;
}

export class Space {
  readonly range = new Range(1);
  readonly #renderer: WebGLRenderer;
  readonly #world = new Scene();
  readonly #camera = new PerspectiveCamera(38, 1, 1, 1e5);
  readonly #orbit: OrbitControls;
  readonly #sun = new DirectionalLight(0xffffff, 2.2);
  readonly #course: Course;
  readonly #layout: Layout;
  readonly #string: Mesh<Tube, MeshLambertMaterial>;
  readonly #holder: HTMLElement;
  readonly #watch: ResizeObserver;
  #hole: Mesh[] = [];
  #table = table(false);
  #paint: Paint;
  #range: Range;
  #depths: [number, number];
  #exaggeration = 1;
  #due = true;

  /** Null if the browser has no WebGL. */
  static of(canvas: HTMLCanvasElement, holder: HTMLElement, layout: Layout, paint: Paint): Space | null {
    try {
      const renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
      return new Space(renderer, holder, layout, paint);
    } catch {
      return null;
    }
  }

  private constructor(renderer: WebGLRenderer, holder: HTMLElement, layout: Layout, paint: Paint) {
    this.#renderer = renderer;
    [this.#layout, this.#holder, this.#paint] = [layout, holder, paint];
    this.#course = new Course(layout.path);
    this.#range = new Range(paint.least);
    this.#orbit = new OrbitControls(this.#camera, renderer.domElement);
    this.#orbit.enableDamping = false;
    this.#orbit.enableZoom = false;
    this.#orbit.listenToKeyEvents(renderer.domElement);
    this.#orbit.addEventListener("change", () => (this.#due = true));
    this.#world.add(new AmbientLight(0xffffff, 1.6), this.#sun);
    const tube = new Tube(layout.contact_radius_m.length, SIDES);
    this.#string = new Mesh(tube, new MeshLambertMaterial({ vertexColors: true }));
    this.#string.frustumCulled = false;
    this.#world.add(this.#string);
    this.#depths = [0, this.#course.deepest];
    this.#watch = new ResizeObserver(() => this.#fit());
    this.#watch.observe(holder);
    renderer.domElement.addEventListener("wheel", this.#wheel, { passive: false });
    this.#fit();
    this.show(this.#depths);
  }

  readonly #wheel = (event: WheelEvent) => {
    if (!event.ctrlKey && !event.metaKey) return;
    event.preventDefault();
    this.nearer(Math.exp(event.deltaY * 0.002));
  };

  get exaggeration(): number {
    return this.#exaggeration;
  }

  /** Range of the colours. */
  get painted(): Range {
    return this.#range;
  }

  nearer(factor: number): void {
    const offset = this.#camera.position.clone().sub(this.#orbit.target).multiplyScalar(factor);
    this.#camera.position.copy(this.#orbit.target).add(offset);
    this.#due = true;
  }

  /** Colours the string by another quantity. */
  paint(paint: Paint): void {
    this.#paint = paint;
    this.#range = new Range(paint.least);
    this.#table = table(paint.signed);
    this.#due = true;
  }

  /** Updates the colours from the page. */
  dress(): void {
    this.#table = table(this.#paint.signed);
    this.#build();
  }

  /** Displays a range of depths. */
  show(depths: [number, number]): void {
    this.#depths = depths;
    const widest = Math.max(...this.#layout.hole.map((section) => section.diameter_m), 0.1);
    this.#exaggeration = Math.max((0.025 * (depths[1] - depths[0])) / widest, 1);
    this.#build();
    this.look("side");
  }

  /** Looks across the plane of the well, or down on it. */
  look(from: "side" | "above"): void {
    const [low, high] = this.#depths;
    const places = Array.from({ length: 41 }, (_, i) => {
      const at = this.#course.go(low + ((high - low) * i) / 40);
      return new Vector3(at[0], at[1], at[2]);
    });
    const box = new Box3().setFromPoints(places);
    const middle = box.getCenter(new Vector3());
    const along = places[40]!.clone().sub(places[0]!).setY(0);
    const towards =
      from === "above"
        ? new Vector3(0.001, 1, 0.001)
        : along.length() < 1
          ? new Vector3(0.6, 0.2, 0.8)
          : new Vector3(-along.z, 0.25 * along.length(), along.x);
    towards.normalize();
    const tall = Math.tan((this.#camera.fov * Math.PI) / 360);
    let far = Math.max(box.getSize(new Vector3()).length(), 1);
    for (let round = 0; round < 8; round++) {
      this.#camera.position.copy(middle).addScaledVector(towards, far);
      this.#camera.near = far / 200;
      this.#camera.far = far * 20;
      this.#camera.updateProjectionMatrix();
      this.#camera.lookAt(middle);
      this.#camera.updateMatrixWorld();
      const seen = new Box3().setFromPoints(places.map((place) => place.clone().project(this.#camera)));
      const [x, y] = [(seen.min.x + seen.max.x) / 2, (seen.min.y + seen.max.y) / 2];
      const right = new Vector3().setFromMatrixColumn(this.#camera.matrixWorld, 0);
      const up = new Vector3().setFromMatrixColumn(this.#camera.matrixWorld, 1);
      middle.addScaledVector(right, x * far * tall * this.#camera.aspect).addScaledVector(up, y * far * tall);
      far *= Math.max((seen.max.x - seen.min.x) / 1.76, (seen.max.y - seen.min.y) / 1.8, 0.05);
    }
    this.#orbit.target.copy(middle);
    this.#camera.position.copy(middle).addScaledVector(towards, far);
    this.#orbit.update();
    this.#due = true;
  }

  #fit(): void {
    const { clientWidth, clientHeight } = this.#holder;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.#renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.#renderer.setSize(clientWidth, clientHeight, false);
    this.#camera.aspect = clientWidth / clientHeight;
    this.#camera.updateProjectionMatrix();
    this.#due = true;
  }

  /** Rebuilds the hole. */
  #build(): void {
    for (const mesh of this.#hole) {
      this.#world.remove(mesh);
      mesh.geometry.dispose();
      (mesh.material as MeshLambertMaterial).dispose();
    }
    this.#hole = [];
    const [from, to] = this.#depths;
    for (const section of this.#layout.hole) {
      const [low, high] = [Math.max(section.from_m, from), Math.min(section.to_m, to)];
      if (high <= low) continue;
      const tube = new Tube(HOLE_RINGS, HOLE_SIDES);
      for (let i = 0; i < HOLE_RINGS; i++) {
        const at = this.#course.go(low + ((high - low) * i) / (HOLE_RINGS - 1));
        tube.ring(i, at, 0, 0, (section.diameter_m / 2) * this.#exaggeration);
      }
      const casing = section.kind === "casing";
      const material = new MeshLambertMaterial({
        color: colour(casing ? "casing" : "rock"),
        transparent: true,
        opacity: casing ? 0.16 : 0.26,
        side: DoubleSide,
        depthWrite: false,
      });
      const mesh = new Mesh(tube, material);
      mesh.renderOrder = 2;
      this.#world.add(mesh);
      this.#hole.push(mesh);
    }
    this.#due = true;
  }

  /** Draws a frame, if anything has changed. */
  draw(frame: Frame | null, isNew: boolean): void {
    if (!isNew && !this.#due) return;
    this.#due = false;
    if (frame) this.#place(frame);
    this.#sun.position.copy(this.#camera.position);
    this.#sun.target.position.copy(this.#orbit.target);
    this.#sun.target.updateMatrixWorld();
    this.#renderer.render(this.#world, this.#camera);
  }

  #place(frame: Frame): void {
    const { values, nodes } = frame;
    const [from, to] = this.#depths;
    const [tube, radii, wide] = [this.#string.geometry, this.#layout.contact_radius_m, this.#exaggeration];
    const count = Math.min(nodes, tube.rings);
    let [low, high] = [Infinity, -Infinity];
    for (let node = 0; node < count; node++) {
      const md = values[node]!;
      if (md < from - 1 || md > to + 1) continue;
      const value = this.#paint.value(frame, node);
      if (value < low) low = value;
      if (value > high) high = value;
    }
    if (this.#paint.signed) {
      high = Math.max(Math.abs(low), Math.abs(high));
      low = -high;
    }
    this.#range.hold(low, high);
    const { low: least, high: most } = this.#range;
    const scale = (COLOURS - 1) / (most - least || 1);
    let ring = 0;
    for (let node = 0; node < count; node++) {
      const md = values[node]!;
      if (md < from - 1 || md > to + 1) continue;
      const at = this.#course.go(Math.min(md, this.#course.deepest));
      tube.ring(ring, at, values[nodes + node]! * wide, values[2 * nodes + node]! * wide, radii[node]! * wide);
      const part = (this.#paint.value(frame, node) - least) * scale;
      tube.paint(ring, this.#table, Math.min(Math.max(Math.round(part) || 0, 0), COLOURS - 1));
      ring++;
    }
    tube.changed(ring);
  }

  close(): void {
    this.#watch.disconnect();
    this.#orbit.dispose();
    this.#string.geometry.dispose();
    for (const mesh of this.#hole) mesh.geometry.dispose();
    this.#renderer.domElement.removeEventListener("wheel", this.#wheel);
    this.#renderer.dispose();
  }
}
