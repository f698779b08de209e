// Colours of the page, declared by the program that made it.

/** The value of a custom property of the page. */
export const colour = (name: string): string =>
  getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();

/** The colour of a curve by its index. */
export const line = (index: number): string => colour(`line-${index % 7}`);

/** Red, green and blue, from 0 to 255. */
export type Rgb = [number, number, number];

/** Red, green and blue of `#rrggbb`. */
export function rgb(hex: string): Rgb {
  const number = parseInt(hex.slice(1), 16);
  return [number >> 16, (number >> 8) & 255, number & 255];
}

/** Names of the colours from low to high values, and from the low side over zero to the high side. */
const AMOUNTS = Array.from({ length: 10 }, (_, i) => `amount-${i}`);
const SIDES = ["low-side-strong", "low-side", "middle", "high-side", "high-side-strong"];

function between(stops: readonly Rgb[], part: number): Rgb {
  const place = part * (stops.length - 1);
  const low = Math.min(Math.floor(place), stops.length - 2);
  const rest = place - low;
  const [from, to] = [stops[low] as Rgb, stops[low + 1] as Rgb];
  const mix = (i: 0 | 1 | 2): number => from[i] + rest * (to[i] - from[i]);
  return [mix(0), mix(1), mix(2)];
}

/** Steps of a scale of colours. */
const STEPS = 512;

/** Returns a colour for a part from 0 to 1. */
export type ColourScale = (part: number) => Rgb;

/** A scale of colours. A signed one ranges from the low side over zero to the high side. */
export function colourScale(signed: boolean): ColourScale {
  const stops = (signed ? SIDES : AMOUNTS).map((name) => rgb(colour(name)));
  const table = Array.from({ length: STEPS + 1 }, (_, i) => between(stops, i / STEPS));
  return (part) => table[Math.round(Math.min(Math.max(part, 0), 1) * STEPS)] as Rgb;
}
