// What stays the same as long as the program runs: the schema of the case file, units, the catalogue.

import { request } from "#asked";
import type { UnitSet } from "../settings.svelte";

/** JSON schema as the program writes it. */
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

/** A unit in which numbers are shown. */
export interface ShownUnit {
  /** As it is written in a case; null where nobody writes the dimension. */
  symbol: string | null;
  label: string;
  factor: number;
}

export interface DimensionUnits {
  /** By every way to write a unit, how much of SI it is. */
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

/** Asks once; where that fails, again the next time. */
function once<T>(path: string): () => Promise<T> {
  let asked: Promise<T> | null = null;
  return () => {
    asked ??= request<T>("GET", path).catch((problem: unknown) => {
      asked = null;
      throw problem;
    });
    return asked;
  };
}

export const readSchema = once<Schema>("/schema");
export const readUnits = once<Units>("/units");
export const searchCatalogue = (word: string, signal?: AbortSignal): Promise<Catalogue> =>
  request("GET", `/catalogue?${new URLSearchParams({ word })}`, undefined, signal);
