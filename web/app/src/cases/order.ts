// Search and order of the list of cases.

import type { CaseInList } from "../api/cases";

export const ORDERS = [
  ["changed", "last change"],
  ["name", "name"],
  ["severity", "severity"],
] as const;
export type Order = (typeof ORDERS)[number][0];

/** Severities of the server, the most severe first; cases without one come last. */
const SEVERITIES = ["error", "warning", "note", "ok"];

function rank({ problem, overview }: CaseInList): number {
  if (problem !== null) return -1;
  const place = SEVERITIES.indexOf(overview?.check?.severity ?? "");
  return place < 0 ? SEVERITIES.length : place;
}

const byName = (one: CaseInList, other: CaseInList): number =>
  one.name.localeCompare(other.name, undefined, { numeric: true }) || one.path.localeCompare(other.path);
const byChange = (one: CaseInList, other: CaseInList): number => other.modified_ms - one.modified_ms || byName(one, other);

const COMPARE: Record<Order, (one: CaseInList, other: CaseInList) => number> = {
  changed: byChange,
  name: byName,
  severity: (one, other) => rank(one) - rank(other) || byChange(one, other),
};

/** The cases that contain every word in name, path, verdict or mistake, in an order. */
export function ordered(cases: readonly CaseInList[], words: string, order: Order): CaseInList[] {
  const sought = words.toLowerCase().split(/\s+/).filter(Boolean);
  const textOf = ({ name, path, problem, overview }: CaseInList): string =>
    [name, path, problem, overview?.check?.verdict, overview?.check?.sentence].join(" ").toLowerCase();
  const found = sought.length === 0 ? cases : cases.filter((one) => sought.every((word) => textOf(one).includes(word)));
  return found.toSorted(COMPARE[order]);
}
