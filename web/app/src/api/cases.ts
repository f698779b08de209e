// Cases of the folder: their texts, drafts and diagnostics.

import type { HoleSection, StringPart } from "../../../components/schematic.ts";
import { request } from "#asked";
import { part, type Diagnostic } from "./client";

export interface CaseInList {
  id: string;
  path: string;
  name: string | null;
  /** Reason why the case is invalid; null if it is valid. */
  problem: string | null;
  /** Verdict of its newest results; null if there are none. */
  verdict: CaseVerdict | null;
  has_draft: boolean;
  modified_ms: number;
}

export interface CaseVerdict {
  severity: "ok" | "note" | "warning" | "error";
  words: string;
  /** The command of the results. */
  kind: string;
  results: string;
  /** Whether the case is unchanged since the results were computed. */
  is_current: boolean;
}

export interface Draft {
  text: string;
  base_revision: string;
  modified_ms: number;
}

export interface CaseText {
  id: string;
  path: string;
  text: string;
  revision: string;
  draft: Draft | null;
  beside: string[];
}

export interface Example {
  name: string;
  title: string;
  text: string;
  beside: BesideFile[];
}

/** A file that a case refers to and that is written next to it. */
export interface BesideFile {
  file_name: string;
  text: string;
}

/** A JSON value of a case file. */
export type Value = string | number | boolean | null | Value[] | { [key: string]: Value };
export type Table = { [key: string]: Value };

export interface Checked {
  diagnostics: Diagnostic[];
  values: Table | null;
  /** SI values of texts, by dimension and text. */
  quantities: Quantities;
  layout: Layout;
}

export type Quantities = { [dimension: string]: { [text: string]: number } };

/** Stations, column by column. */
export interface Stations {
  md_m: number[];
  inclination_rad: number[];
  azimuth_rad: number[];
  dogleg_severity_rad_per_m: number[];
}

/** Position of the first station. */
export interface Start {
  north_m: number;
  east_m: number;
  tvd_m: number;
}

/** A path at its stations and between them; null for missing numbers. */
export interface PathView {
  md_m: number[];
  north_m: number[];
  east_m: number[];
  tvd_m: number[];
  vertical_section_m: number[];
  inclination_rad: number[];
  azimuth_rad: number[];
  dogleg_severity_rad_per_m: (number | null)[];
}

/** A component of the string and its position. */
export interface Span extends StringPart {
  id_m: number;
}

/** Drawable data of a case, valid or not. */
export interface Layout {
  stations: Stations;
  tie_in: Start | null;
  path: PathView | null;
  /** Both from the surface down. */
  hole: HoleSection[];
  string: Span[];
}

/** A survey from a spreadsheet. */
export interface PastedSurvey {
  stations: Stations;
  tie_in: Start | null;
  notes: string[];
}

/** A change of a case; keys are dotted: `well.hole.0.friction`. */
export type Change =
  | { set: string; to: Value }
  | { remove: string }
  | { insert: string; at: number; value: Value }
  | { move: string; from: number; to: number };

export type Fate = "keep" | "mark" | "remove";

/** Modified values, by keys. */
export interface Applying {
  text: string;
  set: Record<string, string>;
  /** Treatments of comments, by their first lines. */
  comments: Record<number, Fate>;
}

/** A comment that may be about a value that changes. */
export interface Comment {
  line: number;
  text: string;
  fate: Fate;
  marked: string;
}

export interface Applied {
  text: string;
  changes: { key: string; label: string; old: string | null; new: string }[];
  comments: Comment[];
  warnings: string[];
}

export const listCases = (): Promise<CaseInList[]> => request("GET", "/cases");
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
export const listExamples = (): Promise<Omit<Example, "text" | "beside">[]> => request("GET", "/examples");
export const readExample = (name: string): Promise<Example> => request("GET", `/examples/${part(name)}`);
/** Reads rows with a heading as a survey; `length_unit` applies if the heading has none. */
export const readSurvey = (text: string, length_unit: string | null): Promise<PastedSurvey> =>
  request("POST", "/survey", { text, length_unit });
