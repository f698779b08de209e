// Keys that the screen in view answers to; `?` lists them.

import { untrack } from "svelte";

/** A key as people read it, and what it does. */
export interface KeyHelp {
  keys: string;
  does: string;
}

interface Shortcut extends KeyHelp {
  matches: (event: KeyboardEvent) => boolean;
  run: () => void;
}

let shortcuts = $state.raw<Shortcut[]>([]);
let notes = $state.raw<KeyHelp[]>([]);

const command = (event: KeyboardEvent) => event.ctrlKey || event.metaKey;
const typing = (event: KeyboardEvent) =>
  event.target instanceof HTMLElement &&
  (event.target.isContentEditable || ["INPUT", "TEXTAREA", "SELECT"].includes(event.target.tagName));

/**
 * Answers to `key`; with Ctrl (or Cmd) where `ctrl`, and else only where nobody writes. Gives what ends it: return it
 * from an effect.
 */
export function onKey(key: string, does: string, run: () => void, ctrl = false, shift = false): () => void {
  const keys = [ctrl && "Ctrl", shift && "Shift", key.length === 1 ? key.toUpperCase() : key].filter(Boolean).join(" + ");
  const shortcut: Shortcut = {
    keys,
    does,
    run,
    matches: (event) =>
      event.key.toLowerCase() === key.toLowerCase() &&
      (ctrl ? command(event) && event.shiftKey === shift : !command(event) && !event.altKey && !typing(event)),
  };
  // The effect that adds it does not follow the others.
  shortcuts = [...untrack(() => shortcuts), shortcut];
  return () => {
    shortcuts = shortcuts.filter((other) => other !== shortcut);
  };
}

/** Tells `?` of keys that a part of the screen answers to by itself. */
export function tellKeys(told: KeyHelp[]): () => void {
  notes = [...untrack(() => notes), ...told];
  return () => {
    notes = notes.filter((note) => !told.includes(note));
  };
}

/** Every key of the screen in view. */
export const keyHelp = {
  get all(): KeyHelp[] {
    return [...shortcuts, ...notes];
  },
};

addEventListener("keydown", (event) => {
  const found = shortcuts.find((shortcut) => shortcut.matches(event));
  if (!found || event.defaultPrevented) return;
  event.preventDefault();
  found.run();
});
