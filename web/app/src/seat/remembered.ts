// Choices of the driller's seat, stored in this browser.

const PREFIX = "wholestring.seat.";

/** The stored choice if it is known, or the usual one. */
export function remembered<T extends string>(name: string, known: readonly T[], usual: T): T {
  try {
    const stored = localStorage.getItem(PREFIX + name);
    return known.find((value) => value === stored) ?? usual;
  } catch {
    return usual;
  }
}

export function remember(name: string, value: string): void {
  try {
    localStorage.setItem(PREFIX + name, value);
  } catch {
    // Without storage in the browser, the choice applies until the page is closed.
  }
}
