// Zooming, moving and pointing along depth with mouse, pen and finger.

import type { Interval } from "./ticks.ts";

/** Movement of a pointer below which it is a click, pixels. */
const STILL = 4;

/** Position of the depth axis in a picture, and callbacks. */
export interface DepthPicture {
  /** Covers `height` of the `total` units of `picture` from `head` down. */
  cover: SVGElement;
  /** Marks the interval being selected. */
  band: SVGElement;
  picture: SVGElement;
  head: number;
  height: number;
  total: number;
  /** All depths, and those in view. */
  full: Interval;
  view: () => Interval;
  /** Changes the interval in view, within the full one. */
  zoom: (view: Interval) => void;
  /** Called with the depth at the pointer; null when the pointer leaves. */
  point: (depth: number | null) => void;
  /** Called with a selected depth. */
  choose: (depth: number) => void;
}

/** Listens to the pointer. */
export function listenToDepths(options: DepthPicture): void {
  const { cover, band, picture, head, height, total, full, view, zoom, point, choose } = options;
  const place = (depth: number): number => {
    const [from, to] = view();
    return head + ((depth - from) / (to - from)) * height;
  };
  const depthAt = (event: MouseEvent): number => {
    const box = picture.getBoundingClientRect();
    const [from, to] = view();
    const at = ((event.clientY - box.top) / box.height) * total;
    return from + ((at - head) / height) * (to - from);
  };
  let begun: { depth: number; y: number } | null = null;

  /** Moves the view until the pointer is released; the picture is redrawn meanwhile. */
  function drag(begin: PointerEvent): void {
    const [from, to] = view();
    const perPixel = ((total / picture.getBoundingClientRect().height) * (to - from)) / height;
    const move = (event: PointerEvent): void => {
      const by = (begin.clientY - event.clientY) * perPixel;
      const shift = Math.min(Math.max(by, full[0] - from), full[1] - to);
      zoom([from + shift, to + shift]);
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
      const ends = [place(begun.depth), place(depth)];
      band.setAttribute("y", String(Math.min(...ends)));
      band.setAttribute("height", String(Math.max(...ends) - Math.min(...ends)));
      band.setAttribute("visibility", "visible");
    }
    point(depth);
  });
  cover.addEventListener("pointerup", (event) => {
    if (!begun) return;
    const { depth, y } = begun;
    begun = null;
    band.setAttribute("visibility", "hidden");
    if (Math.abs(event.clientY - y) > STILL) zoom([depth, depthAt(event)]);
    else choose(Math.min(Math.max(depth, full[0]), full[1]));
  });
  cover.addEventListener("pointerleave", () => point(null));
  cover.addEventListener("dblclick", () => zoom(full));
  cover.addEventListener(
    "wheel",
    (event) => {
      if (!event.ctrlKey && !event.metaKey) return;
      event.preventDefault();
      const depth = depthAt(event);
      const by = Math.exp(event.deltaY * 0.002);
      const [from, to] = view();
      zoom([depth + (from - depth) * by, depth + (to - depth) * by]);
    },
    { passive: false },
  );
}
