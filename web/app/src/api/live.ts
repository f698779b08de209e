// Live strings: begin, list, rewind, branch, keep. Their motion is received over a socket: seat/connection.

import { request } from "#asked";
import { part } from "./client";
import type { KeptEntry as KeptString, LiveEntry, Scheduled } from "./types";

export type {
  KeptEntry as KeptString,
  Knob as KnobRange,
  Lamp,
  LiveEntry,
  LiveLayout as Layout,
  LiveSetPoints as SetPoints,
  LiveState,
  LiveUnit as ShownUnit,
  Pace,
  Status,
} from "./types";

export const listLive = (): Promise<LiveEntry[]> => request("GET", "/live");
export const beginLive = (id: string, text: string, operation: string | null): Promise<{ id: string }> =>
  request("POST", "/live", { case: id, text, operation });
export const endLive = (id: string): Promise<void> => request("DELETE", `/live/${part(id)}`);
export const rewindLive = (id: string, checkpoint: number, replay: boolean): Promise<void> =>
  request("POST", `/live/${part(id)}/rewind`, { checkpoint, replay });
export const branchLive = (id: string, checkpoint: number | null): Promise<{ id: string }> =>
  request("POST", `/live/${part(id)}/branch`, { checkpoint });
export const keepLive = (id: string, checkpoint: number | null): Promise<{ name: string }> =>
  request("POST", `/live/${part(id)}/keep`, { checkpoint });
export const scheduleOf = (id: string, text: string): Promise<Scheduled> =>
  request("POST", `/live/${part(id)}/schedule`, { text });
export const listKept = (): Promise<KeptString[]> => request("GET", "/kept-strings");
export const continueKept = (name: string): Promise<{ id: string }> => request("POST", `/kept-strings/${part(name)}`);
