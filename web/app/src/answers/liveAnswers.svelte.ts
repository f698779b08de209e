// The answers of a case that the parts of its screen share: those of the text, those with modified values, and the
// place that the reader looks at.

import type { Check, Model } from "../api/answers";
import { Answering } from "./answering.svelte";
import { WhatIf } from "./whatIf.svelte";

/** A check with its operation and model. */
export interface StripCheck extends Check {
  operation: string;
  model: Model;
}

/** Severities of the judge, the most severe first. */
const SEVERITIES = ["error", "warning", "note", "ok"];

/** Capacity over load and required factor. Without it, a state that needs attention comes first, any other last. */
const margin = ({ factor, required, severity }: Check): number =>
  factor === null || required === null ? (severity === "ok" ? Infinity : 0) : factor / required;

export class LiveAnswers {
  readonly id: string;
  readonly own: Answering;
  readonly changed: Answering;
  readonly whatIf = new WhatIf();
  /** The operation in view; null for the last. */
  chosen = $state<string | null>(null);
  /** Depth of the cursor on the tracks, m. */
  pointer = $state<number | null>(null);
  /** Number of times that a depth was sought on the tracks. */
  seeks = $state(0);

  constructor(id: string) {
    this.id = id;
    this.own = new Answering(id);
    this.changed = new Answering(id);
  }

  /** Answers in view. */
  get now(): Answering {
    return this.whatIf.isUsed && this.changed.request !== null ? this.changed : this.own;
  }

  /** Answers for comparison. */
  get before(): Answering | null {
    return this.now === this.changed ? this.own : null;
  }

  /** Answers that are computed next. */
  get pending(): Answering {
    return this.whatIf.isUsed ? this.changed : this.own;
  }

  /** Checks of all operations, the most severe first; for each operation and kind the first one of the server. */
  get checks(): StripCheck[] {
    const { soft, stiff } = this.now;
    const operations = [soft, stiff].flatMap((answer) => answer?.operations ?? []);
    const all = operations.flatMap(({ checks, operation, model }) => checks.map((check): StripCheck => ({ ...check, operation, model })));
    const rank = ({ severity }: Check): number => SEVERITIES.indexOf(severity);
    const sorted = all.sort((one, other) => rank(one) - rank(other) || (margin(one) === margin(other) ? 0 : margin(one) - margin(other)));
    const seen = new Set<string>();
    return sorted.filter(({ operation, kind, severity }) => {
      const name = `${operation} ${kind} ${severity}`;
      return seen.size < seen.add(name).size;
    });
  }

  /** Shows the place of a check on the tracks of its operation. */
  seek({ operation, md_m }: StripCheck): void {
    this.chosen = operation;
    if (md_m === null) return;
    this.pointer = md_m;
    this.seeks += 1;
  }

  /** Cancels all requests. */
  end(): void {
    this.own.end();
    this.changed.end();
  }
}
