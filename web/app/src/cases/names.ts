// Names of new files.

/** A name that is not in use in the folder: `well.toml`, `well-2.toml`. */
export function freeName(name: string, taken: string[]): string {
  const stem = name.replace(/\.toml$/i, "");
  const names = new Set(taken.map((path) => path.toLowerCase()));
  for (let number = 1; ; number++) {
    const name = number === 1 ? `${stem}.toml` : `${stem}-${number}.toml`;
    if (!names.has(name.toLowerCase())) return name;
  }
}

/** The name of a file without its folder. */
export const fileName = (path: string): string => path.split("/").at(-1) ?? path;

/** A typed name with the extension of a case file. */
export const withEnding = (typed: string): string => (/\.toml$/i.test(typed.trim()) ? typed.trim() : `${typed.trim()}.toml`);
