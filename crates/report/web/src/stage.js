// A view in space: a scene with light from the reader's side that turns by hand, and a copy of it for paper.

import { AmbientLight, Box3, DirectionalLight, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { el } from "./dom.js";
import { isPrinting } from "./theme.js";

/** Said where the browser gives no WebGL. */
export const noSpace = () => el("p", { class: "warning" }, "This view needs WebGL, which this browser does not give.");

/** The middle of the box around some places. */
const centreOf = (places) => new Box3().setFromArray(places.flat()).getCenter(new Vector3());

/** What one does to look around. */
export const LOOK_AROUND = "drag to turn, right-drag to move, Ctrl + wheel to go nearer";

/**
 * A stage as wide as it is let be and so high in pixels; null where the browser has none. `aside` is how far the light comes
 * from above and from the left of the reader, in parts of the distance: what is rough throws no shade in light from the eye.
 */
export function stage(what, height, aside = 0) {
  const canvas = el("canvas", { class: "space", style: `height:${height}px`, role: "img", "aria-label": what });
  let renderer;
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
  // Browsers print the picture that was last on the screen: paper gets a copy of the one that is meant for it.
  const paper = el("canvas", { class: "space-paper" });
  const holder = el("div", { class: "space-holder" }, canvas, paper);
  let items = [];

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

  function add(item) {
    items.push(item);
    world.add(item);
    return item;
  }

  /** Takes these off the stage and out of memory; all where none is named. */
  function remove(gone = items) {
    for (const item of gone) {
      world.remove(item);
      item.geometry?.dispose();
      item.material.map?.dispose();
      item.material.dispose();
    }
    items = items.filter((item) => !gone.includes(item));
  }

  function render() {
    const off = aside * camera.position.distanceTo(orbit.target);
    sun.position.copy(camera.position).add(new Vector3(-off, off, 0).applyQuaternion(camera.quaternion));
    sun.target.position.copy(orbit.target);
    sun.target.updateMatrixWorld();
    holder.dataset.labels = JSON.stringify(arrangeLabels());
    renderer.render(world, camera);
    if (!isPrinting()) return;
    [paper.width, paper.height] = [canvas.width, canvas.height];
    paper.getContext("2d").drawImage(canvas, 0, 0);
  }

  /**
   * Looks from a direction at places: as near as they allow, so that they fill the stage but for `margins`, pixels to the left
   * and right and above and below. `middle` is where to look first.
   */
  function lookAt(places, direction, middle = centreOf(places), margins = [0.07 * (canvas.clientWidth || 1200), 0.04 * height]) {
    const width = canvas.clientWidth || 1200;
    const towards = new Vector3(...direction).normalize();
    const points = places.map((place) => new Vector3(...place));
    const tall = Math.tan((camera.fov * Math.PI) / 360);
    const room = [1 - (2 * margins[0]) / width, 1 - (2 * margins[1]) / height].map((part) => Math.max(part, 0.3));
    const target = middle.clone();
    let far = 2 * Math.max(...points.map((point) => point.distanceTo(middle)), 1e-3);
    // Perspective bends the fit a little: each round is nearer by far than the last.
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
      far *= Math.max((box.max.x - box.min.x) / 2 / room[0], (box.max.y - box.min.y) / 2 / room[1]) || 1;
    }
    orbit.target.copy(target);
    camera.position.copy(target).addScaledVector(towards, far);
    camera.near = far / 200;
    camera.far = far * 20;
    camera.updateProjectionMatrix();
    orbit.update();
    render();
  }

  /** Labels are as large as letters are to be read, and of two that would lie on each other the first stays. */
  function arrangeLabels() {
    camera.updateMatrixWorld();
    const [width, tall] = [canvas.clientWidth || 1200, Math.tan((camera.fov * Math.PI) / 360)];
    const taken = [];
    for (const label of items.filter((item) => item.userData.pixels)) {
      const [wide, high] = label.userData.pixels;
      const away = -label.position.clone().applyMatrix4(camera.matrixWorldInverse).z;
      const pixel = (2 * tall * away) / height;
      label.scale.set(wide * pixel, high * pixel, 1);
      const at = label.position.clone().project(camera);
      const left = ((at.x + 1) / 2) * width - label.center.x * wide;
      const top = ((1 - at.y) / 2) * height - high / 2;
      const room = { left, top, right: left + wide, bottom: top + high };
      const overlaps = (other) =>
        room.left < other.right + 4 && other.left < room.right + 4 && room.top < other.bottom && other.top < room.bottom;
      label.visible = away > 0 && room.left >= 0 && room.right <= width && !taken.some(overlaps);
      if (label.visible) taken.push(room);
    }
    return taken;
  }

  /** Fits the picture to the room that there is. */
  function size() {
    const width = holder.clientWidth || 1200;
    renderer.setPixelRatio(Math.min(devicePixelRatio * (devicePixelRatio < 1.5 ? 1.5 : 1), 2.5));
    renderer.setSize(width, height, false);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
  }

  let width = 0;
  new ResizeObserver(() => {
    if (holder.clientWidth === width) return;
    width = holder.clientWidth;
    size();
    render();
  }).observe(holder);
  return {
    holder,
    canvas,
    /** What these places span, in parts of the stage across and up. */
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
    /** From where the reader looks, as a vector from what is looked at. */
    from: () => camera.position.clone().sub(orbit.target),
  };
}
