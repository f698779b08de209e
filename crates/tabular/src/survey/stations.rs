//! Converts rows of numbers to stations.

use std::collections::HashSet;

use wholestring::well::Station;
use wholestring_units::number_text;

use super::{
    imported::{self, Dogleg},
    places::within_a_turn,
};
use crate::{
    cells::{
        number::{self, Style},
        table::{Row, Table},
    },
    columns::{
        column::Column,
        heading,
        layout::{Found as FoundColumn, Layout},
        names::{SURVEY, Sort},
    },
    error::{TableError, TableErrorKind},
    survey::{
        imported::ImportedSurvey,
        places::StationPlaces,
        preamble,
        reader::{Reader, position, style, whole},
    },
};

/// Maximum measured depth of a hole, m.
const DEEPEST_M: f64 = 1e5;

/// Maximum number of notes about skipped rows; further ones are counted.
const NOTED_ROWS: usize = 5;

/// Reason why the rows of a table are not a survey.
pub(crate) struct Broken {
    pub(crate) error: TableError,
    /// The row after the last valid station, if there is text between it and the error: another
    /// table may begin there.
    pub(crate) behind: Option<usize>,
}

impl From<TableError> for Broken {
    fn from(error: TableError) -> Self {
        Self { error, behind: None }
    }
}

/// Reads the rows below the header.
pub(crate) fn read(table: &Table, layout: &Layout) -> Result<ImportedSurvey, Broken> {
    let mut notes = layout.notes.clone();
    let mut rows = data_rows(table, layout, &SURVEY, &mut notes)?;
    let reader = Reader { table, style: style(table, layout, &rows)? };
    let is_turned = is_deepest_first(&reader, layout, &rows);
    if is_turned {
        rows.reverse();
        notes.push("the deepest station is listed first: the list is reversed".to_owned());
    }
    if reader.style == Style::Comma {
        notes.push("a comma is read as the decimal sign".to_owned());
    }
    notes.extend(marks(table, layout, &rows));
    let mut stations = Vec::with_capacity(rows.len());
    let mut station_rows = Vec::with_capacity(rows.len());
    let (mut alike, mut vertical, mut turned) = (Vec::new(), Vec::new(), Vec::new());
    for (place, &row) in rows.iter().enumerate() {
        let above = place.checked_sub(1).map(|above| &table.rows[rows[above]]);
        let found = station(&reader, layout, &table.rows[row], &stations, above);
        let found = found.map_err(|error| {
            // A station with a smaller depth, or words in its place.
            let behind = place.checked_sub(1).map(|above| rows[above] + 1);
            let words = !table.rows[row].texts().any(number::is_number);
            let behind = behind.filter(|&behind| !is_turned && (behind < row || words));
            Broken { error, behind }
        })?;
        match found {
            Found::Station { station, has_azimuth, is_turned } => {
                stations.push(station);
                station_rows.push(row);
                if !has_azimuth {
                    vertical.push(row);
                }
                if is_turned {
                    turned.push(row);
                }
            }
            Found::Alike => alike.push(row),
        }
    }
    notes.extend(counted(table, &vertical, |stations| {
        format!("the azimuth of {stations}, vertical and without one, is taken as 0")
    }));
    notes.extend(counted(table, &turned, |stations| {
        format!("the azimuth of {stations}, more than 360 deg, is reduced by 360 deg")
    }));
    notes.extend(counted(table, &alike, |stations| {
        format!("{stations} of the same depth as another and identical is left out")
    }));
    finish(&reader, layout, &station_rows, stations, notes).map_err(Broken::from)
}

/// A note on some rows: their number, and the place of the first.
fn counted(table: &Table, rows: &[usize], note: impl Fn(&str) -> String) -> Option<String> {
    let first = table.source.row_name(whole(&table.rows[*rows.first()?]));
    Some(match rows.len() {
        1 => format!("{} ({first})", note("1 station")),
        count => format!("{} (the first in {first})", note(&format!("{count} stations"))),
    })
}

/// Whether every depth is less than or equal to the one above it, so that the deepest station is
/// first. Two rows do not suffice to decide.
fn is_deepest_first(reader: &Reader, layout: &Layout, rows: &[usize]) -> bool {
    let Some(depth) = layout.column(Column::MeasuredDepth).filter(|_| rows.len() > 2) else {
        return false;
    };
    let depth_m = |&row: &usize| {
        let cell = reader.table.rows[row].cells.get(depth.index)?;
        reader.number(cell, Column::MeasuredDepth, depth.unit)
    };
    let depths: Option<Vec<f64>> = rows.iter().map(depth_m).collect();
    depths
        .is_some_and(|depths| depths.is_sorted_by(|a, b| a >= b) && depths.first() > depths.last())
}

