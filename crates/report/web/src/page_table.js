// Tables of numbers in the reader's units.

import { el } from "../../../../web/components/dom.ts";
import { digits, grouped, plain, quantity, shown, symbol } from "../../../../web/components/units.ts";
import { csv, downloads } from "./downloads.js";
import { on } from "./state.js";

const bare = (value) => (Number.isInteger(value) && Math.abs(value) < 1e12 ? grouped(String(value)) : plain(value));

/** A cell with its unit, in no more digits than it has; in so many where that is said. */
export function cellText(cell, significant, write = significant ? digits : plain) {
  if (cell === null || cell === "") return "–";
  if (typeof cell === "string") return cell;
  if (cell.href) return cell.text;
  if (typeof cell === "number") return bare(cell);
  if (cell.values) return listText(cell);
  return quantity(cell.value, cell.dimension, significant ?? 6, write);
}

/** Several numbers, and their unit once. */
function listText({ values, dimension }) {
  const texts = values.map((value) => plain(shown(value, dimension)));
  return `${texts.join(", ")}\u00a0${symbol(dimension)}`.trim();
}

/** The number of an input without its unit, in the digits that it has. */
function inputText(cell) {
  return cell?.value === undefined ? cellText(cell) : plain(shown(cell.value, cell.dimension));
}

/** The number of a result without its unit, in so many digits, with its deviation. */
function numberText(cell, largest, significant) {
  if (cell === null || typeof cell !== "object") return cellText(cell);
  // What is nothing beside the others of its kind is shown as nothing.
  const near = (value) => (Math.abs(value) < 1e-6 * largest ? 0 : value);
  const value = near(shown(cell.value, cell.dimension));
  const text = cell.dimension === "ratio" && Number.isInteger(value) ? bare(value) : digits(value, significant);
  return cell.std === undefined ? text : `${text} ± ${digits(near(shown(cell.std, cell.dimension)), 2)}`;
}

/** The one dimension of some cells; null where they have none or several. */
function common(cells) {
  const all = new Set(cells.filter((cell) => cell !== null && typeof cell === "object").map((cell) => cell.dimension));
  return all.size === 1 ? [...all][0] : null;
}

const unit = (dimension) =>
  dimension && symbol(dimension) !== "" ? el("span", { class: "unit" }, ` ${symbol(dimension)}`) : null;
const isText = (cell) => typeof cell === "string" || Boolean(cell?.href);

/** The largest number of some cells, without its sign and unit. */
const largestOf = (cells) =>
  Math.max(0, ...cells.map((cell) => (cell?.dimension ? Math.abs(shown(cell.value, cell.dimension)) : 0)));

/** A table whose rows are quantities: its first column names them with their unit. */
function byRow(table) {
  return table.rows.map(([name, ...cells]) =>
    el(
      "tr",
      {},
      el("th", { scope: "row" }, name, unit(common(cells))),
      cells.map((cell) => el("td", { class: "number" }, numberText(cell, largestOf(cells), 5))),
    ),
  );
}

/** A length without its unit, to the centimetre or the hundredth of a foot at any depth. */
const lengthText = (cell) => (cell?.dimension === "length" ? grouped(shown(cell.value, "length").toFixed(2)) : cellText(cell));

/**
 * Writes the numbers of a column of results: whole ones, such as what was set, without decimals; lengths in two decimals
 * where `exact` says so.
 */
function caseText(column, exact = false) {
  if (exact && common(column) === "length") return lengthText;
  const whole = ({ value, dimension, std }) => {
    const number = shown(value, dimension);
    return std === undefined && Math.abs(number - Math.round(number)) <= 1e-9 * Math.abs(number);
  };
  const cells = column.filter((cell) => cell?.dimension);
  const largest = largestOf(cells);
  return cells.every(whole) ? inputText : (cell) => numberText(cell, largest, 4);
}

/** A table whose columns are quantities: their heads name the unit. `writer` gives what writes a column. */
function byColumn(table, writer) {
  const writers = (table.rows[0] ?? []).map((_, i) => writer(table.rows.map((row) => row[i])));

  return table.rows.map((cells) =>
    el(
      "tr",
      {},
      cells.map((cell, i) => el(
          "td",
          { class: isText(cell) ? null : "number" },
          cell?.href ? el("a", { href: cell.href }, cell.text) : writers[i](cell),
        )),
    ),
  );
}

