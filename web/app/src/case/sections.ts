// The parts of a case, in the order of the schema: a tab each.

import type { Schema } from "../api/lookup";
import { keysOf, kindOf, titleOf } from "./kinds";

export interface Section {
  /** Name in the address. */
  name: string;
  title: string;
  /** Key of the displayed table; "" for the keys outside all tables. */
  key: string;
  schema: Schema;
}

const isTable = (schema: Schema) => ["table", "tables"].includes(kindOf(schema).is);

export const tableKeys = (schema: Schema): string[] => keysOf(schema).filter(([, part]) => isTable(part)).map(([key]) => key);

/** All sections. The hole, a part of the well, has its own. */
export function sectionsOf(schema: Schema): Section[] {
  const sections: Section[] = [{ name: "case", title: "Case", key: "", schema }];
  for (const [key, part] of keysOf(schema)) {
    if (!isTable(part)) continue;
    sections.push({ name: key, title: titleOf(key), key, schema: part });
    const hole = key === "well" ? part.properties?.hole : undefined;
    if (hole) sections.push({ name: "hole", title: "Hole", key: "well.hole", schema: hole });
  }
  return sections;
}

/** Groups of sections, with the names of those in each; all others are in the last one. */
const GROUPS: readonly (readonly [title: string, names: readonly string[]])[] = [
  ["Well", ["well", "hole"]],
  ["String", ["string", "steel", "catalogue", "ends", "bit", "rock"]],
  ["Fluids", ["mud"]],
  ["Rig", ["rig", "hoist", "top_drive"]],
  ["Operations", ["operation", "plan"]],
  ["Analysis", ["case"]],
];

/** Sections under a heading. */
export interface Group {
  title: string;
  sections: Section[];
}

/** The sections in their groups, in the order of the groups. */
export function grouped(sections: Section[]): Group[] {
  const named = GROUPS.map(([title, names]) => ({
    title,
    sections: names.flatMap((name) => sections.filter((one) => one.name === name)),
  }));
  const placed = new Set(named.flatMap((group) => group.sections));
  const last = named.at(-1);
  last?.sections.push(...sections.filter((one) => !placed.has(one)));
  return named.filter((group) => group.sections.length > 0);
}

/** The section of a key: that of its longest prefix. */
export function sectionOf(sections: Section[], key: string): Section | undefined {
  const inside = sections.filter((one) => one.key !== "" && (key === one.key || key.startsWith(`${one.key}.`)));
  return inside.sort((a, b) => b.key.length - a.key.length)[0] ?? sections[0];
}