/// Contents of a row.
enum Found {
    Station {
        station: Station,
        has_azimuth: bool,
        /// Whether its azimuth is a turn less than written.
        is_turned: bool,
    },
    /// A duplicate of the station in the row above.
    Alike,
}

/// Reads the station of a row after those above it.
fn station(
    reader: &Reader,
    layout: &Layout,
    row: &Row,
    above: &[Station],
    row_above: Option<&Row>,
) -> Result<Found, TableError> {
    let source = reader.table.source;
    let needed = Column::NEEDED.map(|column| layout.column(column));
    let [Some(depth), Some(inclination), Some(azimuth)] = needed else {
        return Err(source.error(TableErrorKind::NoHeader, None));
    };
    if let Some(expected) = reader.table.counted.filter(|&count| row.cells.len() < count) {
        let kind = TableErrorKind::ShortRow { found: row.cells.len(), expected };
        return Err(source.error(kind, Some(whole(row))));
    }
    reader.table.check_width(row, &layout.header, |index| layout.is_of_numbers(index))?;
    let md_m = reader.value(row, depth)?;
    if !(0.0..=DEEPEST_M).contains(&md_m) {
        return Err(reader.out_of_range(row, depth, "0 to 100 km"));
    }
    let angles = || -> Result<(Station, bool, bool), TableError> {
        let inclination_rad = reader.value(row, inclination)?;
        if !(0.0..=std::f64::consts::PI).contains(&inclination_rad) {
            return Err(reader.out_of_range(row, inclination, "0 to 180 deg"));
        }
        // A vertical hole has no azimuth.
        let has_azimuth = inclination_rad != 0.0 || !reader.is_missing(row, azimuth);
        let azimuth_rad = if has_azimuth { reader.value(row, azimuth)? } else { 0.0 };
        let turn = std::f64::consts::TAU;
        if !(-turn..=2.0 * turn).contains(&azimuth_rad) {
            return Err(reader.out_of_range(row, azimuth, "-360 to 720 deg"));
        }
        let (azimuth_rad, is_turned) = within_a_turn(azimuth_rad);
        Ok((Station { md_m, inclination_rad, azimuth_rad }, has_azimuth, is_turned))
    };
    if let Some(last) = above.last().filter(|last| md_m <= last.md_m) {
        let again = angles().ok().filter(|_| md_m == last.md_m);
        let is_alike = again.is_some_and(|(again, ..)| {
            again.inclination_rad == last.inclination_rad
                && (again.azimuth_rad == last.azimuth_rad || again.inclination_rad == 0.0)
        });
        if is_alike {
            return Ok(Found::Alike);
        }
        let written = |row: &Row| format!("{} {}", row.text(depth.index), depth.unit.symbol);
        let previous = row_above.map_or_else(String::new, written);
        let found = if md_m == last.md_m { previous.clone() } else { written(row) };
        let kind = TableErrorKind::DepthNotIncreasing { found, previous };
        return Err(source.error(kind, Some(position(row, depth))));
    }
    let (station, has_azimuth, is_turned) = angles()?;
    Ok(Found::Station { station, has_azimuth, is_turned })
}

/// Adds the further information on the stations.
fn finish(
    reader: &Reader,
    layout: &Layout,
    rows: &[usize],
    stations: Vec<Station>,
    mut notes: Vec<String>,
) -> Result<ImportedSurvey, TableError> {
    let table = reader.table;
    let (Some(&first), Some(&last), true) = (rows.first(), rows.last(), stations.len() > 1) else {
        let kind = TableErrorKind::TooFewStations { found: stations.len() };
        let last = rows.last().map_or(layout.data.saturating_sub(1), |&row| row);
        let at = table.rows.get(last).map(whole);
        return Err(table.source.error(kind, at));
    };
    let tie_in = reader.tie_in(layout, &table.rows[first], stations[0].md_m, &mut notes)?;
    if tie_in.is_none() && stations[0].md_m != 0.0 {
        notes.push(format!(
            "the first station is at {} m and the file does not give its position: assumed at a \
             true vertical depth equal to its measured depth, vertically below the origin",
            number_text(stations[0].md_m)
        ));
    }
    notes.extend(table.notes.iter().cloned());
    notes.push(format!("{} stations", stations.len()));
    notes.extend(nulls(reader, layout, rows));
    let dogleg = Dogleg::of(table, layout);
    let of_row =
        |&row: &usize| imported::position(reader, layout, dogleg.as_ref(), &table.rows[row]);
    let symbol = |column| layout.column(column).map_or("", |found: &FoundColumn| found.unit.symbol);
    let is_read = |index: usize| layout.columns.iter().any(|found| found.index == index);
    let unread = layout.header.iter().enumerate();
    let unread = unread.filter(|(index, text)| !text.is_empty() && !is_read(*index));
    Ok(ImportedSurvey {
        stations,
        tie_in,
        place: table
            .source
            .rows_name(whole(&table.rows[first.min(last)]), whole(&table.rows[first.max(last)])),
        places: StationPlaces::new(table, rows),
        units: Column::NEEDED.map(symbol),
        stated: rows.iter().map(of_row).collect(),
        unread: unread.map(|(_, text)| text.clone()).collect(),
        preamble: preamble::above(table, layout.data),
        notes,
    })
}

