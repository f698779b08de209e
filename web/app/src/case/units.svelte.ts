// Numbers in the units that the header says.

import { readUnits, type ShownUnit, type Units } from "../api/lookup";
import { settings } from "../settings.svelte";

let units = $state.raw<Units>({});

/** Fetches the units; what shows numbers waits for it. */
export async function loadUnits(): Promise<void> {
  units = await readUnits();
}

/** The unit in which a dimension is shown now. */
export const shownUnit = (dimension: string): ShownUnit | undefined => units[dimension]?.shown[settings.units];

/** How much of SI a unit is. */
export const factorOf = (dimension: string, unit: string): number | undefined => units[dimension]?.factors[unit];

/** The unit of a dimension as headings and labels have it. */
export const unitLabel = (dimension: string): string => shownUnit(dimension)?.label ?? "";

/** A number with so many significant digits, without noughts at its end. */
export function numberText(number: number, digits = 7): string {
  if (!Number.isFinite(number)) return "";
  return String(Number(number.toPrecision(digits)));
}

/** A number of SI in the unit that is shown, without it. */
export function shownNumber(dimension: string, si: number, digits = 7): string {
  return numberText(si / (shownUnit(dimension)?.factor ?? 1), digits);
}

/** The same with its unit. */
export function shownText(dimension: string, si: number, digits = 4): string {
  return `${shownNumber(dimension, si, digits)} ${unitLabel(dimension)}`.trim();
}
