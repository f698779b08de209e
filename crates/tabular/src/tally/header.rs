//! Headings of a tally: in one row or stacked in several, some over more than one column.

use wholestring_units::{Dimension, Unit};

use crate::{
    cells::{
        number,
        table::{Row, Table},
    },
    columns::{
        column::Column,
        heading::{self, HeadingUnit},
        names::TALLY,
    },
};

/// Number of rows searched for a header.
const HEADER_ROWS: usize = 200;

/// Number of columns searched for those of a tally.
const HEADER_COLUMNS: usize = 100;

/// Maximum number of rows of a heading.
const STACKED: usize = 4;

/// Maximum number of words of a unit in a heading: `lb / ft`.
const UNIT_WORDS: usize = 3;

/// A unit and its dimension: a weight per length may be given as a force.
pub(crate) type OfUnit = (&'static Unit, Dimension);

/// A column with its heading.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Headed {
    pub(crate) column: Column,
    pub(crate) index: usize,
    pub(crate) text: String,
    pub(crate) unit: Option<OfUnit>,
    /// A text in brackets that is not one of its units.
    pub(crate) wrong: Option<String>,
    rank: u8,
}

/// A header with the columns that a tally requires.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Header {
    pub(crate) row: usize,
    pub(crate) columns: Vec<Headed>,
    /// Headings that are not used.
    pub(crate) unused: Vec<String>,
    pub(crate) texts: Vec<String>,
}

/// Header of a table, or the closest match.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Found {
    Header(Header),
    /// Some of the headings, in a row: their number, the missing column, and all of them.
    Nearest {
        count: usize,
        row: usize,
        missing: Column,
        texts: Vec<String>,
    },
    Nothing,
}

/// Finds the header of a tally.
pub(crate) fn find(table: &Table) -> Found {
    let mut nearest = Found::Nothing;
    for row in 0..table.rows.len().min(HEADER_ROWS) {
        let named = || table.rows[row].texts().take(HEADER_COLUMNS);
        if named().count() < 2 || named().all(number::is_number) {
            continue;
        }
        let mut best: Option<Header> = None;
        for stacked in 1..=STACKED.min(row + 1) {
            let top = row + 1 - stacked;
            if table.rows[top].is_empty() {
                break;
            }
            // A title has one cell.
            let is_stack = stacked == 1 || table.rows[top].texts().nth(1).is_some();
            for is_filled in [false, true] {
                if is_filled && stacked == 1 {
                    continue;
                }
                match named_by(&table.rows[top..=row], row, is_filled) {
                    Ok(header) => {
                        let better = best.as_ref().is_none_or(|best| {
                            let (own, other) = (header.columns.len(), best.columns.len());
                            own > other || (own == other && is_stack && !is_filled)
                        });
                        if better {
                            best = Some(header);
                        }
                    }
                    Err((count, missing, texts)) => {
                        let most = match &nearest {
                            Found::Nearest { count, .. } => *count,
                            _ => 1,
                        };
                        if count > most {
                            nearest = Found::Nearest { count, row, missing, texts };
                        }
                    }
                }
            }
        }
        if let Some(header) = best {
            return Found::Header(header);
        }
    }
    nearest
}

