// Jobs started from the page: commands of the command line on a saved case.

import { request } from "#asked";
import { part } from "./client";
import type { FileEntry, JobRequest, JobView as Job } from "./types";

export type {
  Bar,
  FileEntry,
  Found as FoundCheck,
  Existing as IfThere,
  JobRequest,
  JobView as Job,
  Progress,
  State as JobState,
  Work,
} from "./types";

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
