// A view in space: a scene with light from the reader's side that turns by hand, and a copy of it for paper.

import { AmbientLight, Box3, DirectionalLight, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { el } from "./dom.js";
import { isPrinting } from "./theme.js";

/** Said where the browser gives no WebGL. */
export const noSpace = () => el("p", { class: "warning" }, "This view needs WebGL, which this browser does not give.");

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
    renderer.render(world, camera);
    if (!isPrinting()) return;
    [paper.width, paper.height] = [canvas.width, canvas.height];
    paper.getContext("2d").drawImage(canvas, 0, 0);
  }

  /** Looks at `middle`, that of the places where it is not given, from a direction: as near as they allow, with room for labels. */
  function lookAt(places, direction, middle = new Box3().setFromArray(places.flat()).getCenter(new Vector3())) {
    const wide = (canvas.clientWidth || 1200) / height;
    const towards = new Vector3(...direction).normalize();
    const right = new Vector3(0, 1, 0).cross(towards).normalize();
    const up = towards.clone().cross(right);
    const tall = Math.tan((camera.fov * Math.PI) / 360);
    let far = 0;
    for (const place of places) {
      const at = new Vector3(...place).sub(middle);
      const needs = Math.max(Math.abs(at.dot(right)) / (tall * wide * 0.86), Math.abs(at.dot(up)) / (tall * 0.93));
      far = Math.max(far, needs + at.dot(towards));
    }
    orbit.target.copy(middle);
    camera.position.copy(middle).addScaledVector(towards, far);
    camera.near = far / 200;
    camera.far = far * 20;
    camera.updateProjectionMatrix();
    orbit.update();
    render();
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
