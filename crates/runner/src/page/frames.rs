//! Positions of the string at evenly chosen frames of a run.

use std::{collections::BTreeMap, path::Path};

use wholestring_report::{Frames, Packed, frame_columns};
use wholestring_results::{ResultsError, Table};

use crate::column::{numbers, words};

/// Largest count of frame values in a page, all operations together: 1.6 MB.
const MAX_NUMBERS: usize = 600_000;

/// Nodes of a frame on the page.
const MAX_NODES: usize = 450;

/// Frames of each operation, with space shared by `runs` operations; empty if no frames were kept,
/// or if they do not contain the position of the string.
///
/// The file may exceed the memory, so it is read in two passes, piece by piece.
pub(super) fn read(folder: &Path, runs: usize) -> Result<BTreeMap<String, Frames>, ResultsError> {
    let path = folder.join("frames.parquet");
    if !path.is_file() {
        return Ok(BTreeMap::new());
    }
    let mut extents: BTreeMap<String, Extent> = BTreeMap::new();
    Table::read_parquet_pieces(&path, &["operation", "node"], |piece| {
        let operations = words(&piece, "operation").iter();
        for (operation, node) in operations.zip(numbers(&piece, "node")) {
            let extent = extents.entry(operation.clone()).or_default();
            extent.rows += 1;
            extent.frames += usize::from(*node == Some(0.0));
        }
    })?;
    let mut reader = Reader {
        extents,
        share: MAX_NUMBERS / runs.max(1),
        seen: BTreeMap::new(),
        moment: None,
        taken: BTreeMap::new(),
        columns: frame_columns(),
    };
    let names = [&["operation", "time_s", "node", "md_m"], &reader.columns[..]].concat();
    Table::read_parquet_pieces(&path, &names, |piece| reader.take(&piece))?;
    reader.end_moment();
    let taken = reader.taken.into_iter();
    Ok(taken
        .filter_map(|(operation, taken)| {
            let count = reader.extents.get(&operation)?.frames;
            Some((operation, taken.frames(count, &reader.columns)?))
        })
        .collect())
}

/// The number of a row; NaN if the column has no value there.
fn number(column: &[Option<f64>], row: usize) -> f64 {
    column.get(row).copied().flatten().unwrap_or(f64::NAN)
}

fn larger(a: f64, b: f64) -> f64 {
    if b.abs() > a.abs() { b } else { a }
}

/// A frame whose rows are being read.
struct Moment {
    operation: String,
    time_s: f64,
    md_m: Vec<f64>,
    channels: Vec<Vec<f64>>,
}

/// Contents of the file for an operation.
#[derive(Default)]
struct Extent {
    frames: usize,
    rows: usize,
}

/// Reads rows, which may end anywhere in a frame.
struct Reader {
    extents: BTreeMap<String, Extent>,
    /// Number of values available for each operation.
    share: usize,
    /// Frames by operation so far.
    seen: BTreeMap<String, usize>,
    /// The frame that is being read, if it is selected.
    moment: Option<Moment>,
    taken: BTreeMap<String, Taken>,
    /// The columns that the page holds.
    columns: Vec<&'static str>,
}

impl Reader {
    fn take(&mut self, piece: &Table) {
        let nodes = numbers(piece, "node");
        let (times, depths) = (numbers(piece, "time_s"), numbers(piece, "md_m"));
        let operations = words(piece, "operation");
        let channels: Vec<&[Option<f64>]> =
            self.columns.iter().map(|name| numbers(piece, name)).collect();
        for (row, node) in nodes.iter().enumerate() {
            if *node == Some(0.0) {
                self.end_moment();
                let Some(operation) = operations.get(row) else { return };
                self.begin_moment(operation, number(times, row));
            }
            if let Some(moment) = &mut self.moment {
                moment.md_m.push(number(depths, row));
                for (values, channel) in moment.channels.iter_mut().zip(&channels) {
                    if let Some(value) = channel.get(row) {
                        values.push(value.unwrap_or(f64::NAN));
                    }
                }
            }
        }
    }

    fn begin_moment(&mut self, operation: &str, time_s: f64) {
        let seen = self.seen.entry(operation.to_owned()).or_default();
        let place = *seen;
        *seen += 1;
        let Some(extent) = self.extents.get(operation).filter(|extent| extent.frames > 0) else {
            return;
        };
        let nodes = (extent.rows / extent.frames).min(MAX_NODES);
        let most = (self.share / (nodes * self.columns.len())).max(2);
        let every = extent.frames.div_ceil(most).max(1);
        self.moment = place.is_multiple_of(every).then(|| Moment {
            operation: operation.to_owned(),
            time_s,
            md_m: Vec::new(),
            channels: vec![Vec::new(); self.columns.len()],
        });
    }

    fn end_moment(&mut self) {
        if let Some(moment) = self.moment.take() {
            let taken = self.taken.entry(moment.operation.clone()).or_default();
            taken.add(moment, &self.columns);
        }
    }
}

/// Selected frames of one operation.
#[derive(Default)]
struct Taken {
    nodes: usize,
    /// Nodes of the string that are on the page.
    chosen: Vec<usize>,
    time_s: Vec<f64>,
    md_m: Vec<f64>,
    bit_md_m: Vec<f64>,
    channels: Vec<Vec<f64>>,
}

impl Taken {
    fn add(&mut self, moment: Moment, columns: &[&str]) {
        let Some(bit_md_m) = moment.md_m.last().copied() else { return };
        let nodes = moment.md_m.len();
        if self.time_s.is_empty() {
            self.nodes = nodes;
            let every = nodes.div_ceil(MAX_NODES).max(1);
            // The bit is always included.
            self.chosen =
                (0..nodes).filter(|node| (nodes - 1 - node).is_multiple_of(every)).collect();
            self.md_m = self.chosen.iter().map(|node| moment.md_m[*node]).collect();
            self.channels = vec![Vec::new(); columns.len()];
        } else if nodes != self.nodes {
            // The run was killed while it wrote this frame.
            return;
        }
        self.time_s.push(moment.time_s);
        self.bit_md_m.push(bit_md_m);
        let mut above = 0;
        for node in &self.chosen {
            for (channel, (all, values)) in
                self.channels.iter_mut().zip(&moment.channels).enumerate()
            {
                if values.len() == nodes {
                    // Joints touch the wall and the pipe between them does not, so a node also
                    // represents those above it.
                    let range = if columns[channel] == "contact_force_N" {
                        above..node + 1
                    } else {
                        *node..node + 1
                    };
                    let largest = values[range].iter().copied().reduce(larger);
                    all.push(largest.unwrap_or(f64::NAN));
                }
            }
            above = node + 1;
        }
    }

    fn frames(self, count: usize, columns: &[&str]) -> Option<Frames> {
        let first = *self.bit_md_m.first()?;
        let full = self.time_s.len() * self.chosen.len();
        let channels: BTreeMap<String, Packed> = columns
            .iter()
            .zip(&self.channels)
            .filter(|(_, values)| values.len() == full)
            .map(|(name, values)| ((*name).to_owned(), Packed::short(values)))
            .collect();
        let lies = ["offset_high_m", "offset_right_m"];
        lies.iter().all(|name| channels.contains_key(*name)).then(|| Frames {
            time_s: Packed::single(self.time_s),
            md_m: Packed::single(self.md_m),
            moved_m: Packed::single(self.bit_md_m.iter().map(|md| md - first)),
            channels,
            kept: count,
            nodes: self.nodes,
        })
    }
}
