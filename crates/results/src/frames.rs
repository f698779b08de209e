//! `frames.parquet`: the whole string against time, written as it comes, in memory that does not grow with
//! the run.

use std::{
    fs::{self, File},
    io::BufWriter,
    path::{Path, PathBuf},
    sync::Arc,
};

use parquet::{
    basic::{Encoding, Type as PhysicalType},
    column::writer::ColumnWriter,
    data_type::ByteArray,
    errors::ParquetError,
    file::{properties::EnabledStatistics, writer::SerializedFileWriter},
    schema::types::ColumnPath,
};
use wholestring::dynamics::{Channel, Frame};

use crate::{
    ColumnSpec, FRAMES, ResultsError,
    file::partial_name,
    parquet_file::{self, io_error},
};

/// Rows that are held until they are written: 0.5 MB a column.
const GROUP_ROWS: usize = 1 << 17;

/// Values of one column that wait to be written.
enum Waiting {
    /// A word and how many rows it fills.
    Words(Vec<(ByteArray, usize)>),
    Time(Vec<f64>),
    Node(Vec<i32>),
    Number(Vec<f32>),
}

/// Writes frames.
///
/// Rows gather until there are 131 072 of them and go to the file as one row group. The file bears the name
/// `frames.parquet.partial` until [`FrameWriter::finish`].
pub struct FrameWriter {
    path: PathBuf,
    partial: PathBuf,
    file: SerializedFileWriter<BufWriter<File>>,
    channels: Vec<Channel>,
    waiting: Vec<(&'static ColumnSpec, Waiting)>,
    rows: usize,
}

impl FrameWriter {
    /// Begins `frames.parquet` in a folder with these channels; one that an earlier run left goes.
    pub(crate) fn create(folder: &Path, channels: &[Channel]) -> Result<Self, ResultsError> {
        let path = folder.join("frames.parquet");
        let partial = partial_name(&path);
        let blank = Frame::default();
        let asked = |name: &str| {
            let mut all = channels.iter().flat_map(|channel| blank.channel(*channel));
            all.any(|(other, _)| other == name)
        };
        let waiting: Vec<(&ColumnSpec, Waiting)> = FRAMES
            .iter()
            .filter_map(|spec| {
                let waiting = match spec.name {
                    "operation" => Waiting::Words(Vec::new()),
                    "time_s" => Waiting::Time(Vec::new()),
                    "node" => Waiting::Node(Vec::new()),
                    "md_m" => Waiting::Number(Vec::new()),
                    name if asked(name) => Waiting::Number(Vec::new()),
                    _ => return None,
                };
                Some((spec, waiting))
            })
            .collect();
        let fields = waiting.iter().map(|(spec, waiting)| {
            let kind = match waiting {
                Waiting::Words(_) => PhysicalType::BYTE_ARRAY,
                Waiting::Time(_) => PhysicalType::DOUBLE,
                Waiting::Node(_) => PhysicalType::INT32,
                Waiting::Number(_) => PhysicalType::FLOAT,
            };
            (spec.name, kind)
        });
        let notes = waiting
            .iter()
            .map(|(spec, _)| (spec.name, spec.unit, spec.meaning));
        let mut properties = parquet_file::properties(notes)
            // What repeats from row to row gets a dictionary below; the rest never repeats.
            .set_dictionary_enabled(false)
            .set_statistics_enabled(EnabledStatistics::Chunk);
        for (spec, waiting) in &waiting {
            let column = ColumnPath::from(spec.name);
            properties = match waiting {
                // Bytes of like weight side by side: neighbours share sign, exponent and first digits.
                Waiting::Number(_) => {
                    properties.set_column_encoding(column, Encoding::BYTE_STREAM_SPLIT)
                }
                _ => properties.set_column_dictionary_enabled(column, true),
            };
        }
        let begin = || -> Result<_, ParquetError> {
            match fs::remove_file(&path) {
                Err(error) if error.kind() != std::io::ErrorKind::NotFound => {
                    return Err(error.into());
                }
                _ => {}
            }
            let writer = BufWriter::new(File::create(&partial)?);
            let schema = parquet_file::schema(fields)?;
            SerializedFileWriter::new(writer, schema, Arc::new(properties.build()))
        };
        let file = begin().map_err(|error| failed(&path, error))?;
        Ok(Self {
            path,
            partial,
            file,
            channels: channels.to_vec(),
            waiting,
            rows: 0,
        })
    }

