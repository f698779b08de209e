// What the page and a worker say to each other.

import type { Call, Left } from "./engine";

/** From the page. The module comes first, once. */
export type ToWorker =
  | { module: WebAssembly.Module }
  | { number: number; call: Call; request: string; bytes?: ArrayBuffer }
  /** Somebody looks at the live string from now on. */
  | { attend: true }
  /** What the page says to the live string. */
  | { say: string }
  /** The page has taken what it was given: more may come. */
  | { taken: true };

/** From a worker. */
export type FromWorker = ({ number: number } & Left) | { number: number; ended: string } | { told: string | ArrayBuffer } | { ended: string };
