//! Tables as Parquet files: the only place that knows the format.

use std::{fs::File, io, ops::Range, path::Path, sync::Arc};

use parquet::{
    basic::{Compression, LogicalType, Repetition, Type as PhysicalType},
    column::{
        reader::{ColumnReader, ColumnReaderImpl},
        writer::{ColumnCloseResult, ColumnWriter},
    },
    data_type::{ByteArray, DataType},
    errors::ParquetError,
    file::{
        metadata::{KeyValue, ParquetMetaData},
        properties::{WriterProperties, WriterPropertiesBuilder},
        reader::{FileReader, SerializedFileReader},
        writer::{SerializedFileWriter, SerializedRowGroupWriter},
    },
    schema::types::Type,
};

use wholestring_contain::contain;

use crate::{Column, Data, ResultsError, Table, file::write_whole, parquet_guard};

impl Table {
    /// Writes the table as Parquet (Snappy), with unit and meaning of each column in the metadata.
    pub fn write_parquet(&self, path: &Path) -> Result<(), ResultsError> {
        write(self, path)
    }

    /// Reads back a table that [`Table::write_parquet`] wrote.
    pub fn read_parquet(path: &Path) -> Result<Self, ResultsError> {
        read(path)
    }

    /// Reads back the columns of these names, as far as the file has them, piece by piece: a table
    /// may be larger than memory. The pieces follow each other as the rows do.
    pub fn read_parquet_pieces(
        path: &Path,
        names: &[&str],
        take: impl FnMut(Self),
    ) -> Result<(), ResultsError> {
        read_groups(path, names, take)
    }

    /// Reads back the pieces of a file that hold a row with this word in that column, whole: they
    /// may hold rows with other words. `None` where there is no such piece. The tables of a run
    /// against time have a piece for each operation.
    ///
    /// # Errors
    /// A file that cannot be read, or is damaged.
    pub fn read_parquet_with(
        path: &Path,
        column: &str,
        word: &str,
    ) -> Result<Option<Self>, ResultsError> {
        read_groups_with(path, column, word)
    }
}

/// Key of a column's unit and meaning in the file's metadata.
fn key(column: &str, what: &str) -> String {
    format!("{column}.{what}")
}

fn write(table: &Table, path: &Path) -> Result<(), ResultsError> {
    write_whole(path, |writer| write_to(table, writer).map_err(io_error))
}

fn write_to(table: &Table, writer: impl io::Write + Send) -> Result<(), ParquetError> {
    let mut file = begin(table, writer)?;
    write_group(table, &mut file)?;
    file.close()?;
    Ok(())
}

/// Begins a file with the columns of a table.
pub(crate) fn begin<W: io::Write + Send>(
    table: &Table,
    writer: W,
) -> Result<SerializedFileWriter<W>, ParquetError> {
    let fields = table.columns().iter().map(|column| {
        let kind = match column.data {
            Data::Number(_) => PhysicalType::DOUBLE,
            Data::Text(_) => PhysicalType::BYTE_ARRAY,
        };
        (column.name.as_str(), kind)
    });
    let notes = table.columns().iter().map(|column| {
        let (name, unit) = (column.name.as_str(), column.unit.as_str());
        (name, unit, column.meaning.as_str())
    });
    let properties = Arc::new(properties(notes).build());
    SerializedFileWriter::new(writer, schema(fields)?, properties)
}

/// Writes the rows of a table as a row group.
pub(crate) fn write_group<W: io::Write + Send>(
    table: &Table,
    file: &mut SerializedFileWriter<W>,
) -> Result<(), ParquetError> {
    let mut rows = file.next_row_group()?;
    for column in table.columns() {
        write_column(&mut rows, &column.data)?;
    }
    rows.close()?;
    Ok(())
}

/// Copies the first `most` row groups of a file as they are packed.
pub(crate) fn copy_groups<W: io::Write + Send>(
    from: &File,
    metadata: &ParquetMetaData,
    most: usize,
    to: &mut SerializedFileWriter<W>,
) -> Result<(), ParquetError> {
    for rows in metadata.row_groups().iter().take(most) {
        let mut group = to.next_row_group()?;
        for column in rows.columns() {
            let packed = ColumnCloseResult {
                bytes_written: column.compressed_size() as u64,
                rows_written: rows.num_rows() as u64,
                metadata: column.clone(),
                bloom_filter: None,
                column_index: None,
                offset_index: None,
            };
            group.append_column(from, packed)?;
        }
        group.close()?;
    }
    Ok(())
}

/// The system's error where there is one inside, so that a full disk is called one.
pub(crate) fn io_error(error: ParquetError) -> io::Error {
    match error {
        ParquetError::External(error) => match error.downcast::<io::Error>() {
            Ok(error) => *error,
            Err(error) => io::Error::other(error),
        },
        other => io::Error::other(other),
    }
}

/// The schema of columns: words are always there, numbers may be missing.
pub(crate) fn schema<'a>(
    fields: impl Iterator<Item = (&'a str, PhysicalType)>,
) -> Result<Arc<Type>, ParquetError> {
    let fields = fields
        .map(|(name, kind)| {
            let field = Type::primitive_type_builder(name, kind);
            let field = match kind {
                PhysicalType::BYTE_ARRAY => field
                    .with_repetition(Repetition::REQUIRED)
                    .with_logical_type(Some(LogicalType::String)),
                _ => field.with_repetition(Repetition::OPTIONAL),
            };
            Ok(Arc::new(field.build()?))
        })
        .collect::<Result<_, ParquetError>>()?;
    let schema = Type::group_type_builder("table").with_fields(fields);
    Ok(Arc::new(schema.build()?))
}

