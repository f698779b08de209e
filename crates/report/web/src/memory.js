// What the reader chose before, on any page that this browser keeps with the same memory.

const PLACE = "wholestring.";

/** What was chosen under a name, if it is one of these; browsers may refuse to remember files. */
export function remembered(name, allowed) {
  try {
    const value = localStorage.getItem(PLACE + name);
    return allowed.includes(value) ? value : null;
  } catch {
    return null;
  }
}

/** Remembers a choice, where the browser lets it. */
export function remember(name, value) {
  try {
    localStorage.setItem(PLACE + name, value);
  } catch {
    // Nothing is lost but the convenience.
  }
}
