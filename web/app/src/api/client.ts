// Requests to the server that has served this page.

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

async function failure(response: Response): Promise<ApiError> {
  try {
    const { error } = (await response.json()) as {
      error: { kind: string; message: string; diagnostics?: Diagnostic[] };
    };
    return new ApiError(response.status, error.kind, error.message, error.diagnostics ?? []);
  } catch {
    return new ApiError(response.status, "unknown", `The server answered with status ${response.status}.`);
  }
}

type Method = "GET" | "POST" | "PUT" | "DELETE";

/**
 * Asks the server; `body` goes as JSON, or as it is where it is a form. With `keepalive` it arrives though the page
 * is closed.
 */
export async function request<T>(
  method: Method,
  path: string,
  body?: unknown,
  signal?: AbortSignal,
  keepalive = false,
): Promise<T> {
  const form = body instanceof FormData;
  let response: Response;
  try {
    response = await fetch(`/api${path}`, {
      method,
      headers: body === undefined || form ? {} : { "content-type": "application/json" },
      body: body === undefined ? null : form ? body : JSON.stringify(body),
      signal: signal ?? null,
      keepalive,
    });
  } catch (problem) {
    if (wasAborted(problem)) throw problem;
    throw new ApiError(0, "unreachable", "The server does not answer: is `wholestring app` still running?");
  }
  if (!response.ok) throw await failure(response);
  const text = await response.text();
  return (text === "" ? undefined : JSON.parse(text)) as T;
}

/** One part of a path. */
export const part = (id: string): string => encodeURIComponent(id);
