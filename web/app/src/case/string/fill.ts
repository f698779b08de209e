// Keys of a row that an entry of the catalogue replaces.

import type { Change, Table } from "../../api/cases";

/** Keys that an entry defines; with an entry they are a mistake, or have another meaning. */
const GIVEN = {
  catalogue: ["od", "id", "joint_od", "joint_spacing", "mass_per_length", "yield_strength"],
  casing: ["diameter"],
} as const;

/** The changes that set an entry of the catalogue in a row. */
export function filled(row: string, table: Table, key: keyof typeof GIVEN, name: string): Change[] {
  const replaced = GIVEN[key].filter((old) => Object.hasOwn(table, old));
  return [{ set: `${row}.${key}`, to: name }, ...replaced.map((old) => ({ remove: `${row}.${old}` }))];
}
