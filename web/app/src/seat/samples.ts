// The samples of the last minutes, column by column, by index.

/** Samples of a live string: as many as the server keeps; the oldest are dropped. */
export class Samples {
  readonly columns: Float32Array[];
  readonly interval_s: number;
  /** Indices of the first kept sample and of the next one. */
  first = 0;
  next = 0;
  epoch = -1;
  readonly #most: number;

  constructor(columns: number, most: number, interval_s: number) {
    this.columns = Array.from({ length: columns }, () => new Float32Array(most));
    this.#most = most;
    this.interval_s = interval_s;
  }

  /** Position of a sample in each column. */
  place(number: number): number {
    return number % this.#most;
  }

  /** The time of a sample, s. */
  time(number: number): number {
    return (number + 1) * this.interval_s;
  }

  /** The value of a column in the latest sample. */
  latest(column: number): number {
    return this.next > this.first ? (this.columns[column]?.[this.place(this.next - 1)] ?? NaN) : NaN;
  }

  /** Adds rows from an index on; missing rows in between are empty. */
  add(epoch: number, first: number, rows: number, values: Float32Array): void {
    if (epoch !== this.epoch) {
      this.epoch = epoch;
      this.first = this.next = first;
    }
    if (first > this.next + this.#most) this.first = this.next = first;
    while (this.next < first) {
      const place = this.place(this.next++);
      for (const column of this.columns) column[place] = NaN;
    }
    const count = this.columns.length;
    for (let row = 0; row < rows; row++) {
      const number = first + row;
      if (number < this.next) continue;
      const place = this.place(number);
      for (let k = 0; k < count; k++) this.columns[k]![place] = values[row * count + k]!;
      this.next = number + 1;
    }
    this.first = Math.max(this.first, this.next - this.#most);
  }
}
