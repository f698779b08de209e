// Requests the results of a text; a new request cancels the previous one.

import { type Answer, answerCase, type Assembly, assemblyOf, type Broomstick, broomstickOf, type Changed } from "../api/answers";
import { wasAborted } from "../api/client";
import { settings } from "../settings.svelte";

/** Time for which a running request is not cancelled, ms, so that results appear while a slider moves. */
const LET_BE = 300;

/** Time for which the soft string waits for the stiff one, ms: drawing both at once takes half as long as one by one. */
const TOGETHER = 30;

/** Results of one text. */
export class Answering {
  readonly #id: string;
  soft = $state.raw<Answer | null>(null);
  stiff = $state.raw<Answer | null>(null);
  broomstick = $state.raw<Broomstick | null>(null);
  assembly = $state.raw<Assembly | null>(null);
  /** Error of the newest request. */
  problem = $state.raw<unknown>(null);
  /** Whether soft and stiff string of the newest request are pending. */
  solving = $state(false);
  /** Times of the requests that the soft and the stiff results belong to, on the clock of the page, ms. */
  #softSince = $state(0);
  #stiffSince = $state(0);
  /** The request that soft and stiff results belong to. */
  request = $state.raw<Changed | null>(null);
  #next: { request: Changed; operation: string | null; since: number } | null = null;
  #underWay: { abort: AbortController; since: number; text: string; urgent: boolean } | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;

  /** Time of the request that both models have answered, on the clock of the page, ms; null while they differ. */
  get since(): number | null {
    return this.#softSince === this.#stiffSince ? this.#softSince : null;
  }

  constructor(id: string) {
    this.#id = id;
  }

  /** Requests results after a pause without another request, ms. */
  ask(request: Changed, operation: string | null, pause: number): void {
    const now = performance.now();
    this.#next = { request, operation, since: now };
    this.solving = true;
    clearTimeout(this.#timer);
    const going = this.#underWay;
    let wait = pause;
    if (going?.urgent && going.text === request.text) wait = Math.max(wait, going.since + LET_BE - now);
    else going?.abort.abort();
    this.#timer = setTimeout(() => this.#start(), wait);
  }

  /** Repeats the request. */
  again(): void {
    this.#start();
  }

  /** Cancels the running request. */
  end(): void {
    clearTimeout(this.#timer);
    this.#underWay?.abort.abort();
    this.#next = null;
    this.solving = false;
  }

  /** Discards all results. */
  clear(): void {
    this.end();
    this.request = null;
    this.soft = this.stiff = null;
    this.broomstick = null;
    this.assembly = null;
    this.problem = null;
  }

  #start(): void {
    clearTimeout(this.#timer);
    this.#underWay?.abort.abort();
    if (this.#next) void this.#run(this.#next);
  }

  async #run(next: { request: Changed; operation: string | null; since: number }): Promise<void> {
    const abort = new AbortController();
    const { signal } = abort;
    const going = { abort, since: performance.now(), text: next.request.text, urgent: true };
    this.#underWay = going;
    const newest = (): boolean => this.#next === next;
    const units = settings.chosenUnits;
    try {
      // Separate requests, so that the soft string is drawn while the stiff one is solved.
      const soft = answerCase(this.#id, next.request, ["soft"], units, signal);
      const stiff = answerCase(this.#id, next.request, ["stiff"], units, signal);
      await Promise.race([stiff, soft.then(() => new Promise((wake) => setTimeout(wake, TOGETHER)))]);
      this.soft = await soft;
      settings.followCase(this.soft.set_points.units);
      this.request = next.request;
      this.#softSince = next.since;
      this.problem = null;
      this.stiff = await stiff;
      this.#stiffSince = next.since;
      if (!newest()) return this.#start();
      this.solving = false;
      // The slower requests may be cancelled at any time.
      going.urgent = false;
      this.broomstick = await broomstickOf(this.#id, next.request, signal);
      this.assembly = await assemblyOf(this.#id, next.request, next.operation, signal);
    } catch (problem) {
      if (wasAborted(problem) || signal.aborted) return;
      abort.abort();
      if (!newest()) return this.#start();
      this.problem = problem;
      this.solving = false;
    } finally {
      if (this.#underWay === going) this.#underWay = null;
    }
  }
}
