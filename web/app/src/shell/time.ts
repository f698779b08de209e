// Times in readable form.

/** `09:14` of today, `23 November, 09:14` of another day. */
export function timeText(milliseconds: number): string {
  const moment = new Date(milliseconds);
  const time = moment.toLocaleTimeString("en-GB", { hour: "2-digit", minute: "2-digit" });
  if (moment.toDateString() === new Date().toDateString()) return time;
  const year = moment.getFullYear() === new Date().getFullYear() ? {} : ({ year: "numeric" } as const);
  return `${moment.toLocaleDateString("en-GB", { day: "numeric", month: "long", ...year })}, ${time}`;
}

/** A number of seconds as `3 s`, `4 min 05 s`, `2 h 10 min`. */
export function spanText(seconds: number): string {
  if (seconds < 60) return `${Math.round(seconds)} s`;
  const two = (number: number) => String(number).padStart(2, "0");
  const minutes = Math.floor(seconds / 60);
  if (minutes < 60) return `${minutes} min ${two(Math.floor(seconds % 60))} s`;
  return `${Math.floor(minutes / 60)} h ${two(minutes % 60)} min`;
}
