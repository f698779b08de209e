// Texts to go back to and forth again.

/** Where a change came from: typing is one step as long as it goes on. */
export type Origin = "typing" | "edit";

/** Typing that rests for so long begins a new step, ms. */
const REST_MS = 1000;
/** So many steps are kept. */
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

  /** Notes the text that is about to be another. */
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

  /** The text after the step that was taken back. */
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
