// Numbers in the units chosen in the header.

import { readUnits, type ShownUnit, type Units } from "../api/lookup";
import { settings } from "../settings.svelte";

let units = $state.raw<Units>({});

/** Fetches the units; components with numbers wait for it. */
export async function loadUnits(): Promise<void> {
  units = await readUnits();
}

/** The current display unit of a dimension. */
export const shownUnit = (dimension: string): ShownUnit | undefined => units[dimension]?.shown[settings.units];

/** SI factor of a unit. */
export const factorOf = (dimension: string, unit: string): number | undefined => units[dimension]?.factors[unit];

/** The unit of a dimension for headings and labels. */
export const unitLabel = (dimension: string): string => shownUnit(dimension)?.label ?? "";

/** A number with a count of significant digits, without trailing zeros. */
export function numberText(number: number, digits = 7): string {
  if (!Number.isFinite(number)) return "";
  return String(Number(number.toPrecision(digits)));
}

/** An SI number in the display unit, without the symbol. */
export function shownNumber(dimension: string, si: number, digits = 7): string {
  return numberText(si / (shownUnit(dimension)?.factor ?? 1), digits);
}

/** An SI number in the display unit, with the symbol. */
export function shownText(dimension: string, si: number, digits = 4): string {
  return `${shownNumber(dimension, si, digits)} ${unitLabel(dimension)}`.trim();
}
