//! Reading rows back from their table.

use std::path::Path;

use super::{FromNumber, FromWord, Row};
use crate::{Data, ResultsError, Table};

/// A row that can be read back from its table.
pub trait ReadRow: Row + Sized {
    /// The rows of a table; `path` names its file in errors.
    ///
    /// # Errors
    /// A column that is missing or holds words in place of numbers or the reverse, and a value that
    /// the field cannot have, such as a word that is no operation.
    fn read(table: &Table, path: &Path) -> Result<Vec<Self>, ResultsError>;
}

/// A table whose rows are read.
pub(crate) struct Reader<'a> {
    table: &'a Table,
    path: &'a Path,
}

impl<'a> Reader<'a> {
    pub(crate) fn new(table: &'a Table, path: &'a Path) -> Self {
        Self { table, path }
    }

    /// The values of a column of numbers.
    pub(crate) fn numbers<N: FromNumber>(&self, name: &str) -> Result<Vec<N>, ResultsError> {
        let Data::Number(numbers) = self.column(name)? else {
            return Err(
                self.error(format_args!("its column `{name}` holds words, expected numbers"))
            );
        };
        numbers.iter().enumerate().map(|(row, number)| self.number(name, row, *number)).collect()
    }

    /// The values of a weight's column and of a torque's: each row has a number in one of them.
    pub(crate) fn loads<N: FromNumber>(
        &self,
        weight: &str,
        torque: &str,
    ) -> Result<Vec<N>, ResultsError> {
        let weights = self.numbers::<Option<f64>>(weight)?;
        let torques = self.numbers::<Option<f64>>(torque)?;
        let loads = weights.into_iter().zip(torques).enumerate();
        loads
            .map(|(row, (of_weight, of_torque))| self.number(weight, row, of_weight.or(of_torque)))
            .collect()
    }

    fn number<N: FromNumber>(
        &self,
        name: &str,
        row: usize,
        number: Option<f64>,
    ) -> Result<N, ResultsError> {
        N::from_number(number).ok_or_else(|| {
            let found = number.map_or_else(|| "empty".to_owned(), |number| number.to_string());
            self.unexpected(name, row, &found, N::EXPECTED)
        })
    }

    /// The values of a column of words.
    pub(crate) fn words<W: FromWord>(&self, name: &str) -> Result<Vec<W>, ResultsError> {
        let Data::Text(words) = self.column(name)? else {
            return Err(
                self.error(format_args!("its column `{name}` holds numbers, expected words"))
            );
        };
        let value = |(row, word): (usize, &String)| {
            W::from_word(word)
                .ok_or_else(|| self.unexpected(name, row, &format!("'{word}'"), W::EXPECTED))
        };
        words.iter().enumerate().map(value).collect()
    }

    fn column(&self, name: &str) -> Result<&'a Data, ResultsError> {
        let column = self.table.column(name).map(|column| &column.data);
        column.ok_or_else(|| self.error(format_args!("it has no column `{name}`")))
    }

    fn unexpected(&self, name: &str, row: usize, found: &str, expected: &str) -> ResultsError {
        let row = row + 1;
        self.error(format_args!("its column `{name}` is {found} in row {row}, expected {expected}"))
    }

    fn error(&self, reason: std::fmt::Arguments<'_>) -> ResultsError {
        ResultsError::format(self.path, reason)
    }
}
