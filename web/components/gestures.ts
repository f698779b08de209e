// Zooming, moving and pointing along depth with mouse, pen and finger.

import type { Interval } from "./ticks.ts";

/** A pointer that has moved by less has only clicked, pixels. */
const STILL = 4;

/** Where depth is in a picture, and what becomes of it. */
export interface DepthPicture {
  /** Lies over `height` of the `total` units of `picture` from `head` down. */
  cover: SVGElement;
  /** Shows what is being chosen. */
  band: SVGElement;
  picture: SVGElement;
  head: number;
  height: number;
  total: number;
  /** All depths, and those in view. */
  full: Interval;
  view: () => Interval;
  /** Changes what is in view, within all of it. */
  zoom: (view: Interval) => void;
  /** A depth is pointed at; null: none any more. */
  point: (depth: number | null) => void;
  /** A depth is chosen. */
  choose: (depth: number) => void;
}

/** Listens to the pointer. */
export function listenToDepths(of: DepthPicture): void {
  const { cover, band, picture, head, height, total, full, view, zoom, point, choose } = of;
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

  /** Moves the view until the pointer is let go; the picture under it is drawn anew meanwhile. */
  function drag(begin: PointerEvent): void {
    const [from, to] = view();
    const perPixel = ((total / picture.getBoundingClientRect().height) * (to - from)) / height;
    const move = (event: PointerEvent): void => {
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
