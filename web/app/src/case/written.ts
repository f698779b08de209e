// Conversion of values to displayed texts, and of typed texts to values.

import type { Quantities, Value } from "../api/cases";
import type { Scalar } from "./kinds";
import { factorOf, numberText, shownNumber, shownUnit, unitLabel } from "./units.svelte";

/** A typed number without a unit: `12`, `-0.5`, `1e5`. */
const NUMBER = /^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$/;
/** A typed number with a fraction: `9-5/8`, `5 1/2`. */
const FRACTION = /^\d+([- ]\d+\/\d+|\/\d+)$/;

/** A value in the form of the file. */
export function asWritten(value: Value | undefined): string {
  if (value === undefined || value === null) return "";
  return typeof value === "object" ? JSON.stringify(value) : String(value);
}

/** SI value of a quantity; undefined if the value is none. */
export function inSi(kind: Scalar, value: Value | undefined, quantities: Quantities): number | undefined {
  if (kind.is !== "quantity") return typeof value === "number" ? value : undefined;
  if (typeof value === "number") return value * (factorOf(kind.dimension, kind.bareUnit) ?? 1);
  return typeof value === "string" ? quantities[kind.dimension]?.[value] : undefined;
}

/** A value for display: a quantity in the chosen unit, without the symbol. */
export function asShown(kind: Scalar, value: Value | undefined, quantities: Quantities): string {
  if (kind.is !== "quantity") return asWritten(value);
  const si = inSi(kind, value, quantities);
  return si === undefined ? asWritten(value) : shownNumber(kind.dimension, si);
}

/** A value for display with its unit, for fields without a unit label. */
export function asShownWithUnit(kind: Scalar, value: Value | undefined, quantities: Quantities): string {
  if (kind.is !== "quantity" || inSi(kind, value, quantities) === undefined) return asShown(kind, value, quantities);
  return `${asShown(kind, value, quantities)} ${unitLabel(kind.dimension)}`;
}

/**
 * The value of a typed text; undefined if it is empty. A bare number is in the display unit; it remains a number if
 * the previous value (`before`) was one and the file takes it in that unit. Any other text is kept as typed, so that
 * the check reports it.
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

/** An SI number in the form of a case: a bare number if the file takes the display unit for it. */
export function fromSi(kind: Scalar, si: number): Value {
  if (kind.is !== "quantity") return si;
  const unit = shownUnit(kind.dimension);
  const bare = factorOf(kind.dimension, kind.bareUnit) ?? 1;
  if (!unit?.symbol || unit.factor === bare) return Number(numberText(si / bare, 10));
  return `${numberText(si / unit.factor, 10)} ${unit.symbol}`;
}

/** Items of a typed list, separated by commas. */
export const listText = (items: Value[]): string => items.map(asWritten).join(", ");

export function readList(kind: Scalar, typed: string, before: Value[]): Value[] {
  const parts = typed.replace(/^\[|\]$/g, "").split(",");
  return parts.flatMap((part, index) => {
    const value = read(kind, part.replaceAll('"', ""), before[index] ?? before[0]);
    return value === undefined ? [] : [value];
  });
}
