//! Converts rows of cells to components and totals.

use wholestring_units::Unit;

use super::{
    cell::{self, holds},
    header::{Found, Header, find, unit_named, unit_of},
    imported::{ImportedTally, TallyCell, TallyRow, TallyTotal},
    layout::{self, Laid, Layout, Lines},
};
use crate::{
    cells::{
        limits::too_much,
        number::{self, Style},
        table::{Cell, Position, Row, Source, Table},
    },
    columns::column::Column,
    error::{TableError, TableErrorKind},
    survey::reader::whole,
};

/// Maximum number of rows of a tally: a thousand stands of joints.
const MOST_ROWS: usize = 5000;

/// Maximum number of skipped rows that are listed.
const NAMED: usize = 5;

/// Reads the tally of a table.
pub(crate) fn read(
    table: &Table,
    said: &mut dyn FnMut(Column) -> Option<&'static Unit>,
) -> Option<Result<ImportedTally, TableError>> {
    let Found::Header(header) = find(table) else { return None };
    Some(layout::below(table, &header, said).and_then(|layout| below(table, &header, &layout)))
}

fn below(table: &Table, header: &Header, layout: &Layout) -> Result<ImportedTally, TableError> {
    let lines = Lines::of(table.source);
    let style = style(table, layout)?;
    let mut notes = layout.notes.clone();
    if style == Style::Comma {
        notes.push("a comma is read as the decimal sign".to_owned());
    }
    let mut left_out: Vec<String> =
        header.unused.iter().map(|text| format!("the column '{text}'")).collect();
    let mut passed_over = 0;
    let mut rows: Vec<TallyRow> = Vec::new();
    let mut totals = Vec::new();
    for row in &table.rows[layout.data.min(table.rows.len())..] {
        if row.is_empty() || row.is_rule() {
            continue;
        }
        let kind = kind(row, header, layout);
        let place = lines.row(whole(row));
        if kind == Kind::Remark {
            check_units(table, row, layout)?;
            passed_over += 1;
            if passed_over <= NAMED {
                let text: String = row.texts().next().unwrap_or("").chars().take(60).collect();
                left_out.push(format!("{place}: '{text}'"));
            }
            continue;
        }
        if kind == Kind::Component {
            let is_of_numbers = |index: usize| {
                layout.columns.iter().any(|laid| laid.index == index && !laid.column.is_words())
            };
            table.check_width(row, &header.texts, is_of_numbers)?;
        }
        let mut cells = Vec::new();
        for laid in &layout.columns {
            // Only the length of a sum is used, and it may have other columns than the rows.
            let is_summed = matches!(laid.column, Column::Length | Column::CumulativeLength);
            if kind == Kind::Total && !is_summed {
                continue;
            }
            let Some(found) = row.cells.get(laid.index) else { continue };
            match holds(found, laid, style) {
                Ok(Some(holds)) => cells.push(TallyCell {
                    column: laid.column,
                    place: lines.cell(found.at, &laid.heading),
                    written: found.text.clone(),
                    holds,
                }),
                Ok(None) => {}
                Err(_) if kind == Kind::Total => {}
                Err(error) => {
                    let at = match error {
                        TableErrorKind::MissingReadingUnit { .. } => {
                            place_of_unit(table, (header, layout), laid, found)
                        }
                        _ => found.at,
                    };
                    return Err(table.source.error(error, Some(at)));
                }
            }
        }
        if kind == Kind::Total {
            let length = |cell: &&TallyCell| cell.si().is_some();
            totals.extend(
                cells
                    .iter()
                    .find(length)
                    .map(|length| TallyTotal { rows_above: rows.len(), length: length.clone() }),
            );
            continue;
        }
        if rows.len() == MOST_ROWS {
            let kind = too_much(format!("more than {MOST_ROWS}"), "rows of a tally", MOST_ROWS);
            return Err(table.source.error(kind, Some(whole(row))));
        }
        rows.push(TallyRow { place, cells });
    }
    if passed_over > NAMED {
        left_out.push(format!("{} more rows without a component", passed_over - NAMED));
    }
    if rows.is_empty() {
        let kind = TableErrorKind::NoTally { found: "no component follows the header" };
        return Err(table.source.error(kind, table.rows.get(header.row).map(whole)));
    }
    notes.extend(table.notes.iter().cloned());
    let sheet = match table.source {
        Source::Sheet { sheet, .. } => Some(sheet.to_owned()),
        Source::Text { .. } => None,
    };
    Ok(ImportedTally { sheet, rows, totals, notes, left_out })
}

