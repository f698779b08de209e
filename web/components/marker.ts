// Shapes and strokes that distinguish curves where colours do not.

/** Lengths of dashes and gaps by the index of a curve; null for a solid line. */
const DASHES = [null, [6, 4], [1.5, 3], [13, 4], [3.5, 2.5], [6, 7], [1.5, 6]] as const;

/** Outlines about the origin, by the index of a curve. */
const SHAPES = [
  "M-3.5 0a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0 -7 0z",
  "M-3.2 -3.2h6.4v6.4h-6.4z",
  "M0 -4.2L4 3.2H-4z",
  "M0 -4.6L4.2 0L0 4.6L-4.2 0z",
  "M0 4.2L4 -3.2H-4z",
  "M-4 -1.2h2.8v-2.8h2.4v2.8h2.8v2.4h-2.8v2.8h-2.4v-2.8h-2.8z",
  "M-4 -2.4L-2.4 -4L0 -1.6L2.4 -4L4 -2.4L1.6 0L4 2.4L2.4 4L0 1.6L-2.4 4L-4 2.4L-1.6 0z",
] as const;

/** Lengths of dashes and gaps, pixels; null for a solid line. */
export type Dash = readonly number[] | null;

export const dashOf = (place: number): Dash => DASHES[place % DASHES.length] ?? null;
export const shapeOf = (place: number): string => SHAPES[place % SHAPES.length] ?? SHAPES[0];
