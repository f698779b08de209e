//! Time histories of an operation, reduced for a page.

use std::collections::BTreeMap;

use wholestring::operation::OperationKind;
use wholestring_report::{
    BottomPicture, ContactPicture, DrillOff, Packed, Thinned, contact_columns, drill_off_columns,
};
use wholestring_results::{ResultsError, Table};

use super::{rows::rows, tables::Tables};
use crate::column::{numbers, words};

/// Largest number of rows of time histories in a page, all operations together.
const MAX_ROWS: usize = 12_000;

/// Largest number of times of a contact map in a page, all operations together.
const MAX_TIMES: usize = 450;

/// Largest number of samples of the drilling response in a page, all operations together.
const MAX_DRILLED: usize = 3000;

/// Time histories of one operation.
pub(super) struct History {
    /// Number of samples in the history.
    pub(super) samples: usize,
    /// Columns by their name.
    pub(super) columns: BTreeMap<String, Packed>,
    /// Start times of schedule lines with a note, and the notes.
    pub(super) notes: Vec<(f64, String)>,
    /// Drilling response of the bit in the window; `None` if there is no weight on bit.
    pub(super) drill_off: Option<DrillOff>,
}

impl History {
    /// Reads the history of an operation whose window begins at `window_s` and which shares the
    /// page with `many`, including itself. The table is read in two passes, because the number of
    /// rows to merge depends on their total.
    pub(super) fn of(
        tables: &Tables,
        operation: OperationKind,
        window_s: f64,
        many: usize,
    ) -> Result<Self, ResultsError> {
        let (mut samples, mut in_window) = (0, 0);
        tables.columns_of("time", &["operation", "time_s"], |piece| {
            let rows = rows(&piece, None, operation);
            let times_s = of_rows(&piece, "time_s", &rows);
            samples += rows.len();
            in_window += times_s.iter().filter(|time_s| **time_s >= window_s).count();
        })?;
        let mut reading = Reading {
            samples,
            many: many.max(1),
            times: Thinned::times(samples, MAX_ROWS / many.max(1)),
            columns: BTreeMap::new(),
            notes: Vec::new(),
            last_note: String::new(),
            drill_off: DrillOffRows::new(in_window, samples, window_s, many),
        };
        tables.pieces_of("time", operation, |piece| reading.take(&piece, operation))?;
        Ok(reading.end())
    }
}

/// Reader of time histories.
struct Reading {
    samples: usize,
    many: usize,
    times: Thinned,
    columns: BTreeMap<String, Thinned>,
    notes: Vec<(f64, String)>,
    last_note: String,
    drill_off: DrillOffRows,
}

impl Reading {
    fn take(&mut self, piece: &Table, operation: OperationKind) {
        let rows = rows(piece, None, operation);
        let times_s = of_rows(piece, "time_s", &rows);
        times_s.iter().for_each(|time_s| self.times.push(*time_s));
        for column in piece.columns() {
            let name = column.name.as_str();
            if name == "time_s" || numbers(piece, name).is_empty() {
                continue;
            }
            let thinned = self.columns.entry(name.to_owned());
            let thinned =
                thinned.or_insert_with(|| Thinned::column(self.samples, MAX_ROWS / self.many));
            of_rows(piece, name, &rows).into_iter().for_each(|value| thinned.push(value));
        }
        self.take_notes(words(piece, "note"), &rows, &times_s);
        self.drill_off.take(piece, &rows, &times_s);
    }

    /// Extracts the changes of the note.
    fn take_notes(&mut self, all: &[String], rows: &[usize], times_s: &[f64]) {
        for (row, time_s) in rows.iter().zip(times_s) {
            let note = all.get(*row).map_or("", String::as_str);
            if note != self.last_note {
                if !note.is_empty() {
                    let time_s = if time_s.is_nan() { 0.0 } else { *time_s };
                    self.notes.push((time_s, note.to_owned()));
                }
                note.clone_into(&mut self.last_note);
            }
        }
    }

    fn end(self) -> History {
        let columns = self.columns.into_iter().filter_map(|(name, thinned)| {
            let values = thinned.values();
            let any = values.iter().any(|value| value.is_finite());
            any.then(|| (name, Packed::single(values)))
        });
        let times = ("time_s".into(), Packed::single(self.times.values()));
        History {
            samples: self.samples,
            columns: columns.chain([times]).collect(),
            notes: self.notes,
            drill_off: self.drill_off.end(),
        }
    }
}

/// Every n-th row of the window, with the drilling response.
struct DrillOffRows {
    /// Rows before this time, s, are outside the window.
    from_s: f64,
    step: usize,
    place: usize,
    columns: Vec<Vec<f64>>,
}

impl DrillOffRows {
    fn new(in_window: usize, samples: usize, window_s: f64, many: usize) -> Self {
        // A run that ended before its window shows all of its samples.
        let (rows, from_s) =
            if in_window > 0 { (in_window, window_s) } else { (samples, f64::NEG_INFINITY) };
        let step = rows.div_ceil((MAX_DRILLED / many.max(1)).max(1)).max(1);
        let columns = vec![Vec::new(); drill_off_columns().len()];
        Self { from_s, step, place: 0, columns }
    }

