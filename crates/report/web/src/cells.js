// The cells of a bottom by rings and sectors, and their colours.

import { colourScale } from "../../../../web/components/palette.ts";

/** From the shallow to the deep: what is deep is dark. */
export const depthScale = () => {
  const scale = colourScale(false);
  return (part) => scale(1 - part);
};

/** Radii of the edges of the rings, m: of the first one's inside and the last one's outside. */
export function edgesOf({ radius_m }) {
  const [first, last] = [radius_m[0], radius_m.at(-1)];
  const half = radius_m.length > 1 ? (last - first) / (radius_m.length - 1) / 2 : first;
  return [Math.max(first - half, 0), last + half];
}

/** The largest depth that is known, m. */
export const deepestOf = ({ depth_m }) => depth_m.reduce((most, depth) => (depth > most ? depth : most), 0);

/** Depth of the cell at a place, m; not a number outside the rings. */
export function depthAt(bottom, high, right) {
  const [inner, outer] = edgesOf(bottom);
  const rings = bottom.radius_m.length;
  const sectors = bottom.angle_rad.length;
  const ring = Math.floor(((Math.hypot(high, right) - inner) / (outer - inner)) * rings);
  if (ring < 0 || ring >= rings) return NaN;
  const turn = Math.atan2(right, high) / (2 * Math.PI);
  const sector = Math.min(Math.floor((turn - Math.floor(turn)) * sectors), sectors - 1);
  return bottom.depth_m[ring * sectors + sector];
}
