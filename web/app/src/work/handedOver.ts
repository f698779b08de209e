// Files that were dropped on another screen, on their way to the import.

let files: File[] = [];

/** Stores files for the import, which takes them when displayed. */
export function handOver(dropped: File[]): void {
  files = dropped;
}

/** Returns the files, once. */
export function taken(): File[] {
  const taken = files;
  files = [];
  return taken;
}
