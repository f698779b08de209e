//! Positions of the string at evenly chosen frames of a run.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use wholestring::operation::OperationKind;
use wholestring_results::{OperationTables, ResultsError, Table};

use crate::{Packed, plots::catalogue::frame_columns};

/// Largest count of frame values in a page, all operations together: 1.6 MB.
const MAX_NUMBERS: usize = 600_000;

/// Nodes of a frame on the page.
const MAX_NODES: usize = 450;

/// The string at moments: frame after frame, each from the surface down.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Frames {
    /// Times of the frames, s.
    pub time_s: Packed,
    /// Measured depth of the nodes in the first frame, m.
    pub md_m: Packed,
    /// Travel of the bit down the hole since then, m.
    pub moved_m: Packed,
    /// Columns of `frames.parquet` by their name.
    pub channels: BTreeMap<String, Packed>,
    /// Number of frames that were stored.
    pub kept: usize,
    /// Number of nodes of the string.
    pub nodes: usize,
}

impl Frames {
    /// Frames of an operation, with space shared by `many`; `None` if no frames were kept, or if
    /// they do not contain the position of the string.
    ///
    /// The file may exceed the memory, so it is read in two passes, piece by piece.
    pub(super) fn read(
        operation: OperationKind,
        tables: &OperationTables,
        many: usize,
    ) -> Result<Option<Self>, ResultsError> {
        let (mut kept, mut rows) = (0, 0);
        tables.pieces("frames", (None, operation), Some(&["node"]), |piece| {
            let nodes = piece.numbers("node").unwrap_or_default();
            rows += nodes.len();
            kept += nodes.iter().filter(|node| **node == Some(0.0)).count();
        })?;
        if kept == 0 {
            return Ok(None);
        }
        let columns = frame_columns();
        let nodes = (rows / kept).min(MAX_NODES);
        let most = (MAX_NUMBERS / many / (nodes * columns.len())).max(2);
        let mut reader = Reader {
            every: kept.div_ceil(most),
            seen: 0,
            moment: None,
            nodes: 0,
            chosen: Vec::new(),
            time_s: Vec::new(),
            md_m: Vec::new(),
            bit_md_m: Vec::new(),
            channels: columns.iter().map(|name| (*name, Vec::new())).collect(),
        };
        let names = [&["time_s", "node", "md_m"], &columns[..]].concat();
        tables.pieces("frames", (None, operation), Some(&names), |piece| reader.take(&piece))?;
        reader.end_moment();
        Ok(reader.frames(kept))
    }
}

/// A frame whose rows are being read.
struct Moment {
    time_s: f64,
    md_m: Vec<f64>,
    channels: Vec<Vec<f64>>,
}

/// Reads rows, which may end anywhere in a frame, and selects frames.
struct Reader {
    /// Every n-th frame is selected.
    every: usize,
    /// Frames so far.
    seen: usize,
    /// The frame that is being read, if it is selected.
    moment: Option<Moment>,
    nodes: usize,
    /// Nodes of the string that are on the page.
    chosen: Vec<usize>,
    time_s: Vec<f64>,
    md_m: Vec<f64>,
    bit_md_m: Vec<f64>,
    /// The columns that the page holds.
    channels: Vec<(&'static str, Vec<f64>)>,
}

impl Reader {
    fn take(&mut self, piece: &Table) {
        let nodes = piece.numbers("node").unwrap_or_default();
        let [times_s, depths_m] = ["time_s", "md_m"].map(|name| piece.values(name));
        let channel = |(name, _): &(&'static str, Vec<f64>)| piece.numbers(name);
        let columns: Vec<Option<&[Option<f64>]>> = self.channels.iter().map(channel).collect();
        for (row, node) in nodes.iter().enumerate() {
            if *node == Some(0.0) {
                self.end_moment();
                let is_selected = self.seen.is_multiple_of(self.every);
                self.seen += 1;
                self.moment = is_selected.then(|| Moment {
                    time_s: times_s[row],
                    md_m: Vec::new(),
                    channels: vec![Vec::new(); columns.len()],
                });
            }
            if let Some(moment) = &mut self.moment {
                moment.md_m.push(depths_m[row]);
                for (values, column) in moment.channels.iter_mut().zip(&columns) {
                    values.extend(column.map(|column| column[row].unwrap_or(f64::NAN)));
                }
            }
        }
    }

    fn end_moment(&mut self) {
        let Some(moment) = self.moment.take() else { return };
        let Some(bit_md_m) = moment.md_m.last().copied() else { return };
        let nodes = moment.md_m.len();
        if self.time_s.is_empty() {
            self.nodes = nodes;
            let every = nodes.div_ceil(MAX_NODES).max(1);
            // The bit is always included.
            self.chosen = (0..nodes).filter(|node| (nodes - 1 - node) % every == 0).collect();
            self.md_m = self.chosen.iter().map(|node| moment.md_m[*node]).collect();
        } else if nodes != self.nodes {
            // The run was killed while it wrote this frame.
            return;
        }
        self.time_s.push(moment.time_s);
        self.bit_md_m.push(bit_md_m);
        let whole = self.channels.iter_mut().zip(&moment.channels);
        for ((name, all), values) in whole.filter(|(_, values)| values.len() == nodes) {
            let mut above = 0;
            for node in &self.chosen {
                // Joints touch the wall and the pipe between them does not, so a node also
                // represents those above it.
                let from = if *name == "contact_force_N" { above } else { *node };
                let range = values[from..=*node].iter().copied();
                all.push(range.reduce(larger).unwrap_or(f64::NAN));
                above = node + 1;
            }
        }
    }

    fn frames(self, kept: usize) -> Option<Frames> {
        let first = *self.bit_md_m.first()?;
        let full = self.time_s.len() * self.chosen.len();
        let channels = self.channels.into_iter().filter(|(_, values)| values.len() == full);
        let channels: BTreeMap<String, Packed> =
            channels.map(|(name, values)| (name.to_owned(), Packed::short(&values))).collect();
        let positions = ["offset_high_m", "offset_right_m"];
        positions.iter().all(|name| channels.contains_key(*name)).then(|| Frames {
            time_s: Packed::single(self.time_s),
            md_m: Packed::single(self.md_m),
            moved_m: Packed::single(self.bit_md_m.iter().map(|md| md - first)),
            channels,
            kept,
            nodes: self.nodes,
        })
    }
}

fn larger(a: f64, b: f64) -> f64 {
    if b.abs() > a.abs() { b } else { a }
}
