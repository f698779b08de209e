// What requests and their answers have in common.

/** A place in a case that something is to be said of. */
export interface Diagnostic {
  level: "error" | "warning" | "note" | "help";
  message: string;
  /** What stands beside the place; may be empty. */
  label: string;
  /** What was expected, how to put it right. */
  help: string[];
  /** The dotted key that the place belongs to. */
  key: string | null;
  /** The file, where it is not the case itself. */
  file: string | null;
  /** UTF-16 offsets in the text. */
  start: number | null;
  end: number | null;
  line: number | null;
  column: number | null;
}

/** What the server answered instead of what was asked for. */
export class ApiError extends Error {
  readonly status: number;
  readonly kind: string;
  readonly diagnostics: Diagnostic[];

  constructor(status: number, kind: string, message: string, diagnostics: Diagnostic[] = []) {
    super(message);
    this.status = status;
    this.kind = kind;
    this.diagnostics = diagnostics;
  }
}

/** Whether a request was given up by us, which is no failure. */
export const wasAborted = (problem: unknown): boolean =>
  problem instanceof DOMException && problem.name === "AbortError";

/** A failure as a sentence for people. */
export const sentence = (problem: unknown): string =>
  problem instanceof Error ? problem.message : String(problem);

export type Method = "GET" | "POST" | "PUT" | "DELETE";

/** One part of a path. */
export const part = (id: string): string => encodeURIComponent(id);
