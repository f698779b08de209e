// Keys of the current screen; `?` lists them.

import { untrack } from "svelte";

/** A key in readable form, and its effect. */
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
 * Handles `key`, with Ctrl (or Cmd) if `ctrl`; otherwise only outside text fields. Returns the function that ends
 * this, to be returned from an effect.
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
  // Untracked, so that the effect does not depend on other keys.
  shortcuts = [...untrack(() => shortcuts), shortcut];
  return () => {
    shortcuts = shortcuts.filter((other) => other !== shortcut);
  };
}

/** Adds keys that a part of the screen handles itself to the list of `?`. */
export function tellKeys(added: KeyHelp[]): () => void {
  notes = [...untrack(() => notes), ...added];
  return () => {
    notes = notes.filter((note) => !added.includes(note));
  };
}

/** All keys of the current screen. */
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
