// Numbers in the reader's units.

import { remember, remembered } from "./memory.js";
import { on, state } from "./state.js";

const SETS = ["si", "metric", "field"];
let dimensions = {};

/** Takes the units of a page: those that the reader chose last, or else its own. */
export function useDimensions(table, own) {
  dimensions = table;
  state.units = remembered("units", SETS) ?? own;
  on("units", () => remember("units", state.units));
}

function unit(dimension) {
  return dimensions[dimension]?.[SETS.indexOf(state.units)] ?? { symbol: "", factor: 1 };
}

export const symbol = (dimension) => unit(dimension).symbol;
export const shown = (si, dimension) => si / unit(dimension).factor;
export const si = (value, dimension) => value * unit(dimension).factor;

/** Values of a column in the reader's units; what is missing becomes null where plots want it so. */
export function shownAll(values, dimension) {
  const factor = unit(dimension).factor;
  return Array.from(values, (value) => (Number.isFinite(value) ? value / factor : null));
}

/**
 * A number in so many significant digits, its thousands apart, without exponents where that reads better: 27 953 ft·lbf in
 * four digits is 27,950.
 */
export function digits(value, significant = 4) {
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

function raised(number) {
  const marks = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" };
  return [...String(number)].map((mark) => marks[mark]).join("");
}

const minus = (text) => text.replace("-", "\u2212");

/**
 * Thousands apart as the reader's units have it, and a true minus: by a thin space from five digits on, in field units by a
 * comma.
 */
export function grouped(text) {
  const [whole, part] = text.split(".");
  const [least, mark] = state.units === "field" ? [4, ","] : [5, "\u202f"];
  const apart = whole.replace("-", "").length >= least ? whole.replace(/\B(?=(\d{3})+$)/g, mark) : whole;
  return minus(part === undefined ? apart : `${apart}.${part}`);
}

/** A number in no more digits than it has. */
export function plain(value, significant = 6) {
  const text = digits(value, significant);
  return /\.\d*0$/.test(text) ? text.replace(/\.?0+$/, "") : text;
}

/** A depth in whole units of length. */
export const depthText = (md) => `${grouped(String(Math.round(shown(md, "length"))))}\u00a0${symbol("length")}`;

/** A quantity with its unit. */
export function quantity(value, dimension, significant = 4, write = digits) {
  const sign = symbol(dimension);
  const text = write(shown(value, dimension), significant);
  return sign === "" ? text : `${text}\u00a0${sign}`;
}
