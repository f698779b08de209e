// Results of a text while it is edited. Numbers are SI; missing ones are null.

import { request } from "#asked";
import type { UnitSet } from "../settings.svelte";
import { part } from "./client";
import type { Answer, Asked, AssemblyView as Assembly, Broomstick, StaticModel as Model, TrackColumns } from "./types";

export type {
  Answer,
  AssemblyView as Assembly,
  Broomstick,
  BroomstickCurve,
  Check,
  Column as Numbers,
  Limit,
  OperationLimits,
  OperationVerdict,
  SetPoint,
  SetPoints,
  Severity,
  Solved,
  StaticModel as Model,
  Track as Along,
  WellView as Well,
} from "./types";

/** Columns along the string for tracks. */
export const COLUMNS = [
  "tension_N",
  "torque_N_m",
  "side_force_N_per_m",
  "bending_moment_N_m",
  "von_mises_stress_Pa",
] as const satisfies readonly (keyof TrackColumns)[];
export type ColumnName = (typeof COLUMNS)[number];

/** A text with replaced values, as with `--set KEY=VALUE`. */
export type Changed = Required<Asked>;

const ask = <T>(id: string, action: string, body: object, signal: AbortSignal): Promise<T> =>
  request("POST", `/cases/${part(id)}/${action}`, body, signal);

/** `units` are those of the sentences; those of the case by default. */
export const answerCase = (id: string, changed: Changed, models: Model[], units: UnitSet | null, signal: AbortSignal): Promise<Answer> =>
  ask(id, "answer", { ...changed, models, units }, signal);
export const broomstickOf = (id: string, changed: Changed, signal: AbortSignal): Promise<Broomstick> =>
  ask(id, "broomstick", changed, signal);
export const assemblyOf = (id: string, changed: Changed, operation: string | null, signal: AbortSignal): Promise<Assembly> =>
  ask(id, "assembly", { ...changed, operation }, signal);
