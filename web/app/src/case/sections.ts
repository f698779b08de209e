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

/** The section of a key: that of its longest prefix. */
export function sectionOf(sections: Section[], key: string): Section | undefined {
  const inside = sections.filter((one) => one.key !== "" && (key === one.key || key.startsWith(`${one.key}.`)));
  return inside.sort((a, b) => b.key.length - a.key.length)[0] ?? sections[0];
}

