// Constants while the program runs: the schema of the case file, units, the catalogue.

import { request } from "#asked";
import type { UnitSet } from "../settings.svelte";

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

/** A unit for the display of numbers. */
export interface ShownUnit {
  /** Symbol in case files; null if the dimension is not used in them. */
  symbol: string | null;
  label: string;
  factor: number;
}

export interface DimensionUnits {
  /** SI factors by every spelling of a unit. */
  factors: Record<string, number>;
  shown: Record<UnitSet, ShownUnit>;
}

export type Units = Record<string, DimensionUnits>;

export interface Tubular {
  name: string;
  kind: string;
  od_m: number;
  id_m: number;
  mass_per_length_kg_per_m: number;
  yield_strength_Pa: number;
  connection: string | null;
}

export interface CasingEntry {
  name: string;
  od_m: number;
  id_m: number;
  drift_m: number;
  mass_per_length_kg_per_m: number;
}

export interface Catalogue {
  string: Tubular[];
  casings: CasingEntry[];
}

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
