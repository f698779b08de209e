// Words of a case file, from the schema: the list with a given word has the others.

import { request } from "#asked";

let schema: Promise<unknown> | null = null;

function listWith(word: string, schema: unknown): string[] | null {
  if (typeof schema !== "object" || schema === null) return null;
  const words: unknown = (schema as { enum?: unknown }).enum;
  if (Array.isArray(words) && words.includes(word)) return words.map(String);
  for (const part of Object.values(schema)) {
    const found = listWith(word, part);
    if (found) return found;
  }
  return null;
}

/** Returns the words of the list that contains this one. */
export async function wordsLike(word: string): Promise<string[]> {
  schema ??= request("GET", "/schema");
  try {
    return listWith(word, await schema) ?? [word];
  } catch (problem) {
    schema = null;
    throw problem;
  }
}
