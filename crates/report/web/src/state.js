// What the reader has chosen, and who wants to know.

const listeners = new Map();

/**
 * The choices: units, theme, operation, interval of depth and time in view (null for all), depth and time pointed at, and
 * the names of curves that are hidden.
 */
export const state = {
  units: "si",
  theme: "auto",
  operation: null,
  depths: null,
  times: null,
  depth: null,
  moment: null,
  pointer: null,
  hidden: new Set(),
};

/** Calls `listener` whenever one of the choices changes. */
export function on(names, listener) {
  for (const name of names.split(" ")) {
    if (!listeners.has(name)) listeners.set(name, []);
    listeners.get(name).push(listener);
  }
}

/** Makes a choice. */
export function choose(changes) {
  const called = new Set();
  for (const [name, value] of Object.entries(changes)) {
    if (Object.is(state[name], value)) continue;
    state[name] = value;
    for (const listener of listeners.get(name) ?? []) called.add(listener);
  }
  called.forEach(each);
}

/** Calls one of several that need nothing of each other: where it fails, that is reported and the others go on. */
export function each(call) {
  try {
    call();
  } catch (error) {
    reportError(error);
  }
}