/// A note on positions that are null values, if there are any.
fn nulls(reader: &Reader, layout: &Layout, rows: &[usize]) -> Option<String> {
    let columns = [Column::TrueVerticalDepth, Column::North, Column::East];
    let is_null = |&row: &usize| {
        columns.iter().filter_map(|column| layout.column(*column)).any(|found| {
            let cell = reader.table.rows[row].cells.get(found.index);
            cell.is_some_and(|cell| reader.is_null(cell, found.column))
        })
    };
    let rows: Vec<usize> = rows.iter().copied().filter(is_null).collect();
    counted(reader.table, &rows, |stations| {
        format!("positions of {stations} that stand for no value, such as -999.25, are left out")
    })
}

/// A note on marks after numbers, if there are any.
fn marks(table: &Table, layout: &Layout, rows: &[usize]) -> Option<String> {
    let cells = rows.iter().flat_map(|&row| {
        let found = layout.columns.iter();
        found.filter_map(move |found| table.rows[row].cells.get(found.index))
    });
    let mut marked = cells.filter(|cell| {
        let text = cell.text.trim();
        number::without_marks(text).len() < text.len() && number::is_number(text)
    });
    let first = marked.next()?;
    let mark = &first.text.trim()[number::without_marks(&first.text).len()..];
    let row = table.source.row_name(first.at);
    Some(match marked.count() {
        0 => format!("the mark '{}' after a number in {row} is ignored", mark.trim()),
        more => {
            let mark = mark.trim();
            format!("the mark '{mark}' after a number in {row} is ignored, and {more} more")
        }
    })
}

/// Rows of data, other than empty rows, comments, rules, remarks and repeated headers.
///
/// # Errors
/// Headings or units that are repeated with another unit.
pub(crate) fn data_rows(
    table: &Table,
    layout: &Layout,
    sort: &Sort,
    notes: &mut Vec<String>,
) -> Result<Vec<usize>, TableError> {
    let mut rows = Vec::new();
    let mut passed_over = 0;
    let words: HashSet<&str> =
        layout.header.iter().flat_map(|heading| heading.split_whitespace()).collect();
    // A line of a header of several lines, or of its units, on another page.
    let of_header = |text: &str| {
        text.split_whitespace().all(|word| words.contains(word))
            || heading::dimension_of(heading::bare_unit(text)).is_some()
    };
    for (index, row) in table.rows.iter().enumerate().skip(layout.data) {
        if row.is_empty() || row.is_rule() {
            continue;
        }
        let needed: Vec<&str> = sort
            .needed
            .iter()
            .filter_map(|&column| layout.column(column))
            .map(|found| row.text(found.index))
            .collect();
        // A remark is in one cell; a row with some numbers is not a remark.
        let remark = needed.iter().filter(|text| !text.is_empty()).count() <= 1
            && !row.texts().any(number::is_number);
        let header = !layout.header.is_empty()
            && row.texts().count() > 1
            && !row.texts().any(number::is_number)
            && row.texts().all(of_header);
        if remark || header || row.is_comment() {
            if !row.is_comment() {
                layout.check_units(table, row, sort)?;
            }
            passed_over += 1;
            if passed_over <= NOTED_ROWS {
                let name = table.source.row_name(whole(row));
                let text: String = row.texts().next().unwrap_or("").chars().take(40).collect();
                notes.push(format!("{name} is skipped: '{text}'"));
            }
        } else {
            rows.push(index);
        }
    }
    if passed_over > NOTED_ROWS {
        notes.push(format!("{passed_over} such rows in all are skipped"));
    }
    Ok(rows)
}
