// Messages between the page and a worker.

import type { Call, Left } from "./engine";

/** Messages from the page. The module is the first, sent once. */
export type ToWorker =
  | { module: WebAssembly.Module }
  | { number: number; call: Call; request: string; bytes?: ArrayBuffer }
  /** Attaches a viewer to the live string. */
  | { attend: true }
  /** Message of the page to the live string. */
  | { say: string }
  /** The page has processed the last message, and can receive the next. */
  | { taken: true };

/** Messages from a worker. */
export type FromWorker = ({ number: number } & Left) | { number: number; ended: string } | { message: string | ArrayBuffer } | { ended: string };
