// The page's colours, which the program that made it declares.

/** The value of a custom property of the page. */
export const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();

/** The colour of a curve by its place. */
export const line = (index) => colour(`line-${index % 7}`);

/** Red, green and blue from 0 to 255 of `#rrggbb`. */
export function rgb(hex) {
  const number = parseInt(hex.slice(1), 16);
  return [number >> 16, (number >> 8) & 255, number & 255];
}

/** Names of the colours from little to much, and from the low side over nothing to the high side. */
const AMOUNTS = Array.from({ length: 10 }, (_, i) => `amount-${i}`);
const SIDES = ["low-side-strong", "low-side", "middle", "high-side", "high-side-strong"];

function between(stops, part) {
  const place = part * (stops.length - 1);
  const low = Math.min(Math.floor(place), stops.length - 2);
  const rest = place - low;
  return stops[low].map((value, i) => value + rest * (stops[low + 1][i] - value));
}

/** Steps of a scale of colours. */
const STEPS = 512;

/**
 * A scale of colours: gives red, green and blue for a part from 0 to 1. A signed one goes from the low side over nothing
 * to the high side.
 */
export function colourScale(signed) {
  const stops = (signed ? SIDES : AMOUNTS).map((name) => rgb(colour(name)));
  const table = Array.from({ length: STEPS + 1 }, (_, i) => between(stops, i / STEPS));
  return (part) => table[Math.round(Math.min(Math.max(part, 0), 1) * STEPS)];
}
