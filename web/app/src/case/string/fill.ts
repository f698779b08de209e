// What of a row an entry of the catalogue takes the place of.

import type { Change, Table } from "../../api/cases";

/** Keys that an entry gives; beside it they are a mistake, or say something else of it. */
const GIVEN = {
  catalogue: ["od", "id", "joint_od", "joint_spacing", "mass_per_length", "yield_strength"],
  casing: ["diameter"],
} as const;

/** The changes that make a row one of the catalogue. */
export function filled(row: string, table: Table, key: keyof typeof GIVEN, name: string): Change[] {
  const replaced = GIVEN[key].filter((given) => Object.hasOwn(table, given));
  return [{ set: `${row}.${key}`, to: name }, ...replaced.map((given) => ({ remove: `${row}.${given}` }))];
}
