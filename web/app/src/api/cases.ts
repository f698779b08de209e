// Cases of the folder: their texts, drafts and diagnostics.

import { request } from "#asked";
import type { UnitSet } from "../settings.svelte";
import { part } from "./client";
import type {
  Applied,
  Applying,
  CaseEntry as CaseInList,
  CaseValue as Value,
  Change,
  Checked,
  Example,
  ExampleEntry,
  ExampleFile as BesideFile,
  OpenCase as CaseText,
  Survey as PastedSurvey,
} from "./types";

export type {
  Applied,
  Applying,
  CaseEntry as CaseInList,
  CaseValue as Value,
  CaseOverview,
  CaseVerdict,
  Change,
  Checked,
  Comment,
  Component as Span,
  Example,
  ExampleFile as BesideFile,
  Fate,
  Layout,
  OpenCase as CaseText,
  OpenDraft as Draft,
  PathView,
  Silhouette,
  Start,
  Stations,
  Survey as PastedSurvey,
} from "./types";

export type Table = { [key: string]: Value };

/** SI values of texts, by dimension and text. */
export type Quantities = Checked["quantities"];

/** The cases of the folder; `units` are those of the sentences, by default those of each case. */
export const listCases = (units?: UnitSet): Promise<CaseInList[]> =>
  request("GET", units === undefined ? "/cases" : `/cases?units=${units}`);
export const readCase = (id: string): Promise<CaseText> => request("GET", `/cases/${part(id)}`);
export const createCase = (file_name: string, text: string, beside: BesideFile[]): Promise<{ id: string }> =>
  request("POST", "/cases", { file_name, text, beside });
export const saveCase = (id: string, text: string, revision: string): Promise<{ revision: string }> =>
  request("PUT", `/cases/${part(id)}`, { text, revision });
export const deleteCase = (id: string, revision: string): Promise<void> =>
  request("DELETE", `/cases/${part(id)}?revision=${part(revision)}`);
export const renameCase = (id: string, file_name: string): Promise<{ id: string }> =>
  request("POST", `/cases/${part(id)}/rename`, { file_name });
export const copyCase = (id: string, file_name: string): Promise<{ id: string }> =>
  request("POST", `/cases/${part(id)}/copy`, { file_name });
export const saveDraft = (id: string, text: string, revision: string, closing = false): Promise<void> =>
  request("PUT", `/cases/${part(id)}/draft`, { text, revision }, undefined, closing);
export const dropDraft = (id: string): Promise<void> => request("DELETE", `/cases/${part(id)}/draft`);
export const checkCase = (id: string, text: string, signal?: AbortSignal): Promise<Checked> =>
  request("POST", `/cases/${part(id)}/check`, { text }, signal);
export const editCase = (id: string, text: string, changes: Change[]): Promise<{ text: string }> =>
  request("POST", `/cases/${part(id)}/edit`, { text, changes });
/** The text with modified values, and its changes; no file is written. */
export const applyToCase = (id: string, applying: Applying): Promise<Applied> =>
  request("POST", `/cases/${part(id)}/apply`, applying);
export const listExamples = (): Promise<ExampleEntry[]> => request("GET", "/examples");
export const readExample = (name: string): Promise<Example> => request("GET", `/examples/${part(name)}`);
/** Reads rows with a heading as a survey; `length_unit` applies if the heading has none. */
export const readSurvey = (text: string, length_unit: string | null): Promise<PastedSurvey> =>
  request("POST", "/survey", { text, length_unit });