    /// Adds a frame of an operation.
    pub fn push(&mut self, operation: &str, frame: &Frame) -> Result<(), ResultsError> {
        let rows = frame.md_m.len();
        let columns: Vec<(&str, &[f64])> = self
            .channels
            .iter()
            .flat_map(|channel| frame.channel(*channel))
            .chain([("md_m", frame.md_m.as_slice())])
            .collect();
        for (spec, waiting) in &mut self.waiting {
            match waiting {
                Waiting::Words(words) => words.push((ByteArray::from(operation), rows)),
                Waiting::Time(times) => times.extend(std::iter::repeat_n(frame.time_s, rows)),
                Waiting::Node(nodes) => nodes.extend((0..rows).map(|node| node as i32)),
                Waiting::Number(numbers) => {
                    let values = columns.iter().find(|(name, _)| *name == spec.name);
                    let (_, values) = values.expect("the columns are those of the channels");
                    numbers.extend(values.iter().map(|value| *value as f32));
                }
            }
        }
        self.rows += rows;
        if self.rows >= GROUP_ROWS {
            self.write_group()
                .map_err(|error| failed(&self.path, error))?;
        }
        Ok(())
    }

    /// Ends the file and gives it its name.
    pub fn finish(mut self) -> Result<(), ResultsError> {
        let path = self.path.clone();
        let end = || -> Result<(), ParquetError> {
            if self.rows > 0 {
                self.write_group()?;
            }
            let writer = self.file.into_inner()?;
            let file = writer.into_inner().map_err(|error| error.into_error())?;
            file.sync_all()?;
            drop(file);
            fs::rename(&self.partial, &self.path)?;
            Ok(())
        };
        end().map_err(|error| failed(&path, error))
    }

    fn write_group(&mut self) -> Result<(), ParquetError> {
        let mut group = self.file.next_row_group()?;
        for (_, waiting) in &mut self.waiting {
            let mut writer = group.next_column()?.expect("one column a schema field");
            match (writer.untyped(), waiting) {
                (ColumnWriter::ByteArrayColumnWriter(writer), Waiting::Words(words)) => {
                    for (word, rows) in words.drain(..) {
                        writer.write_batch(&vec![word; rows], None, None)?;
                    }
                }
                (ColumnWriter::DoubleColumnWriter(writer), Waiting::Time(times)) => {
                    writer.write_batch(times, Some(&vec![1; times.len()]), None)?;
                    times.clear();
                }
                (ColumnWriter::Int32ColumnWriter(writer), Waiting::Node(nodes)) => {
                    writer.write_batch(nodes, Some(&vec![1; nodes.len()]), None)?;
                    nodes.clear();
                }
                (ColumnWriter::FloatColumnWriter(writer), Waiting::Number(numbers)) => {
                    let levels: Vec<i16> = numbers
                        .iter()
                        .map(|number| i16::from(number.is_finite()))
                        .collect();
                    numbers.retain(|number| number.is_finite());
                    writer.write_batch(numbers, Some(&levels), None)?;
                    numbers.clear();
                }
                _ => unreachable!("the schema was made from the same columns"),
            }
            writer.close()?;
        }
        group.close()?;
        self.rows = 0;
        Ok(())
    }
}

fn failed(path: &Path, error: ParquetError) -> ResultsError {
    ResultsError::Write {
        path: path.to_owned(),
        source: io_error(error),
    }
}
