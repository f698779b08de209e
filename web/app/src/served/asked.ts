// Requests of the page to its server.

import { ApiError, wasAborted, type Diagnostic, type Method } from "../api/client";
import type { Line } from "../api/line";

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

/**
 * Sends a request to the server; `body` is sent as JSON, or unchanged if it is a form. With `keepalive` it is
 * delivered even if the page is closed.
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

/** The connection to a live string. */
export function lineTo(id: string): Line {
  const scheme = location.protocol === "https:" ? "wss" : "ws";
  const socket = new WebSocket(`${scheme}://${location.host}/api/live/${encodeURIComponent(id)}/socket`);
  socket.binaryType = "arraybuffer";
  return socket;
}
