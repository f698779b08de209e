// Constants while the program runs: the schema of the case file, units, the catalogue.

import { request } from "#asked";
import type { Catalogue, DimensionUnits } from "./types";

export type { CasingEntry, Catalogue, ShownUnit, Tubular } from "./types";

/** JSON schema from the program. */
export interface Schema {
  type?: string | string[];
  title?: string;
  description?: string;
  default?: unknown;
  const?: string;
  enum?: string[];
  anyOf?: Schema[];
  items?: Schema;
  prefixItems?: Schema[];
  minItems?: number;
  properties?: Record<string, Schema>;
  required?: string[];
  examples?: string[];
  "x-order"?: string[];
  "x-dimension"?: string;
  "x-unit"?: string;
}

/** Units of each dimension by its name. */
export type Units = Record<string, DimensionUnits>;

/** Sends a request once; after a failure, again the next time. */
function once<T>(path: string): () => Promise<T> {
  let pending: Promise<T> | null = null;
  return () => {
    pending ??= request<T>("GET", path).catch((problem: unknown) => {
      pending = null;
      throw problem;
    });
    return pending;
  };
}

export const readSchema = once<Schema>("/schema");
export const readUnits = once<Units>("/units");
export const searchCatalogue = (word: string, signal?: AbortSignal): Promise<Catalogue> =>
  request("GET", `/catalogue?${new URLSearchParams({ word })}`, undefined, signal);
