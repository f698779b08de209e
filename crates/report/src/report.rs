//! Contents of the page of a run: plain data, SI, ready to be shown.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use wholestring::{operation::OperationKind, outcome::ModelKind};

use crate::{BottomPicture, Cell, CheckRow, DisplayUnit, Packed};

/// A run as its page shows it.
///
/// Numbers are SI, angles radians. Where a number has a unit, the name of its dimension is given
/// with it, and [`Report::dimensions`] has its form in each set of units.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// Name and version of the program.
    pub program: String,
    /// Name of the case.
    pub title: String,
    /// Units that the page opens with: `si`, `metric` or `field`.
    pub units: String,
    /// By dimension: its unit in SI, metric and field units.
    pub dimensions: BTreeMap<String, [DisplayUnit; 3]>,
    /// The case in a few facts: operations, depth, models.
    pub facts: Vec<Fact>,
    /// The results of the models, in the order in which they were solved.
    pub solved: Vec<Solved>,
    /// The path of the well.
    pub well: Well,
    /// Sections of the hole, from the surface down.
    pub hole: Vec<Section>,
    /// Parts of the string, from the surface down.
    pub string: Vec<Part>,
    /// Time results of the operations that dynamics solved.
    pub runs: Vec<TimeRun>,
    /// Tables of numbers: results of all models, numerics, then every input.
    pub page_tables: Vec<PageTable>,
}

/// Head of the page of a sweep or of a bit test.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PageHead {
    /// Name and version of the program.
    pub program: String,
    /// Its title.
    pub title: String,
    /// Units that it opens with: `si`, `metric` or `field`.
    pub units: String,
    /// By dimension: its unit in SI, metric and field units.
    pub dimensions: BTreeMap<String, [DisplayUnit; 3]>,
    /// The facts common to all cases or points.
    pub facts: Vec<Fact>,
}

/// A value with its label.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Fact {
    /// Its label.
    pub label: String,
    /// The value.
    pub value: Cell,
}

/// The result of one model for one operation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Solved {
    /// The method.
    pub model: ModelKind,
    /// The operation.
    pub operation: OperationKind,
    /// Reason why it ended early, in SI, metric and field units; `None` where it did not.
    pub message: Option<[String; 3]>,
    /// The checks of the answer, the most severe first.
    #[serde(default)]
    pub checks: Vec<CheckRow>,
    /// Limits that could not be checked, a phrase for each missing number.
    #[serde(default)]
    pub unchecked: Vec<String>,
    /// The most important numbers, with their limits.
    pub key_results: Vec<KeyResult>,
    /// Measured depth at which the side force changes from the high to the low side, m; `None`
    /// where it does not.
    #[serde(default)]
    pub cutoff_depth_m: Option<f64>,
    /// Columns of `nodes.parquet` by their name.
    pub profile: BTreeMap<String, Packed>,
    /// Columns of `wear.parquet` by their name.
    pub wear: BTreeMap<String, Packed>,
}

/// A number with its limit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct KeyResult {
    /// Its label.
    pub label: String,
    /// The number; for a dynamic run a mean, where `largest` is given.
    pub value: Cell,
    /// The largest of the window, where the value is a mean.
    pub largest: Option<f64>,
    /// Value that is compared with the limit, where that is neither the largest nor the value
    /// itself.
    #[serde(default)]
    pub compared: Option<f64>,
    /// The limit.
    pub limit: Option<f64>,
    /// Source of the limit, or that none is given.
    pub limit_label: String,
    /// Additional facts, such as the same number for another part of the rig.
    #[serde(default)]
    pub more: Vec<Fact>,
    /// Kinds of the checks that concern this number.
    #[serde(default)]
    pub check_kinds: Vec<String>,
}

/// The path of the well, point by point.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Well {
    /// Columns of the path by their name.
    #[serde(flatten)]
    pub columns: BTreeMap<String, Packed>,
    /// Unit vector to the high side: north, east and down of all points, one component after the
    /// other.
    pub high: [Packed; 3],
}

/// A section of the hole.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Section {
    /// `casing` or `open`.
    pub kind: String,
    /// Measured depth of its upper end, m.
    pub from_m: f64,
    /// Measured depth of its lower end, m.
    pub to_m: f64,
    /// Its diameter, m.
    pub diameter_m: f64,
    /// Coefficient of kinetic friction.
    pub friction: f64,
}

/// A part of the string.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Part {
    /// Name given by the user.
    pub name: String,
    /// Measured depth of its upper end, m.
    pub from_m: f64,
    /// Measured depth of its lower end, m.
    pub to_m: f64,
    /// Outside diameter of the body, m.
    pub od_m: f64,
    /// Inside diameter, m.
    pub id_m: f64,
    /// Diameter at which it touches the wall: of joints or blades where it has them, m.
    pub contact_od_m: f64,
}

/// An operation in time.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TimeRun {
    /// The operation.
    pub operation: OperationKind,
    /// Beginning of the statistics window, s.
    pub window_s: f64,
    /// Number of samples of the run.
    pub samples: usize,
    /// Columns of `time.parquet` by their name, thinned.
    pub history: BTreeMap<String, Packed>,
    /// Notes of the schedule, each with its time, s.
    pub notes: Vec<(f64, String)>,
    /// Contact over depth and time.
    pub contact: Option<ContactPicture>,
    /// The string at moments.
    pub frames: Option<Frames>,
    /// Response of the bit to its weight and speed, where it drills.
    pub drill_off: Option<DrillOff>,
    /// The bottom of the hole at the end, where the bit is on solid rock.
    pub bottom: Option<BottomPicture>,
    /// Power spectral densities of the signals that the case requires.
    #[serde(default)]
    pub spectra: Vec<SpectrumPicture>,
}

/// A power spectral density as a page draws it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SpectrumPicture {
    /// `surface_torque`, or for a node `tension`, ...
    pub signal: String,
    /// Measured depth of the node, m; `None` for a signal of the whole string.
    pub md_m: Option<f64>,
    /// Dimension of the signal, whose square per frequency is that of the density; empty where it
    /// has none.
    pub dimension: String,
    /// Frequencies, Hz.
    pub frequency_Hz: Packed,
    /// Density at each, square of the signal's SI unit per Hz.
    pub density: Packed,
}

/// Response of a bit to its weight and speed: samples of the window, evenly spaced in time.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct DrillOff {
    /// Columns of `time.parquet` by their name.
    pub columns: BTreeMap<String, Packed>,
}

/// Contact over depth and time: row after row in time, each from the surface down.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ContactPicture {
    /// Beginning of the first row, s.
    pub from_s: f64,
    /// End of each row, s.
    pub time_s: Packed,
    /// Measured depth of each stretch, m.
    pub md_m: Packed,
    /// Columns of `contact.parquet` that are drawn, by their name.
    pub values: BTreeMap<String, Packed>,
}

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

/// A table.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PageTable {
    /// Place on the page.
    pub place: Place,
    /// Its title.
    pub title: String,
    /// Heads of its columns; empty where it needs none.
    pub heads: Vec<String>,
    /// Rows.
    pub rows: Vec<Vec<Cell>>,
}

/// Place of a table on the page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Place {
    /// Among the results.
    Results,
    /// Among the numerics.
    Numerics,
    /// Among the inputs.
    Inputs,
    /// On the page of a sweep: a row for each case.
    Cases,
}
