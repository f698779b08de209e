// Tables of numbers in the reader's units.

import { el } from "./dom.js";
import { on } from "./state.js";
import { digits, grouped, quantity, shown, symbol } from "./units.js";

const bare = (value) => (Number.isInteger(value) && Math.abs(value) < 1e12 ? grouped(String(value)) : digits(value, 6));

/** A cell with its unit. */
export function cellText(cell) {
  if (cell === null) return "–";
  if (typeof cell === "string") return cell;
  if (typeof cell === "number") return bare(cell);
  return quantity(cell.value, cell.dimension, 5);
}

/** The number of a cell without its unit, with its deviation. */
function numberText(cell) {
  if (cell === null || typeof cell !== "object") return cellText(cell);
  const value = shown(cell.value, cell.dimension);
  const text = cell.dimension === "ratio" && Number.isInteger(value) ? bare(value) : digits(value, 5);
  return cell.std === undefined ? text : `${text} ± ${digits(shown(cell.std, cell.dimension), 2)}`;
}

/** The one dimension of some cells; null where they have none or several. */
function common(cells) {
  const all = new Set(cells.filter((cell) => cell !== null && typeof cell === "object").map((cell) => cell.dimension));
  return all.size === 1 ? [...all][0] : null;
}

const unit = (dimension) => (dimension && symbol(dimension) !== "" ? el("span", { class: "unit" }, ` ${symbol(dimension)}`) : null);
const isText = (cell) => typeof cell === "string";

/** A table whose rows are quantities: its first column names them with their unit. */
function byRow(sheet) {
  return sheet.rows.map(([name, ...cells]) => el("tr", {}, el("th", { scope: "row" }, name, unit(common(cells))), cells.map((cell) => el("td", { class: "number" }, numberText(cell)))));
}

/** A table whose columns are quantities: their heads name the unit. */
function byColumn(sheet) {
  return sheet.rows.map((cells) => el("tr", {}, cells.map((cell) => el("td", { class: isText(cell) ? null : "number" }, numberText(cell)))));
}

/** A list of keys and values. */
function keys(sheet) {
  return sheet.rows.map(([name, value]) => el("tr", {}, el("th", { scope: "row" }, name), el("td", {}, cellText(value))));
}

export function sheet(sheet) {
  const body = el("tbody", {});
  const head = el("thead", {});
  const results = sheet.place !== "inputs";
  const draw = () => {
    body.replaceChildren(...(results ? byRow(sheet) : sheet.heads.length ? byColumn(sheet) : keys(sheet)));
    const column = (i) => (results ? null : unit(common(sheet.rows.map((row) => row[i]))));
    if (sheet.heads.length) head.replaceChildren(el("tr", {}, sheet.heads.map((name, i) => el("th", { scope: "col" }, name, column(i)))));
  };
  on("units", draw);
  draw();
  const table = el("div", { class: "scrolls" }, el("table", { class: sheet.heads.length ? "grid" : "keys" }, head, body));
  if (results) return el("div", { class: "sheet" }, el("h3", {}, sheet.title), table);
  const long = sheet.rows.length > 24;
  return el("details", { class: "sheet prints", open: !long }, el("summary", {}, sheet.title, long ? ` (${sheet.rows.length} rows)` : ""), table);
}
