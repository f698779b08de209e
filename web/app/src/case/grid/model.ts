// Content and changes of a grid.

import type { Diagnostic } from "../../api/client";

export interface Column {
  title: string;
  unit?: string;
  description?: string;
  /** Pixels. */
  width: number;
  isNumber?: boolean;
  /** Computed, not editable. */
  fixed?: boolean;
  /** Suggested texts. */
  words?: string[];
  /** A bar behind the number: its share of the largest, 0 to 1. */
  share?: (row: number) => number;
}

/** A cell and the text that it gets. */
export interface Typed {
  row: number;
  column: number;
  text: string;
}

export interface GridModel {
  /** Label of the grid. */
  label: string;
  columns: Column[];
  rows: number;
  /** The text of a cell in the chosen units. */
  shown: (row: number, column: number) => string;
  /** The text of a cell in the form of the file. */
  written: (row: number, column: number) => string;
  /** The diagnostic of a cell. */
  diagnostic?: (row: number, column: number) => Diagnostic | undefined;
  /** Writes cells in one step; rows after the last are new. */
  write: (cells: Typed[]) => void;
  insert?: (at: number) => void;
  remove?: (at: number, count: number) => void;
  move?: (from: number, to: number) => void;
}

export interface Place {
  row: number;
  column: number;
}

/** Cells between two opposite corners, inclusive. */
export interface Range {
  top: number;
  bottom: number;
  left: number;
  right: number;
}

export const rangeOf = (a: Place, b: Place): Range => ({
  top: Math.min(a.row, b.row),
  bottom: Math.max(a.row, b.row),
  left: Math.min(a.column, b.column),
  right: Math.max(a.column, b.column),
});

export const isIn = (range: Range, row: number, column: number): boolean =>
  row >= range.top && row <= range.bottom && column >= range.left && column <= range.right;
