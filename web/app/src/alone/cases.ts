// Cases of this browser, with the operations that the server of the program has for those of its folder.

import type { BesideFile, CaseInList, CaseText, Checked, Draft, Example, Silhouette } from "../api/cases";
import { ApiError } from "../api/client";
import { Desk, unpack } from "./desk";
import * as folder from "./folder";

/** Worker for short tasks. */
export const quick = new Desk();

/** Initial cases, by the names of their examples. */
const FIRST = ["slant", "horizontal", "well-b-2235"];

/** Sends a request to the engine. */
export const engine = async <T>(asks: string, body: object = {}, desk = quick, signal?: AbortSignal): Promise<T> =>
  unpack<T>(await desk.ask("ask", { asks, body }, undefined, signal));

/** Sends a request about the text of a case, saved or edited, to the engine. */
export const ofText = async <T>(asks: string, file: string, body: { text: string }, desk = quick, signal?: AbortSignal): Promise<T> =>
  unpack<T>(await desk.ask("ask", { asks, file, beside: folder.beside(body.text), body }, undefined, signal));

async function fill(): Promise<void> {
  for (const name of FIRST) {
    const { text, beside } = await engine<Example>("example", { name });
    for (const file of [{ file_name: `${name}.toml`, text }, ...beside]) folder.put(file.file_name, file.text);
  }
}

/** The well of a text as a line. */
function silhouetteOf({ layout: { path, hole, string } }: Checked): Silhouette | null {
  if (!path) return null;
  const { md_m, vertical_section_m, tvd_m } = path;
  const shoes = hole.filter(({ kind }) => kind === "casing").map(({ to_m }) => to_m);
  const bit_md_m = string.at(-1)?.to_m ?? md_m.at(-1) ?? 0;
  return { md_m, vertical_section_m, tvd_m, shoe_md_m: shoes.length > 0 ? Math.max(...shoes) : null, bit_md_m };
}

export async function list(): Promise<CaseInList[]> {
  if (folder.isNew()) await fill();
  const entry = async (id: string): Promise<CaseInList> => {
    const { text, modified_ms } = folder.caseOf(id);
    const { name, problem } = await ofText<{ name: string | null; problem: string | null }>("title", id, { text });
    const silhouette = silhouetteOf(await ofText<Checked>("check", id, { text }));
    const shownName = name ?? id.replace(/\.toml$/i, "");
    // The list of this browser has no answers: they are computed once a case is opened.
    return { id, path: id, name: shownName, problem, silhouette, overview: null, is_pending: false, verdict: null, has_draft: folder.draftOf(id) !== null, modified_ms };
  };
  return Promise.all(folder.names().filter(folder.isCase).map(entry));
}

export function open(id: string): CaseText {
  const { text, revision } = folder.caseOf(id);
  return { id, path: id, text, revision: String(revision), draft: folder.draftOf(id), beside: Object.keys(folder.beside(text)) };
}

export function create({ file_name, text, beside }: BesideFile & { beside: BesideFile[] }): { id: string } {
  folder.checkNew(file_name);
  for (const file of beside) {
    const there = folder.fileOf(file.file_name);
    if (there && there.text !== file.text) throw new ApiError(409, "conflict", `a different \`${file.file_name}\` already exists`);
    folder.put(file.file_name, file.text);
  }
  folder.put(file_name, text);
  return { id: file_name };
}

function unchanged(id: string, revision: string): void {
  if (String(folder.caseOf(id).revision) !== revision) throw new ApiError(409, "conflict", "the file has been changed meanwhile");
}

export function save(id: string, { text, revision }: { text: string; revision: string }): { revision: string } {
  unchanged(id, revision);
  const saved = folder.put(id, text);
  folder.dropDraft(id);
  return { revision: String(saved.revision) };
}

export function remove(id: string, revision: string): void {
  unchanged(id, revision);
  folder.remove(id);
}

export function copy(id: string, file_name: string): { id: string } {
  folder.checkNew(file_name);
  folder.put(file_name, folder.caseOf(id).text);
  return { id: file_name };
}

export function rename(id: string, file_name: string): { id: string } {
  const draft = folder.draftOf(id);
  const made = copy(id, file_name);
  if (draft) folder.putDraft(file_name, { ...draft, base_revision: String(folder.caseOf(file_name).revision) });
  folder.remove(id);
  return made;
}

export function keepDraft(id: string, { text, revision }: { text: string; revision: string }): void {
  folder.caseOf(id);
  const draft: Draft = { text, base_revision: revision, modified_ms: Date.now() };
  folder.putDraft(id, draft);
}

export const discardDraft = (id: string): void => folder.dropDraft(id);
