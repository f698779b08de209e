// The units of the answers: those that the header says.

import { type Dimensions, UNIT_SETS, useDimensions } from "../../../components/units.ts";
import { readUnits, type Units } from "../api/lookup";
import { settings } from "../settings.svelte";

let units: Units = {};
let asked: Promise<void> | null = null;

/** Fetches the units, once; what shows numbers waits for it. */
export function loadUnits(): Promise<void> {
  asked ??= readUnits().then(
    (found) => {
      units = found;
      const shown = Object.entries(found).map(([name, { shown }]) => {
        const sets = UNIT_SETS.map((set) => ({ symbol: shown[set].label, factor: shown[set].factor }));
        return [name, sets] as const;
      });
      const dimensions: Dimensions = Object.fromEntries(shown);
      useDimensions(dimensions, () => settings.units);
    },
    (problem: unknown) => {
      asked = null;
      throw problem;
    },
  );
  return asked;
}

/** A value of SI as a case has it, in the units that the header says: `58.8 kN`. */
export function written(value: number, dimension: string): string {
  const unit = units[dimension]?.shown[settings.units];
  const digits = (number: number): string => String(Number(number.toPrecision(6)));
  if (!unit?.symbol) return digits(value);
  return `${digits(value / unit.factor)} ${unit.symbol}`;
}