    fn take(&mut self, piece: &Table, rows: &[usize], times_s: &[f64]) {
        let mut chosen = Vec::new();
        for (row, time_s) in rows.iter().zip(times_s) {
            // If no window began, rows without a time count too.
            if *time_s >= self.from_s || self.from_s == f64::NEG_INFINITY {
                if self.place.is_multiple_of(self.step) {
                    chosen.push(*row);
                }
                self.place += 1;
            }
        }
        for (name, column) in drill_off_columns().into_iter().zip(&mut self.columns) {
            column.extend(of_rows(piece, name, &chosen));
        }
    }

    fn end(self) -> Option<DrillOff> {
        let drills = self.columns[0].iter().any(|weight| *weight > 0.0);
        drills.then(|| DrillOff {
            columns: drill_off_columns()
                .map(String::from)
                .into_iter()
                .zip(self.columns.into_iter().map(Packed::single))
                .collect(),
        })
    }
}

/// Bottom hole left by an operation; `None` if its bit was not on solid rock.
pub(super) fn bottom(table: &Table, operation: OperationKind) -> Option<BottomPicture> {
    bottom_picture(table, &rows(table, None, operation))
}

/// Bottom hole in these rows of a table; `None` if they are none.
pub(crate) fn bottom_picture(table: &Table, rows: &[usize]) -> Option<BottomPicture> {
    let mut radius_m = of_rows(table, "radius_m", rows);
    let mut angle_rad = of_rows(table, "angle_rad", rows);
    // Sectors of a ring are consecutive.
    let sectors = radius_m.iter().take_while(|radius| **radius == radius_m[0]).count();
    if sectors == 0 || !radius_m.len().is_multiple_of(sectors) {
        return None;
    }
    radius_m = radius_m.into_iter().step_by(sectors).collect();
    angle_rad.truncate(sectors);
    BottomPicture::new(&radius_m, &angle_rad, &of_rows(table, "depth_m", rows))
}

/// Numbers of a column in some rows; NaN if there is none.
fn of_rows(table: &Table, name: &str, rows: &[usize]) -> Vec<f64> {
    let values = numbers(table, name);
    let number = |row: &usize| values.get(*row).copied().flatten();
    rows.iter().map(|row| number(row).unwrap_or(f64::NAN)).collect()
}

/// Contact map of an operation that shares the page with `many`, including itself.
pub(super) fn contact(
    table: &Table,
    operation: OperationKind,
    many: usize,
) -> Option<ContactPicture> {
    let rows = rows(table, None, operation);
    let times = of_rows(table, "time_s", &rows);
    // Stretches at one time are consecutive.
    let stretches = times.iter().take_while(|time| **time == times[0]).count();
    let count = times.len().checked_div(stretches)?;
    // Adjacent times are merged if there are too many.
    let many = count.div_ceil((MAX_TIMES / many.max(1)).max(1));
    let groups: Vec<std::ops::Range<usize>> =
        (0..count).step_by(many).map(|first| first..(first + many).min(count)).collect();
    let mean = |name: &str| -> Vec<f64> {
        let values = of_rows(table, name, &rows);
        let values = &values;
        let of_group = |group: &std::ops::Range<usize>| {
            let (times, count) = (group.clone(), group.len() as f64);
            (0..stretches).map(move |stretch| {
                let sum: f64 = times.clone().map(|time| values[time * stretches + stretch]).sum();
                sum / count
            })
        };
        groups.iter().flat_map(of_group).collect()
    };
    let depths_m = of_rows(table, "md_m", &rows);
    let depths = |stretch: usize| {
        let sum: f64 = (0..count).map(|time| depths_m[time * stretches + stretch]).sum();
        sum / count as f64
    };
    Some(ContactPicture {
        from_s: 0.0,
        time_s: Packed::single(groups.iter().map(|group| times[(group.end - 1) * stretches])),
        md_m: Packed::single((0..stretches).map(depths)),
        values: contact_columns()
            .into_iter()
            .map(|name| (name.to_owned(), Packed::short(&mean(name))))
            .collect(),
    })
}

#[cfg(test)]
mod tests {
    use wholestring_results::BOTTOM_HOLE;

    use super::*;

    /// Each operation has its own bottom, ring by ring; an operation without rock has none.
    #[test]
    fn a_bottom_is_read_back() {
        const NAN: f64 = f64::NAN;
        let mut table = Table::with_columns(BOTTOM_HOLE);
        for (operation, deep_m) in [("drill", 0.01), ("slide", 0.02)] {
            table.append(
                &[("operation", &[operation])],
                &[
                    ("radius_m", &[0.03, 0.03, 0.03, 0.05, 0.05, 0.05]),
                    ("angle_rad", &[1.0, 3.0, 5.0, 1.0, 3.0, 5.0]),
                    ("depth_m", &[-0.03, NAN, 0.0, 0.0, 0.0, deep_m]),
                ],
            );
        }
        for (operation, deepest_m) in [(OperationKind::Drill, 0.04), (OperationKind::Slide, 0.05)] {
            let picture = bottom(&table, operation).expect("a bottom");
            let near = |a: f64, b: f64| (a - b).abs() < 1e-7;
            let radii = picture.radius_m.values();
            assert!(radii.len() == 2 && near(radii[1], 0.05), "{radii:?}");
            assert_eq!(picture.angle_rad.values(), [1.0, 3.0, 5.0]);
            let depths = picture.depth_m.values();
            assert!(near(depths[0], 0.0) && depths[1].is_nan() && near(depths[5], deepest_m));
        }
        assert_eq!(bottom(&table, OperationKind::TripOut), None);
        assert_eq!(bottom(&Table::new(Vec::new()), OperationKind::Drill), None);
    }
}
