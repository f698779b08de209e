// Cases and their files in the storage of this browser, in place of a folder.

import type { Draft } from "../api/cases";
import { ApiError } from "../api/client";

/** A file. */
export interface File {
  text: string;
  /** Incremented with every text. */
  revision: number;
  modified_ms: number;
}

const FILE = "wholestring.file.";
const DRAFT = "wholestring.draft.";
/** Set once the folder was used, so that deleted example cases do not reappear. */
const USED = "wholestring.used";

/** Files in memory, for a browser without storage, until the page is closed. */
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
      throw new ApiError(507, "full", "The storage of this browser is full: delete a case, or use the program, which stores cases in a folder.");
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

/** Names of all files, sorted. */
export function names(): string[] {
  const found = keys().filter((key) => key.startsWith(FILE));
  return found.map((key) => key.slice(FILE.length)).sort();
}

export const fileOf = (name: string): File | null => parsed<File>(read(FILE + name));

/** Returns the case of a name. */
export function caseOf(name: string): File {
  const found = isCase(name) ? fileOf(name) : null;
  if (!found) throw new ApiError(404, "not_found", "there is no such case");
  return found;
}

/** Writes a text to a file. */
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

/** The files that a case may refer to: those whose name is in its text. */
export function beside(text: string): Record<string, string> {
  const named = names().filter((name) => !isCase(name) && text.includes(name));
  return Object.fromEntries(named.map((name) => [name, fileOf(name)?.text ?? ""]));
}

/** Whether this is the first use of the folder; false afterwards. */
export function isNew(): boolean {
  const found = read(USED) === null;
  if (found) write(USED, "1");
  return found;
}

/** Refuses a name that is invalid or already in use. */
export function checkNew(name: string): void {
  const refused = (why: string) => new ApiError(422, "bad_input", `\`${name}\` cannot be the name of a file: ${why}`);
  if (!isCase(name)) throw refused("a case file ends in `.toml`");
  if (name.length > 200) throw refused("it is longer than 200 characters");
  if (/[\p{Cc}/\\:*?"<>|]|^[. -]|[. ]$/u.test(name)) throw refused("it contains a character that file names cannot have, or begins with a dot, a space or a dash");
  if (fileOf(name)) throw new ApiError(409, "conflict", `\`${name}\` already exists`);
}
