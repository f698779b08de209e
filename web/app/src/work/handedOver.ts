// Files that were dropped on another screen, on their way to the import.

let files: File[] = [];

/** Keeps files for the import, which takes them when it is shown. */
export function handOver(dropped: File[]): void {
  files = dropped;
}

/** Gives them, once. */
export function taken(): File[] {
  const given = files;
  files = [];
  return given;
}
