//! `summary.json` of a reach: how far a well can go, and what stops it.

use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use wholestring_judge::Check;

use crate::{
    ResultsError, UncertainSummary,
    json::{read_versioned, write_json},
};

/// Version of the layout of the files of a reach; raised when a key changes or goes. 2: `checks`.
/// All versions are read.
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
    /// First depth of the bit that was looked at, m.
    pub from_m: f64,
    /// Last depth of the bit, m.
    pub to_m: f64,
    /// Inclination of the direction in which the well goes on, rad.
    pub inclination_rad: f64,
    /// Whether what a helix presses to the wall rubs.
    pub helix_side_force: bool,
    /// Whether the string stops where its helix begins, though it would go on buckled.
    #[serde(default)]
    pub stop_at_helix: bool,
    /// Operations that were left out, and why, a sentence for each.
    pub left_out: Vec<String>,
    /// The answers, a friction after the other.
    pub frictions: Vec<ReachOfFriction>,
    /// A check for each operation at each friction: how far it goes, and what stops it.
    #[serde(default)]
    pub checks: Vec<ReachCheck>,
    /// What comes of numbers that are not known exactly; none where all are.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub uncertain: Option<UncertainSummary>,
}

/// A check of an operation at one friction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReachCheck {
    /// The operation: `drill`, `slide`, ...
    pub operation: String,
    /// Friction factor of all sections; none where the sections have the case's own.
    pub friction: Option<f64>,
    /// The check; its value is the depth of the bit that is reached, m, its limit the last depth that was
    /// tried.
    #[serde(flatten)]
    pub check: Check,
}

/// How far the well goes at one friction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReachOfFriction {
    /// Friction factor of all sections; none where the sections have the case's own.
    pub friction: Option<f64>,
    /// Friction factor along the hole of the section in which the well goes on.
    pub friction_at_bit: f64,
    /// Inclination, rad, to which a string slides down by its own weight at that friction,
    /// `atan(1/μ)`; none without friction.
    #[serde(default)]
    pub critical_inclination_rad: Option<f64>,
    /// What stops it first; none where nothing does.
    pub first: Option<ReachStop>,
    /// Each limit of each operation.
    pub limits: Vec<ReachLimit>,
    /// Operations that were not solved because the work was interrupted: one of them may stop the
    /// well earlier.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub missing: Vec<String>,
}

/// What stops a well.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReachStop {
    /// The operation: `drill`, `slide`, ...
    pub operation: String,
    /// The limit: `top_drive`, `hook_load_zero`, ...
    pub limit: String,
    /// Depth of the bit, m.
    pub depth_m: f64,
}

/// A limit of an operation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReachLimit {
    /// The operation: `drill`, `slide`, ...
    pub operation: String,
    /// The limit: `top_drive`, `hook_load_zero`, ...
    pub limit: String,
    /// The same in words.
    pub title: String,
    /// Whether the string stops there; it goes on where it buckles.
    pub stops: bool,
    /// Depth of the bit where it is met first, m; none where it is not met down to `to_m`.
    pub depth_m: Option<f64>,
    /// Whether it is met at the first depth already.
    pub already: bool,
    /// Part of the limit that is left with the bit at `from_m`; none of a string that is locked up.
    pub margin_at_from: Option<f64>,
    /// The same at `to_m`.
    pub margin_at_to: Option<f64>,
    /// Measured depth in the string where it is worst when it is met, else at `to_m`, m; none of
    /// what the surface sees.
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
