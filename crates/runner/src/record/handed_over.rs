//! Time histories that a long run has moved to the disk: they are stored in parts, which are read
//! back whenever a result requires them.

use std::{
    path::{Path, PathBuf},
    sync::Mutex,
};

use wholestring::outcome::EarlierRows;
use wholestring_results::{ResultsError, Table};

use crate::parallel::lock;

/// Rows of a part: 16 384 are 164 s of a run that is sampled every 10 ms, and 10 MB of memory.
pub(crate) const PART_ROWS: usize = 1 << 14;

/// The rows that one operation has moved to the disk.
#[derive(Debug)]
pub(crate) struct HandedOver {
    parts: Vec<PathBuf>,
    fault: Mutex<Option<ResultsError>>,
}

impl HandedOver {
    /// Creates them from these parts, each of [`PART_ROWS`] rows.
    pub(super) fn new(parts: Vec<PathBuf>) -> Self {
        Self { parts, fault: Mutex::new(None) }
    }

    /// No rows.
    pub(crate) fn none() -> Self {
        Self::new(Vec::new())
    }

    /// The first error in reading rows, if there was one.
    pub(crate) fn fault(&self) -> Option<String> {
        lock(&self.fault).as_ref().map(ToString::to_string)
    }

    /// Columns of a part; empty if it cannot be read.
    fn read(&self, part: &Path, names: &[&'static str]) -> Vec<Vec<f64>> {
        let mut columns = vec![Vec::with_capacity(PART_ROWS); names.len()];
        let read = Table::read_parquet_pieces(part, names, |piece| {
            for (column, name) in columns.iter_mut().zip(names) {
                let numbers = piece.numbers(name).unwrap_or_default();
                column.extend(numbers.iter().map(|number| number.unwrap_or(f64::NAN)));
            }
        });
        let whole = columns.iter().all(|column| column.len() == PART_ROWS);
        let read = read.and_then(|()| match whole {
            true => Ok(()),
            false => {
                let reason = "it lacks rows that were written to it".to_owned();
                Err(ResultsError::Format { path: part.to_owned(), reason })
            }
        });
        if let Err(error) = read {
            lock(&self.fault).get_or_insert(error);
            columns.iter_mut().for_each(|column| *column = vec![f64::NAN; PART_ROWS]);
        }
        columns
    }
}

impl EarlierRows for HandedOver {
    fn rows(&self) -> usize {
        self.parts.len() * PART_ROWS
    }

    fn each(&self, columns: &[&'static str], from: usize, take: &mut dyn FnMut(&[&[f64]])) {
        let mut skipped = from % PART_ROWS;
        for part in self.parts.iter().skip(from / PART_ROWS) {
            let read = self.read(part, columns);
            let slices: Vec<&[f64]> = read.iter().map(|column| &column[skipped..]).collect();
            take(&slices);
            skipped = 0;
        }
    }
}
