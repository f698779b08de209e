// History of texts for undo and redo.

/** Origin of a change: continuous typing is one step. */
export type Origin = "typing" | "edit";

/** Pause in typing that begins a new step, ms. */
const REST_MS = 1000;
/** Number of steps in the history. */
const STEPS = 500;

export class History {
  #before: string[] = [];
  #after: string[] = [];
  #typed_ms = 0;

  get canUndo(): boolean {
    return this.#before.length > 0;
  }

  get canRedo(): boolean {
    return this.#after.length > 0;
  }

  /** Records the text before a change. */
  leave(text: string, origin: Origin, now_ms: number): void {
    const goesOn = origin === "typing" && this.canUndo && now_ms - this.#typed_ms < REST_MS;
    this.#typed_ms = origin === "typing" ? now_ms : 0;
    this.#after = [];
    if (goesOn) return;
    this.#before.push(text);
    if (this.#before.length > STEPS) this.#before.shift();
  }

  /** The text before the last step. */
  undo(text: string): string | undefined {
    return this.#step(this.#before, this.#after, text);
  }

  /** The text after the undone step. */
  redo(text: string): string | undefined {
    return this.#step(this.#after, this.#before, text);
  }

  #step(from: string[], to: string[], text: string): string | undefined {
    const found = from.pop();
    if (found === undefined) return undefined;
    to.push(text);
    this.#typed_ms = 0;
    return found;
  }
}
