// The parts of a case, in the order of the schema: a tab each.

import type { Schema } from "../api/lookup";
import { keysOf, kindOf, titleOf } from "./kinds";

export interface Section {
  /** In the address. */
  name: string;
  title: string;
  /** What of the case it shows; "" is what stands outside all tables. */
  key: string;
  schema: Schema;
}

const isTable = (schema: Schema) => ["table", "tables"].includes(kindOf(schema).is);

export const tableKeys = (schema: Schema): string[] => keysOf(schema).filter(([, of]) => isTable(of)).map(([key]) => key);

/** Every section. The hole, which is a part of the well, has its own. */
export function sectionsOf(schema: Schema): Section[] {
  const sections: Section[] = [{ name: "case", title: "Case", key: "", schema }];
  for (const [key, of] of keysOf(schema)) {
    if (!isTable(of)) continue;
    sections.push({ name: key, title: titleOf(key), key, schema: of });
    const hole = key === "well" ? of.properties?.hole : undefined;
    if (hole) sections.push({ name: "hole", title: "Hole", key: "well.hole", schema: hole });
  }
  return sections;
}

/** The section in which a key is found: that of the longest key that it begins with. */
export function sectionOf(sections: Section[], key: string): Section | undefined {
  const inside = sections.filter((one) => one.key !== "" && (key === one.key || key.startsWith(`${one.key}.`)));
  return inside.sort((a, b) => b.key.length - a.key.length)[0] ?? sections[0];
}

