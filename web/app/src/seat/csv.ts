// Samples for a spreadsheet.

import type { Layout } from "../api/live";
import type { Samples } from "./samples";

/** The last seconds of samples in SI units, a line per sample; missing values are empty. */
export function csvOf(layout: Layout, samples: Samples, seconds: number): string {
  const first = Math.max(samples.first, samples.next - Math.round(seconds / samples.interval_s));
  const lines = [["time_s", ...layout.samples.map((channel) => channel.name)].join(",")];
  for (let number = first; number < samples.next; number++) {
    const place = samples.place(number);
    const values = samples.columns.map((column) => (Number.isFinite(column[place]!) ? String(column[place]!) : ""));
    lines.push([samples.time(number).toFixed(6), ...values].join(","));
  }
  return `${lines.join("\n")}\n`;
}

/** Downloads a file to the user. */
export function download(name: string, text: string): void {
  const address = URL.createObjectURL(new Blob([text], { type: "text/csv" }));
  const link = document.createElement("a");
  [link.href, link.download] = [address, name];
  link.click();
  URL.revokeObjectURL(address);
}
