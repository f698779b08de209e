// Differing lines of two texts.

export interface Line {
  /** Side of the line; " " for a line on both sides. */
  side: "-" | "+" | " ";
  text: string;
}

/** Number of lines above which texts are compared roughly, by their common beginning and end. */
const MOST = 3000;

/** The lines of two texts: `-` only in the first, `+` only in the second. */
export function difference(first: string, second: string): Line[] {
  const [a, b] = [first.split("\n"), second.split("\n")];
  let from = 0;
  while (from < Math.min(a.length, b.length) && a[from] === b[from]) from += 1;
  let same = 0;
  while (same < Math.min(a.length, b.length) - from && a.at(-1 - same) === b.at(-1 - same)) same += 1;
  const middle = between(a.slice(from, a.length - same), b.slice(from, b.length - same));
  const both = (lines: string[]) => lines.map((text): Line => ({ side: " ", text }));
  return [...both(a.slice(0, from)), ...middle, ...both(a.slice(a.length - same))];
}

/** By the longest common subsequence. */
function between(a: string[], b: string[]): Line[] {
  const minus = (text: string): Line => ({ side: "-", text });
  const plus = (text: string): Line => ({ side: "+", text });
  if (a.length > MOST || b.length > MOST) return [...a.map(minus), ...b.map(plus)];
  const width = b.length + 1;
  const longest = new Uint16Array((a.length + 1) * width);
  const at = (i: number, j: number) => longest[i * width + j] ?? 0;
  for (let i = a.length - 1; i >= 0; i--)
    for (let j = b.length - 1; j >= 0; j--)
      longest[i * width + j] = a[i] === b[j] ? at(i + 1, j + 1) + 1 : Math.max(at(i + 1, j), at(i, j + 1));
  const lines: Line[] = [];
  let [i, j] = [0, 0];
  while (i < a.length || j < b.length) {
    if (i < a.length && j < b.length && a[i] === b[j]) {
      lines.push({ side: " ", text: a[i]! });
      i += 1;
      j += 1;
    } else if (j >= b.length || (i < a.length && at(i + 1, j) >= at(i, j + 1))) lines.push(minus(a[i++]!));
    else lines.push(plus(b[j++]!));
  }
  return lines;
}

/** Differing lines with a line or two around them; null in place of omitted lines. */
export function shortened(lines: Line[], around = 2): (Line | null)[] {
  const near = lines.map((_, index) => lines.slice(Math.max(0, index - around), index + around + 1).some(({ side }) => side !== " "));
  return lines.flatMap((line, index) => (near[index] ? [line] : near[index - 1] || index === 0 ? [null] : []));
}
