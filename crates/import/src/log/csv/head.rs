//! Headings of a log in text, with the units in them or below them.

use wholestring_units::Dimension;

use super::super::{
    channel::{Column, is_no_unit, unit},
    lines::{Lines, text},
    mnemonics,
    moment::{Order, moment, time_of_day},
    number::{Marks, is_nothing, marked},
    quantity::Quantity,
    record::{COLUMNS, Row},
};
use crate::error::{ImportError, ImportErrorKind};

/// Number of lines searched for the headings.
const AHEAD: usize = 60;

/// Possible separators of cells.
const SIGNS: [u8; 4] = [b',', b';', b'\t', b'|'];

/// Position and contents of the head.
#[derive(Debug)]
pub(super) struct Found {
    pub(super) sign: u8,
    /// Index of the heading line among the first lines.
    pub(super) headings: usize,
    /// Index of the first line of data, or one past the last line.
    pub(super) data: usize,
    pub(super) columns: Vec<Column>,
    /// Lines between the headings and the data that are not units.
    pub(super) passed_over: Vec<usize>,
    has_readings: bool,
}

/// Reads the first lines.
pub(super) fn ahead(lines: &mut Lines, ahead: &mut Vec<Vec<u8>>) -> Result<(), ImportError> {
    while ahead.len() < AHEAD {
        let mut line = Vec::new();
        if !lines.next(&mut line)? {
            break;
        }
        if line.iter().filter(|b| SIGNS.contains(b)).count() > 4 * COLUMNS {
            let found = format!("a line of more than {COLUMNS} columns");
            let most = COLUMNS.to_string();
            return Err(lines.error(ImportErrorKind::TooMuch { found, most }));
        }
        ahead.push(line);
    }
    Ok(())
}

/// Finds the headings: the line and the separator for which most cells name a quantity.
pub(super) fn find(ahead: &[Vec<u8>]) -> Option<Found> {
    let mut best: Option<(usize, usize, u8)> = None;
    for (at, line) in ahead.iter().enumerate() {
        for sign in SIGNS.into_iter().filter(|sign| line.contains(sign)) {
            let row = parted(line, sign);
            if row.cells.len() > COLUMNS {
                continue;
            }
            let named = (0..row.cells.len()).filter(|&i| names(&heading(&cell(&row, i)))).count();
            if named >= 2 && best.is_none_or(|(most, _, _)| named > most) {
                best = Some((named, at, sign));
            }
        }
    }
    let (_, headings, sign) = best?;
    let row = parted(&ahead[headings], sign);
    let mut columns: Vec<Column> =
        (0..row.cells.len()).map(|at| heading(&cell(&row, at))).collect();
    let has_readings = columns.iter().any(|column| mnemonics::is_reading(&column.mnemonic));
    let mut data = headings + 1;
    let mut passed_over = Vec::new();
    let mut has_units = columns.iter().any(|column| !column.unit.is_empty());
    while let Some(line) = ahead.get(data) {
        let below = parted(line, sign);
        if line.trim_ascii().is_empty() {
            data += 1;
            continue;
        }
        if is_data(&below) {
            break;
        }
        let fits = columns.iter().enumerate().any(|(at, column)| {
            let written = bare(&cell(&below, at));
            quantity(column).is_some_and(|quantity| unit(quantity.dimension(), &written).is_some())
        });
        if fits && !has_units {
            has_units = true;
            for (at, column) in columns.iter_mut().enumerate() {
                column.unit = bare(&cell(&below, at));
            }
        } else {
            passed_over.push(data);
        }
        data += 1;
    }
    Some(Found { sign, headings, data, columns, passed_over, has_readings })
}

impl Found {
    /// Whether these are the headings of a log, as opposed to a survey, a tally or readings.
    pub(super) fn is_log(&self) -> bool {
        let has = |other| self.columns.iter().any(|column| quantity(column) == Some(other));
        let has_time = has(Quantity::Time)
            || self.columns.iter().any(|column| mnemonics::is_date(&column.mnemonic));
        let has_depth = has(Quantity::BitDepth) || has(Quantity::HoleDepth);
        let (hook, block) = (has(Quantity::HookLoad), has(Quantity::BlockPosition));
        let others = [
            Quantity::WeightOnBit,
            Quantity::Torque,
            Quantity::RotarySpeed,
            Quantity::FlowRate,
            Quantity::StandpipePressure,
        ];
        let more = others.into_iter().filter(|quantity| has(*quantity)).count();
        let measured = usize::from(hook) + usize::from(block) + more;
        !self.has_readings
            && (has_time && (hook || block || measured >= 2)
                || has_depth && hook && measured >= 2
                || has_depth && measured >= 3)
    }
}

/// Whether a row names channels: at least three, and no number.
pub(super) fn is_heading(row: &Row) -> bool {
    let named = (0..row.cells.len()).filter(|&at| names(&heading(&cell(row, at)))).count();
    named >= 3 && !is_data(row)
}

/// Splits a line at a separator.
pub(super) fn parted(line: &[u8], sign: u8) -> Row {
    let mut row = Row { bytes: line.to_vec(), ..Row::default() };
    row.part_at(sign, 0);
    row
}

fn cell(row: &Row, at: usize) -> String {
    text(row.cell(at))
}

