//! Rows of the tables: each is declared once, with its fields, columns and JSON.

mod declaration;
mod read;
#[cfg(test)]
mod tests;
mod value;

use std::{borrow::Borrow, slice::IterMut};

pub use read::ReadRow;

pub(crate) use self::{
    declaration::rows,
    read::Reader,
    value::{FromNumber, FromWord, Number, Part, Word, named, parts},
};
use crate::{Column, ColumnSpec, Data, Table};

/// A row of a table, whose columns are declared together with it.
pub trait Row {
    /// Columns of the table, in the order of the file.
    const COLUMNS: &'static [ColumnSpec];

    /// Appends the cells of the row, in the order of the columns.
    #[doc(hidden)]
    fn append(&self, cells: &mut Cells<'_>);

    /// The table of these rows.
    fn table<R: Borrow<Self>>(rows: impl IntoIterator<Item = R>) -> Table {
        let mut table = Table::with_columns(Self::COLUMNS);
        Self::append_to(&mut table, rows);
        table
    }

    /// Adds rows to a table of such rows.
    ///
    /// # Panics
    /// If the table has other columns.
    fn append_to<R: Borrow<Self>>(table: &mut Table, rows: impl IntoIterator<Item = R>) {
        assert!(table.is_like(&Table::with_columns(Self::COLUMNS)), "it is a table of other rows");
        for row in rows {
            row.borrow().append(&mut Cells(table.columns_mut().iter_mut()));
        }
    }
}

/// Cells of a new row that are still to be appended, each to its column.
#[derive(Debug)]
pub struct Cells<'a>(IterMut<'a, Column>);

impl Cells<'_> {
    /// Appends the next number; a number that is not finite is `None`.
    pub(crate) fn number(&mut self, number: &impl Number) {
        match self.0.next().map(|column| &mut column.data) {
            Some(Data::Number(all)) => all.push(number.number().filter(|value| value.is_finite())),
            _ => unreachable!("the declaration makes a column of numbers"),
        }
    }

    /// Appends the next word.
    pub(crate) fn word(&mut self, word: &impl Word) {
        match self.0.next().map(|column| &mut column.data) {
            Some(Data::Text(all)) => all.push(word.word().to_owned()),
            _ => unreachable!("the declaration makes a column of words"),
        }
    }
}

/// A column of numbers of this type.
///
/// # Panics
/// If a number may be missing and no condition for that is declared: in a constant this is a
/// compile error.
pub(crate) const fn numbers<N: Number>(spec: ColumnSpec) -> ColumnSpec {
    assert!(!N::MAY_BE_NONE || spec.null_where.is_some(), "an optional number needs `null_where`");
    spec
}

/// A column of words of this type.
///
/// # Panics
/// As [`numbers`].
pub(crate) const fn words<W: Word>(spec: ColumnSpec) -> ColumnSpec {
    assert!(!W::MAY_BE_NONE || spec.null_where.is_some(), "an optional word needs `null_where`");
    spec
}

/// A column that several tables share.
///
/// # Panics
/// If it has another name, or is of another kind: in a constant this is a compile error.
pub(crate) const fn shared(spec: ColumnSpec, declared: ColumnSpec) -> ColumnSpec {
    assert!(spec.text == declared.text, "the shared column is of another kind");
    let (name, expected) = (spec.name.as_bytes(), declared.name.as_bytes());
    assert!(name.len() == expected.len(), "the shared column has another name");
    let mut place = 0;
    while place < name.len() {
        assert!(name[place] == expected[place], "the shared column has another name");
        place += 1;
    }
    spec
}

/// Total number of columns in these lists.
pub(crate) const fn count(lists: &[&[ColumnSpec]]) -> usize {
    let (mut total, mut place) = (0, 0);
    while place < lists.len() {
        total += lists[place].len();
        place += 1;
    }
    total
}

/// The columns of these lists, one list after the other.
///
/// # Panics
/// If `N` is not their total number.
pub(crate) const fn joined<const N: usize>(lists: &[&[ColumnSpec]]) -> [ColumnSpec; N] {
    assert!(count(lists) == N);
    let mut all = [ColumnSpec::text("", ""); N];
    let (mut end, mut list) = (0, 0);
    while list < lists.len() {
        let mut place = 0;
        while place < lists[list].len() {
            all[end] = lists[list][place];
            end += 1;
            place += 1;
        }
        list += 1;
    }
    all
}
