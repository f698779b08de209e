// Numbers in the units of the reader.

/** The sets of units that a reader chooses among. */
export const UNIT_SETS = ["si", "metric", "field"] as const;
export type UnitSet = (typeof UNIT_SETS)[number];

/** Display unit of a dimension in a set of units: a number times `factor` is SI. */
export interface DisplayUnit {
  symbol: string;
  factor: number;
}

/** A unit for each dimension by its name, in the order of the sets. */
export type Dimensions = Readonly<Record<string, readonly DisplayUnit[]>>;

let dimensions: Dimensions = {};
let chosen: () => UnitSet = () => "si";

/** Sets the units of a page, and the function that returns the set chosen by the reader. */
export function useDimensions(table: Dimensions, set: () => UnitSet): void {
  dimensions = table;
  chosen = set;
}

/** The one of the reader's units among those that are given for each set. */
export const ofReader = <T>(sets: readonly T[]): T | undefined => sets[UNIT_SETS.indexOf(chosen())];

function unit(dimension: string): DisplayUnit {
  return dimensions[dimension]?.[UNIT_SETS.indexOf(chosen())] ?? { symbol: "", factor: 1 };
}

export const symbol = (dimension: string): string => unit(dimension).symbol;
export const shown = (si: number, dimension: string): number => si / unit(dimension).factor;
export const si = (value: number, dimension: string): number => value * unit(dimension).factor;

/** Values of a column in the units of the reader; missing ones are null, as plots require. */
export function shownAll(values: ArrayLike<number | null>, dimension: string): (number | null)[] {
  const factor = unit(dimension).factor;
  return Array.from(values, (value) => (value !== null && Number.isFinite(value) ? value / factor : null));
}

/**
 * A number with a count of significant digits and grouped thousands, without an exponent if that is more readable:
 * 27 953 ft·lbf in four digits is 27,950.
 */
export function digits(value: number, significant = 4): string {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e9 || size < 1e-4) {
    const [mantissa, exponent] = value.toExponential(significant - 1).split("e");
    return `${minus(String(Number(mantissa)))}·10${raised(Number(exponent))}`;
  }
  const whole = Math.floor(Math.log10(size)) + 1;
  const decimals = Math.min(Math.max(significant - whole, 0), 6);
  if (whole <= significant) return grouped(value.toFixed(decimals));
  const unsaid = 10 ** (whole - significant);
  return grouped(String(Math.round(value / unsaid) * unsaid));
}

function raised(number: number): string {
  const marks = "⁰¹²³⁴⁵⁶⁷⁸⁹";
  return [...String(number)].map((mark) => (mark === "-" ? "⁻" : marks[Number(mark)])).join("");
}

const minus = (text: string): string => text.replace("-", "\u2212");

/**
 * Grouped thousands by the convention of the units, and a true minus sign: a thin space from five digits on, in field
 * units a comma.
 */
export function grouped(text: string): string {
  const [whole = "", part] = text.split(".");
  const [least, mark] = chosen() === "field" ? [4, ","] : [5, "\u202f"];
  const apart = whole.replace("-", "").length >= least ? whole.replace(/\B(?=(\d{3})+$)/g, mark) : whole;
  return minus(part === undefined ? apart : `${apart}.${part}`);
}

/** A number in no more digits than it has. */
export function plain(value: number, significant = 6): string {
  const text = digits(value, significant);
  return /\.\d*0$/.test(text) ? text.replace(/\.?0+$/, "") : text;
}

/** A depth in whole units of length. */
export const depthText = (md: number): string =>
  `${grouped(String(Math.round(shown(md, "length"))))}\u00a0${symbol("length")}`;

/** A quantity with its unit. */
export function quantity(value: number, dimension: string, significant = 4, write = digits): string {
  const sign = symbol(dimension);
  const text = write(shown(value, dimension), significant);
  return sign === "" ? text : `${text}\u00a0${sign}`;
}
