// A view in space: a scene with light from the side of the viewer, rotated by the pointer, and a copy of it for print.

import {
  AmbientLight,
  Box3,
  DirectionalLight,
  LineSegments,
  type Material,
  Mesh,
  type Object3D,
  PerspectiveCamera,
  Scene,
  Sprite,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Vector } from "./bore.ts";
import { el } from "./dom.ts";
import { isPrinting } from "./printing.ts";

/** Message for a browser without WebGL. */
export const noSpace = (): HTMLElement => el("p", { class: "warning" }, "This view requires WebGL, which this browser does not provide.");

/** The centre of the box around some positions. */
const centreOf = (places: readonly Vector[]): Vector3 => new Box3().setFromArray(places.flat()).getCenter(new Vector3());

/** Instructions for moving the view. */
export const LOOK_AROUND = "drag to rotate, right-drag to move, Ctrl + wheel to zoom";

/** Box of a label, pixels. */
interface Room {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

/** A stage and its operations. */
export interface Stage {
  holder: HTMLElement;
  canvas: HTMLCanvasElement;
  /** Extent of these positions, as parts of the stage horizontally and vertically. */
  spans: (places: readonly Vector[]) => [number, number];
  add: <T extends Object3D>(item: T) => T;
  has: (item: Object3D) => boolean;
  /** Removes these from the stage and from memory; all by default. */
  remove: (gone?: readonly Object3D[]) => void;
  render: () => void;
  lookAt: (places: readonly Vector[], direction: Vector, middle?: Vector3, margins?: [number, number]) => void;
  /** Fits the picture to the available space. */
  size: () => void;
  /** Position of the viewer, as a vector from the target. */
  from: () => Vector3;
  /** Releases the graphics context, of which the browser allows few at a time. */
  end: () => void;
}

/** Resources of an item in graphics memory. */
function release(item: Object3D): void {
  if (!(item instanceof Mesh || item instanceof LineSegments || item instanceof Sprite)) return;
  if (!(item instanceof Sprite)) item.geometry.dispose();
  const material: Material = item.material;
  if (item instanceof Sprite) item.material.map?.dispose();
  material.dispose();
}

/**
 * A stage with the available width and a height in pixels; null if the browser has no WebGL. `aside` is the offset of the
 * light above and to the left of the viewer, as a part of the distance, because light from the viewer casts no shadows.
 */
export function stage(label: string, height: number, aside = 0): Stage | null {
  const canvas = el("canvas", { class: "space", style: `height:${height}px`, role: "img", "aria-label": label });
  let renderer: WebGLRenderer;
  try {
    renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
  } catch {
    return null;
  }
  const world = new Scene();
  const camera = new PerspectiveCamera(38, 1, 1, 1e5);
  const orbit = new OrbitControls(camera, canvas);
  orbit.enableDamping = false;
  orbit.enableZoom = false;
  const sun = new DirectionalLight(0xffffff, 2.2);
  world.add(new AmbientLight(0xffffff, 1.6), sun);
  // Browsers print the last picture on the screen, so a separate copy is made for print.
  const paper = el("canvas", { class: "space-paper" });
  const holder = el("div", { class: "space-holder" }, canvas, paper);
  let items: Object3D[] = [];

  canvas.addEventListener(
    "wheel",
    (event) => {
      if (!event.ctrlKey && !event.metaKey) return;
      event.preventDefault();
      const offset = camera.position
        .clone()
        .sub(orbit.target)
        .multiplyScalar(Math.exp(event.deltaY * 0.002));
      camera.position.copy(orbit.target).add(offset);
      render();
    },
    { passive: false },
  );
  orbit.addEventListener("change", render);

  function add<T extends Object3D>(item: T): T {
    items.push(item);
    world.add(item);
    return item;
  }

  function remove(gone: readonly Object3D[] = items): void {
    for (const item of gone) {
      world.remove(item);
      release(item);
    }
    items = items.filter((item) => !gone.includes(item));
  }

  function render(): void {
    const off = aside * camera.position.distanceTo(orbit.target);
    sun.position.copy(camera.position).add(new Vector3(-off, off, 0).applyQuaternion(camera.quaternion));
    sun.target.position.copy(orbit.target);
    sun.target.updateMatrixWorld();
    holder.dataset.labels = JSON.stringify(arrangeLabels());
    renderer.render(world, camera);
    if (!isPrinting()) return;
    [paper.width, paper.height] = [canvas.width, canvas.height];
    paper.getContext("2d")?.drawImage(canvas, 0, 0);
  }

  /**
   * Looks from a direction at positions, as near as possible, so that they fill the stage except for `margins`, pixels to
   * the left and right and above and below. `middle` is the initial target.
   */
  function lookAt(
    places: readonly Vector[],
    direction: Vector,
    middle = centreOf(places),
    margins: [number, number] = [0.07 * (canvas.clientWidth || 1200), 0.04 * height],
  ): void {
    const width = canvas.clientWidth || 1200;
    const towards = new Vector3(...direction).normalize();
    const points = places.map((place) => new Vector3(...place));
    const tall = Math.tan((camera.fov * Math.PI) / 360);
    const wide = Math.max(1 - (2 * margins[0]) / width, 0.3);
    const high = Math.max(1 - (2 * margins[1]) / height, 0.3);
    const target = middle.clone();
    let far = 2 * Math.max(...points.map((point) => point.distanceTo(middle)), 1e-3);
    // Because of perspective the fit is iterative; each iteration is much more accurate than the last.
    for (let round = 0; round < 12; round++) {
      camera.position.copy(target).addScaledVector(towards, far);
      camera.near = far / 1000;
      camera.far = far * 1000;
      camera.updateProjectionMatrix();
      camera.lookAt(target);
      camera.updateMatrixWorld();
      const box = new Box3().setFromPoints(points.map((point) => point.clone().project(camera)));
      const [x, y] = [(box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2];
      const right = new Vector3().setFromMatrixColumn(camera.matrixWorld, 0);
      const up = new Vector3().setFromMatrixColumn(camera.matrixWorld, 1);
      target.addScaledVector(right, x * far * tall * (width / height)).addScaledVector(up, y * far * tall);
      far *= Math.max((box.max.x - box.min.x) / 2 / wide, (box.max.y - box.min.y) / 2 / high) || 1;
    }
    orbit.target.copy(target);
    camera.position.copy(target).addScaledVector(towards, far);
    camera.near = far / 200;
    camera.far = far * 20;
    camera.updateProjectionMatrix();
    orbit.update();
    render();
  }

  /** Scales labels to a readable size; of two overlapping labels the first is kept. */
  function arrangeLabels(): Room[] {
    camera.updateMatrixWorld();
    const [width, tall] = [canvas.clientWidth || 1200, Math.tan((camera.fov * Math.PI) / 360)];
    const taken: Room[] = [];
    for (const label of items) {
      if (!(label instanceof Sprite)) continue;
      const [wide, high] = label.userData.pixels as [number, number];
      const away = -label.position.clone().applyMatrix4(camera.matrixWorldInverse).z;
      const pixel = (2 * tall * away) / height;
      label.scale.set(wide * pixel, high * pixel, 1);
      const at = label.position.clone().project(camera);
      const left = ((at.x + 1) / 2) * width - label.center.x * wide;
      const top = ((1 - at.y) / 2) * height - high / 2;
      const room = { left, top, right: left + wide, bottom: top + high };
      const overlaps = (other: Room): boolean =>
        room.left < other.right + 4 && other.left < room.right + 4 && room.top < other.bottom && other.top < room.bottom;
      label.visible = away > 0 && room.left >= 0 && room.right <= width && !taken.some(overlaps);
      if (label.visible) taken.push(room);
    }
    return taken;
  }

  /** Fits the picture to the available space. */
  function size(): void {
    const width = holder.clientWidth || 1200;
    renderer.setPixelRatio(Math.min(devicePixelRatio * (devicePixelRatio < 1.5 ? 1.5 : 1), 2.5));
    renderer.setSize(width, height, false);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
  }

  let width = 0;
  const sizes = new ResizeObserver(() => {
    if (holder.clientWidth === width) return;
    width = holder.clientWidth;
    size();
    render();
  });
  sizes.observe(holder);
  return {
    holder,
    canvas,
    spans: (places) => {
      const box = new Box3().setFromPoints(places.map((place) => new Vector3(...place).project(camera)));
      return [(box.max.x - box.min.x) / 2, (box.max.y - box.min.y) / 2];
    },
    add,
    has: (item) => items.includes(item),
    remove,
    render,
    lookAt,
    size,
    from: () => camera.position.clone().sub(orbit.target),
    end: () => {
      sizes.disconnect();
      remove();
      orbit.dispose();
      renderer.dispose();
      renderer.forceContextLoss();
    },
  };
}
