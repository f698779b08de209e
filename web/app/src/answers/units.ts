// Units of the results, as chosen in the header.

import { type Dimensions, UNIT_SETS, useDimensions } from "../../../components/units.ts";
import { readUnits, type Units } from "../api/lookup";
import { settings } from "../settings.svelte";

let units: Units = {};
let loading: Promise<void> | null = null;

/** Fetches the units, once; components with numbers wait for it. */
export function loadUnits(): Promise<void> {
  loading ??= readUnits().then(
    (found) => {
      units = found;
      const entries = Object.entries(found).map(([name, { shown }]) => {
        const sets = UNIT_SETS.map((set) => ({ symbol: shown[set].label, factor: shown[set].factor }));
        return [name, sets] as const;
      });
      const dimensions: Dimensions = Object.fromEntries(entries);
      useDimensions(dimensions, () => settings.units);
    },
    (problem: unknown) => {
      loading = null;
      throw problem;
    },
  );
  return loading;
}

/** An SI value in the form of a case, in the units chosen in the header: `58.8 kN`. */
export function written(value: number, dimension: string): string {
  const unit = units[dimension]?.shown[settings.units];
  const digits = (number: number): string => String(Number(number.toPrecision(6)));
  if (!unit?.symbol) return digits(value);
  return `${digits(value / unit.factor)} ${unit.symbol}`;
}