/** A list of keys and values. */
function keys(table) {
  return table.rows.map(([name, value]) =>
    el("tr", {}, el("th", { scope: "row" }, name), el("td", {}, cellText(value))),
  );
}

/** Heads and rows of a table for a file: numbers in the reader's units, deviations in columns of their own. */
function fileRows(table, results) {
  const number = (cell) => {
    if (cell === null || typeof cell !== "object") return cell;
    if (cell.values || cell.href) return cellText(cell);
    return shown(cell.value, cell.dimension);
  };
  const named = (name, dimension) => (dimension && symbol(dimension) ? `${name}, ${symbol(dimension)}` : name);
  const spread = (cells) => cells.some((cell) => cell?.std !== undefined);
  const deviation = (cell) => (cell?.std === undefined ? null : shown(cell.std, cell.dimension));
  if (results) {
    const wide = table.heads.map((_, i) => i > 0 && spread(table.rows.map((row) => row[i])));
    const heads = table.heads.flatMap((head, i) => (wide[i] ? [head, `${head}, deviation`] : [head]));
    const rows = table.rows.map(([name, ...cells]) => [
      named(name, common(cells)),
      ...cells.flatMap((cell, i) => (wide[i + 1] ? [number(cell), deviation(cell)] : [number(cell)])),
    ]);
    return [heads, rows];
  }
  if (!table.heads.length) {
    const unit = (cell) => (cell?.dimension ? symbol(cell.dimension) : "");
    return [["key", "value", "unit"], table.rows.map(([name, cell]) => [name, number(cell), unit(cell)])];
  }
  const columns = table.heads.map((head, i) => {
    const cells = table.rows.map((row) => row[i]);
    return { head: named(head, common(cells)), wide: spread(cells) };
  });
  return [
    columns.flatMap(({ head, wide }) => (wide ? [head, `${head}, deviation`] : [head])),
    table.rows.map((row) =>
      row.flatMap((cell, i) => (columns[i].wide ? [number(cell), deviation(cell)] : [number(cell)])),
    ),
  ];
}

/** Buttons that give a table as a file. */
export const tableDownloads = (table) =>
  downloads(table.title, { csv: () => csv(...fileRows(table, ["results", "numerics"].includes(table.place))) });

/** A table; `exact` writes the lengths in its columns in two decimals, for what is identified by its depth. */
export function pageTable(table, { exact = false } = {}) {
  const body = el("tbody", {});
  const head = el("thead", {});
  const cases = table.place === "cases";
  const results = table.place !== "inputs" && !cases;
  const rows = () => {
    if (results) return byRow(table);
    if (cases) return byColumn(table, (column) => caseText(column, exact));
    return table.heads.length ? byColumn(table, () => inputText) : keys(table);
  };
  const draw = () => {
    body.replaceChildren(...rows());
    const column = (i) => (results ? null : unit(common(table.rows.map((row) => row[i]))));
    if (table.heads.length)
      head.replaceChildren(
        el(
          "tr",
          {},
          table.heads.map((name, i) => {
            const words = cases && table.rows.every((row) => isText(row[i]));
            return el("th", { scope: "col", class: words ? "words" : null }, name, column(i));
          }),
        ),
      );
  };
  on("units", draw);
  draw();
  const save = tableDownloads(table);
  const grid = el(
    "div",
    { class: "scrolls" },
    el("table", { class: table.heads.length ? "grid" : "keys" }, head, body),
  );
  // The table of a page of cases stands alone in its section, whose title has the downloads.
  if (cases) return el("div", { class: "page-table cases" }, grid);
  if (results) return el("div", { class: "page-table" }, el("h3", {}, table.title, save), grid);
  const long = table.rows.length > 24;
  return el(
    "details",
    { class: `page-table prints${table.heads.length > 4 ? " wide" : ""}${long ? " long" : ""}`, open: !long },
    el("summary", {}, table.title, long ? ` (${table.rows.length} rows)` : ""),
    grid,
    save,
  );
}
