//! `summary.json` of a reach: the depth that a well can reach, and the limit that stops it.

use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use wholestring::operation::OperationKind;
use wholestring_judge::Check;

use crate::{
    ResultsError, UncertainSummary,
    json::{read_versioned, write_json},
};

/// Version of the layout of the files of a reach; raised when a key changes or is removed. 2:
/// `checks`. All versions are read.
pub const REACH_VERSION: u32 = 2;

/// `summary.json` of a reach.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReachSummary {
    /// [`REACH_VERSION`] of the program that wrote it.
    pub schema_version: u32,
    /// Name of the case.
    pub case: String,
    /// The case's settings with all defaults filled in.
    pub settings: Value,
    /// First depth of the bit that was examined, m.
    pub from_m: f64,
    /// Last depth of the bit, m.
    pub to_m: f64,
    /// Inclination of the direction in which the well continues, rad.
    pub inclination_rad: f64,
    /// Whether the wall force of a helix causes friction.
    pub helix_side_force: bool,
    /// Whether the string counts as stopped where its helix begins, although it would continue
    /// buckled.
    #[serde(default)]
    pub stop_at_helix: bool,
    /// Operations that were left out, and the reasons, a sentence for each.
    pub left_out: Vec<String>,
    /// The answers, a friction after the other.
    pub frictions: Vec<ReachOfFriction>,
    /// A check for each operation at each friction: the depth that it reaches, and the limit that
    /// stops it.
    #[serde(default)]
    pub checks: Vec<ReachCheck>,
    /// Effect of uncertain numbers; none where all are exact.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub uncertain: Option<UncertainSummary>,
}

/// A check of an operation at one friction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReachCheck {
    /// The operation: `drill`, `slide`, ...
    pub operation: OperationKind,
    /// Friction factor of all sections; none where the sections have the case's own.
    pub friction: Option<f64>,
    /// The check; its value is the depth that the bit reaches, m, its limit the last depth that was
    /// tried.
    #[serde(flatten)]
    pub check: Check,
}

/// Reach of the well at one friction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReachOfFriction {
    /// Friction factor of all sections; none where the sections have the case's own.
    pub friction: Option<f64>,
    /// Axial friction factor of the section in which the well continues.
    pub friction_at_bit: f64,
    /// Inclination, rad, to which a string slides down by its own weight at that friction,
    /// `atan(1/μ)`; none without friction.
    #[serde(default)]
    pub critical_inclination_rad: Option<f64>,
    /// Limit that stops it first; none where nothing does.
    pub first: Option<ReachStop>,
    /// Each limit of each operation.
    pub limits: Vec<ReachLimit>,
    /// Operations that were not solved because the work was interrupted: one of them may stop the
    /// well earlier.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub missing: Vec<OperationKind>,
}

/// Limit that stops a well.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReachStop {
    /// The operation: `drill`, `slide`, ...
    pub operation: OperationKind,
    /// The limit: `top_drive`, `hook_load_zero`, ...
    pub limit: String,
    /// Depth of the bit, m.
    pub depth_m: f64,
}

/// A limit of an operation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReachLimit {
    /// The operation: `drill`, `slide`, ...
    pub operation: OperationKind,
    /// The limit: `top_drive`, `hook_load_zero`, ...
    pub limit: String,
    /// The same in words.
    pub title: String,
    /// Whether the string stops there; where it buckles, it continues.
    pub stops: bool,
    /// Depth of the bit where it is first reached, m; none where it is not reached down to `to_m`.
    pub depth_m: Option<f64>,
    /// Whether it is reached at the first depth already.
    pub already: bool,
    /// Remaining part of the limit with the bit at `from_m`; none for a string that is locked up.
    pub margin_at_from: Option<f64>,
    /// The same at `to_m`.
    pub margin_at_to: Option<f64>,
    /// Measured depth of the smallest margin in the string when it is reached, else at `to_m`, m;
    /// none for a limit at the surface.
    pub at_md_m: Option<f64>,
}

impl ReachSummary {
    /// Writes the summary as indented JSON.
    pub fn write(&self, path: &Path) -> Result<(), ResultsError> {
        write_json(self, path)
    }

    /// Reads back a summary, and refuses one of another [`REACH_VERSION`].
    pub fn read(path: &Path) -> Result<Self, ResultsError> {
        read_versioned(path, 1..=REACH_VERSION)
    }
}
