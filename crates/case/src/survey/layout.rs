//! Where a table's columns stand: its header, its row of units, its first row of numbers.

use wholestring_units::Unit;

use super::Column;
use super::error::{SurveyError, SurveyErrorKind};
use super::heading::{self, Heading, HeadingUnit};
use super::number;
use super::table::{Position, Table};

/// A header stands within this many rows.
const HEADER_ROWS: usize = 200;

/// A column of a survey stands within this many columns.
const HEADER_COLUMNS: usize = 500;

/// A heading is spread over at most this many rows.
const STACKED: usize = 4;

/// A heading this near to a column's name is offered for it.
const NEAR: f64 = 0.6;

/// One column of the survey in the table.
#[derive(Debug, Clone)]
pub(super) struct Found {
    pub(super) column: Column,
    /// Which cell of each row.
    pub(super) index: usize,
    pub(super) unit: &'static Unit,
}

/// Where everything is.
#[derive(Debug, Clone)]
pub(super) struct Layout {
    pub(super) columns: Vec<Found>,
    /// The first row below the header and the units.
    pub(super) data: usize,
    /// The header's texts, by which a header repeated further down is known.
    pub(super) header: Vec<String>,
    pub(super) notes: Vec<String>,
}

impl Layout {
    pub(super) fn column(&self, column: Column) -> Option<&Found> {
        self.columns.iter().find(|found| found.column == column)
    }
}

/// A column's heading: the cell's index, its text and what it says.
type Taken = (usize, String, Heading);

/// A header row with the needed columns.
#[derive(Debug, Clone)]
pub(super) struct Header {
    /// Its last row.
    row: usize,
    headings: Vec<Taken>,
    /// Headings of columns that another was taken for.
    passed_over: Vec<String>,
    texts: Vec<String>,
}

/// A row that names some of the columns.
#[derive(Debug, Clone)]
pub(super) struct Partial {
    /// How many columns it names.
    pub(super) count: usize,
    row: usize,
    texts: Vec<String>,
    kind: SurveyErrorKind,
}

impl Partial {
    /// It is more than a title with a word that also heads columns.
    pub(super) fn is_header(&self) -> bool {
        self.count >= 2 || (self.count == 1 && self.texts.len() >= Column::NEEDED.len())
    }

    pub(super) fn error(self, table: &Table) -> SurveyError {
        let at = table.rows[self.row]
            .cells
            .iter()
            .filter(|cell| !cell.is_empty())
            .map(|cell| cell.at)
            .reduce(|first, last| {
                if first.0 == last.0 {
                    first
                } else {
                    Position(first.0, last.1)
                }
            });
        table.source.error(self.kind, at)
    }
}

/// Finds the header; `Err` has the row that comes nearest to one, if any names a column.
pub(super) fn header(table: &Table) -> Result<Header, Option<Partial>> {
    let mut best: Option<Partial> = None;
    for row in 0..table.rows.len().min(HEADER_ROWS) {
        if table.rows[row].texts().all(number::is_number) {
            continue;
        }
        for stacked in 1..=STACKED.min(row + 1) {
            let top = row + 1 - stacked;
            if stacked > 1 && (table.rows[top].is_empty() || table.rows[top].is_comment()) {
                break;
            }
            match named(table, top, row) {
                Ok(header) => return Ok(header),
                // A duplicate is told only if nothing else is: more rows may tell the two apart.
                Err(partial) if stacked == 1 && !table.rows[row].is_comment() => {
                    let better = best.as_ref().is_none_or(|best| partial.count >= best.count);
                    if partial.texts.len() > 1 && better {
                        best = Some(partial);
                    }
                }
                Err(_) => {}
            }
        }
    }
    Err(best)
}

