//! Tables in memory, and their CSV form.

use std::{io, path::Path};

use serde::{Deserialize, Serialize};
use wholestring::outcome::{self, ModelKind, Values};

use crate::{
    ColumnSpec, ResultsError,
    file::{read_at_most, write_whole},
    formula,
};

/// Upper bound of any table that is read back from CSV, bytes.
const LARGEST_CSV: u64 = 64 << 20;
const MAX_CELLS: usize = 8_000_000;

/// The values of one column.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Data {
    /// Numbers; `None` where one does not apply. A number that is not finite is written as `None`.
    Number(Vec<Option<f64>>),
    /// Words.
    Text(Vec<String>),
}

impl Data {
    /// Number of rows.
    pub fn len(&self) -> usize {
        match self {
            Self::Number(values) => values.len(),
            Self::Text(values) => values.len(),
        }
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// A column: its values and their meaning.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Column {
    /// Name, with the unit in it: `tension_N`.
    pub name: String,
    /// Unit symbol, empty where there is none.
    pub unit: String,
    /// Meaning of the values, in one sentence.
    pub meaning: String,
    /// The values.
    pub data: Data,
}

impl Column {
    /// Words that need no explanation beyond their name.
    pub fn words(name: impl Into<String>, words: Vec<String>) -> Self {
        Self::named(name, Data::Text(words))
    }

    /// Numbers that need no explanation beyond their name.
    pub fn numbers(name: impl Into<String>, numbers: Vec<Option<f64>>) -> Self {
        Self::named(name, Data::Number(numbers))
    }

    fn named(name: impl Into<String>, data: Data) -> Self {
        Self { name: name.into(), unit: String::new(), meaning: String::new(), data }
    }

    /// A column without rows.
    fn empty(spec: &ColumnSpec) -> Self {
        Self {
            name: spec.name.into(),
            unit: spec.unit.into(),
            meaning: spec.meaning.into(),
            data: if spec.text { Data::Text(Vec::new()) } else { Data::Number(Vec::new()) },
        }
    }
}

/// A table: columns of equal length.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Unchecked")]
pub struct Table {
    columns: Vec<Column>,
}

/// A table as it is stored.
#[derive(Deserialize)]
struct Unchecked {
    columns: Vec<Column>,
}

impl TryFrom<Unchecked> for Table {
    type Error = &'static str;

    fn try_from(stored: Unchecked) -> Result<Self, Self::Error> {
        let columns = stored.columns;
        let rows = columns.first().map_or(0, |first| first.data.len());
        if columns.iter().any(|column| column.data.len() != rows) {
            return Err("its columns differ in length");
        }
        Ok(Self { columns })
    }
}

impl Table {
    /// A table of these columns.
    ///
    /// # Panics
    /// If the columns differ in length.
    pub fn new(columns: Vec<Column>) -> Self {
        if let Some(first) = columns.first() {
            for column in &columns {
                assert_eq!(
                    column.data.len(),
                    first.data.len(),
                    "column `{}` is as long as `{}`",
                    column.name,
                    first.name
                );
            }
        }
        Self { columns }
    }

    /// A table without rows, with the columns of a registry ([`crate::NODES`], [`crate::TIME`]).
    pub fn with_columns(specs: &[ColumnSpec]) -> Self {
        Self::new(specs.iter().map(Column::empty).collect())
    }

    /// Adds rows: each list of `words` gives one word a row, or one for all rows, each slice of
    /// `numbers` one number a row, and the columns of numbers that are not named become `None`.
    ///
    /// # Panics
    /// If the table has no such column of that kind, a text column is not named, or the slices
    /// differ in length.
    pub fn append(&mut self, words: &[(&str, &[&str])], numbers: &[(&str, &[f64])]) {
        for &(name, _) in numbers {
            assert!(self.column(name).is_some(), "the table has no `{name}`");
        }
        let rows = numbers.first().map_or(0, |(_, values)| values.len());
        for column in &mut self.columns {
            match &mut column.data {
                Data::Text(all) => {
                    let word = words.iter().find(|(name, _)| *name == column.name);
                    let (name, words) =
                        word.unwrap_or_else(|| panic!("`{}` is named", column.name));
                    match words {
                        [word] => all.extend(std::iter::repeat_n((*word).to_owned(), rows)),
                        words => {
                            assert_eq!(words.len(), rows, "`{name}` is as long as the others");
                            all.extend(words.iter().map(|word| (*word).to_owned()));
                        }
                    }
                }
                Data::Number(all) => match numbers.iter().find(|(name, _)| *name == column.name) {
                    Some((name, values)) => {
                        assert_eq!(values.len(), rows, "`{name}` is as long as the others");
                        all.extend(values.iter().map(|value| finite(*value)));
                    }
                    None => all.extend(std::iter::repeat_n(None, rows)),
                },
            }
        }
    }

