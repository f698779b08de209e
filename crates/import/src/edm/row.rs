//! Rows of an export, stored compactly.

use super::table::{TABLES, Table};
use crate::{
    error::{ImportError, ImportErrorKind},
    xml::{Event, Xml},
};

/// Separator of the values of a row.
const UNIT_SEPARATOR: char = '\u{1f}';

/// Maximum bytes of all rows that are kept. In an export of 200 MB a tenth of the text is in the
/// tables that are read; with this limit the program stays within 200 MB of memory.
const LARGEST: usize = 100 << 20;

/// Rows of one table: their values in the order of its columns, one after the other.
#[derive(Debug, Clone, Default)]
struct Stored {
    text: String,
    /// End of each row's text, and its line.
    rows: Vec<(u32, u32)>,
}

/// Rows of all tables that are read.
///
/// A file has them in any order, children before their parents, and is read once, so that all are
/// kept.
#[derive(Debug, Clone)]
pub(super) struct Rows {
    file: String,
    tables: Vec<Stored>,
}

/// A row of a table.
#[derive(Debug, Clone, Copy)]
pub(super) struct Row<'a> {
    rows: &'a Rows,
    pub(super) table: Table,
    index: usize,
}

impl Rows {
    /// Reads a file to its end.
    pub(super) fn read(mut xml: Xml) -> Result<Self, ImportError> {
        xml.only(|name| Table::of(name).is_some());
        let mut rows = Self {
            file: xml.file().to_owned(),
            tables: TABLES.iter().map(|_| Stored::default()).collect(),
        };
        let mut bytes = 0;
        let mut elements = 0_u64;
        loop {
            match xml.next()? {
                Event::Eof => break,
                Event::Text(_) | Event::End => {}
                Event::Start(element) => {
                    elements += 1;
                    let Some(table) = Table::of(&element.name) else { continue };
                    let declared = table.declared();
                    let stored = &mut rows.tables[table as usize];
                    let too_much = |found, most| ImportErrorKind::TooMuch { found, most };
                    if stored.rows.len() == declared.most {
                        let found =
                            format!("more than {} rows of {}", declared.most, declared.name);
                        return Err(xml.error(too_much(found, declared.most.to_string())));
                    }
                    let before = stored.text.len();
                    for (place, column) in declared.columns.iter().enumerate() {
                        if place > 0 {
                            stored.text.push(UNIT_SEPARATOR);
                        }
                        let own = element
                            .attributes
                            .iter()
                            .find(|(key, _)| key.eq_ignore_ascii_case(column));
                        let value = own.map_or("", |(_, value)| value.trim());
                        stored.text.extend(value.chars().filter(|c| !c.is_control()));
                    }
                    bytes += stored.text.len() - before;
                    if bytes > LARGEST {
                        let most = format!("{} MB", LARGEST >> 20);
                        let found =
                            format!("more than {most} in the tables of wells, strings and holes");
                        return Err(xml.error(too_much(found, most)));
                    }
                    let line = u32::try_from(element.line).unwrap_or(u32::MAX);
                    stored.rows.push((stored.text.len() as u32, line));
                }
            }
        }
        if rows.tables.iter().all(|stored| stored.rows.is_empty()) {
            let found = format!(
                "it is XML with {elements} elements, none of which is a row of Landmark's tables"
            );
            return Err(ImportError::new(
                &rows.file,
                None,
                ImportErrorKind::NotRecognised { found },
            ));
        }
        Ok(rows)
    }

    /// Rows of a table in file order.
    pub(super) fn of(&self, table: Table) -> impl Iterator<Item = Row<'_>> {
        let count = self.tables[table as usize].rows.len();
        (0..count).map(move |index| Row { rows: self, table, index })
    }

    /// An error of the whole file.
    pub(super) fn error(&self, kind: ImportErrorKind) -> ImportError {
        ImportError::new(&self.file, None, kind)
    }
}

impl<'a> Row<'a> {
    /// All its values.
    pub(super) fn text(self) -> &'a str {
        let stored = &self.rows.tables[self.table as usize];
        let from = match self.index {
            0 => 0,
            index => stored.rows[index - 1].0,
        };
        &stored.text[from as usize..stored.rows[self.index].0 as usize]
    }

    /// Value of a column; `None` if it is empty or missing.
    pub(super) fn get(self, column: &str) -> Option<&'a str> {
        let place = self.table.declared().columns.iter().position(|own| *own == column)?;
        self.text().split(UNIT_SEPARATOR).nth(place).filter(|value| !value.is_empty())
    }

    /// Whether all its values equal those of another.
    pub(super) fn same(self, other: Row) -> bool {
        self.table == other.table && self.text() == other.text()
    }

    /// Its line.
    pub(super) fn line(self) -> u32 {
        self.rows.tables[self.table as usize].rows[self.index].1
    }

    /// Place of a value.
    pub(super) fn place(self, column: &str) -> String {
        format!("line {}, {} {column}", self.line(), self.table.declared().name)
    }

    /// An error of a value.
    pub(super) fn error(self, column: &str, kind: ImportErrorKind) -> ImportError {
        ImportError::new(&self.rows.file, Some(self.place(column)), kind)
    }

    /// The number in a column.
    pub(super) fn number(self, column: &str) -> Result<Option<f64>, ImportError> {
        let Some(found) = self.get(column) else { return Ok(None) };
        let number = found.parse::<f64>().ok().filter(|number| number.is_finite());
        let kind =
            || ImportErrorKind::NotANumber { what: column.to_owned(), found: found.to_owned() };
        number.map(Some).ok_or_else(|| self.error(column, kind()))
    }
}
