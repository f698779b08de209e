// Values that replace those of the text while one asks what would be.

import type { SetPoint } from "../api/answers";
import { written } from "./units";
import type { Change } from "../api/cases";

/** A key of the case and the value that it would get. */
export type KeyValue = readonly [key: string, value: string];

/** What a key of `--set` is called in the file. */
const IN_FILE: Record<string, string> = {
  bit_depth: "operation.bit_depth",
  rpm: "operation.rpm",
  wob: "operation.wob",
};

export class WhatIf {
  /** Values by key, SI. */
  values = $state.raw<Readonly<Record<string, number>>>({});

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

  /** What the server is told. */
  set(points: readonly SetPoint[]): Record<string, string> {
    const told = points.flatMap(({ key, dimension }) => {
      const value = this.values[key];
      return value === undefined ? [] : [[key, written(value, dimension)]];
    });
    return Object.fromEntries(told) as Record<string, string>;
  }

  /** Keys and values for the file: friction stands in each of its sections. */
  changes(points: readonly SetPoint[], sections: number): KeyValue[] {
    return Object.entries(this.set(points)).flatMap(([key, value]): KeyValue[] => {
      if (key !== "friction") return [[IN_FILE[key] ?? key, value]];
      return Array.from({ length: sections }, (_, i): KeyValue => [`well.hole.${i}.friction`, value]);
    });
  }
}

/** A bare number is a number in the file, too. */
const asValue = (text: string): string | number => (/^-?[\d.]+(e[-+]?\d+)?$/i.test(text) ? Number(text) : text);

/** The changes of a case's text that give it these values. */
export const editsOf = (changes: readonly KeyValue[]): Change[] => changes.map(([set, to]) => ({ set, to: asValue(to) }));
