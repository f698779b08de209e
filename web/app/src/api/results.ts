// Results of commands in the folder.

import { request } from "#asked";
import { part } from "./client";
import type { FoundCheck } from "./jobs";
import type { UnitSet } from "../settings.svelte";

export interface ResultsInList {
  id: string;
  path: string;
  kind: string;
  name: string;
  modified_ms: number;
  engine_version: string | null;
  unfinished: boolean;
  errors: number;
  warnings: number;
  notes: number;
  has_page: boolean;
}

export interface ResultsFile {
  id: string;
  path: string;
  bytes: number;
  is_page: boolean;
}

export interface Results extends ResultsInList {
  checks: FoundCheck[];
  files: ResultsFile[];
}

export interface Curve {
  /** Index of the results, from 0. */
  result: number;
  of: string;
  quantity: string;
  unit: string;
  depth_unit: string;
  against: string;
  depth: (number | null)[];
  value: (number | null)[];
}

export interface Compared {
  results: ResultsInList[];
  inputs: { key: string; values: (string | null)[] }[];
  scalars: { of: string; label: string; unit: string; values: (number | null)[] }[];
  curves: Curve[];
}

export const listResults = (): Promise<ResultsInList[]> => request("GET", "/results");
export const readResults = (id: string): Promise<Results> => request("GET", `/results/${part(id)}`);
export const compareResults = (ids: string[], units: UnitSet, signal?: AbortSignal): Promise<Compared> =>
  request("GET", `/compare?${new URLSearchParams({ ids: ids.join(","), units })}`, undefined, signal);
/** Download address of a file. */
export const fileAddress = (results: string, file: string): string =>
  `/api/results/${part(results)}/files/${part(file)}`;
/** Address of a page for a frame. */
export const pageAddress = (results: string, file: string): string =>
  `/api/results/${part(results)}/pages/${part(file)}`;
