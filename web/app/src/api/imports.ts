// Files of other programs, and the case made from them.

import { request } from "#asked";
import type { Reading, Said } from "./types";

export type { Question, Reading } from "./types";

/** User input for data that are missing in the files. */
export type Choices = Required<Said>;

/** Reads files into a case of that name; with `write`, writes it if no question is open. */
export function importFiles(files: File[], choices: Choices, name: string, write: boolean, signal?: AbortSignal): Promise<Reading> {
  const form = new FormData();
  form.append("choices", JSON.stringify(choices));
  form.append("name", name);
  if (write) form.append("write", "true");
  for (const file of files) form.append("file", file, file.name);
  return request("POST", "/import", form, signal);
}
