//! Rows of `frames.parquet`: their columns, and their conversion to a row group.

use std::{io::Write, sync::Arc};

use parquet::{
    basic::{Encoding, Type as PhysicalType},
    column::writer::ColumnWriter,
    data_type::ByteArray,
    errors::ParquetError,
    file::{
        properties::{EnabledStatistics, WriterProperties},
        writer::SerializedFileWriter,
    },
    schema::types::{ColumnPath, Type},
};
use serde::{Deserialize, Serialize};
use wholestring::dynamics::{Channel, Frame};

use crate::{ColumnSpec, FRAMES, parquet_file};

/// Rows of frames, column by column.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct FrameRows {
    columns: Vec<(String, Values)>,
    rows: usize,
}

/// Values of one column.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
enum Values {
    /// A word and the number of rows that it fills.
    Words(Vec<(String, usize)>),
    Time(Vec<f64>),
    Node(Vec<i32>),
    Number(Vec<f32>),
}

impl FrameRows {
    /// No rows, with the columns of these channels.
    pub(super) fn none(channels: &[Channel]) -> Self {
        let columns = specs(channels).map(|spec| {
            let values = match spec.name {
                "operation" => Values::Words(Vec::new()),
                "time_s" => Values::Time(Vec::new()),
                "node" => Values::Node(Vec::new()),
                _ => Values::Number(Vec::new()),
            };
            (spec.name.to_owned(), values)
        });
        Self { columns: columns.collect(), rows: 0 }
    }

    pub(super) fn len(&self) -> usize {
        self.rows
    }

    /// Whether the columns belong to these channels.
    pub(super) fn are_of(&self, channels: &[Channel]) -> bool {
        let names = self.columns.iter().map(|(name, _)| name.as_str());
        names.eq(specs(channels).map(|spec| spec.name))
    }

    /// Whether every column has as many rows as there are, and values of the kind that its name
    /// requires.
    pub(super) fn is_sound(&self) -> bool {
        self.columns.iter().all(|(name, values)| {
            let (kind, rows) = match values {
                Values::Words(words) => (
                    "operation",
                    words.iter().try_fold(0_usize, |sum, (_, rows)| sum.checked_add(*rows)),
                ),
                Values::Time(times) => ("time_s", Some(times.len())),
                Values::Node(nodes) => ("node", Some(nodes.len())),
                Values::Number(numbers) => ("", Some(numbers.len())),
            };
            let named = ["operation", "time_s", "node"].contains(&name.as_str());
            rows == Some(self.rows) && if named { kind == name } else { kind.is_empty() }
        })
    }

    pub(super) fn push(&mut self, operation: &str, frame: &Frame, channels: &[Channel]) {
        let rows = frame.md_m.len();
        let channel_values: Vec<(&str, &[f64])> = channels
            .iter()
            .flat_map(|channel| frame.channel(*channel))
            .chain([("md_m", frame.md_m.as_slice())])
            .collect();
        for (name, values) in &mut self.columns {
            match values {
                Values::Words(words) => words.push((operation.to_owned(), rows)),
                Values::Time(times) => times.extend(std::iter::repeat_n(frame.time_s, rows)),
                Values::Node(nodes) => nodes.extend((0..rows).map(|node| node as i32)),
                Values::Number(numbers) => {
                    let values = channel_values.iter().find(|(other, _)| other == name);
                    let (_, values) = values.expect("the columns are those of the channels");
                    numbers.extend(values.iter().map(|value| *value as f32));
                }
            }
        }
        self.rows += rows;
    }

    pub(super) fn clear(&mut self) {
        for (_, values) in &mut self.columns {
            match values {
                Values::Words(words) => words.clear(),
                Values::Time(times) => times.clear(),
                Values::Node(nodes) => nodes.clear(),
                Values::Number(numbers) => numbers.clear(),
            }
        }
        self.rows = 0;
    }

