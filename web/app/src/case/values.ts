// Values of a case by their dotted keys, and the effect of changes on them.

import type { Change, Table, Value } from "../api/cases";

const isTable = (value: Value | undefined): value is Table =>
  typeof value === "object" && value !== null && !Array.isArray(value);

export const asTable = (value: Value | undefined): Table => (isTable(value) ? value : {});
export const asList = (value: Value | undefined): Value[] => (Array.isArray(value) ? value : []);

/** The value of a dotted key; undefined if there is none. */
export function at(values: Value | undefined, key: string): Value | undefined {
  let found: Value | undefined = values;
  for (const step of key.split(".")) {
    if (Array.isArray(found)) found = found[Number(step)];
    else if (isTable(found) && Object.hasOwn(found, step)) found = found[step];
    else return undefined;
  }
  return found;
}

/** The values after a change, equal to the effect of the server on the text. */
export function applied(values: Table, change: Change): Table {
  if ("set" in change) return asTable(put(values, change.set.split("."), change.to));
  if ("remove" in change) return asTable(put(values, change.remove.split("."), undefined));
  if ("insert" in change) {
    const list = asList(at(values, change.insert)).toSpliced(change.at, 0, change.value);
    return asTable(put(values, change.insert.split("."), list));
  }
  const list = asList(at(values, change.move));
  const moved = list[change.from];
  if (moved === undefined) return values;
  const others = list.toSpliced(change.from, 1);
  return asTable(put(values, change.move.split("."), others.toSpliced(change.to, 0, moved)));
}

/** A copy in which the key has another value, or none. */
function put(within: Value | undefined, keys: string[], value: Value | undefined): Value {
  const [key = "", ...rest] = keys;
  if (Array.isArray(within)) {
    const index = Number(key);
    if (rest.length > 0) return within.with(index, put(within[index], rest, value));
    return value === undefined ? within.toSpliced(index, 1) : within.with(index, value);
  }
  const table = asTable(within);
  if (rest.length === 0 && value === undefined) {
    const { [key]: _removed, ...others } = table;
    return others;
  }
  return { ...table, [key]: rest.length === 0 ? value! : put(table[key], rest, value) };
}
