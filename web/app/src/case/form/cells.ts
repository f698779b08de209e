// Cells of a grid for keys of a case: their texts, and the changes from typed texts.

import type { Change, Quantities, Table, Value } from "../../api/cases";
import type { Schema } from "../../api/lookup";
import type { Column, Typed } from "../grid/model";
import { keysOf, kindOf, titleOf, type Scalar } from "../kinds";
import { unitLabel } from "../units.svelte";
import { asShown, asWritten, read } from "../written";
import { asTable } from "../values";

/** A column of a grid for a key of its tables. */
export interface KeyColumn {
  key: string;
  kind: Scalar;
}

/** Number of columns for keys that are neither required nor present. */
const OFFERED = 5;

/** The kind of a value that fits a cell; for a value that may be a table, that of the value. */
function inCell(schema: Schema): Scalar | null {
  const kind = kindOf(schema);
  if (kind.is === "split") return kind.item;
  return kind.is === "table" || kind.is === "tables" || kind.is === "rows" || kind.is === "list" ? null : kind;
}

/** The columns of a list of tables: required and present keys, and the first of the others. */
export function keyColumns(item: Schema, rows: Value[]): KeyColumn[] {
  const used = new Set(rows.flatMap((row) => Object.keys(asTable(row))));
  const needed = item.required ?? [];
  let offered = 0;
  return keysOf(item).flatMap(([key, schema]) => {
    const kind = inCell(schema);
    if (!kind) return [];
    offered += 1;
    return needed.includes(key) || used.has(key) || offered <= OFFERED ? [{ key, kind }] : [];
  });
}

/** The column in the form of a grid. */
export function gridColumn(title: string, kind: Scalar, description?: string): Column {
  const isText = kind.is === "text" || kind.is === "words" || kind.is === "truth";
  const longest = title.length * 7 + 20;
  return {
    title,
    unit: kind.is === "quantity" ? unitLabel(kind.dimension) : "",
    ...(description === undefined ? {} : { description }),
    width: Math.max(isText ? 130 : kind.is === "quantity" && kind.words.length > 0 ? 96 : 76, longest),
    isNumber: !isText,
    ...(kind.is === "words" || kind.is === "quantity" ? { words: kind.words } : kind.is === "truth" ? { words: ["true", "false"] } : {}),
  };
}

export const tableColumn = ({ key, kind }: KeyColumn, item: Schema): Column =>
  gridColumn(titleOf(key), kind, item.properties?.[key]?.description);

export const shownCell = (kind: Scalar, value: Value | undefined, quantities: Quantities): string =>
  value !== undefined && typeof value === "object" ? "in parts" : asShown(kind, value, quantities);

/** The changes from cells of a list of tables; rows after the last are new. */
export function tableChanges(name: string, columns: KeyColumn[], rows: Value[], cells: Typed[]): Change[] {
  const changes: Change[] = [];
  const added = new Map<number, Table>();
  for (const { row, column, text } of cells) {
    const target = columns[column];
    if (!target) continue;
    const before = asTable(rows[row] ?? rows.at(-1))[target.key];
    const value = read(target.kind, text, before);
    if (row >= rows.length) {
      const table = added.get(row) ?? {};
      added.set(row, value === undefined ? table : { ...table, [target.key]: value });
    } else if (value !== undefined) changes.push({ set: `${name}.${row}.${target.key}`, to: value });
    else if (before !== undefined) changes.push({ remove: `${name}.${row}.${target.key}` });
  }
  let at = rows.length;
  for (const [, value] of [...added].sort(([a], [b]) => a - b))
    if (Object.keys(value).length > 0) changes.push({ insert: name, at: at++, value });
  return changes;
}

/** The changes from cells of a list of rows of values; a new row has at least `least` values. */
export function rowChanges(name: string, kinds: Scalar[], least: number, rows: Value[], cells: Typed[]): Change[] {
  const changed = new Map<number, Value[]>();
  for (const { row, column, text } of cells) {
    const kind = kinds[column];
    if (!kind) continue;
    const before = rows[row];
    const values = changed.get(row) ?? (Array.isArray(before) ? [...before] : Array<Value>(least).fill(0));
    const model = Array.isArray(before) ? before : rows.at(-1);
    const value = read(kind, text, Array.isArray(model) ? model[column] : undefined);
    while (values.length <= column) values.push(0);
    // A row has no gaps, so only optional values at its end are removed.
    if (value !== undefined) values[column] = value;
    else if (column >= least) values.length = column;
    else values[column] = 0;
    changed.set(row, values);
  }
  let at = rows.length;
  return [...changed]
    .sort(([a], [b]) => a - b)
    .map(([row, value]) => (row < rows.length ? { set: `${name}.${row}`, to: value } : { insert: name, at: at++, value }));
}

export const writtenCell = (value: Value | undefined): string => asWritten(value);
