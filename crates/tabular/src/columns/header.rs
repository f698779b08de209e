//! The header: the row or rows that name the columns.

use super::names::Sort;
use crate::{
    cells::{
        number,
        table::{Position, Table},
    },
    columns::{
        column::Column,
        heading::{self, Heading},
    },
    error::{TableError, TableErrorKind},
};

/// Number of rows searched for a header.
const HEADER_ROWS: usize = 200;

/// Number of columns searched for those of a survey.
const HEADER_COLUMNS: usize = 500;

/// Maximum number of rows of a heading.
const STACKED: usize = 4;

/// Minimum number of headings in a header; a row with fewer is a title that contains the word of
/// one.
const FEWEST_HEADINGS: usize = 3;

/// Similarity from which a heading is suggested for a column.
const NEAR: f64 = 0.6;

/// A column's heading: the cell's index, its text and its meaning.
pub(crate) type Taken = (usize, String, Heading);

/// A header row with the needed columns.
#[derive(Debug, Clone)]
pub(crate) struct Header {
    /// Its last row.
    pub(crate) row: usize,
    pub(crate) headings: Vec<Taken>,
    /// Further headings of columns for which another heading is used.
    pub(crate) passed_over: Vec<String>,
    pub(crate) texts: Vec<String>,
}

/// A row that names some of the columns.
#[derive(Debug, Clone)]
pub(crate) struct Partial {
    /// Number of columns that it names.
    pub(crate) count: usize,
    row: usize,
    texts: Vec<String>,
    fault: Fault,
}

/// Deficiency of a header. Headings similar to a missing one are searched for in the best row only.
#[derive(Debug, Clone, Copy)]
enum Fault {
    Missing(Column),
    Twice { column: Column, first: usize, second: usize },
}

impl Partial {
    /// Whether it is more than a title that contains the word of a heading.
    pub(crate) fn is_header(&self) -> bool {
        self.count >= 2 || (self.count == 1 && self.headings() >= FEWEST_HEADINGS)
    }

    /// Number of its cells that are not empty.
    fn headings(&self) -> usize {
        self.texts.iter().filter(|text| !text.is_empty()).count()
    }

    pub(crate) fn error(self, table: &Table, sort: &Sort) -> TableError {
        let at = table.rows[self.row]
            .cells
            .iter()
            .filter(|cell| !cell.is_empty())
            .map(|cell| cell.at)
            .reduce(
                |first, last| {
                    if first.0 == last.0 { first } else { Position(first.0, last.1) }
                },
            );
        let kind = match self.fault {
            Fault::Missing(column) => missing(column, self.texts, sort),
            Fault::Twice { column, first, second } => TableErrorKind::DuplicateColumn {
                column,
                first: self.texts[first].clone(),
                second: self.texts[second].clone(),
            },
        };
        table.source.error(kind, at)
    }
}

/// Finds the header; `Err` contains the row that resembles one most, if any names a column.
pub(crate) fn find(table: &Table, sort: &Sort) -> Result<Header, Option<Partial>> {
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
            match named(table, top, row, sort) {
                Ok(header) => return Ok(header),
                // A duplicate is reported only if there is no other error, because more rows may
                // distinguish the two.
                Err(partial) if stacked == 1 && !table.rows[row].is_comment() => {
                    let better = best.as_ref().is_none_or(|best| partial.count >= best.count);
                    if partial.headings() > 1 && better {
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
fn named(table: &Table, top: usize, row: usize, sort: &Sort) -> Result<Header, Partial> {
    let rows = &table.rows[top..=row];
    let width = rows.iter().map(|row| row.cells.len()).max().unwrap_or(0);
    let width = width.min(HEADER_COLUMNS);
    let texts: Vec<String> = (0..width)
        .map(|index| {
            let parts: Vec<&str> =
                rows.iter().map(|row| row.text(index)).filter(|text| !text.is_empty()).collect();
            parts.join(" ")
        })
        .collect();
    let headings: Vec<(usize, Heading)> = texts
        .iter()
        .enumerate()
        .filter_map(|(index, text)| Some((index, heading::recognise(text, sort)?)))
        .collect();

    let mut taken: Vec<Taken> = Vec::new();
    let mut passed_over = Vec::new();
    let mut fault = None;
    for &column in sort.columns {
        let is_of_column = |(_, heading): &&(usize, Heading)| heading.column == column;
        let mut candidates: Vec<&(usize, Heading)> = headings.iter().filter(is_of_column).collect();
        candidates.sort_by_key(|(_, heading)| heading.rank);
        match candidates[..] {
            [] if sort.needed.contains(&column) => {
                fault.get_or_insert(Fault::Missing(column));
            }
            [] => {}
            [first, second, ..] if first.1.rank == second.1.rank => {
                fault.get_or_insert(Fault::Twice { column, first: first.0, second: second.0 });
            }
            [first, ref others @ ..] => {
                taken.push((first.0, texts[first.0].clone(), first.1.clone()));
                passed_over.extend(others.iter().map(|other| texts[other.0].clone()));
            }
        }
    }
    // One alone is not a position: "N" may also be the number of a row.
    let is_plan = |column| matches!(column, Column::North | Column::East);
    if taken.iter().filter(|(_, _, heading): &&Taken| is_plan(heading.column)).count() == 1 {
        let alone = taken.extract_if(.., |(_, _, heading)| is_plan(heading.column));
        passed_over.extend(alone.map(|(_, text, _)| text));
    }
    match fault {
        None => Ok(Header { row, headings: taken, passed_over, texts }),
        Some(fault) => {
            let count = sort
                .columns
                .iter()
                .filter(|column| headings.iter().any(|(_, heading)| heading.column == **column))
                .count();
            Err(Partial { count, row, texts, fault })
        }
    }
}

/// The error of a header without that column: its headings and similar ones.
fn missing(column: Column, texts: Vec<String>, sort: &Sort) -> TableErrorKind {
    let headers: Vec<String> = texts.into_iter().filter(|text| !text.is_empty()).collect();
    let nearest = headers
        .iter()
        .filter(|text| heading::recognise(text, sort).is_none())
        .map(|text| (heading::nearness(column, text), text))
        .filter(|(nearness, _)| *nearness >= NEAR)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, text)| text.clone());
    TableErrorKind::MissingColumn { column, headers, nearest }
}

/// A header among tables.
pub(crate) enum Headed<'a> {
    Found(&'a Table<'a>, Header),
    /// The most similar one.
    Nearest(Partial, &'a Table<'a>),
    None,
}

/// The first of the tables with a header that names the needed columns.
pub(crate) fn headed<'a>(tables: &'a [Table<'a>], sort: &Sort) -> Headed<'a> {
    let mut nearest: Option<(Partial, &Table)> = None;
    for table in tables {
        match find(table, sort) {
            Ok(header) => return Headed::Found(table, header),
            Err(Some(partial)) => {
                let nearer = nearest.as_ref().is_none_or(|(best, _)| partial.count > best.count);
                if nearer {
                    nearest = Some((partial, table));
                }
            }
            Err(None) => {}
        }
    }
    nearest.map_or(Headed::None, |(partial, table)| Headed::Nearest(partial, table))
}
