// Words that a case file takes, from the schema of the case: a list that has one has its others.

import { request } from "#asked";

let asked: Promise<unknown> | null = null;

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

/** The words of the list that has this one. */
export async function wordsLike(word: string): Promise<string[]> {
  asked ??= request("GET", "/schema");
  try {
    return listWith(word, await asked) ?? [word];
  } catch (problem) {
    asked = null;
    throw problem;
  }
}
