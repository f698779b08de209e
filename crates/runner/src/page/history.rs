//! What an operation did in time, as much of it as a page can show.

use std::collections::BTreeMap;

use wholestring_report::{
    BottomPicture, ContactPicture, DrillOff, Packed, contact_columns, drill_off_columns, thinned,
};
use wholestring_results::Table;

use super::rows::rows;
use crate::{
    column::{numbers, words},
    parallel::beside,
};

/// Rows of time histories that a page holds, all operations together.
const MAX_ROWS: usize = 12_000;

/// Times of a map of contact that a page holds, all operations together.
const MAX_TIMES: usize = 450;

/// Samples of what the bit does that a page holds, all operations together.
const MAX_DRILLED: usize = 3000;

/// Time histories of one operation.
pub(super) struct History {
    /// Samples that it took.
    pub(super) samples: usize,
    /// Columns by their name.
    pub(super) columns: BTreeMap<String, Packed>,
    /// When a line of the schedule with a note began, and the note.
    pub(super) notes: Vec<(f64, String)>,
}

/// Time histories of an operation that shares the page with `many`, itself included.
pub(super) fn history(time: &Table, operation: &str, many: usize) -> History {
    let rows = rows(time, None, operation);
    let times = of_rows(time, "time_s", &rows);
    let most = MAX_ROWS / many.max(1);
    let names: Vec<&str> = time
        .columns()
        .iter()
        .map(|column| column.name.as_str())
        .filter(|name| *name != "time_s" && !numbers(time, name).is_empty())
        .collect();
    let of_names = |names: &[&str]| -> Vec<(String, Packed)> {
        let thin = |name: &&str| {
            let values = of_rows(time, name, &rows);
            values.iter().any(|value| value.is_finite()).then(|| {
                let values = thinned(&times, &[&values], most).1.remove(0);
                ((*name).to_owned(), Packed::single(values))
            })
        };
        names.iter().filter_map(thin).collect()
    };
    // Half of them on another core: who interrupts a long run waits for its page.
    let (some, others) = names.split_at(names.len() / 2);
    let (others, some) = beside(|| of_names(others), || of_names(some));
    let columns = some.into_iter().chain(others);
    let times = ("time_s".into(), Packed::single(thinned(&times, &[], most).0));
    History {
        samples: rows.len(),
        columns: columns.chain([times]).collect(),
        notes: notes(time, &rows),
    }
}

/// What the bit takes away in the window for what it is given, of an operation that shares the page
/// with `many`, itself included; none where no weight is on the bit.
pub(super) fn drill_off(
    time: &Table,
    operation: &str,
    window_s: f64,
    many: usize,
) -> Option<DrillOff> {
    let rows = rows(time, None, operation);
    let times = of_rows(time, "time_s", &rows);
    let begun = rows.iter().zip(&times).filter(|(_, time_s)| **time_s >= window_s);
    let mut window: Vec<usize> = begun.map(|(row, _)| *row).collect();
    if window.is_empty() {
        // What ended before its window shows what there is.
        window = rows;
    }
    let step = window.len().div_ceil((MAX_DRILLED / many.max(1)).max(1));
    let chosen: Vec<usize> = window.into_iter().step_by(step.max(1)).collect();
    let names = drill_off_columns();
    let columns = names.map(|name| of_rows(time, name, &chosen));
    let drills = columns[0].iter().any(|weight| *weight > 0.0);
    drills.then(|| DrillOff {
        columns: names.map(String::from).into_iter().zip(columns.map(Packed::single)).collect(),
    })
}

/// The bottom of the hole that an operation left; none where its bit did not stand on solid rock.
pub(crate) fn bottom(table: &Table, operation: &str) -> Option<BottomPicture> {
    let rows = rows(table, None, operation);
    let mut radius_m = of_rows(table, "radius_m", &rows);
    let mut angle_rad = of_rows(table, "angle_rad", &rows);
    // All sectors of a ring follow each other.
    let sectors = radius_m.iter().take_while(|of| **of == radius_m[0]).count();
    if sectors == 0 || !radius_m.len().is_multiple_of(sectors) {
        return None;
    }
    radius_m = radius_m.into_iter().step_by(sectors).collect();
    angle_rad.truncate(sectors);
    BottomPicture::new(&radius_m, &angle_rad, &of_rows(table, "depth_m", &rows))
}

/// The numbers of a column in some rows; not a number where there is none.
fn of_rows(table: &Table, name: &str, rows: &[usize]) -> Vec<f64> {
    let values = numbers(table, name);
    let number = |row: &usize| values.get(*row).copied().flatten();
    rows.iter().map(|row| number(row).unwrap_or(f64::NAN)).collect()
}

/// Where the note changes to another one.
fn notes(time: &Table, rows: &[usize]) -> Vec<(f64, String)> {
    let (all, times) = (words(time, "note"), numbers(time, "time_s"));
    let mut last = "";
    let mut notes = Vec::new();
    for row in rows {
        let note = all.get(*row).map_or("", String::as_str);
        if note != last && !note.is_empty() {
            notes.push((times[*row].unwrap_or(0.0), note.to_owned()));
        }
        last = note;
    }
    notes
}

/// The map of contact of an operation that shares the page with `many`, itself included.
pub(super) fn contact(table: &Table, operation: &str, many: usize) -> Option<ContactPicture> {
    let rows = rows(table, None, operation);
    let times = of_rows(table, "time_s", &rows);
    // All stretches of one time follow each other.
    let stretches = times.iter().take_while(|time| **time == times[0]).count();
    let count = times.len().checked_div(stretches)?;
    // Neighbouring times become one where there are too many.
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

    /// Of each operation its own, ring after ring, and none of one without rock.
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
        for (operation, deepest_m) in [("drill", 0.04), ("slide", 0.05)] {
            let shown = bottom(&table, operation).expect("a bottom");
            let near = |a: f64, b: f64| (a - b).abs() < 1e-7;
            let radii = shown.radius_m.values();
            assert!(radii.len() == 2 && near(radii[1], 0.05), "{radii:?}");
            assert_eq!(shown.angle_rad.values(), [1.0, 3.0, 5.0]);
            let depths = shown.depth_m.values();
            assert!(near(depths[0], 0.0) && depths[1].is_nan() && near(depths[5], deepest_m));
        }
        assert_eq!(bottom(&table, "trip_out"), None);
        assert_eq!(bottom(&Table::new(Vec::new()), "drill"), None);
    }
}