    /// Adds rows of declared quantities: `words` as in [`Table::append`], and the columns of
    /// `answer`, which a method has computed. Where the method does not know a column, its numbers
    /// are `None` and its words empty.
    ///
    /// # Panics
    /// As [`Table::append`], and if a column is missing although the method knows it, or exists
    /// although it does not.
    pub fn append_declared<T>(
        &mut self,
        words: &[(&str, &[&str])],
        declared: &[outcome::Column<T>],
        answer: &T,
        model: ModelKind,
    ) {
        self.append_first_declared(words, declared, answer, model, usize::MAX);
    }

    /// The same for the first rows, at most `most`.
    ///
    /// # Panics
    /// As [`Table::append_declared`].
    pub fn append_first_declared<T>(
        &mut self,
        words: &[(&str, &[&str])],
        declared: &[outcome::Column<T>],
        answer: &T,
        model: ModelKind,
        most: usize,
    ) {
        let values = declared.iter().map(|column| (&column.quantity, (column.of)(answer)));
        let values: Vec<_> = values.collect();
        let mut words = words.to_vec();
        let mut numbers: Vec<(&str, &[f64])> = Vec::new();
        for (quantity, values) in &values {
            let known = quantity.is_known_by(model);
            assert!(known || values.is_empty(), "{model:?} knows no `{}`", quantity.name);
            match values {
                Values::Words(_) if !known => words.push((quantity.name, &[""])),
                Values::Numbers(_) if !known => {}
                Values::Numbers(values) => {
                    numbers.push((quantity.name, &values[..most.min(values.len())]));
                }
                Values::Words(values) => {
                    words.push((quantity.name, &values[..most.min(values.len())]));
                }
            }
        }
        self.append(&words, &numbers);
    }

    /// Returns the table of a file with the columns that are declared for it. A column of numbers
    /// that it lacks, as the table of an earlier version may, is empty.
    ///
    /// # Errors
    /// A column of words that is not there, or a column that holds words in place of numbers or the
    /// reverse: the file holds another table.
    pub fn with_declared(
        mut self,
        declared: &[ColumnSpec],
        path: &Path,
    ) -> Result<Self, ResultsError> {
        let rows = self.rows();
        for spec in declared {
            let (expected, found) = match self.column(spec.name).map(|column| &column.data) {
                Some(Data::Text(_)) if !spec.text => ("numbers", "words"),
                Some(Data::Number(_)) if spec.text => ("words", "numbers"),
                Some(_) => continue,
                None if spec.text => {
                    let reason = format!("it has no column `{}`", spec.name);
                    return Err(ResultsError::format(path, reason));
                }
                None => {
                    let data = Data::Number(vec![None; rows]);
                    self.columns.push(Column { data, ..Column::empty(spec) });
                    continue;
                }
            };
            let reason = format!("its column `{}` holds {found}, expected {expected}", spec.name);
            return Err(ResultsError::format(path, reason));
        }
        Ok(self)
    }

    /// Whether another table has the same columns: their names, units and kinds.
    pub fn is_like(&self, other: &Self) -> bool {
        let about = |column: &Column| {
            let is_text = matches!(column.data, Data::Text(_));
            (column.name.clone(), column.unit.clone(), is_text)
        };
        self.columns.iter().map(about).eq(other.columns.iter().map(about))
    }

    /// The columns, in the order of the file.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// The columns, to which rows are added.
    pub(crate) fn columns_mut(&mut self) -> &mut [Column] {
        &mut self.columns
    }

    /// The columns, given away.
    pub(crate) fn into_columns(self) -> impl Iterator<Item = Column> {
        self.columns.into_iter()
    }

    /// The column of that name.
    pub fn column(&self, name: &str) -> Option<&Column> {
        self.columns.iter().find(|column| column.name == name)
    }

    /// The numbers of a column, if there is such a column of numbers.
    pub fn numbers(&self, name: &str) -> Option<&[Option<f64>]> {
        match &self.column(name)?.data {
            Data::Number(values) => Some(values),
            Data::Text(_) => None,
        }
    }

    /// The numbers of a column, NaN where there is none: in every row if there is no such column of
    /// numbers.
    pub fn values(&self, name: &str) -> Vec<f64> {
        match self.numbers(name) {
            Some(numbers) => numbers.iter().map(|value| value.unwrap_or(f64::NAN)).collect(),
            None => vec![f64::NAN; self.rows()],
        }
    }

    /// The words of a column, if there is such a column of words.
    pub fn words(&self, name: &str) -> Option<&[String]> {
        match &self.column(name)?.data {
            Data::Text(words) => Some(words),
            Data::Number(_) => None,
        }
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |column| column.data.len())
    }

    /// The rows for which `keep` has `true`.
    pub(crate) fn filtered(mut self, keep: &[bool]) -> Self {
        fn filter<T>(values: &mut Vec<T>, keep: &[bool]) {
            let mut kept = keep.iter();
            values.retain(|_| kept.next().is_some_and(|kept| *kept));
        }
        for column in &mut self.columns {
            match &mut column.data {
                Data::Number(numbers) => filter(numbers, keep),
                Data::Text(words) => filter(words, keep),
            }
        }
        self
    }

