//! What linear vibration about static equilibrium leaves as JSON: `summary.json`.

use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use wholestring_judge::Check;

use crate::{
    ResultsError, StabilitySummary, Table,
    json::{read_versioned, write_json},
};

/// Version of the layout of the files of small motions; raised when a key changes or goes.
pub const MODES_VERSION: u32 = 2;

/// `summary.json` of small motions.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ModesSummary {
    /// [`MODES_VERSION`] of the program that wrote it.
    pub schema_version: u32,
    /// Name of the case.
    pub case: String,
    /// The case's settings with all defaults filled in.
    pub settings: Value,
    /// The operation whose string at rest it is.
    pub operation: String,
    /// Its rotary speed, rad/s.
    pub rotary_speed_rad_per_s: f64,
    /// Elements of the string.
    pub elements: usize,
    /// Whether every small motion costs energy, friction and torque apart.
    pub stable: bool,
    /// The checks, the most severe first.
    #[serde(default)]
    pub checks: Vec<Check>,
    /// Length of the assembly, m.
    pub assembly_length_m: f64,
    /// What turns with the string and shakes it, in words.
    pub forcing: String,
    /// Natural modes: lateral, axial, torsional.
    pub modes: Vec<ModeFound>,
    /// By rising rotary speed.
    pub critical_speeds: Vec<CriticalSpeed>,
    /// Torsional stability of the operation that drills.
    pub torsional_stability: Option<StabilitySummary>,
    /// Why there is no such thing.
    pub no_torsional_stability: Option<String>,
    /// What was not computed because the work was interrupted.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub missing: Vec<String>,
}

/// A place in the string.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Spot {
    /// Measured depth, m.
    pub md_m: f64,
    /// Distance from the bit, m.
    pub from_bit_m: f64,
    /// The component there.
    pub component: String,
}

/// A natural mode.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ModeFound {
    /// `lateral`, `axial` or `torsional`.
    pub family: String,
    /// Number within the family, from 1.
    pub number: usize,
    /// Natural frequency, Hz.
    pub frequency_Hz: f64,
    /// `forward`, `backward` or `planar`, of lateral modes.
    pub whirl: Option<String>,
    /// How far it is a circle with the rotation.
    pub precession: f64,
    /// Parts of its kinetic energy: lateral, axial, torsional.
    pub energy: [f64; 3],
    /// Where it strains the string's steel most.
    pub most_strained: Spot,
}

/// A rotary speed at which an order of the rotation meets a natural frequency.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CriticalSpeed {
    /// How often something pushes in a turn.
    pub order: f64,
    /// Rotary speed, rad/s.
    pub rotary_speed_rad_per_s: f64,
    /// Natural frequency there, Hz.
    pub frequency_Hz: f64,
    /// Its branch of `campbell.parquet`.
    pub branch: usize,
    /// `lateral`, `axial` or `torsional`.
    pub family: String,
    /// Number within the family, from 1.
    pub number: usize,
    /// Where the mode strains the string's steel most.
    pub most_strained: Spot,
}

/// The tables of small motions.
#[derive(Debug, Clone, PartialEq)]
pub struct ModesTables {
    /// `mode_shapes.parquet`.
    pub shapes: Table,
    /// `campbell.parquet`.
    pub campbell: Table,
    /// `response.parquet`.
    pub response: Table,
}

impl ModesSummary {
    /// What is missing, in a sentence; nothing where all is there.
    pub fn warning(&self) -> Option<String> {
        let missing = self.missing.join(", ");
        (!missing.is_empty()).then(|| format!("interrupted: not computed are {missing}"))
    }

    /// Writes the summary as indented JSON.
    pub fn write(&self, path: &Path) -> Result<(), ResultsError> {
        write_json(self, path)
    }

    /// Reads back a summary, and refuses one of another [`MODES_VERSION`].
    pub fn read(path: &Path) -> Result<Self, ResultsError> {
        read_versioned(path, 1..=MODES_VERSION)
    }
}