/// The columns that rows name together. If filled, a heading of an upper row also extends over the
/// empty cells to its right, as a heading over several columns does in a spreadsheet.
fn named_by(
    rows: &[Row],
    row: usize,
    is_filled: bool,
) -> Result<Header, (usize, Column, Vec<String>)> {
    let width = rows.iter().map(|row| row.cells.len()).max().unwrap_or(0).min(HEADER_COLUMNS);
    let mut above = vec![String::new(); rows.len()];
    let mut texts = Vec::with_capacity(width);
    let mut headed: Vec<Headed> = Vec::new();
    let mut unused = Vec::new();
    for index in 0..width {
        let mut parts: Vec<&str> = Vec::new();
        let last = rows.len() - 1;
        let own = rows[last].text(index);
        for (depth, row) in rows.iter().enumerate() {
            let text = row.text(index);
            if !text.is_empty() {
                above[depth] = text.to_owned();
            }
        }
        for (depth, row) in rows.iter().enumerate() {
            let text = row.text(index);
            let filled = is_filled && depth < last && !own.is_empty();
            let part = if filled { above[depth].as_str() } else { text };
            if !part.is_empty() {
                parts.push(part);
            }
        }
        let text = parts.join(" ");
        // `Tool joint` over all following columns: the heading below may be sufficient.
        let found = recognise(&text, index).or_else(|| match is_filled {
            true => recognise(own, index),
            false => None,
        });
        match found {
            Some(found) => headed.push(found),
            None if !text.is_empty() => unused.push(text.clone()),
            None => {}
        }
        texts.push(text);
    }
    let count =
        TALLY.columns.iter().filter(|column| headed.iter().any(|h| h.column == **column)).count();
    let mut columns = Vec::new();
    for &column in TALLY.columns {
        let mut own: Vec<Headed> = headed.iter().filter(|h| h.column == column).cloned().collect();
        own.sort_by_key(|headed| headed.rank);
        if own.len() > 1 && own[0].rank == own[1].rank && !column.is_words() {
            return Err((count.saturating_sub(1), column, texts));
        }
        let mut own = own.into_iter();
        columns.extend(own.next());
        unused.extend(own.map(|headed| headed.text));
    }
    // "Item" may be the number of a row, or the component.
    if !columns.iter().any(|headed| headed.column == Column::Component)
        && let Some(number) = columns.iter_mut().find(|headed| headed.column == Column::Number)
        && number.text.eq_ignore_ascii_case("item")
    {
        number.column = Column::Component;
    }
    let has = |column| columns.iter().any(|headed| headed.column == column);
    for &column in TALLY.needed {
        let is_there = match column {
            Column::Length => has(Column::Length) || has(Column::JointLength),
            column => has(column),
        };
        if !is_there {
            return Err((count, column, texts));
        }
    }
    Ok(Header { row, columns, unused, texts })
}

/// Parses a heading: its column, and its unit in brackets or after it.
fn recognise(text: &str, index: usize) -> Option<Headed> {
    let headed = |column, rank, unit, wrong| Headed {
        column,
        index,
        text: text.to_owned(),
        unit,
        wrong,
        rank,
    };
    if text == "#" {
        return Some(headed(Column::Number, 0, None, None));
    }
    // "OD in", "Length, ft", "Weight lb / ft": `in` and `at` are also words of names.
    let words: Vec<&str> = text.split([' ', ',', '_']).filter(|word| !word.is_empty()).collect();
    for count in 1..=UNIT_WORDS.min(words.len().saturating_sub(1)) {
        let (name, unit) = words.split_at(words.len() - count);
        let Some(named) = heading::recognise(&name.join(" "), &TALLY) else { continue };
        if named.unit == HeadingUnit::None
            && !named.column.is_words()
            && let Some((column, unit)) = unit_of(named.column, &unit.join(" "))
        {
            return Some(headed(column, named.rank, Some(unit), None));
        }
    }
    let heading = heading::recognise(text, &TALLY)?;
    match heading.unit {
        _ if heading.column.is_words() => Some(headed(heading.column, heading.rank, None, None)),
        HeadingUnit::None => Some(headed(heading.column, heading.rank, None, None)),
        HeadingUnit::Unit(unit) => {
            let unit = (unit, heading.column.dimension());
            Some(headed(heading.column, heading.rank, Some(unit), None))
        }
        HeadingUnit::Wrong { found, .. } => match unit_of(heading.column, &found) {
            Some((column, unit)) => Some(headed(column, heading.rank, Some(unit), None)),
            None => Some(headed(heading.column, heading.rank, None, Some(found))),
        },
    }
}

/// The unit that a cell names for a column: as a heading of the column, or alone as in a row of
/// units.
pub(crate) fn unit_named(column: Column, text: &str) -> Option<OfUnit> {
    let headed = recognise(text, 0).filter(|headed| headed.column == column);
    let alone = || Some(unit_of(column, heading::bare_unit(text))?.1);
    headed.and_then(|headed| headed.unit).or_else(alone)
}

/// Returns the unit of a column, and the column that results from it: a weight in pounds is that of
/// the whole component.
pub(crate) fn unit_of(column: Column, text: &str) -> Option<(Column, OfUnit)> {
    let find = |dimension: Dimension| Some((dimension.find_unit(text)?, dimension));
    let own = column.dimension();
    if let Some(unit) = find(own) {
        return Some((column, unit));
    }
    match column {
        Column::Mass | Column::NominalMass => {
            if let Some(unit) = find(Dimension::ForcePerLength) {
                return Some((column, unit));
            }
            let whole = find(Dimension::Mass).or_else(|| find(Dimension::Force))?;
            (column == Column::Mass).then_some((Column::TotalMass, whole))
        }
        Column::TotalMass => Some((column, find(Dimension::Force)?)),
        _ => None,
    }
}
