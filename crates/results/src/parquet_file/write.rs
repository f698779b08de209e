//! Writes tables to Parquet files.

use std::{collections::HashSet, fs::File, io, path::Path, sync::Arc};

use parquet::{
    basic::{Compression, LogicalType, Repetition, Type as PhysicalType},
    column::writer::{ColumnCloseResult, ColumnWriter},
    data_type::ByteArray,
    errors::ParquetError,
    file::{
        metadata::{KeyValue, ParquetMetaData},
        properties::{EnabledStatistics, WriterProperties, WriterPropertiesBuilder},
        writer::{SerializedFileWriter, SerializedRowGroupWriter},
    },
    schema::types::{ColumnPath, Type},
};

use crate::{Data, ResultsError, Table, file::write_whole};

impl Table {
    /// Writes the table as Parquet (Snappy), with unit and meaning of each column in the metadata.
    pub fn write_parquet(&self, path: &Path) -> Result<(), ResultsError> {
        write(self, path)
    }
}

/// Key of a column's unit and meaning in the file's metadata.
pub(super) fn key(column: &str, what: &str) -> String {
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

/// Starts a file with the columns of a table.
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
    let mut properties = properties(notes);
    for column in table.columns() {
        let path = || ColumnPath::from(column.name.as_str());
        if !column.data.repeats() {
            properties = properties.set_column_dictionary_enabled(path(), false);
        }
        // The alphabetically first and last word are of no use to a reader, and finding them
        // compares every word.
        if matches!(column.data, Data::Text(_)) {
            properties = properties.set_column_statistics_enabled(path(), EnabledStatistics::None);
        }
    }
    SerializedFileWriter::new(writer, schema(fields)?, Arc::new(properties.build()))
}

/// Number of rows examined.
const LOOKED_AT: usize = 128;

impl Data {
    /// Whether a dictionary of the values is worth its time: computed numbers are all different, so
    /// that a dictionary of them is useless.
    fn repeats(&self) -> bool {
        match self {
            Data::Number(values) => {
                let looked_at = &values[..values.len().min(LOOKED_AT)];
                let bits = looked_at.iter().map(|value| value.map(f64::to_bits));
                bits.collect::<HashSet<_>>().len() <= looked_at.len() / 2
            }
            Data::Text(_) => true,
        }
    }
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

/// Copies the first `most` row groups of a file without unpacking them.
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

/// The system's error where there is one inside, so that a full disk is reported as such.
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
    fn what_repeats_has_a_dictionary_and_what_is_computed_has_none() {
        let numbers = |value_at: fn(usize) -> f64| {
            Data::Number((0..1000).map(|i| Some(value_at(i))).collect())
        };
        assert!(numbers(|i| (i / 100) as f64).repeats());
        assert!(numbers(|_| 0.3).repeats());
        assert!(!numbers(|i| (i as f64).sqrt()).repeats());
        assert!(Data::Number(vec![None; 1000]).repeats());
    }

    #[test]
    fn a_full_disk_is_called_one() {
        let table = Table::with_columns(crate::NODES);
        let error = io_error(write_to(&table, FullDisk).unwrap_err());
        assert_eq!(error.kind(), io::ErrorKind::StorageFull);
    }
}
