//! The JSON file of linear vibration about static equilibrium: `summary.json`.

use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use wholestring::operation::OperationKind;
use wholestring_judge::Check;

use crate::{
    ResultsError, StabilitySummary, Table, Texts,
    json::{read_versioned, write_json},
};

/// Version of the layout of the files of linear vibration; raised when a key changes or is removed.
pub const MODES_VERSION: u32 = 2;

/// `summary.json` of linear vibration.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ModesSummary {
    /// [`MODES_VERSION`] of the program that wrote it.
    pub schema_version: u32,
    /// Name of the case.
    pub case: String,
    /// The case's settings with all defaults filled in.
    pub settings: Value,
    /// The operation whose static equilibrium is analysed.
    pub operation: OperationKind,
    /// Its rotary speed, rad/s.
    pub rotary_speed_rad_per_s: f64,
    /// Elements of the string.
    pub elements: usize,
    /// Whether every small motion takes energy, friction and torque excepted.
    pub stable: bool,
    /// The checks, the most severe first.
    #[serde(default)]
    pub checks: Vec<Check>,
    /// Length of the assembly, m.
    pub assembly_length_m: f64,
    /// Parts that turn with the string and excite it, in words.
    pub forcing: String,
    /// Natural modes: lateral, axial, torsional.
    pub modes: Vec<ModeFound>,
    /// In order of increasing rotary speed.
    pub critical_speeds: Vec<CriticalSpeed>,
    /// Torsional stability of the operation that drills.
    pub torsional_stability: Option<StabilitySummary>,
    /// Reason why there is no torsional stability.
    pub no_torsional_stability: Option<String>,
    /// Parts that were not computed because the work was interrupted.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub missing: Vec<String>,
    /// Quantities of its texts, from which they are rendered in other units.
    #[serde(default, skip_serializing_if = "Texts::is_empty")]
    pub texts: Texts,
}

/// A place in the string.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Spot {
    /// Measured depth, m.
    pub md_m: f64,
    /// Distance from the bit, m.
    pub from_bit_m: f64,
    /// The component at that place.
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
    /// `forward`, `backward` or `planar`, for lateral modes.
    pub whirl: Option<String>,
    /// Degree to which it is a circle with the rotation: 1 with it, -1 against it, 0 to and fro.
    pub precession: f64,
    /// Parts of its kinetic energy: lateral, axial, torsional.
    pub energy: [f64; 3],
    /// Place of its largest strain of the string's steel.
    pub most_strained: Spot,
}

/// A rotary speed at which an order of the rotation coincides with a natural frequency.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CriticalSpeed {
    /// Number of excitations per turn.
    pub order: f64,
    /// Rotary speed, rad/s.
    pub rotary_speed_rad_per_s: f64,
    /// Natural frequency at that speed, Hz.
    pub frequency_Hz: f64,
    /// Its branch of `campbell.parquet`.
    pub branch: usize,
    /// `lateral`, `axial` or `torsional`.
    pub family: String,
    /// Number within the family, from 1.
    pub number: usize,
    /// Place of the mode's largest strain of the string's steel.
    pub most_strained: Spot,
}

/// The tables of linear vibration.
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
    /// The missing parts, in a sentence; `None` where nothing is missing.
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
