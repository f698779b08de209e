// Conversion of lengths to a drawing, with one scale in both directions.

export interface Frame {
  x: (length_m: number) => number;
  y: (length_m: number) => number;
  /** Pixels per metre. */
  scale: number;
}

/** The smallest and the largest number. */
export function extent(numbers: number[]): [number, number] {
  let [least, most] = [Infinity, -Infinity];
  for (const number of numbers) {
    if (number < least) least = number;
    if (number > most) most = number;
  }
  return least <= most ? [least, most] : [0, 0];
}

/** Lengths to the right and down, to one scale, centred in a box. */
export function fitted(xs: number[], ys: number[], width: number, height: number, margin: number): Frame {
  const [left, right] = extent(xs);
  const [top, bottom] = extent(ys);
  const room = Math.max(1e-6, Math.min((width - 2 * margin) / Math.max(right - left, 1), (height - 2 * margin) / Math.max(bottom - top, 1)));
  const middle = { x: (left + right) / 2, y: (top + bottom) / 2 };
  return {
    x: (length_m) => width / 2 + (length_m - middle.x) * room,
    y: (length_m) => height / 2 + (length_m - middle.y) * room,
    scale: room,
  };
}

/** A round length, in a unit given in metres, that takes at most a number of pixels. */
export function roundLength(scale: number, most: number, factor: number): number {
  const largest = most / scale / factor;
  const power = 10 ** Math.floor(Math.log10(largest));
  const step = [5, 2, 1].find((one) => one * power <= largest) ?? 1;
  return step * power * factor;
}