/// Compression, author, and the unit and meaning of each column.
pub(crate) fn properties<'a>(
    notes: impl Iterator<Item = (&'a str, &'a str, &'a str)>,
) -> WriterPropertiesBuilder {
    let notes = notes
        .flat_map(|(name, unit, meaning)| {
            [
                KeyValue::new(key(name, "unit"), unit.to_owned()),
                KeyValue::new(key(name, "meaning"), meaning.to_owned()),
            ]
        })
        .collect();
    WriterProperties::builder()
        .set_compression(Compression::SNAPPY)
        .set_created_by(format!("wholestring {}", env!("CARGO_PKG_VERSION")))
        .set_key_value_metadata(Some(notes))
}

fn write_column<W: io::Write + Send>(
    rows: &mut SerializedRowGroupWriter<'_, W>,
    data: &Data,
) -> Result<(), ParquetError> {
    let mut writer = rows.next_column()?.expect("one column a schema field");
    match (writer.untyped(), data) {
        (ColumnWriter::DoubleColumnWriter(writer), Data::Number(values)) => {
            let finite = |value: &Option<f64>| value.filter(|value| value.is_finite());
            let levels: Vec<i16> =
                values.iter().map(|value| i16::from(finite(value).is_some())).collect();
            let present: Vec<f64> = values.iter().filter_map(finite).collect();
            writer.write_batch(&present, Some(&levels), None)?;
        }
        (ColumnWriter::ByteArrayColumnWriter(writer), Data::Text(values)) => {
            let words: Vec<ByteArray> =
                values.iter().map(|word| ByteArray::from(word.as_bytes().to_vec())).collect();
            writer.write_batch(&words, None, None)?;
        }
        _ => unreachable!("the schema was made from the same columns"),
    }
    writer.close()
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

/// Reads the row groups in which a column of words holds this one, one after the other.
fn read_groups_with(path: &Path, column: &str, word: &str) -> Result<Option<Table>, ResultsError> {
    let opened = Opened::new(path)?;
    let mut found: Option<Table> = None;
    for group in 0..opened.reader.num_row_groups() {
        let words = opened.read_some(|name| name == column, group..group + 1)?;
        let has = words.columns().iter().any(|column| match &column.data {
            Data::Text(words) => words.iter().any(|one| one == word),
            Data::Number(_) => false,
        });
        if has {
            let rows = opened.read_some(|_| true, group..group + 1)?;
            match &mut found {
                None => found = Some(rows),
                Some(found) => found.extend(rows),
            }
        }
    }
    Ok(found)
}

/// Calls the reader of Parquet, which is not ours and panics at some of what a damaged file holds.
pub(crate) fn guarded<T>(
    path: &Path,
    of: impl FnOnce() -> Result<T, ParquetError>,
) -> Result<T, ResultsError> {
    match contain(of) {
        Ok(done) => done.map_err(|error| ResultsError::format(path, error)),
        Err(_) => Err(ResultsError::format(path, "it is damaged")),
    }
}

/// Opens a file and sees that its footer is sound.
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
        let reader = guarded(path, || SerializedFileReader::new(file.try_clone()?))?;
        Ok(Self { path, file, reader })
    }

    /// Columns whose names are wanted, of some row groups.
    fn read_some(
        &self,
        wanted: impl Fn(&str) -> bool,
        groups: Range<usize>,
    ) -> Result<Table, ResultsError> {
        let schema = self.reader.metadata().file_metadata().schema_descr();
        let columns: Vec<(usize, bool)> = schema
            .columns()
            .iter()
            .enumerate()
            .filter(|(_, field)| wanted(field.name()))
            .map(|(index, field)| (index, field.physical_type() == PhysicalType::BYTE_ARRAY))
            .collect();
        parquet_guard::columns(&self.file, &self.reader, groups.clone(), &columns)
            .map_err(|reason| ResultsError::format(self.path, reason))?;
        guarded(self.path, || read_columns(&self.reader, wanted, groups))
    }
}

fn read_columns(
    reader: &SerializedFileReader<File>,
    wanted: impl Fn(&str) -> bool,
    groups: Range<usize>,
) -> Result<Table, ParquetError> {
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
    for (index, field) in fields.filter(|(_, field)| wanted(field.name())) {
        let data = match field.physical_type() {
            PhysicalType::DOUBLE | PhysicalType::FLOAT | PhysicalType::INT32
                if field.max_def_level() == 1 =>
            {
                Data::Number(Vec::new())
            }
            PhysicalType::BYTE_ARRAY if field.max_def_level() == 0 => Data::Text(Vec::new()),
            other => {
                return Err(ParquetError::General(format!(
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
                return Err(ParquetError::General(format!(
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
) -> Result<(), ParquetError> {
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
                // A dictionary's word may stand in every row.
                *text_left = text_left.checked_sub(word.len()).ok_or_else(|| {
                    let most = parquet_guard::MAX_TEXT >> 20;
                    ParquetError::General(format!("it holds more than {most} MB of text"))
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

#[cfg(test)]
mod tests {
    use super::*;

    struct FullDisk;

    impl io::Write for FullDisk {
        fn write(&mut self, _: &[u8]) -> io::Result<usize> {
            Err(io::ErrorKind::StorageFull.into())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn a_full_disk_is_called_one() {
        let table = Table::with_columns(crate::NODES);
        let error = io_error(write_to(&table, FullDisk).unwrap_err());
        assert_eq!(error.kind(), io::ErrorKind::StorageFull);
    }
}
