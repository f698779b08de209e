// Numbers with their units, as a page prints them and as files hold them.
import { readFileSync } from "node:fs";

const TURN = 2 * Math.PI;
const FOOT = 0.3048;
const POUND = 4.4482216152605;

/** SI units in one of a unit, and the ending that names of SI columns have. */
const UNITS = {
  m: [1, "m"],
  ft: [FOOT, "m"],
  mm: [1e-3, "m"],
  in: [FOOT / 12, "m"],
  kN: [1e3, "N"],
  t: [9806.65, "N"],
  klbf: [1e3 * POUND, "N"],
  "kN·m": [1e3, "N_m"],
  "N·m": [1, "N_m"],
  "ft·lbf": [FOOT * POUND, "N_m"],
  "kN/m": [1e3, "N_per_m"],
  "lbf/ft": [POUND / FOOT, "N_per_m"],
  MPa: [1e6, "Pa"],
  bar: [1e5, "Pa"],
  psi: [(POUND / FOOT ** 2) * 144, "Pa"],
  ksi: [(POUND / FOOT ** 2) * 144e3, "Pa"],
  "kg/m³": [1, "kg_per_m3"],
  sg: [1e3, "kg_per_m3"],
  ppg: [0.45359237 / (231 * (FOOT / 12) ** 3), "kg_per_m3"],
  "°/30 m": [TURN / 360 / 30, "rad_per_m"],
  "°/100 ft": [TURN / 360 / (100 * FOOT), "rad_per_m"],
  "°": [TURN / 360, "rad"],
  rpm: [TURN / 60, "rad_per_s"],
  Hz: [1, "Hz"],
  s: [1, "s"],
  "%": [0.01, ""],
};

const LONGEST_FIRST = Object.keys(UNITS).sort((a, b) => b.length - a.length);

/** The unit that stands after a comma: `Hook load, kN` or `Hook load without block, kN, soft string`. */
const named = (text) => text.split(", ").slice(1).find((part) => part in UNITS);

/** Columns whose unit is told by a cell of their row: of `unit`, or behind what the row is of, as in `hook load, kN`. */
const OF_ROW = /^(the case|5 %|50 %|95 %|measured|low friction|expected|high|residual|mean difference|largest|theirs at that depth)$/;

/** The unit of such a column; none where its row does not tell one. */
function ofRow(heads, row, heading) {
  const place = heads.findIndex(({ text }) => text === "unit" || text === "of");
  if (place < 0 || !OF_ROW.test(heading)) return undefined;
  return row[place].split(", ").find((part) => part in UNITS);
}

/**
 * The numbers of a cell: value in SI, half of what its last digit counts, what it is of, and its unit, which stands behind
 * it, in the heading, or in the title. Words may hold numbers that are names, such as `line 2`: there those with a unit count.
 */
export function quantities({ title, heads, rows }, row, column) {
  const text = rows[row][column].replaceAll("kN.m", "kN·m").replaceAll("N.m", "N·m").replaceAll("ft-lbf", "ft·lbf");
  const { text: heading, words } = heads[column];
  const around = words ? undefined : (ofRow(heads, rows[row], heading) ?? named(heading) ?? named(title));
  const found = [];
  for (const match of text.matchAll(/(?<![\w.])([−-]?)(\d+(?:\.(\d+))?)(?:·10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?(?![\w.]*\d)/g)) {
    const rest = text.slice(match.index + match[0].length);
    const behind = LONGEST_FIRST.find((unit) => new RegExp(`^ ?${unit}(?![\\w·/³])`).test(rest));
    // Beyond what is told in numbers.
    if (/(over|under) $/.test(text.slice(0, match.index)) || (words && !behind)) continue;
    const unit = behind ?? around;
    const [factor, kind] = UNITS[unit] ?? [1, ""];
    const raised = match[4] ? 10 ** Number([...match[4]].map((mark) => "⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(mark)).map((digit) => (digit < 0 ? "-" : digit)).join("")) : 1;
    const value = Number(match[2]) * (match[1] ? -1 : 1) * raised;
    const half = 0.5 * 10 ** -(match[3]?.length ?? 0) * raised;
    found.push({ unit, kind, si: value * factor, half: half * factor });
  }
  return found;
}

/** What a name says of its unit: `hook_load_N` is in `N`. */
const kindOf = (name) => name.match(/_(kg_per_m3|N_per_m|rad_per_m|rad_per_s|N_m|rad|Hz|Pa|N|m|s)$/)?.[1] ?? "";

const OF_UNIT = { N: "N", "N·m": "N_m", Pa: "Pa", m: "m", 1: "" };

/** Columns whose unit stands in their row. */
const WITH_UNIT = /^(load|capacity|expected|p\d\d|mean|std)$/;

/** The numbers of a CSV or JSON file by what they are of. */
export function numbersOf(path) {
  const found = new Map();
  const note = (kind, value) => {
    if (!found.has(kind)) found.set(kind, []);
    found.get(kind).push(value);
  };
  const text = readFileSync(path, "utf8");
  if (path.endsWith(".json")) {
    const visit = (name, value, unit) => {
      if (typeof value === "number") note(unit && WITH_UNIT.test(name) ? OF_UNIT[unit] : kindOf(name), value);
      // A list of numbers is of what its name says; a list of names and numbers, of the names.
      else if (Array.isArray(value)) value.forEach((item) => visit(name, item));
      else if (value !== null && typeof value === "object") {
        for (const [key, item] of Object.entries(value)) visit(key, item, value.unit);
        // A number that a parameter names, and one that is a torque or a weight.
        const kind = value.parameter ? kindOf(value.parameter) : value.is_torque === undefined ? "" : value.is_torque ? "N_m" : "N";
        for (const key of ["value", "standard_error", "interval", "mean", "largest", "theirs_there"])
          for (const item of [value[key]].flat()) if (typeof item === "number" && kind) note(kind, item);
      }
    };
    visit("", JSON.parse(text));
    return found;
  }
  const [names, ...rows] = text.trim().split(/\r?\n/).map(fields);
  const unit = names.indexOf("unit");
  for (const row of rows)
    names.forEach((name, i) => {
      if (row[i] === "" || row[i] === undefined || Number.isNaN(Number(row[i]))) return;
      const own = unit >= 0 && WITH_UNIT.test(name);
      note(own ? OF_UNIT[row[unit]] : kindOf(name), Number(row[i]));
    });
  return found;
}

/** The fields of a line of CSV (RFC 4180). */
const fields = (line) =>
  [...line.matchAll(/(?:^|,)(?:"((?:[^"]|"")*)"|([^,]*))/g)].map((match) => match[1]?.replaceAll('""', '"') ?? match[2]);

/** Several files' numbers together. */
export function pooled(files) {
  const all = new Map();
  for (const file of files) for (const [kind, values] of file) all.set(kind, [...(all.get(kind) ?? []), ...values]);
  return all;
}