    /// Adds the rows of a table of the same columns.
    pub(crate) fn extend(&mut self, other: Self) {
        for (column, more) in self.columns.iter_mut().zip(other.columns) {
            match (&mut column.data, more.data) {
                (Data::Number(all), Data::Number(more)) => all.extend(more),
                (Data::Text(all), Data::Text(more)) => all.extend(more),
                _ => unreachable!("both are read by the same schema"),
            }
        }
    }

    /// Writes pieces of a table as [`Table::write_csv`] writes the whole; `like` has its columns.
    pub(crate) fn write_csv_pieces(
        path: &Path,
        like: &Self,
        pieces: impl FnOnce(
            &mut dyn FnMut(Self) -> Result<(), ResultsError>,
        ) -> Result<(), ResultsError>,
    ) -> Result<(), ResultsError> {
        let mut unread = None;
        let written = write_whole(path, |writer| {
            let mut csv = csv::Writer::from_writer(writer);
            like.write_header(&mut csv).map_err(io_error)?;
            let mut failed = None;
            let read = pieces(&mut |piece| {
                piece.write_rows(&mut csv).map_err(|error| {
                    failed = Some(io_error(error));
                    ResultsError::format(path, "it cannot be written")
                })
            });
            match (failed, read) {
                (Some(error), _) => Err(error),
                (None, Err(error)) => {
                    let readable = io::Error::other(error.to_string());
                    unread = Some(error);
                    Err(readable)
                }
                (None, Ok(())) => csv.flush(),
            }
        });
        match unread {
            Some(error) => Err(error),
            None => written,
        }
    }

    /// Writes the table as CSV: a header row of column names, numbers with the digits that make
    /// them exact, and nothing where a number does not apply. A text that a spreadsheet would take
    /// for a formula gets a leading apostrophe, which [`Table::read_csv`] removes again.
    pub fn write_csv(&self, path: &Path) -> Result<(), ResultsError> {
        write_whole(path, |writer| {
            let mut csv = csv::Writer::from_writer(writer);
            self.write_records(&mut csv).map_err(io_error)?;
            csv.flush()
        })
    }

    /// Reads back a CSV file, every column as words.
    ///
    /// # Errors
    /// A file that cannot be read, is no table, or holds more than 64 MB or 8 million cells.
    pub fn read_csv(path: &Path) -> Result<Self, ResultsError> {
        let bytes = read_at_most(path, LARGEST_CSV)?;
        let mut csv = csv::Reader::from_reader(&bytes[..]);
        let malformed = |error: csv::Error| ResultsError::format(path, defect(&error));
        let names = csv.headers().map_err(malformed)?.clone();
        let mut columns: Vec<Vec<String>> = vec![Vec::new(); names.len()];
        let mut cells = 0;
        for record in csv.records() {
            cells += columns.len();
            if cells > MAX_CELLS {
                let reason = format!("it holds more than {MAX_CELLS} cells");
                return Err(ResultsError::format(path, reason));
            }
            for (column, cell) in columns.iter_mut().zip(&record.map_err(malformed)?) {
                column.push(formula::unguarded(cell).to_owned());
            }
        }
        let columns = names.iter().zip(columns);
        let column = |(name, words)| Column::words(formula::unguarded(name), words);
        Ok(Self::new(columns.map(column).collect()))
    }

    fn write_records(&self, csv: &mut csv::Writer<impl io::Write>) -> csv::Result<()> {
        self.write_header(csv)?;
        self.write_rows(csv)
    }

    fn write_header(&self, csv: &mut csv::Writer<impl io::Write>) -> csv::Result<()> {
        let names = self.columns.iter().map(|column| column.name.as_str());
        csv.write_record(names.map(|name| formula::guarded(name).into_owned()))
    }

    fn write_rows(&self, csv: &mut csv::Writer<impl io::Write>) -> csv::Result<()> {
        for row in 0..self.rows() {
            for column in &self.columns {
                match &column.data {
                    Data::Number(values) => match values[row].and_then(finite) {
                        Some(value) => csv.write_field(value.to_string())?,
                        None => csv.write_field("")?,
                    },
                    Data::Text(values) => csv.write_field(&*formula::guarded(&values[row]))?,
                }
            }
            csv.write_record(None::<&[u8]>)?;
        }
        Ok(())
    }
}

fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

/// Defect of a CSV file in words.
fn defect(error: &csv::Error) -> String {
    let line = |position: &Option<csv::Position>| match position {
        Some(position) => format!("line {}", position.line()),
        None => "a line".to_owned(),
    };
    match error.kind() {
        csv::ErrorKind::UnequalLengths { pos, expected_len, len } => {
            format!("{} has {len} values, expected {expected_len} as in its heading", line(pos))
        }
        csv::ErrorKind::Utf8 { pos, .. } => {
            format!("{} is not UTF-8 text", line(pos))
        }
        _ => "it is no table of comma-separated values".to_owned(),
    }
}

fn io_error(error: csv::Error) -> io::Error {
    let sentence = error.to_string();
    match error.into_kind() {
        csv::ErrorKind::Io(error) => error,
        _ => io::Error::other(sentence),
    }
}
