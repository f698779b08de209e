// Numbers of a live string in the units of the reader.

import type { Layout, ShownUnit } from "../api/live";
import { UNIT_SETS, type UnitSet } from "../settings.svelte";

const BARE: ShownUnit = { symbol: "", factor: 1 };

/** The unit of a dimension in a set of units. */
export const unitOf = (layout: Layout, dimension: string, set: UnitSet): ShownUnit =>
  layout.units[dimension]?.[UNIT_SETS.indexOf(set)] ?? BARE;

/** A number for display: decimals by its size, and a true minus sign. */
export function numberText(value: number, digits = 4): string {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  const whole = size < 1 ? 1 : Math.floor(Math.log10(size)) + 1;
  return value.toFixed(Math.max(digits - whole, 0)).replace("-", "\u2212");
}

/** The smallest of 1, 2 or 5 times a power of ten that is not below a number. */
export function niceAbove(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  for (const times of [1, 2, 5]) if (times * power >= value * 0.999999) return times * power;
  return 10 * power;
}

/** `1:05`, or `1:02:05` from one hour on. */
export function clockText(seconds: number): string {
  const all = Math.floor(Math.max(seconds, 0));
  const two = (number: number) => String(number).padStart(2, "0");
  const [hours, minutes] = [Math.floor(all / 3600), Math.floor(all / 60) % 60];
  return hours > 0 ? `${hours}:${two(minutes)}:${two(all % 60)}` : `${minutes}:${two(all % 60)}`;
}
