// Asks for the answers of a text, the newest first: of what was asked before nobody wants to know any more.

import { type Answer, answerCase, type Assembly, assemblyOf, type Broomstick, broomstickOf, type Changed } from "../api/answers";
import { wasAborted } from "../api/client";
import { settings } from "../settings.svelte";

/** What is under way is let be for so long, ms, or who moves a slider would never see an answer. */
const LET_BE = 300;

/** So long a soft string waits for the stiff one, ms: to draw both at once takes half of the time that each alone takes. */
const TOGETHER = 30;

/** What was found of one text. */
export class Answering {
  readonly #id: string;
  soft = $state.raw<Answer | null>(null);
  stiff = $state.raw<Answer | null>(null);
  broomstick = $state.raw<Broomstick | null>(null);
  assembly = $state.raw<Assembly | null>(null);
  /** Why the newest has no answer. */
  problem = $state.raw<unknown>(null);
  /** Whether soft and stiff string of the newest are still to come. */
  solving = $state(false);
  /** When what soft and stiff string are of was asked for, on the page's clock, ms. */
  #softSince = $state(0);
  #stiffSince = $state(0);
  /** What soft and stiff string are of. */
  of = $state.raw<Changed | null>(null);
  #wanted: { of: Changed; operation: string | null; since: number } | null = null;
  #underWay: { abort: AbortController; since: number; text: string; urgent: boolean } | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;

  /** When the answer was asked for that both models have, on the page's clock, ms; null while one of them is of another. */
  get since(): number | null {
    return this.#softSince === this.#stiffSince ? this.#softSince : null;
  }

  constructor(id: string) {
    this.#id = id;
  }

  /** Wants the answers of this, after a pause in which nothing else is wanted, ms. */
  ask(of: Changed, operation: string | null, pause: number): void {
    const now = performance.now();
    this.#wanted = { of, operation, since: now };
    this.solving = true;
    clearTimeout(this.#timer);
    const going = this.#underWay;
    let wait = pause;
    if (going?.urgent && going.text === of.text) wait = Math.max(wait, going.since + LET_BE - now);
    else going?.abort.abort();
    this.#timer = setTimeout(() => this.#start(), wait);
  }

  /** Asks once more. */
  again(): void {
    this.#start();
  }

  /** Gives up what is under way. */
  end(): void {
    clearTimeout(this.#timer);
    this.#underWay?.abort.abort();
    this.#wanted = null;
    this.solving = false;
  }

  /** Forgets what was found. */
  clear(): void {
    this.end();
    this.of = null;
    this.soft = this.stiff = null;
    this.broomstick = null;
    this.assembly = null;
    this.problem = null;
  }

  #start(): void {
    clearTimeout(this.#timer);
    this.#underWay?.abort.abort();
    if (this.#wanted) void this.#run(this.#wanted);
  }

  async #run(wanted: { of: Changed; operation: string | null; since: number }): Promise<void> {
    const abort = new AbortController();
    const { signal } = abort;
    const going = { abort, since: performance.now(), text: wanted.of.text, urgent: true };
    this.#underWay = going;
    const newest = (): boolean => this.#wanted === wanted;
    const units = settings.chosenUnits;
    try {
      // Apart, so that the soft string is drawn while the stiff one is solved.
      const soft = answerCase(this.#id, wanted.of, ["soft"], units, signal);
      const stiff = answerCase(this.#id, wanted.of, ["stiff"], units, signal);
      await Promise.race([stiff, soft.then(() => new Promise((wake) => setTimeout(wake, TOGETHER)))]);
      this.soft = await soft;
      settings.followCase(this.soft.set_points.units);
      this.of = wanted.of;
      this.#softSince = wanted.since;
      this.problem = null;
      this.stiff = await stiff;
      this.#stiffSince = wanted.since;
      if (!newest()) return this.#start();
      this.solving = false;
      // What takes longer may be given up at once.
      going.urgent = false;
      this.broomstick = await broomstickOf(this.#id, wanted.of, signal);
      this.assembly = await assemblyOf(this.#id, wanted.of, wanted.operation, signal);
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
