// Cases and the files beside them, kept in this browser: the folder of who has no program.

import type { Draft } from "../api/cases";
import { ApiError } from "../api/client";

/** A file. */
export interface File {
  text: string;
  /** Grows with every text. */
  revision: number;
  modified_ms: number;
}

const FILE = "wholestring.file.";
const DRAFT = "wholestring.draft.";
/** There once the folder was used: who has removed all cases does not find them again. */
const USED = "wholestring.used";

/** Of a browser that keeps nothing: what holds until the page is closed. */
const forNow = new Map<string, string>();

function read(key: string): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return forNow.get(key) ?? null;
  }
}

function write(key: string, text: string): void {
  try {
    localStorage.setItem(key, text);
  } catch (problem) {
    if (problem instanceof DOMException && problem.name === "QuotaExceededError")
      throw new ApiError(507, "full", "This browser keeps no more: delete a case, or take the program, which keeps them in a folder.");
    forNow.set(key, text);
  }
}

function forget(key: string): void {
  try {
    localStorage.removeItem(key);
  } catch {
    forNow.delete(key);
  }
}

function keys(): string[] {
  try {
    return Object.keys(localStorage);
  } catch {
    return [...forNow.keys()];
  }
}

const parsed = <T>(text: string | null): T | null => (text === null ? null : (JSON.parse(text) as T));

export const isCase = (name: string): boolean => name.toLowerCase().endsWith(".toml");

/** Names of all files, in their order. */
export function names(): string[] {
  const found = keys().filter((key) => key.startsWith(FILE));
  return found.map((key) => key.slice(FILE.length)).sort();
}

export const fileOf = (name: string): File | null => parsed<File>(read(FILE + name));

/** The case of a name. */
export function caseOf(name: string): File {
  const found = isCase(name) ? fileOf(name) : null;
  if (!found) throw new ApiError(404, "not_found", "there is no such case");
  return found;
}

/** Puts a text into a file. */
export function put(name: string, text: string): File {
  const file = { text, revision: (fileOf(name)?.revision ?? 0) + 1, modified_ms: Date.now() };
  write(FILE + name, JSON.stringify(file));
  return file;
}

export function remove(name: string): void {
  forget(FILE + name);
  forget(DRAFT + name);
}

export const draftOf = (name: string): Draft | null => parsed<Draft>(read(DRAFT + name));
export const putDraft = (name: string, draft: Draft): void => write(DRAFT + name, JSON.stringify(draft));
export const dropDraft = (name: string): void => forget(DRAFT + name);

/** The files that a case may name: those whose name stands in its text. */
export function beside(text: string): Record<string, string> {
  const named = names().filter((name) => !isCase(name) && text.includes(name));
  return Object.fromEntries(named.map((name) => [name, fileOf(name)?.text ?? ""]));
}

/** Whether the folder is used for the first time; not any more from then on. */
export function isNew(): boolean {
  const found = read(USED) === null;
  if (found) write(USED, "1");
  return found;
}

/** Refuses what is no plain name of a case file that is free. */
export function checkNew(name: string): void {
  const refused = (why: string) => new ApiError(422, "bad_input", `\`${name}\` cannot be the name of a file: ${why}`);
  if (!isCase(name)) throw refused("a case file ends in `.toml`");
  if (name.length > 200) throw refused("it is longer than 200 letters");
  if (/[\p{Cc}/\\:*?"<>|]|^[. -]|[. ]$/u.test(name)) throw refused("it holds a character that no name of a file has, or begins with a dot, a space or a dash");
  if (fileOf(name)) throw new ApiError(409, "conflict", `there is a \`${name}\` already`);
}
