// Results of a text while it is edited. Numbers are SI; missing ones are null.

import type { AssemblyAtRest } from "../../../components/assembly_views.ts";
import type { HoleSection, StringPart } from "../../../components/schematic.ts";
import { request } from "#asked";
import type { UnitSet } from "../settings.svelte";
import { part } from "./client";

/** Numbers of a column. */
export type Numbers = (number | null)[];

export type Severity = "ok" | "note" | "warning" | "error";

/** A check of an operation. */
export interface Check {
  kind: string;
  severity: Severity;
  md_m: number | null;
  to_md_m: number | null;
  sentence: string;
}

export type Model = "soft" | "stiff";

/** An operation by a model. */
export interface Solved {
  model: Model;
  operation: string;
  status: "complete" | "interrupted" | "failed";
  /** Reason why it has no answer. */
  message?: string;
  checks: Check[];
  hook_load_N: number | null;
  surface_torque_N_m: number | null;
  axial_friction_N: number | null;
  side_force_total_N: number | null;
  neutral_point_m: number | null;
  stretch_m: number | null;
}

/** Columns along the string for tracks. */
export const COLUMNS = [
  "tension_N",
  "torque_N_m",
  "side_force_N_per_m",
  "bending_moment_N_m",
  "von_mises_stress_Pa",
] as const;
export type ColumnName = (typeof COLUMNS)[number];

/** Values along the string; columns that a model does not compute are left out. */
export interface Along extends Partial<Record<ColumnName, Numbers>> {
  model: Model;
  operation: string;
  md_m: Numbers;
}

export interface Well {
  md_m: Numbers;
  north_m: Numbers;
  east_m: Numbers;
  tvd_m: Numbers;
  inclination_rad: Numbers;
  azimuth_rad: Numbers;
  dogleg_severity_rad_per_m: Numbers;
  hole: HoleSection[];
  string: StringPart[];
}

/** A load and its capacity; `reserve` is the relative increase of the load up to the limit. */
export interface Limit {
  kind: string;
  label: string;
  component: string | null;
  md_m: number | null;
  dimension: string;
  load: number;
  capacity: number;
  required: number;
  reserve: number;
  verdict: string;
  severity: Severity;
  sentence: string;
}

export interface OperationLimits {
  operation: string;
  limits: Limit[];
  unchecked: { missing: string; components: string[] }[];
}

/** A value that can be replaced without changing the text. */
export interface SetPoint {
  key: string;
  label: string;
  dimension: string;
  now: number;
  range: [number, number];
}

export interface SetPoints {
  values: SetPoint[];
  sections: { label: string; friction: number }[];
  /** Reason why one friction cannot be set for all sections; null if it can. */
  no_uniform_friction: string | null;
  /** Units of the case. */
  units: UnitSet;
}

/** The verdict on an operation by a model, in words. */
export interface OperationVerdict {
  model: Model;
  operation: string;
  severity: Severity;
  words: string;
}

export interface Answer {
  operations: Solved[];
  tracks: Along[];
  well: Well;
  limits: OperationLimits[];
  set_points: SetPoints;
  verdicts: OperationVerdict[];
  took_s: number;
}

export interface BroomstickCurve {
  operation: string;
  friction: "low" | "expected" | "high";
  bit_depth_m: Numbers;
  hook_load_N: Numbers;
  surface_torque_N_m: Numbers;
}

export interface Broomstick {
  curves: BroomstickCurve[];
  frictions: { name: string; coefficients: number[] }[];
  hoist_N: number | null;
  top_drive_N_m: number | null;
  took_s: number;
}

export interface Assembly extends AssemblyAtRest {
  operation: string;
  bit_depth_m: number;
  weight_on_bit_N: number;
  inclination_rad: number;
  toolface_rad: number | null;
  side_force_N: [number, number];
  tilt_rad: [number, number];
  took_s: number;
}

/** A text with replaced values, as with `--set KEY=VALUE`. */
export interface Changed {
  text: string;
  set: Record<string, string>;
}

const ask = <T>(id: string, action: string, body: object, signal: AbortSignal): Promise<T> =>
  request("POST", `/cases/${part(id)}/${action}`, body, signal);

/** `units` are those of the sentences; those of the case by default. */
export const answerCase = (id: string, changed: Changed, models: Model[], units: UnitSet | null, signal: AbortSignal): Promise<Answer> =>
  ask(id, "answer", { ...changed, models, units }, signal);
export const broomstickOf = (id: string, changed: Changed, signal: AbortSignal): Promise<Broomstick> =>
  ask(id, "broomstick", changed, signal);
export const assemblyOf = (id: string, changed: Changed, operation: string | null, signal: AbortSignal): Promise<Assembly> =>
  ask(id, "assembly", { ...changed, operation }, signal);
