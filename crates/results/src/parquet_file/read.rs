//! Reads tables from Parquet files.

use std::{fs::File, io, ops::Range, path::Path};

use parquet::{
    basic::Type as PhysicalType,
    column::reader::{ColumnReader, ColumnReaderImpl},
    data_type::{ByteArray, DataType},
    errors::ParquetError,
    file::reader::{FileReader, SerializedFileReader},
};

use wholestring_contain::contain;

use super::write::key;
use crate::{Column, Data, ResultsError, Table, parquet_guard};

impl Table {
    /// Reads back a table that [`Table::write_parquet`] wrote.
    pub fn read_parquet(path: &Path) -> Result<Self, ResultsError> {
        read(path)
    }

    /// Reads back the columns of these names, as far as the file has them, in pieces, because a
    /// table may be larger than memory. The pieces follow each other as the rows do.
    pub fn read_parquet_pieces(
        path: &Path,
        names: &[&str],
        take: impl FnMut(Self),
    ) -> Result<(), ResultsError> {
        read_groups(path, names, take)
    }
}

fn read(path: &Path) -> Result<Table, ResultsError> {
    let opened = Opened::new(path)?;
    let all = 0..opened.reader.num_row_groups();
    opened.read_some(|_| true, all)
}

/// Reads columns of these names, as far as the file has them, one row group after the other.
fn read_groups(
    path: &Path,
    names: &[&str],
    mut take: impl FnMut(Table),
) -> Result<(), ResultsError> {
    let opened = Opened::new(path)?;
    for group in 0..opened.reader.num_row_groups() {
        take(opened.read_some(|name| names.contains(&name), group..group + 1)?);
    }
    Ok(())
}

/// Reads one row group after the other, with all columns.
pub(crate) fn read_each_group(
    path: &Path,
    mut take: impl FnMut(Table) -> Result<(), ResultsError>,
) -> Result<(), ResultsError> {
    let opened = Opened::new(path)?;
    for group in 0..opened.reader.num_row_groups() {
        take(opened.read_some(|_| true, group..group + 1)?)?;
    }
    Ok(())
}

/// Reads the row groups in which a column of words has this one, one after the other: the columns
/// that are named, or all.
pub(crate) fn read_groups_with(
    path: &Path,
    (column, word): (&str, &str),
    names: Option<&[&str]>,
    mut take: impl FnMut(Table),
) -> Result<(), ResultsError> {
    let opened = Opened::new(path)?;
    let is_named = |name: &str| names.is_none_or(|names| names.contains(&name));
    for group in 0..opened.reader.num_row_groups() {
        let words = opened.read_some(|name| name == column, group..group + 1)?;
        if !words.words(column).unwrap_or_default().iter().any(|one| one == word) {
            continue;
        }
        let others = opened.read_some(|name| name != column && is_named(name), group..group + 1)?;
        take(opened.in_order(words.into_columns().chain(others.into_columns())));
    }
    Ok(())
}

/// Reason for a file that the Parquet library cannot decode. The library's own reasons name its
/// internals, which help no reader of the message.
const DAMAGED: &str = "it is damaged, expected a complete Parquet file as it was written";

/// Reason why a file cannot be read.
pub(crate) enum Defect {
    /// In a sentence.
    Sentence(String),
    /// An error of the Parquet library.
    Library(ParquetError),
}

impl From<ParquetError> for Defect {
    fn from(error: ParquetError) -> Self {
        Self::Library(error)
    }
}

impl Defect {
    fn of_file(self, path: &Path) -> ResultsError {
        match self {
            Self::Sentence(reason) => ResultsError::format(path, reason),
            Self::Library(ParquetError::External(error)) => match error.downcast::<io::Error>() {
                // The disk fails, not the file. The library's decompressors have these kinds.
                Ok(source)
                    if !matches!(
                        source.kind(),
                        io::ErrorKind::UnexpectedEof
                            | io::ErrorKind::InvalidData
                            | io::ErrorKind::InvalidInput
                            | io::ErrorKind::Other
                    ) =>
                {
                    ResultsError::Read { path: path.to_owned(), source: *source }
                }
                _ => ResultsError::format(path, DAMAGED),
            },
            Self::Library(_) => ResultsError::format(path, DAMAGED),
        }
    }
}

/// Calls the Parquet library, which panics at some contents of damaged files.
pub(crate) fn guarded<T, E: Into<Defect>>(
    path: &Path,
    once: impl FnOnce() -> Result<T, E>,
) -> Result<T, ResultsError> {
    match contain(once) {
        Ok(done) => done.map_err(|error| error.into().of_file(path)),
        Err(_) => Err(ResultsError::format(path, DAMAGED)),
    }
}

/// Opens a file and checks that its footer is valid.
pub(crate) fn open(path: &Path) -> Result<File, ResultsError> {
    let file =
        File::open(path).map_err(|source| ResultsError::Read { path: path.to_owned(), source })?;
    parquet_guard::footer(&file).map_err(|reason| ResultsError::format(path, reason))?;
    Ok(file)
}

/// A file that is being read.
struct Opened<'a> {
    path: &'a Path,
    file: File,
    reader: SerializedFileReader<File>,
}

impl<'a> Opened<'a> {
    fn new(path: &'a Path) -> Result<Self, ResultsError> {
        let file = open(path)?;
        let reader = guarded(path, || -> Result<_, ParquetError> {
            SerializedFileReader::new(file.try_clone()?)
        })?;
        Ok(Self { path, file, reader })
    }

