//! Comparison of cumulative lengths and totals with the lengths.

use wholestring_tabular::{Column, Holds, ImportedTally, TallyCell, TallyRow};
use wholestring_units::number_text;

use super::part::Length;
use crate::fragment::{Note, Origin};

/// Maximum number of decimals of a length; further ones are rounding errors.
const MOST_DECIMALS: i32 = 3;

/// Number of cumulative lengths that follow from the previous one and the length of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Steps {
    /// Down the table.
    pub(crate) grow: usize,
    /// Up the table.
    pub(crate) fall: usize,
}

/// Counts the steps of the cumulative length that equal the lengths of their rows.
pub(crate) fn steps(rows: &[TallyRow], lengths: &[Length]) -> Steps {
    let cumulative: Vec<Option<f64>> = rows.iter().map(cumulative_m).collect();
    let tolerance_m = rounding_m(rows) * 3.0;
    let agrees = |row: usize, before: Option<f64>| {
        let (Some(sum), Some(before), Some(length)) =
            (cumulative[row], before, lengths[row].si_m())
        else {
            return false;
        };
        (sum - before - length).abs() <= tolerance_m
    };
    let last = rows.len().saturating_sub(1);
    let grow = (0..rows.len())
        .filter(|&row| agrees(row, if row == 0 { Some(0.0) } else { cumulative[row - 1] }));
    let fall = (0..rows.len())
        .filter(|&row| agrees(row, if row == last { Some(0.0) } else { cumulative[row + 1] }));
    Steps { grow: grow.count(), fall: fall.count() }
}

fn cumulative_m(row: &TallyRow) -> Option<f64> {
    row.get(Column::CumulativeLength)?.si()
}

/// Half of the last digit of written lengths, m.
fn rounding_m(rows: &[TallyRow]) -> f64 {
    let columns = [Column::Length, Column::JointLength, Column::CumulativeLength];
    let cells = || rows.iter().flat_map(|row| columns.iter().filter_map(|&column| row.get(column)));
    let decimals = cells().map(|cell| decimals(&cell.written)).max().unwrap_or(0);
    let unit = cells().find_map(|cell| match cell.holds {
        Holds::Quantity { unit, .. } => Some(unit),
        _ => None,
    });
    // Slightly more than a half, because of values rounded at a half.
    unit.map_or(0.0, |unit| unit.to_si(0.501 * 10f64.powi(-decimals)))
}

fn decimals(written: &str) -> i32 {
    let digits = written.rsplit_once(['.', ',']).map_or("", |(_, behind)| behind);
    let count = digits.bytes().take_while(u8::is_ascii_digit).count() as i32;
    if written.contains('/') { MOST_DECIMALS } else { count.min(MOST_DECIMALS) }
}

/// Adds notes on whether cumulative lengths and totals agree with the lengths.
pub(crate) fn check(
    tally: &ImportedTally,
    lengths: &[Length],
    steps: &Steps,
    notes: &mut Vec<Note>,
) {
    let rows = &tally.rows;
    let rounding_m = rounding_m(rows);
    let grows = steps.grow >= steps.fall;
    let order: Vec<usize> =
        if grows { (0..rows.len()).collect() } else { (0..rows.len()).rev().collect() };
    let mut sum_m = 0.0;
    let mut compared = 0;
    let mut differ: Vec<String> = Vec::new();
    for (place, &row) in order.iter().enumerate() {
        let Some(length_m) = lengths[row].si_m() else { break };
        sum_m += length_m;
        let Some(cell) = rows[row].get(Column::CumulativeLength) else { continue };
        let Some(stated_m) = cell.si() else { continue };
        compared += 1;
        if (stated_m - sum_m).abs() > rounding_m * (joints_up_to(lengths, &order[..=place]) + 2.0) {
            differ.push(format!("{} against {}", said(cell), in_unit(sum_m, cell)));
            // Later sums are compared with those of the table.
            sum_m = stated_m;
        }
    }
    if compared > 0 && differ.is_empty() {
        notes.push(Note::Checked(format!(
            "the cumulative length agrees with the lengths in {compared} rows"
        )));
    } else if let Some(first) = differ.first() {
        let more = match differ.len() {
            1 => String::new(),
            count => format!(", and in {} rows more", count - 1),
        };
        notes.push(Note::Warning(format!(
            "THE CUMULATIVE LENGTH DIFFERS from the sum of the lengths: {first}{more}; the \
             lengths are used"
        )));
    }
    let mut before = 0;
    for total in &tally.totals {
        let sum = |from: usize| -> f64 {
            lengths[from..total.rows_above].iter().filter_map(Length::si_m).sum()
        };
        let stated_m = total.length.si().unwrap_or_default();
        let sums = [sum(0), sum(before)];
        before = total.rows_above;
        let all: Vec<usize> = (0..total.rows_above).collect();
        let tolerance_m = rounding_m * (joints_up_to(lengths, &all) + 2.0);
        let agrees = sums.iter().any(|sum_m| (sum_m - stated_m).abs() <= tolerance_m);
        let is_open = lengths[..total.rows_above].contains(&Length::ToSurface);
        let stated = said(&total.length);
        notes.push(match (agrees, is_open) {
            (true, false) => Note::Checked(format!("the total agrees with the lengths: {stated}")),
            (true, true) => Note::Checked(format!(
                "the total agrees with the lengths below the topmost component: {stated}"
            )),
            (false, false) => {
                let sum = in_unit(sums[0], &total.length);
                Note::Warning(format!(
                    "THE TOTAL DIFFERS from the sum of the lengths: {stated} against {sum}"
                ))
            }
            (false, true) => Note::Checked(format!(
                "the total is not compared, for a length reaches to the surface: {stated}"
            )),
        });
    }
}

/// Number of roundings in a sum of lengths: one for each joint whose length was multiplied.
fn joints_up_to(lengths: &[Length], rows: &[usize]) -> f64 {
    let roundings = rows.iter().map(|&row| match &lengths[row] {
        Length::Of { joints: Some(joints), origin: Origin::Derived { .. }, .. } => joints.max(1.0),
        _ => 1.0,
    });
    roundings.sum()
}

/// A quantity and its place.
fn said(cell: &TallyCell) -> String {
    format!("{} ({})", in_unit(cell.si().unwrap_or_default(), cell), cell.place)
}

/// A length in the unit of a cell.
fn in_unit(length_m: f64, cell: &TallyCell) -> String {
    match cell.holds {
        Holds::Quantity { unit, .. } => {
            let rounded = (unit.from_si(length_m) * 1e3).round() / 1e3;
            format!("{} {}", number_text(rounded), unit.symbol)
        }
        _ => format!("{} m", number_text(length_m)),
    }
}
