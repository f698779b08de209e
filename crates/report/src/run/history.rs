//! Time histories of an operation, reduced for a page.

use std::collections::BTreeMap;

use wholestring::operation::OperationKind;
use wholestring_results::{Data, OperationTables, ResultsError, Table};

use crate::{Packed, plots::catalogue::drill_off_columns, thin::Thinned};

/// Largest number of rows of time histories in a page, all operations together.
const MAX_ROWS: usize = 12_000;

/// Largest number of samples of the drilling response in a page, all operations together.
const MAX_DRILLED: usize = 3000;

/// Time histories of one operation.
pub(super) struct History {
    /// Number of samples.
    pub(super) samples: usize,
    columns: BTreeMap<String, Thinned>,
    /// Start times of schedule lines with a note, s, and the notes.
    pub(super) notes: Vec<(f64, String)>,
    last_note: String,
    /// Rows before this time, s, are outside the window of the drilling response.
    window_s: f64,
    /// Every n-th row of the window is in the drilling response.
    step: usize,
    /// Rows of the window so far.
    in_window: usize,
    drilled: [Vec<f64>; 3],
}

impl History {
    /// Reads the history of an operation whose window begins at `window_s` and which shares the
    /// page with `many`, including itself. The table is read in two passes, because the number of
    /// rows to merge depends on their total.
    pub(super) fn read(
        operation: OperationKind,
        window_s: f64,
        tables: &OperationTables,
        many: usize,
    ) -> Result<Self, ResultsError> {
        let (mut samples, mut in_window) = (0, 0);
        tables.pieces("time", (None, operation), Some(&["time_s"]), |piece| {
            let times_s = piece.values("time_s");
            samples += times_s.len();
            in_window += times_s.iter().filter(|time_s| **time_s >= window_s).count();
        })?;
        // A run that ended before its window shows all of its samples.
        let (rows, window_s) =
            if in_window > 0 { (in_window, window_s) } else { (samples, f64::NEG_INFINITY) };
        let most = MAX_ROWS / many;
        let times = Thinned::times(samples, most);
        let mut history = Self {
            samples,
            columns: BTreeMap::from([("time_s".to_owned(), times)]),
            notes: Vec::new(),
            last_note: String::new(),
            window_s,
            step: rows.div_ceil((MAX_DRILLED / many).max(1)).max(1),
            in_window: 0,
            drilled: Default::default(),
        };
        tables.pieces("time", (None, operation), None, |piece| history.take(&piece, most))?;
        Ok(history)
    }

    fn take(&mut self, piece: &Table, most: usize) {
        let numbers =
            piece.columns().iter().filter(|column| matches!(column.data, Data::Number(_)));
        for column in numbers {
            let thinned = self.columns.entry(column.name.clone());
            let thinned = thinned.or_insert_with(|| Thinned::column(self.samples, most));
            piece.values(&column.name).into_iter().for_each(|value| thinned.push(value));
        }
        let times_s = piece.values("time_s");
        let notes = piece.words("note").unwrap_or_default();
        for (row, time_s) in times_s.iter().enumerate() {
            let note = notes.get(row).map_or("", String::as_str);
            if note != self.last_note {
                if !note.is_empty() {
                    let time_s = if time_s.is_nan() { 0.0 } else { *time_s };
                    self.notes.push((time_s, note.to_owned()));
                }
                note.clone_into(&mut self.last_note);
            }
        }
        let drilled = drill_off_columns().map(|name| piece.values(name));
        for (row, time_s) in times_s.iter().enumerate() {
            // If no window began, rows without a time count too.
            if *time_s >= self.window_s || self.window_s == f64::NEG_INFINITY {
                if self.in_window.is_multiple_of(self.step) {
                    for (all, values) in self.drilled.iter_mut().zip(&drilled) {
                        all.push(values[row]);
                    }
                }
                self.in_window += 1;
            }
        }
    }

    /// Drilling response of the bit in the window; `None` if there is no weight on bit.
    pub(super) fn drill_off(&self) -> Option<BTreeMap<String, Packed>> {
        let drills = self.drilled[0].iter().any(|weight| *weight > 0.0);
        let columns = drill_off_columns().into_iter().zip(&self.drilled);
        let packed = |values: &Vec<f64>| Packed::single(values.iter().copied());
        drills.then(|| columns.map(|(name, values)| (name.to_owned(), packed(values))).collect())
    }

    /// The columns by their name, thinned: times, and those with a number.
    pub(super) fn columns(self) -> BTreeMap<String, Packed> {
        let columns = self.columns.into_iter().filter_map(|(name, thinned)| {
            let values = thinned.values();
            let any = name == "time_s" || values.iter().any(|value| value.is_finite());
            any.then(|| (name, Packed::single(values)))
        });
        columns.collect()
    }
}
