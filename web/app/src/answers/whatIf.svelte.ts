// Modified values that replace those of the text.

import type { SetPoint } from "../api/answers";
import { written } from "./units";

/** The two ways to change friction, used one at a time. */
export const FRICTIONS = ["friction_multiplier", "friction"] as const;
export type FrictionKey = (typeof FRICTIONS)[number];

const isFriction = (key: string): boolean => FRICTIONS.some((one) => one === key);

export class WhatIf {
  /** Values by key, SI. */
  values = $state.raw<Readonly<Record<string, number>>>({});
  /** Way to change friction: multiply the factor of each section, or set one factor for all. */
  friction = $state<FrictionKey>("friction_multiplier");

  get isUsed(): boolean {
    return Object.keys(this.values).length > 0;
  }

  put(key: string, value: number): void {
    this.values = { ...this.values, [key]: value };
  }

  drop(key: string): void {
    const { [key]: _, ...rest } = this.values;
    this.values = rest;
  }

  reset(): void {
    this.values = {};
  }

  /** Selects a way to change friction; values of the other way are dropped. */
  chooseFriction(key: FrictionKey): void {
    this.friction = key;
    for (const other of FRICTIONS) if (other !== key) this.drop(other);
  }

  /** Whether a point is displayed: for friction, only that of the selected way. */
  shows = ({ key }: SetPoint): boolean => !isFriction(key) || key === this.friction;

  /** The values sent with requests. */
  set(points: readonly SetPoint[]): Record<string, string> {
    const pairs = points.flatMap(({ key, dimension }) => {
      const value = this.values[key];
      return value === undefined ? [] : [[key, written(value, dimension)]];
    });
    return Object.fromEntries(pairs) as Record<string, string>;
  }
}
