// Common types of requests and answers.

import type { Diagnostic } from "./types";

export type { Diagnostic } from "./types";

/** Error answer of the server. */
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

/** Whether the page cancelled a request, which is no failure. */
export const wasAborted = (problem: unknown): boolean =>
  problem instanceof DOMException && problem.name === "AbortError";

/** A failure as a sentence for the user. */
export const sentence = (problem: unknown): string =>
  problem instanceof Error ? problem.message : String(problem);

export type Method = "GET" | "POST" | "PUT" | "DELETE";

/** One part of a path. */
export const part = (id: string): string => encodeURIComponent(id);
