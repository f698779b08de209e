// Results of commands in the folder.

import { request } from "#asked";
import { part } from "./client";
import type { Compared, ResultsEntry as ResultsInList, ResultsView as Results } from "./types";
import type { UnitSet } from "../settings.svelte";

export type { Compared, Curve, FileView as ResultsFile, ResultsEntry as ResultsInList, ResultsView as Results } from "./types";

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
