// Zooming, moving and pointing along depth with mouse, pen and finger.

import { choose } from "./state.js";

/** A pointer that has moved by less has only clicked, pixels. */
const STILL = 4;

/**
 * Listens to the pointer over `cover`, which lies over `height` of the `total` units of a picture from `head` down.
 * `view` gives the depths in view, `zoom` changes them within `full`, and `band` shows what is being chosen.
 */
export function listenToDepths({ cover, band, picture, head, height, total, full, view, zoom }) {
  const place = (depth) => {
    const [from, to] = view();
    return head + ((depth - from) / (to - from)) * height;
  };
  const depthAt = (event) => {
    const box = picture.getBoundingClientRect();
    const [from, to] = view();
    const at = ((event.clientY - box.top) / box.height) * total;
    return from + ((at - head) / height) * (to - from);
  };
  let begun = null;

  /** Moves the view until the pointer is let go; the picture under it is drawn anew meanwhile. */
  function drag(begin) {
    const [from, to] = view();
    const perPixel = ((total / picture.getBoundingClientRect().height) * (to - from)) / height;
    const move = (event) => {
      const by = (begin.clientY - event.clientY) * perPixel;
      const kept = Math.min(Math.max(by, full[0] - from), full[1] - to);
      zoom([from + kept, to + kept]);
    };
    addEventListener("pointermove", move);
    addEventListener("pointerup", () => removeEventListener("pointermove", move), { once: true });
  }

  cover.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    if (event.shiftKey) return drag(event);
    begun = { depth: depthAt(event), y: event.clientY };
    cover.setPointerCapture(event.pointerId);
  });
  cover.addEventListener("pointermove", (event) => {
    const depth = depthAt(event);
    if (begun && Math.abs(event.clientY - begun.y) > STILL) {
      const ends = [place(begun.depth), place(depth)].sort((a, b) => a - b);
      band.setAttribute("y", ends[0]);
      band.setAttribute("height", ends[1] - ends[0]);
      band.setAttribute("visibility", "visible");
    }
    choose({ pointer: depth });
  });
  cover.addEventListener("pointerup", (event) => {
    if (!begun) return;
    const { depth, y } = begun;
    begun = null;
    band.setAttribute("visibility", "hidden");
    if (Math.abs(event.clientY - y) > STILL) zoom([depth, depthAt(event)]);
    else choose({ depth: Math.min(Math.max(depth, full[0]), full[1]) });
  });
  cover.addEventListener("pointerleave", () => choose({ pointer: null }));
  cover.addEventListener("dblclick", () => zoom(full));
  cover.addEventListener(
    "wheel",
    (event) => {
      if (!event.ctrlKey && !event.metaKey) return;
      event.preventDefault();
      const depth = depthAt(event);
      const by = Math.exp(event.deltaY * 0.002);
      zoom(view().map((end) => depth + (end - depth) * by));
    },
    { passive: false },
  );
}
