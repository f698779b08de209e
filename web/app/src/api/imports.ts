// Files of other programs, and the case made from them.

import { request } from "#asked";

/** User input for data that are missing in the files. */
export interface Choices {
  units: Record<string, string>;
  values: Record<string, string>;
  picks: Record<string, string>;
}

export interface Question {
  ask: "unit" | "value" | "pick";
  name: string;
  options: string[];
  message: string;
}

export interface Reading {
  files: { name: string; what: string | null; lines: string[] }[];
  question: Question | null;
  problem: string | null;
  case: {
    text: string;
    beside: string[];
    notes: { file: string | null; kind: string; text: string }[];
    missing: string[];
  } | null;
  /** The id of the case that was written. */
  written: string | null;
}

/** Reads files into a case of that name; with `write`, writes it if no question is open. */
export function importFiles(files: File[], choices: Choices, name: string, write: boolean, signal?: AbortSignal): Promise<Reading> {
  const form = new FormData();
  form.append("choices", JSON.stringify(choices));
  form.append("name", name);
  if (write) form.append("write", "true");
  for (const file of files) form.append("file", file, file.name);
  return request("POST", "/import", form, signal);
}