/// The columns that the rows from `top` to `row` name together.
fn named(table: &Table, top: usize, row: usize) -> Result<Header, Partial> {
    let rows = &table.rows[top..=row];
    let width = rows.iter().map(|row| row.cells.len()).max().unwrap_or(0);
    let width = width.min(HEADER_COLUMNS);
    let texts: Vec<String> = (0..width)
        .map(|index| {
            let parts: Vec<&str> = rows
                .iter()
                .map(|row| row.text(index))
                .filter(|text| !text.is_empty())
                .collect();
            parts.join(" ")
        })
        .collect();
    let headings: Vec<(usize, Heading)> = texts
        .iter()
        .enumerate()
        .filter_map(|(index, text)| Some((index, heading::recognise(text)?)))
        .collect();

    let mut taken: Vec<Taken> = Vec::new();
    let mut passed_over = Vec::new();
    let mut fault = None;
    for column in Column::ALL {
        let of = |(_, heading): &&(usize, Heading)| heading.column == column;
        let mut candidates: Vec<&(usize, Heading)> = headings.iter().filter(of).collect();
        candidates.sort_by_key(|(_, heading)| heading.rank);
        match candidates[..] {
            [] if Column::NEEDED.contains(&column) => {
                fault.get_or_insert_with(|| missing(column, &texts));
            }
            [] => {}
            [first, second, ..] if first.1.rank == second.1.rank => {
                fault.get_or_insert(SurveyErrorKind::DuplicateColumn {
                    column,
                    first: texts[first.0].clone(),
                    second: texts[second.0].clone(),
                });
            }
            [first, ref others @ ..] => {
                taken.push((first.0, texts[first.0].clone(), first.1.clone()));
                passed_over.extend(others.iter().map(|other| texts[other.0].clone()));
            }
        }
    }
    // One alone is no position: "N" may as well number the rows.
    let is_plan = |column| matches!(column, Column::North | Column::East);
    if taken
        .iter()
        .filter(|(_, _, heading): &&Taken| is_plan(heading.column))
        .count()
        == 1
    {
        let alone = taken.extract_if(.., |(_, _, heading)| is_plan(heading.column));
        passed_over.extend(alone.map(|(_, text, _)| text));
    }
    match fault {
        None => Ok(Header {
            row,
            headings: taken,
            passed_over,
            texts,
        }),
        Some(kind) => {
            let count = Column::ALL
                .iter()
                .filter(|column| {
                    headings
                        .iter()
                        .any(|(_, heading)| heading.column == **column)
                })
                .count();
            let texts = texts.into_iter().filter(|text| !text.is_empty()).collect();
            Err(Partial {
                count,
                row,
                texts,
                kind,
            })
        }
    }
}

fn missing(column: Column, texts: &[String]) -> SurveyErrorKind {
    let headers: Vec<String> = texts
        .iter()
        .filter(|text| !text.is_empty())
        .cloned()
        .collect();
    let nearest = headers
        .iter()
        .filter(|text| heading::recognise(text).is_none())
        .map(|text| (heading::nearness(column, text), text))
        .filter(|(nearness, _)| *nearness >= NEAR)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, text)| text.clone());
    SurveyErrorKind::MissingColumn {
        column,
        headers,
        nearest,
    }
}

/// The layout below a header: its units, and where the numbers begin.
pub(super) fn below(table: &Table, header: Header) -> Result<Layout, SurveyError> {
    let row = table.source.row_name(table.rows[header.row].end);
    let mut notes = vec![table.note(&format!("header in {row}"))];
    for text in &header.passed_over {
        notes.push(format!("the column '{text}' is not used"));
    }
    let (units_row, data) = units_row(table, &header);
    let bare = bare_md_inc_azi(&header, units_row.is_some());

    let mut columns = Vec::new();
    let mut in_degrees = Vec::new();
    for (index, text, heading) in &header.headings {
        let column = heading.column;
        let header_at = header_position(table, header.row, *index);
        let in_row = match units_row {
            Some(row) => unit_in_row(table, row, *index, column)?,
            None => None,
        };
        let unit = match (&heading.unit, in_row) {
            (HeadingUnit::Wrong { found, is }, _) => {
                let kind = SurveyErrorKind::WrongUnit {
                    column,
                    found: found.clone(),
                    is: *is,
                };
                return Err(table.source.error(kind, Some(header_at)));
            }
            (HeadingUnit::Unit(in_header), Some((in_row, at))) if *in_header != in_row => {
                let kind = SurveyErrorKind::UnitConflict {
                    column,
                    header: in_header.symbol,
                    row: in_row.symbol,
                };
                return Err(table.source.error(kind, Some(at)));
            }
            (HeadingUnit::Unit(unit), _) => *unit,
            (HeadingUnit::None, Some((unit, _))) => unit,
            (HeadingUnit::None, None) => match column {
                Column::Inclination | Column::Azimuth => {
                    in_degrees.push(column.to_string());
                    named_unit(column, "deg")
                }
                _ if bare => named_unit(column, "m"),
                _ => {
                    let kind = SurveyErrorKind::MissingUnit {
                        column,
                        header: text.clone(),
                    };
                    return Err(table.source.error(kind, Some(header_at)));
                }
            },
        };
        notes.push(format!("{column} from '{text}' in {}", unit.symbol));
        columns.push(Found {
            column,
            index: *index,
            unit,
        });
    }
    if bare {
        notes.push("the header 'md, inc, azi' has no units: read in m, deg, deg".to_owned());
    } else if !in_degrees.is_empty() {
        notes.push(format!(
            "no unit for {}: read in degrees",
            in_degrees.join(" and ")
        ));
    }
    Ok(Layout {
        columns,
        data,
        header: header.texts,
        notes,
    })
}

