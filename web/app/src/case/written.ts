// From values to what is shown, and from what is typed to values.

import type { Quantities, Value } from "../api/cases";
import type { Scalar } from "./kinds";
import { factorOf, numberText, shownNumber, shownUnit, unitLabel } from "./units.svelte";

/** A number without a unit, as people type it: `12`, `-0.5`, `1e5`. */
const NUMBER = /^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$/;
/** The same with a fraction: `9-5/8`, `5 1/2`. */
const FRACTION = /^\d+([- ]\d+\/\d+|\/\d+)$/;

/** A value as it stands in the file. */
export function asWritten(value: Value | undefined): string {
  if (value === undefined || value === null) return "";
  return typeof value === "object" ? JSON.stringify(value) : String(value);
}

/** What a value is worth in SI; undefined where it is no quantity. */
export function inSi(kind: Scalar, value: Value | undefined, quantities: Quantities): number | undefined {
  if (kind.is !== "quantity") return typeof value === "number" ? value : undefined;
  if (typeof value === "number") return value * (factorOf(kind.dimension, kind.bareUnit) ?? 1);
  return typeof value === "string" ? quantities[kind.dimension]?.[value] : undefined;
}

/** A value as it is shown: a quantity in the chosen unit, without it. */
export function asShown(kind: Scalar, value: Value | undefined, quantities: Quantities): string {
  if (kind.is !== "quantity") return asWritten(value);
  const si = inSi(kind, value, quantities);
  return si === undefined ? asWritten(value) : shownNumber(kind.dimension, si);
}

/** The same with its unit, for fields that have none beside them. */
export function asShownWithUnit(kind: Scalar, value: Value | undefined, quantities: Quantities): string {
  if (kind.is !== "quantity" || inSi(kind, value, quantities) === undefined) return asShown(kind, value, quantities);
  return `${asShown(kind, value, quantities)} ${unitLabel(kind.dimension)}`;
}

/**
 * What is typed, as a value; undefined where it is nothing. A number alone is in the unit that is shown; it stays a
 * number where one stood there (`before`) and the file takes it in that unit. What is no number stays what was typed,
 * for the check to speak of.
 */
export function read(kind: Scalar, typed: string, before: Value | undefined): Value | undefined {
  const text = typed.trim().replace("\u2212", "-");
  if (text === "") return undefined;
  switch (kind.is) {
    case "quantity": {
      const isNumber = NUMBER.test(text);
      if ((!isNumber && !FRACTION.test(text)) || kind.words.includes(text)) return text;
      const unit = shownUnit(kind.dimension);
      if (!unit?.symbol) return text;
      const bare = factorOf(kind.dimension, kind.bareUnit);
      if (isNumber && typeof before === "number" && bare === unit.factor) return Number(text);
      return `${text} ${unit.symbol}`;
    }
    case "number":
    case "either":
      return NUMBER.test(text) ? Number(text) : text;
    case "truth":
      return text === "true" ? true : text === "false" ? false : text;
    case "words":
    case "text":
      return text;
  }
}

/** A number of SI as a case has it where it is put in by us: a bare number where the file takes the shown unit so. */
export function fromSi(kind: Scalar, si: number): Value {
  if (kind.is !== "quantity") return si;
  const unit = shownUnit(kind.dimension);
  const bare = factorOf(kind.dimension, kind.bareUnit) ?? 1;
  if (!unit?.symbol || unit.factor === bare) return Number(numberText(si / bare, 10));
  return `${numberText(si / unit.factor, 10)} ${unit.symbol}`;
}

/** Items of a list as they are typed: separated by commas. */
export const listText = (items: Value[]): string => items.map(asWritten).join(", ");

export function readList(kind: Scalar, typed: string, before: Value[]): Value[] {
  const parts = typed.replace(/^\[|\]$/g, "").split(",");
  return parts.flatMap((part, index) => {
    const value = read(kind, part.replaceAll('"', ""), before[index] ?? before[0]);
    return value === undefined ? [] : [value];
  });
}
