// Cursor, selection and typed text of a grid.

import { rowsOf, textOf } from "./clipboard";
import { rangeOf, type GridModel, type Place, type Range, type Typed } from "./model";

/** Number of rows of a page. */
const PAGE = 12;

export class GridState {
  #model: () => GridModel;
  /** The active cell. */
  cursor = $state.raw<Place>({ row: 0, column: 0 });
  /** The opposite corner of the selection. */
  anchor = $state.raw<Place>({ row: 0, column: 0 });
  /** Typed text; null while not typing. */
  typing = $state<string | null>(null);
  /** Whether Tab leaves the grid, after Escape. */
  leaves = false;

  constructor(model: () => GridModel) {
    this.#model = model;
  }

  get range(): Range {
    return rangeOf(this.cursor, this.anchor);
  }

  /** Number of rows, with the empty one at the end for a new row. */
  get lines(): number {
    const model = this.#model();
    return model.rows + (model.insert ? 1 : 0);
  }

  /** Moves the cursor to a cell, within the grid. */
  go(row: number, column: number, extends_ = false): void {
    const within = (index: number, count: number) => Math.max(0, Math.min(count - 1, index));
    this.cursor = { row: within(row, this.lines), column: within(column, this.#model().columns.length) };
    if (!extends_) this.anchor = this.cursor;
    this.leaves = false;
  }

  by(rows: number, columns: number, extends_ = false): void {
    this.go(this.cursor.row + rows, this.cursor.column + columns, extends_);
  }

  /** Moves to the next cell, at the end of a row to the next row; returns whether there is one. */
  next(step: 1 | -1): boolean {
    const columns = this.#model().columns.length;
    const place = this.cursor.row * columns + this.cursor.column + step;
    if (place < 0 || place >= this.lines * columns) return false;
    this.go(Math.floor(place / columns), place % columns);
    return true;
  }

  selectAll(): void {
    const model = this.#model();
    this.anchor = { row: 0, column: 0 };
    this.cursor = { row: Math.max(0, model.rows - 1), column: model.columns.length - 1 };
  }

  /** Begins to type, in the existing text or in a new one with a first letter. */
  begin(letter?: string): void {
    const { row, column } = this.cursor;
    const model = this.#model();
    if (model.columns[column]?.fixed) return;
    this.anchor = this.cursor;
    this.typing = letter ?? (row < model.rows ? model.written(row, column) : "");
  }

  /** Writes the typed text, if it changed. */
  commit(): void {
    const { typing, cursor } = this;
    if (typing === null) return;
    this.typing = null;
    const model = this.#model();
    const before = cursor.row < model.rows ? model.written(cursor.row, cursor.column) : "";
    if (typing.trim() !== before.trim()) model.write([{ ...cursor, text: typing }]);
  }

  clear(): void {
    const { top, bottom, left, right } = this.range;
    const model = this.#model();
    const cells: Typed[] = [];
    for (let row = top; row <= Math.min(bottom, model.rows - 1); row++)
      for (let column = left; column <= right; column++)
        if (!model.columns[column]?.fixed && model.written(row, column) !== "") cells.push({ row, column, text: "" });
    if (cells.length > 0) model.write(cells);
  }

  /** The selection in the format of a spreadsheet, in the displayed units. */
  copied(): string {
    const { top, bottom, left, right } = this.range;
    const model = this.#model();
    const rows: string[][] = [];
    for (let row = top; row <= Math.min(bottom, model.rows - 1); row++) {
      const cells: string[] = [];
      for (let column = left; column <= right; column++) cells.push(model.shown(row, column));
      rows.push(cells);
    }
    return textOf(rows);
  }

  /** Writes rows of cells from the corner of the selection; one cell fills the whole selection. */
  paste(text: string): void {
    const rows = rowsOf(text);
    const model = this.#model();
    const { top, left, bottom, right } = this.range;
    const single = rows.length === 1 && rows[0]?.length === 1 ? rows[0][0] : undefined;
    const cells: Typed[] = [];
    const put = (row: number, column: number, cell: string) => {
      const isNew = row >= model.rows;
      if (column >= model.columns.length || model.columns[column]?.fixed || (isNew && !model.insert)) return;
      if (isNew || model.written(row, column) !== cell) cells.push({ row, column, text: cell });
    };
    if (single !== undefined) {
      for (let row = top; row <= bottom; row++) for (let column = left; column <= right; column++) put(row, column, single);
    } else {
      rows.forEach((row, i) => row.forEach((cell, j) => put(top + i, left + j, cell)));
      const widest = Math.max(...rows.map((row) => row.length));
      this.anchor = { row: top, column: left };
      this.cursor = { row: top + rows.length - 1, column: Math.min(model.columns.length, left + widest) - 1 };
    }
    if (cells.length > 0) model.write(cells);
  }

  /** Adds a row above or below the cursor. */
  insert(below: boolean): void {
    const model = this.#model();
    const row = Math.min(model.rows, this.cursor.row + (below ? 1 : 0));
    model.insert?.(row);
    this.go(row, this.cursor.column);
  }

  /** Removes the selected rows. */
  removeRows(): void {
    const { top, bottom } = this.range;
    const model = this.#model();
    const count = Math.min(bottom, model.rows - 1) - top + 1;
    if (count > 0) model.remove?.(top, count);
    this.go(Math.min(top, Math.max(0, this.lines - 1 - count)), this.cursor.column);
  }

  /** Moves the row of the cursor up or down. */
  moveRow(by: 1 | -1): void {
    const model = this.#model();
    const { row, column } = this.cursor;
    const to = row + by;
    if (!model.move || row >= model.rows || to < 0 || to >= model.rows) return;
    model.move(row, to);
    this.go(to, column);
  }

  /** Handles a key; returns whether it is one of the grid. */
  key(event: KeyboardEvent): boolean {
    const command = event.ctrlKey || event.metaKey;
    const { shiftKey: extends_ } = event;
    const last = { row: this.#model().rows - 1, column: this.#model().columns.length - 1 };
    const { row, column } = this.cursor;
    if (event.altKey) {
      if (event.key === "ArrowUp") this.moveRow(-1);
      else if (event.key === "ArrowDown") this.moveRow(1);
      else return false;
      return true;
    }
    switch (event.key) {
      case "ArrowUp":
        command ? this.go(0, column, extends_) : this.by(-1, 0, extends_);
        return true;
      case "ArrowDown":
        command ? this.go(last.row, column, extends_) : this.by(1, 0, extends_);
        return true;
      case "ArrowLeft":
        command ? this.go(row, 0, extends_) : this.by(0, -1, extends_);
        return true;
      case "ArrowRight":
        command ? this.go(row, last.column, extends_) : this.by(0, 1, extends_);
        return true;
      case "PageUp":
        this.by(-PAGE, 0, extends_);
        return true;
      case "PageDown":
        this.by(PAGE, 0, extends_);
        return true;
      case "Home":
        this.go(command ? 0 : row, 0, extends_);
        return true;
      case "End":
        this.go(command ? last.row : row, last.column, extends_);
        return true;
      case "Tab":
        return !this.leaves && this.next(extends_ ? -1 : 1);
      case "Escape":
        this.anchor = this.cursor;
        this.leaves = true;
        return true;
      case "Enter":
        command ? this.insert(!extends_) : this.begin();
        return true;
      case "F2":
        this.begin();
        return true;
      case "Delete":
      case "Backspace":
        command ? this.removeRows() : this.clear();
        return true;
    }
    if (command && event.key.toLowerCase() === "a") {
      this.selectAll();
      return true;
    }
    if (event.key.length === 1 && !command) {
      this.begin(event.key);
      return true;
    }
    return false;
  }
}
