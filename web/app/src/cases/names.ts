// Names of new files.

/** A name that no case of the folder has yet: `well.toml`, `well-2.toml`. */
export function freeName(wanted: string, taken: string[]): string {
  const stem = wanted.replace(/\.toml$/i, "");
  const names = new Set(taken.map((path) => path.toLowerCase()));
  for (let number = 1; ; number++) {
    const name = number === 1 ? `${stem}.toml` : `${stem}-${number}.toml`;
    if (!names.has(name.toLowerCase())) return name;
  }
}

/** The name of a file without its folder. */
export const fileName = (path: string): string => path.split("/").at(-1) ?? path;

/** A name as it is typed, with the ending of a case file. */
export const withEnding = (typed: string): string => (/\.toml$/i.test(typed.trim()) ? typed.trim() : `${typed.trim()}.toml`);
