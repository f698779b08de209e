//! `summary.json`: the scalars of every model and operation solved.

use std::{collections::BTreeMap, path::Path};

use serde::{Deserialize, Serialize};
use wholestring::{
    dynamics::{self, Indicators, Statistic, TableUse, TunedHookLoad},
    mud::Hydraulics,
    operation::OperationKind,
    outcome::{ModelKind, Scalars},
    statics::stiff::EquilibriumSummary,
};

use wholestring_judge::{Check, Unchecked};

use crate::{
    ResultsError,
    json::{read_versioned, versioned, write_json, write_json_compact},
};

/// Version of the layout of `summary.json`; raised when a key changes or is removed. 2: keys that a
/// component does not have are left out of `settings`, where 1 had them as `null`. 3: `checks` in
/// place of `findings`, with limits, verdicts and required factors, and `unchecked`. All versions
/// are read.
pub const SCHEMA_VERSION: u32 = 3;

/// The whole of `summary.json`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Summary {
    /// [`SCHEMA_VERSION`] of the program that wrote it.
    pub schema_version: u32,
    /// Version of the engine that solved it, such as `0.1.0`; none in files of versions that did
    /// not record it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub engine_version: Option<String>,
    /// Name of the case.
    pub case: String,
    /// [Digest](crate::digest) of everything that the answers depend on, as shown by `settings`:
    /// cases with the same digest have the same answers. None in files of versions that did not
    /// record it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub identity: Option<String>,
    /// The case's settings with all defaults filled in.
    pub settings: serde_json::Value,
    /// One entry per model and operation solved, in the order in which they were solved.
    pub operations: Vec<OperationSummary>,
}

/// Progress of the solution of an operation.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", tag = "status", content = "message")]
pub enum Status {
    /// To its end.
    Complete,
    /// Stopped by the user, with the results up to then.
    Interrupted,
    /// Unable to continue, for this reason, with the results up to then.
    Failed(String),
}

/// Kinetic friction of the hole.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(
    untagged,
    expecting = "a `friction` is neither a number nor a list with a number for each hole section"
)]
pub enum Friction {
    /// The same in every hole section.
    Uniform(f64),
    /// By hole section, from the surface down.
    BySection(Vec<f64>),
}

impl Friction {
    /// One number where all sections agree, a list where they do not.
    pub fn of(sections: &[f64]) -> Self {
        match sections {
            [first, rest @ ..] if rest.iter().all(|other| other == first) => Self::Uniform(*first),
            _ => Self::BySection(sections.to_vec()),
        }
    }
}

/// One operation as one model solved it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct OperationSummary {
    /// The model.
    pub model: ModelKind,
    /// The operation, as in case files: `trip_out`, `drill`, ...
    pub operation: OperationKind,
    /// Progress of the solution.
    #[serde(flatten)]
    pub status: Status,
    /// Kinetic friction of the hole.
    pub friction: Friction,
    /// Measured depth of the bit, m.
    #[serde(with = "finite")]
    pub bit_depth_m: f64,
    /// The checks of the answer, the most severe first: all that need attention, and for each kind
    /// of limit the one with the least reserve.
    #[serde(default, alias = "findings")]
    pub checks: Vec<Check>,
    /// Limits that could not be checked.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub unchecked: Vec<Unchecked>,
    /// Torque and drag; means over the window for a dynamic model.
    #[serde(flatten)]
    pub scalars: Scalars,
    /// The constant lift that was found for it, where the hoist is a tuned lift; dynamic models
    /// only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lift: Option<TunedHookLoad>,
    /// Pressures and forces of the mud, if it has a rheology; means over the window for a dynamic
    /// model.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hydraulics: Option<Hydraulics>,
    /// Solution of the static equilibrium and forces of the bit in it; the stiff string only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at_rest: Option<EquilibriumSummary>,
    /// Statistics over the window by quantity; dynamic models only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub statistics: Option<BTreeMap<String, Statistic>>,
    /// Whirl, stick-slip and the use of the top drive over the window; dynamic models only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub indicators: Option<Indicators>,
    /// Use of a bit's table, and the share outside it, over the window; dynamic models only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bit_table: Option<TableUse>,
    /// Cost and quality of the numbers; dynamic models only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub numerics: Option<Numerics>,
}

impl OperationSummary {
    /// The checks that need attention, the most severe first.
    pub fn open_checks(&self) -> impl Iterator<Item = &Check> {
        self.checks.iter().filter(|check| !check.is_ok())
    }

    /// Beginning of the window of its statistics, s: as the run found it, or as in `settings` of
    /// the case where the file is older.
    pub fn window_from_s(&self, settings: &serde_json::Value) -> f64 {
        let found_s = self.numerics.as_ref().map(|numeric| numeric.run.settle_s);
        let given_s = || settings["dynamics"]["settle_s"].as_f64();
        found_s.filter(|found_s| found_s.is_finite()).or_else(given_s).unwrap_or(0.0)
    }
}

/// Cost and quality of a dynamic solution.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Numerics {
    /// Method and quality of the computation.
    #[serde(flatten)]
    pub run: dynamics::Numerics,
    /// Wall-clock time of the solution, s.
    #[serde(with = "finite")]
    pub wall_time_s: f64,
    /// Simulated time over wall-clock time.
    #[serde(with = "finite")]
    pub real_time_factor: f64,
}

/// JSON has no NaN: a number that is not finite is `null`, and `null` is read back as NaN. Zero has
/// no sign there.
mod finite {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub(super) fn serialize<S: Serializer>(value: &f64, to: S) -> Result<S::Ok, S::Error> {
        value.is_finite().then_some(*value + 0.0).serialize(to)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
        Ok(Option::<f64>::deserialize(from)?.unwrap_or(f64::NAN))
    }
}

/// Version of the engine; all crates of the program share it.
pub const ENGINE_VERSION: &str = env!("CARGO_PKG_VERSION");

impl Summary {
    /// Returns the summary as indented JSON, as in the file.
    ///
    /// # Errors
    /// A value that cannot be serialized; no summary contains one.
    pub fn json(&self) -> Result<String, serde_json::Error> {
        serde_json::to_string_pretty(self)
    }

    /// Writes the summary as indented JSON.
    pub fn write(&self, path: &Path) -> Result<(), ResultsError> {
        write_json(self, path)
    }

    /// Writes the summary without blanks, and does not wait for the disk: for the many files of a
    /// sweep that are solved again in milliseconds.
    pub fn write_compact(&self, path: &Path) -> Result<(), ResultsError> {
        write_json_compact(self, path)
    }

    /// Reads back a summary, and refuses one of a later [`SCHEMA_VERSION`].
    pub fn read(path: &Path) -> Result<Self, ResultsError> {
        read_versioned(path, 1..=SCHEMA_VERSION)
    }

    /// The same from its text; `path` names it in errors.
    ///
    /// # Errors
    /// A text that is no summary, or of a newer version.
    pub fn parse(path: &Path, text: &str) -> Result<Self, ResultsError> {
        versioned(path, text.as_bytes(), 1..=SCHEMA_VERSION)
    }
}