/// Three columns of numbers without a header, from the first row that is such; `Err` if the
/// numbers stand in more columns, or under a header that names none of them.
pub(super) fn without_header(table: &Table) -> Option<Layout> {
    let first = table.rows.iter().position(|row| {
        !row.is_empty() && row.texts().count() > 1 && row.texts().all(number::is_number)
    })?;
    let headed = table.rows[..first]
        .iter()
        .any(|row| !row.is_comment() && row.texts().count() >= Column::NEEDED.len());
    if headed || table.rows[first].texts().count() != Column::NEEDED.len() {
        return None;
    }
    let cells = &table.rows[first].cells;
    let filled = cells
        .iter()
        .enumerate()
        .filter(|(_, cell)| !cell.is_empty());
    let columns = filled
        .zip(Column::NEEDED)
        .map(|((index, _), column)| {
            let symbol = if column == Column::MeasuredDepth {
                "m"
            } else {
                "deg"
            };
            Found {
                column,
                index,
                unit: named_unit(column, symbol),
            }
        })
        .collect();
    let notes = vec![
        table.note("no header"),
        "three columns read as measured depth in m, inclination in deg, azimuth in deg".to_owned(),
    ];
    Some(Layout {
        columns,
        data: first,
        header: Vec::new(),
        notes,
    })
}

/// The row of units below a header, if there is one, and the row after it.
fn units_row(table: &Table, header: &Header) -> (Option<usize>, usize) {
    let below = header.row + 1;
    let drawn = |row: usize| table.rows[row].is_empty() || table.rows[row].is_rule();
    let Some(row) = (below..table.rows.len()).find(|&row| !drawn(row)) else {
        return (None, below);
    };
    let mut cells = header
        .headings
        .iter()
        .map(|(index, _, heading)| (heading.column, table.rows[row].text(*index)))
        .filter(|(_, text)| !text.is_empty())
        .peekable();
    let mut names_unit = false;
    let mut names_number = false;
    for (column, text) in cells.by_ref() {
        let unit = heading::bare_unit(text);
        names_unit |= column.dimension().find_unit(unit).is_some();
        names_unit |= heading::dimension_of(unit).is_some();
        names_number |= number::is_number(text);
    }
    if names_unit && !names_number {
        (Some(row), row + 1)
    } else {
        (None, below)
    }
}

/// The unit in a row of units, and where it stands.
fn unit_in_row(
    table: &Table,
    row: usize,
    index: usize,
    column: Column,
) -> Result<Option<(&'static Unit, Position)>, SurveyError> {
    let Some(cell) = table.rows[row].cells.get(index) else {
        return Ok(None);
    };
    let text = heading::bare_unit(&cell.text);
    if text.is_empty() || text.chars().all(|c| "-=_".contains(c)) {
        return Ok(None);
    }
    match column.dimension().find_unit(text) {
        Some(unit) => Ok(Some((unit, cell.at))),
        None => {
            let is = heading::dimension_of(text);
            let kind = SurveyErrorKind::WrongUnit {
                column,
                found: text.to_owned(),
                is,
            };
            Err(table.source.error(kind, Some(cell.at)))
        }
    }
}

/// The header is `md`, `inc`, `azi` as the case file's own keys, and nothing gives a unit.
fn bare_md_inc_azi(header: &Header, units_row: bool) -> bool {
    let is = |column, name| {
        header
            .headings
            .iter()
            .any(|(_, text, heading)| heading.column == column && text == name)
    };
    !units_row
        && is(Column::MeasuredDepth, "md")
        && is(Column::Inclination, "inc")
        && is(Column::Azimuth, "azi")
        && header
            .headings
            .iter()
            .all(|(_, _, heading)| heading.unit == HeadingUnit::None)
}

fn header_position(table: &Table, row: usize, index: usize) -> Position {
    let row = &table.rows[row];
    row.cells.get(index).map_or(row.end, |cell| cell.at)
}

/// A unit of the column by its symbol; the dimension's first if the symbol were not its.
fn named_unit(column: Column, symbol: &str) -> &'static Unit {
    let dimension = column.dimension();
    dimension.find_unit(symbol).unwrap_or(&dimension.units()[0])
}