    /// Writes the rows as one row group.
    pub(super) fn write_group<W: Write + Send>(
        &self,
        file: &mut SerializedFileWriter<W>,
    ) -> Result<(), ParquetError> {
        let mut group = file.next_row_group()?;
        for (_, values) in &self.columns {
            let mut writer = group.next_column()?.expect("one column a schema field");
            match (writer.untyped(), values) {
                (ColumnWriter::ByteArrayColumnWriter(writer), Values::Words(words)) => {
                    for (word, rows) in words {
                        let word = ByteArray::from(word.as_str());
                        writer.write_batch(&vec![word; *rows], None, None)?;
                    }
                }
                (ColumnWriter::DoubleColumnWriter(writer), Values::Time(times)) => {
                    writer.write_batch(times, Some(&vec![1; times.len()]), None)?;
                }
                (ColumnWriter::Int32ColumnWriter(writer), Values::Node(nodes)) => {
                    writer.write_batch(nodes, Some(&vec![1; nodes.len()]), None)?;
                }
                (ColumnWriter::FloatColumnWriter(writer), Values::Number(numbers)) => {
                    let there = |number: &&f32| number.is_finite();
                    let levels = numbers.iter().map(|number| i16::from(there(&number)));
                    let levels: Vec<i16> = levels.collect();
                    let present: Vec<f32> = numbers.iter().filter(there).copied().collect();
                    writer.write_batch(&present, Some(&levels), None)?;
                }
                _ => unreachable!("the schema was made from the same columns"),
            }
            writer.close()?;
        }
        group.close()?;
        Ok(())
    }
}

/// The columns of these channels, in the order of the file.
fn specs(channels: &[Channel]) -> impl Iterator<Item = &'static ColumnSpec> {
    let requested =
        move |name: &str| channels.iter().any(|channel| channel.columns().contains(&name));
    let always = ["operation", "time_s", "node", "md_m"];
    let all = FRAMES.iter();
    all.filter(move |spec| always.contains(&spec.name) || requested(spec.name))
}

/// Layout of files of such rows.
pub(super) struct Layout {
    schema: Arc<Type>,
    properties: Arc<WriterProperties>,
}

impl Layout {
    /// The layout for rows of these channels.
    pub(super) fn of(channels: &[Channel]) -> Result<Self, ParquetError> {
        let kind = |spec: &ColumnSpec| match spec.name {
            "operation" => PhysicalType::BYTE_ARRAY,
            "time_s" => PhysicalType::DOUBLE,
            "node" => PhysicalType::INT32,
            _ => PhysicalType::FLOAT,
        };
        let notes = specs(channels).map(|spec| (spec.name, spec.unit, spec.meaning));
        let mut properties = parquet_file::properties(notes)
            // Values that repeat from row to row get a dictionary below; the rest never repeats.
            .set_dictionary_enabled(false)
            .set_statistics_enabled(EnabledStatistics::Chunk)
            // Row groups are copied from file to file, which drops the offset index.
            .set_offset_index_disabled(true);
        for spec in specs(channels) {
            let column = ColumnPath::from(spec.name);
            properties = match kind(spec) {
                // Groups bytes of equal significance, because neighbours share sign, exponent and
                // first digits.
                PhysicalType::FLOAT => {
                    properties.set_column_encoding(column, Encoding::BYTE_STREAM_SPLIT)
                }
                _ => properties.set_column_dictionary_enabled(column, true),
            };
        }
        Ok(Self {
            schema: parquet_file::schema(specs(channels).map(|spec| (spec.name, kind(spec))))?,
            properties: Arc::new(properties.build()),
        })
    }

    /// Starts a file.
    pub(super) fn begin<W: Write + Send>(
        &self,
        writer: W,
    ) -> Result<SerializedFileWriter<W>, ParquetError> {
        SerializedFileWriter::new(writer, self.schema.clone(), self.properties.clone())
    }
}
