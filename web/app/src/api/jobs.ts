// Jobs started from the page: commands of the command line on a saved case.

import { request } from "#asked";
import { part } from "./client";

export type Work =
  | { kind: "run"; models: string[]; csv: boolean }
  | { kind: "plan"; overlay: string | null }
  | {
      kind: "reach";
      from: string | null;
      to: string | null;
      frictions: number[];
      operations: string[];
      no_helix_friction: boolean;
    }
  | {
      kind: "bha";
      operation: string | null;
      whole: boolean;
      toolface: string | null;
      weight: string | null;
      inclination: string | null;
      build: string | null;
    }
  | { kind: "modes"; operation: string | null }
  | {
      kind: "calibrate";
      data: string;
      one_factor: boolean;
      by_section: boolean;
      friction_around: boolean;
      block_weight: boolean;
      bit_torque: boolean;
      hold: string[];
      model: string;
      check_dynamics: boolean;
    }
  | { kind: "sweep"; vary: string[]; keep: string | null }
  | { kind: "study"; study: string }
  | { kind: "bit_test" };

export type IfThere = "protect" | "resume" | "overwrite";

export interface JobRequest {
  /** The id of the case; null for a study. */
  case?: string;
  work: Work;
  set?: Record<string, string>;
  if_there?: IfThere;
}

/** A running operation. */
export interface Bar {
  title: string;
  /** Preparation before the simulated time begins; null afterwards. */
  preparing: string | null;
  reached_s: number;
  end_s: number;
  settling: boolean;
  left_s: number | null;
}

/** Cases, points or samples. */
export interface Batch {
  of: number;
  ended: number;
  /** From 0 to 1. */
  part: number;
  left_s: number | null;
}

/** A check that needs attention, once for all its places. */
export interface FoundCheck {
  severity: string;
  kind: string;
  name: string;
  sentence: string;
  times: number;
}

export interface Progress {
  bars: Bar[];
  batch: Batch | null;
  notes: string[];
  warnings: string[];
  checks: FoundCheck[];
}

export type JobState = "waiting" | "running" | "finished" | "stopped" | "interrupted" | "failed" | "refused";

export interface Job {
  id: string;
  request: JobRequest;
  command: string;
  title: string;
  path: string;
  state: JobState;
  created_ms: number;
  started_ms: number | null;
  ended_ms: number | null;
  folder: string | null;
  message: string | null;
  refusal: "unfinished" | "occupied" | "busy" | "not_resumable" | null;
  /** The id of its results. */
  results: string | null;
  resumable: boolean;
  progress: Progress;
}

/** A file of the folder. */
export interface FileEntry {
  id: string;
  path: string;
}

/** Whether a job is waiting or running. */
export const isOpen = (job: Job): boolean => job.state === "waiting" || job.state === "running";

export const listJobs = (): Promise<Job[]> => request("GET", "/jobs");
export const startJob = (job: JobRequest): Promise<{ id: string }> => request("POST", "/jobs", job);
export const stopJob = (id: string): Promise<void> => request("POST", `/jobs/${part(id)}/stop`);
export const resumeJob = (id: string): Promise<void> => request("POST", `/jobs/${part(id)}/resume`);
export const forgetJob = (id: string): Promise<void> => request("DELETE", `/jobs/${part(id)}`);
/** Address of the events of a job. */
export const eventsOf = (id: string): string => `/api/jobs/${part(id)}/events`;
export const listStudies = (): Promise<FileEntry[]> => request("GET", "/studies");
export const listReadings = (): Promise<FileEntry[]> => request("GET", "/readings");