    /// A table of columns that were read separately, in the order of the file.
    fn in_order(&self, columns: impl Iterator<Item = Column>) -> Table {
        let schema = self.reader.metadata().file_metadata().schema_descr();
        let place = |column: &Column| {
            schema.columns().iter().position(|stored| stored.name() == column.name)
        };
        let mut columns: Vec<Column> = columns.collect();
        columns.sort_by_key(place);
        Table::new(columns)
    }

    /// Columns whose names are requested, of some row groups.
    fn read_some(
        &self,
        requested: impl Fn(&str) -> bool,
        groups: Range<usize>,
    ) -> Result<Table, ResultsError> {
        let schema = self.reader.metadata().file_metadata().schema_descr();
        let columns: Vec<(usize, bool)> = schema
            .columns()
            .iter()
            .enumerate()
            .filter(|(_, field)| requested(field.name()))
            .map(|(index, field)| (index, field.physical_type() == PhysicalType::BYTE_ARRAY))
            .collect();
        parquet_guard::columns(&self.file, &self.reader, groups.clone(), &columns)
            .map_err(|reason| ResultsError::format(self.path, reason))?;
        guarded(self.path, || read_columns(&self.reader, requested, groups))
    }
}

fn read_columns(
    reader: &SerializedFileReader<File>,
    requested: impl Fn(&str) -> bool,
    groups: Range<usize>,
) -> Result<Table, Defect> {
    let metadata = reader.metadata().file_metadata();
    let notes = metadata.key_value_metadata();
    let note = |name: &str, what: &str| {
        let key = key(name, what);
        notes
            .and_then(|notes| notes.iter().find(|note| note.key == key))
            .and_then(|note| note.value.clone())
            .unwrap_or_default()
    };
    let mut columns: Vec<Column> = Vec::new();
    let mut text_left = parquet_guard::MAX_TEXT;
    let fields = metadata.schema_descr().columns().iter().enumerate();
    for (index, field) in fields.filter(|(_, field)| requested(field.name())) {
        let data = match field.physical_type() {
            PhysicalType::DOUBLE | PhysicalType::FLOAT | PhysicalType::INT32
                if field.max_def_level() == 1 =>
            {
                Data::Number(Vec::new())
            }
            PhysicalType::BYTE_ARRAY if field.max_def_level() == 0 => Data::Text(Vec::new()),
            other => {
                return Err(Defect::Sentence(format!(
                    "column `{}` is {other}, expected optional numbers or words",
                    field.name()
                )));
            }
        };
        let mut column = Column {
            name: field.name().into(),
            unit: note(field.name(), "unit"),
            meaning: note(field.name(), "meaning"),
            data,
        };
        for group in groups.clone() {
            let rows = reader.metadata().row_group(group).num_rows() as usize;
            let reader = reader.get_row_group(group)?.get_column_reader(index)?;
            let before = column.data.len();
            read_column(reader, rows, &mut column, &mut text_left)?;
            let found = column.data.len() - before;
            if found != rows {
                return Err(Defect::Sentence(format!(
                    "column `{}` has {found} values for {rows} rows",
                    column.name
                )));
            }
        }
        columns.push(column);
    }
    Ok(Table::new(columns))
}

fn read_column(
    reader: ColumnReader,
    rows: usize,
    column: &mut Column,
    text_left: &mut usize,
) -> Result<(), Defect> {
    match (reader, &mut column.data) {
        (ColumnReader::DoubleColumnReader(reader), Data::Number(all)) => {
            read_numbers(reader, rows, all)?;
        }
        (ColumnReader::FloatColumnReader(reader), Data::Number(all)) => {
            read_numbers(reader, rows, all)?;
        }
        (ColumnReader::Int32ColumnReader(reader), Data::Number(all)) => {
            read_numbers(reader, rows, all)?;
        }
        (ColumnReader::ByteArrayColumnReader(mut reader), Data::Text(all)) => {
            let mut words: Vec<ByteArray> = Vec::new();
            while words.len() < rows {
                let (read, _, _) =
                    reader.read_records(rows - words.len(), None, None, &mut words)?;
                if read == 0 {
                    break;
                }
            }
            for word in words {
                // A dictionary's word may occur in every row.
                *text_left = text_left.checked_sub(word.len()).ok_or_else(|| {
                    let most = parquet_guard::MAX_TEXT >> 20;
                    Defect::Sentence(format!("it holds more than {most} MB of text"))
                })?;
                all.push(word.as_utf8()?.to_owned());
            }
        }
        _ => unreachable!("the column was made for the same type"),
    }
    Ok(())
}

fn read_numbers<T: DataType<T: Into<f64>>>(
    mut reader: ColumnReaderImpl<T>,
    rows: usize,
    all: &mut Vec<Option<f64>>,
) -> Result<(), ParquetError> {
    let (mut levels, mut present) = (Vec::new(), Vec::new());
    while levels.len() < rows {
        let missing = rows - levels.len();
        let (read, _, _) = reader.read_records(missing, Some(&mut levels), None, &mut present)?;
        if read == 0 {
            break;
        }
    }
    let mut present = present.into_iter();
    all.extend(levels.into_iter().map(|level| match level {
        0 => None,
        _ => present.next().map(Into::into),
    }));
    Ok(())
}
