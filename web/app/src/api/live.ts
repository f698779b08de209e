// Live strings: begin, list, rewind, branch, keep. Their motion is received over a socket: seat/connection.

import type { HoleSection } from "../../../components/schematic.ts";
import { request } from "#asked";
import type { Severity } from "./answers";
import { part } from "./client";

export interface LiveEntry {
  id: string;
  case: string;
  name: string;
  operation: string;
  state: LiveState;
  sentence: string | null;
  time_s: number;
  viewers: number;
}

export type LiveState = "paused" | "running" | "failed" | "ended";
export type Pace = number | "max";

/** Set points in SI units; those that are left out are not changed. */
export interface SetPoints {
  rotary_speed_rad_per_s?: number;
  block_velocity_m_per_s?: number;
  weight_on_bit_N?: number;
  flow_rate_m3_per_s?: number;
  friction?: number;
  controller?: string;
  ramp_s?: number;
}

export interface Channel {
  name: string;
  label: string;
  dimension: string;
  meaning: string;
}

export interface ShownUnit {
  symbol: string;
  factor: number;
}

export interface KnobRange {
  low: number;
  high: number;
  begins: number;
}

export interface Knobs {
  rotary_speed_rad_per_s: KnobRange | null;
  block_velocity_m_per_s: KnobRange | null;
  weight_on_bit_N: KnobRange | null;
  flow_rate_m3_per_s: KnobRange | null;
  friction: KnobRange | null;
  controllers: string[];
}

/** Data that a viewer requires before the first frame. */
export interface Layout {
  id: string;
  case: string;
  name: string;
  operation: string;
  sample_interval_s: number;
  samples_kept: number;
  elements: number;
  torsional_travel_s: number;
  samples: Channel[];
  frame: Channel[];
  units: Record<string, [ShownUnit, ShownUnit, ShownUnit]>;
  contact_radius_m: number[];
  path: { md_m: number[]; north_m: number[]; east_m: number[]; tvd_m: number[]; high: [number[], number[], number[]] };
  hole: HoleSection[];
  knobs: Knobs;
}

export interface Checkpoint {
  number: number;
  time_s: number;
}

interface Whirl {
  md_m: number;
  ratio: number;
  length_fraction: number;
}

export interface Lamps {
  stick_slip: { severity: number | null; period_s: number | null; stuck_fraction: number } | null;
  backward_whirl: Whirl | null;
  forward_whirl: Whirl | null;
  top_drive_stalls: boolean;
  torque_use: number | null;
  /** Severities; null if not evaluated. */
  stick_slip_severity: Severity | null;
  whirl_severity: Severity | null;
  top_drive_severity: Severity | null;
}

export interface Status {
  state: LiveState;
  sentence: string | null;
  time_s: number;
  pace: Pace;
  reached: number;
  checkpoints: Checkpoint[];
  events: number;
  replaying: number;
  friction: number[];
  controller: string | null;
  lamps: Lamps;
  viewers: number;
}

export interface KeptString {
  name: string;
  case: string;
  title: string;
  operation: string;
  time_s: number;
  modified_ms: number;
}

export interface Scheduled {
  text: string;
  lines: number;
  left_out: string[];
}

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