fn quantity(column: &Column) -> Option<Quantity> {
    mnemonics::quantity(&column.mnemonic).map(|(quantity, _)| quantity)
}

fn names(column: &Column) -> bool {
    quantity(column).is_some() || mnemonics::is_date(&column.mnemonic)
}

/// Whether a row is data: a cell is a number or begins like a date.
fn is_data(row: &Row) -> bool {
    let filled = (0..row.cells.len()).map(|at| row.cell(at)).filter(|cell| !is_nothing(cell));
    let mut numbers = 0;
    let mut cells = 0;
    for cell in filled {
        cells += 1;
        let is_number = marked(cell, Marks::Point).or(marked(cell, Marks::Comma)).is_some();
        // Item numbers of WITS below the headings: `0108`.
        let is_item = cell.len() == 4 && cell.starts_with(b"01") && !cell.contains(&b'.');
        let is_date = moment(cell, Order::DayFirst).is_some() || time_of_day(cell).is_some();
        numbers += usize::from(is_number && !is_item || is_date);
    }
    numbers > 0 && 2 * numbers >= cells.min(4)
}

/// Parses a heading: `Hook Load (klbs)`, `HKLA[klbf]`, `HKLA, klbf`, `bit_depth_m`.
fn heading(written: &str) -> Column {
    let written = written.trim().trim_matches('"').trim();
    let column = |name: &str, unit: &str| Column {
        mnemonic: name.trim().to_owned(),
        unit: unit.trim().to_owned(),
        ..Column::default()
    };
    if written.len() > 200 {
        return column(&written.chars().take(200).collect::<String>(), "");
    }
    let is_named = |name: &str| mnemonics::quantity(name).is_some() || mnemonics::is_date(name);
    for (open, close) in [('(', ')'), ('[', ']'), ('{', '}'), ('<', '>')] {
        if let Some(rest) = written.strip_suffix(close)
            && let Some((name, inside)) = rest.rsplit_once(open)
        {
            // "Hook Load (max)" is a name.
            let is_name = mnemonics::quantity(written).is_some() && !is_unit(inside);
            return if is_name { column(written, "") } else { column(name, inside) };
        }
    }
    if is_named(written) {
        return column(written, "");
    }
    if let Some((name, unit)) = written.split_once(',')
        && is_named(name)
    {
        return column(name, unit);
    }
    // The unit is the last word or words: "Hook Load klbf", "bit_depth_m", "flow_gal_per_min".
    for (at, sign) in written.match_indices([' ', '_']) {
        let (name, rest) = (&written[..at], &written[at + sign.len()..]);
        if let Some((quantity, _)) = mnemonics::quantity(name)
            && unit(quantity.dimension(), rest).is_some()
        {
            return column(name, rest);
        }
    }
    column(written, "")
}

fn is_unit(written: &str) -> bool {
    is_no_unit(written)
        || Dimension::ALL.iter().any(|dimension| unit(*dimension, written).is_some())
}

/// Unit from a row of units without brackets: `(ft)`, `[ft]`.
fn bare(written: &str) -> String {
    written.trim().trim_matches(['(', ')', '[', ']', '{', '}', '"']).trim().to_owned()
}

#[cfg(test)]
mod tests {
    use super::{super::is_log, heading};

    #[test]
    fn headings_name_channel_and_unit() {
        for (written, name, unit) in [
            ("Hook Load (klbs)", "Hook Load", "klbs"),
            ("HKLA[klbf]", "HKLA", "klbf"),
            ("HKLA, klbf", "HKLA", "klbf"),
            ("bit_depth_m", "bit_depth", "m"),
            ("Total Pump Output (gal_per_min)", "Total Pump Output", "gal_per_min"),
            ("Hook Load (max)", "Hook Load (max)", ""),
            ("Hook Load klbf", "Hook Load", "klbf"),
            ("Rotary Torque (unitless)", "Rotary Torque", "unitless"),
            ("YYYY/MM/DD", "YYYY/MM/DD", ""),
            ("Comments", "Comments", ""),
            ("", "", ""),
        ] {
            let column = heading(written);
            assert_eq!((column.mnemonic.as_str(), column.unit.as_str()), (name, unit), "{written}");
        }
    }

    #[test]
    fn logs_are_told_from_other_tables() {
        for text in [
            "Time,Bit Depth (m),Hook Load (t)\n",
            "Rig 7\n\nYYYY/MM/DD,HH:MM:SS,Hole Depth (feet),Hook Load (klbs)\n",
            "Bit depth;Block position;Hook load\nm;m;t\n",
            "Date,WOB,RPM\n",
        ] {
            assert!(is_log(text.as_bytes()), "{text}");
        }
        for text in [
            "Bit depth (m),Pick-up (t),Slack-off (t)\n",
            "Date,Bit depth,Pick-up,Slack-off,Torque,Flow rate\n",
            "MD (m),Inc,Azi\n",
            "MD,Inc,Azi,TVD,Date\n",
            "Component,Length,OD,ID,Torque\n",
            "Depth,Hook load\n",
            "",
            "\n\n\n",
            "1,2,3\n4,5,6\n",
        ] {
            assert!(!is_log(text.as_bytes()), "{text}");
        }
    }
}