/// Checks that headings or units below the first rows are those of the table.
///
/// # Errors
/// The first cell with another unit.
fn check_units(table: &Table, row: &Row, layout: &Layout) -> Result<(), TableError> {
    for laid in &layout.columns {
        let (Some((above, _)), Some(cell)) = (laid.unit, row.cells.get(laid.index)) else {
            continue;
        };
        let other = unit_named(laid.column, &cell.text).filter(|(below, _)| *below != above);
        if let Some((below, _)) = other {
            let (column, above, below) = (laid.column, above.symbol, below.symbol);
            let kind = TableErrorKind::UnitChanges { column, above, below };
            return Err(table.source.error(kind, Some(cell.at)));
        }
    }
    Ok(())
}

/// Place of a missing unit: the heading, or the cell if other cells have a unit of their own.
fn place_of_unit(
    table: &Table,
    (header, layout): (&Header, &Layout),
    laid: &Laid,
    cell: &Cell,
) -> Position {
    let rows = &table.rows[layout.data.min(table.rows.len())..];
    let has_own = rows.iter().any(|row| {
        let (_, rest) = cell::part(row.text(laid.index));
        unit_of(laid.column, rest).is_some()
    });
    let heading = table.rows[header.row].cells.get(laid.index);
    heading.filter(|_| !has_own).map_or(cell.at, |heading| heading.at)
}

/// Kind of row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Component,
    Total,
    /// A title, a footnote, or the repeated header or units.
    Remark,
}

fn kind(row: &Row, header: &Header, layout: &Layout) -> Kind {
    let is_header = row.texts().count() > 1
        && row.texts().all(|text| header.texts.iter().any(|heading| heading == text));
    if is_header || layout::is_units(row, &header.columns) {
        return Kind::Remark;
    }
    if row.texts().take(3).any(is_total) {
        return Kind::Total;
    }
    let says = |laid: &&Laid| {
        let text = row.text(laid.index);
        let is_measure = !laid.column.is_words() || laid.column == Column::Joints;
        is_measure && !cell::is_blank(text)
    };
    // A remark that begins in a column of numbers contains only words.
    let has_digit = |text: &str| text.chars().any(|c| c.is_ascii_digit());
    let measures: Vec<&str> =
        layout.columns.iter().filter(says).map(|laid| row.text(laid.index)).collect();
    let alone = row.texts().nth(1).is_none();
    let says_nothing = !measures
        .iter()
        .any(|text| has_digit(text) || cell::is_to_surface(text) || *text == "a date");
    if says_nothing || (alone && row.texts().any(|text| text.contains(' '))) {
        return Kind::Remark;
    }
    Kind::Component
}

/// Whether a text is the label of a row of sums: `TOTAL`, `Sub-total`, `BHA total length`.
fn is_total(text: &str) -> bool {
    let lower = text.to_lowercase();
    let mut words = lower.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    let first = words.next();
    let is = |word: Option<&str>| {
        matches!(word, Some("total" | "totals" | "subtotal" | "sum" | "gesamt" | "summe"))
    };
    let second = words.next();
    is(first)
        || (first == Some("sub") && is(second))
        || is(words.next_back().or(second))
        || (text.len() <= 40 && lower.contains("total length"))
}

/// The style of the table's numbers.
fn style(table: &Table, layout: &Layout) -> Result<Style, TableError> {
    let cells = || {
        let rows = table.rows[layout.data.min(table.rows.len())..].iter();
        rows.flat_map(|row| {
            let numbers = layout.columns.iter().filter(|laid| !laid.column.is_words());
            numbers.filter_map(|laid| row.cells.get(laid.index))
        })
    };
    let written = |cell: &&Cell| cell.number.is_none();
    number::style(cells().filter(written).map(|cell| cell::part(&cell.text).0)).map_err(|found| {
        let at = cells().find(|cell| cell::part(&cell.text).0 == found).map(|cell| cell.at);
        table.source.error(TableErrorKind::AmbiguousComma { found: found.to_owned() }, at)
    })
}
