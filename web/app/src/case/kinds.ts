// Kinds of values of keys, from the schema: their display and the conversion of typed texts.

import type { Schema } from "../api/lookup";

/** One value. */
export type Scalar =
  | { is: "quantity"; dimension: string; bareUnit: string; words: string[]; example: string }
  | { is: "number" }
  | { is: "words"; words: string[]; free: boolean }
  | { is: "truth" }
  | { is: "text" }
  /** A number or a text. */
  | { is: "either" };

export type Kind =
  | Scalar
  | { is: "table"; schema: Schema }
  | { is: "tables"; item: Schema }
  /** Rows of values. */
  | { is: "rows"; cells: Scalar[]; least: number }
  /** One or several. */
  | { is: "list"; item: Scalar; bare: boolean }
  /** A value, or a table with more detail. */
  | { is: "split"; item: Scalar; schema: Schema };

const isTable = (schema: Schema) => schema.properties !== undefined;

/** The kind of a value in a cell or a single field; null if it does not fit. */
function scalar(schema: Schema): Scalar | null {
  const either = schema.anyOf ?? [];
  const dimension = schema["x-dimension"];
  if (dimension !== undefined) {
    const words = either.flatMap((one) => (typeof one.const === "string" ? [one.const] : []));
    const bareUnit = either.find((one) => one["x-unit"] !== undefined)?.["x-unit"] ?? "";
    const example = either.flatMap((one) => one.examples ?? [])[0] ?? "";
    return { is: "quantity", dimension, bareUnit, words, example };
  }
  if (schema.enum) return { is: "words", words: schema.enum, free: false };
  if (Array.isArray(schema.type)) return { is: "either" };
  if (schema.type === "number" || schema.type === "integer") return { is: "number" };
  if (schema.type === "boolean") return { is: "truth" };
  if (schema.type === "string") return { is: "text" };
  // Words with other spellings: the first are offered, any is accepted.
  const [first] = either;
  if (first?.enum && either.every((one) => one.type === "string")) return { is: "words", words: first.enum, free: true };
  return null;
}

/** The kind of the value of a key. */
export function kindOf(schema: Schema): Kind {
  const single = scalar(schema);
  if (single) return single;
  if (isTable(schema)) return { is: "table", schema };
  if (schema.type === "array" && schema.items) return ofList(schema.items, false);
  const either = schema.anyOf ?? [];
  const table = either.find(isTable);
  const one = either.map(scalar).find((found) => found !== null);
  if (table && one) return { is: "split", item: one, schema: table };
  const list = either.find(({ type }) => type === "array")?.items;
  if (list) return ofList(list, one !== undefined);
  return { is: "either" };
}

/** A list of such items; `bare` if one may be written without brackets. */
function ofList(items: Schema, bare: boolean): Kind {
  if (isTable(items)) return { is: "tables", item: items };
  if (items.prefixItems) {
    const cells = items.prefixItems.map((cell) => scalar(cell) ?? ({ is: "either" } as const));
    return { is: "rows", cells, least: items.minItems ?? cells.length };
  }
  return { is: "list", item: scalar(items) ?? { is: "either" }, bare };
}

/** The keys of a table in the order of their declaration. */
export function keysOf(schema: Schema): [string, Schema][] {
  const properties = schema.properties ?? {};
  const order = schema["x-order"] ?? Object.keys(properties);
  return order.flatMap((key) => (properties[key] ? [[key, properties[key]] as [string, Schema]] : []));
}

/** Abbreviations in capitals. */
const CAPITALS = new Set(["od", "id", "wob", "rop", "rpm", "tvd"]);

/** A key such as `bit_depth` in readable form. */
export function titleOf(key: string): string {
  const words = key.split("_").map((word) => (CAPITALS.has(word) ? word.toUpperCase() : word)).join(" ");
  return words.charAt(0).toUpperCase() + words.slice(1);
}
