//! The JSON file of linear vibration about static equilibrium: `summary.json`.

use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use wholestring::operation::OperationKind;
use wholestring_judge::Check;

use crate::{
    ResultsError, StabilitySummary, Texts,
    json::{read_versioned, write_json},
    row::{parts, rows},
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

parts![Spot];

rows! {
    /// A natural mode.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct ModeFound {
        family: String => Words,
            "`lateral` of the assembly, `axial` or `torsional` of the whole string";
        number: usize => Ratio, "Number within the family, from 1";
        frequency_Hz: f64 => Frequency, "Natural frequency at the operation's rotary speed";
        whirl: Option<String> => Words,
            "`forward`, `backward` or `planar`; empty for other families",
            null_where "the mode is not lateral";
        precession: f64 => Ratio,
            "Precession: 1 for a circle with the rotation, -1 against it, 0 to and fro";
        energy: [f64; 3], "Parts of its kinetic energy: lateral, axial, torsional", columns {
            lateral_energy = |parts| parts[0] => Ratio, "Lateral part of its kinetic energy";
            axial_energy = |parts| parts[1] => Ratio, "Axial part of its kinetic energy";
            torsional_energy = |parts| parts[2] => Ratio, "Torsional part of its kinetic energy";
        };
        most_strained: Spot, "Place of its largest strain of the string's steel", columns {
            most_strained_md_m = |spot| spot.md_m => Depth,
                "Measured depth of the largest strain of the string's steel";
            most_strained_from_bit_m = |spot| spot.from_bit_m => Length,
                "The same place, from the bit";
            component => Words, "The component at that place";
        };
    }

    /// Columns of `modes.parquet`: a row for each natural mode.
    pub const MODES;
}

rows! {
    /// A rotary speed at which an order of the rotation coincides with a natural frequency.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct CriticalSpeed {
        order: f64 => Ratio, "Excitations per turn";
        rotary_speed_rad_per_s: f64 => RotarySpeed, "Rotary speed";
        frequency_Hz: f64 => Frequency, "Natural frequency at that speed";
        branch: usize => Ratio, "Branch of `campbell.parquet`";
        family: String => Words, "As in `modes.parquet`";
        number: usize => Ratio, "Number within the family, from 1";
        most_strained: Spot, "Place of the mode's largest strain of the string's steel", columns {
            most_strained_md_m = |spot| spot.md_m => Depth,
                "Measured depth of the mode's largest strain of the string's steel";
            most_strained_from_bit_m = |spot| spot.from_bit_m => Length,
                "The same place, from the bit";
            component => Words, "The component at that place";
        };
    }

    /// Columns of `critical_speeds.parquet`: a row for each rotary speed at which an order of the
    /// rotation coincides with a natural frequency.
    pub const CRITICAL_SPEEDS;
}

/// The rows of the tables of linear vibration that the summary does not contain.
#[derive(Debug, Clone, PartialEq)]
pub struct ModesRows {
    /// `mode_shapes.parquet`.
    pub shapes: Vec<ModeShapeRow>,
    /// `campbell.parquet`.
    pub campbell: Vec<CampbellRow>,
    /// `response.parquet`.
    pub response: Vec<ResponseRow>,
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

// Rows of the tables of linear vibration that the summary does not contain.

rows! {
    /// Displacement of a node in a natural mode.
    #[derive(Debug, Clone, PartialEq)]
    pub struct ModeShapeRow {
        family: String => Words, "As in `modes.parquet`";
        number: usize => Ratio, "As in `modes.parquet`";
        md_m: f64 => Depth, "Measured depth of the node";
        high_m: f64 => Length,
            "Displacement towards the high side, in phase with the largest; the largest is 1 m, \
             for a torsional mode the largest turn is 1 rad";
        right_m: f64 => Length,
            "Displacement to the right of it as one looks down the hole, in phase";
        high_later_m: f64 => Length,
            "Displacement towards the high side a quarter of a period later";
        right_later_m: f64 => Length, "Displacement to the right a quarter of a period later";
        along_m: f64 => Length, "Axial displacement, in phase";
        turn_rad: f64 => Angle, "Turn about the axis, in phase";
    }

    /// Columns of `mode_shapes.parquet`: a row for each mode at each node that moves with it.
    pub const MODE_SHAPES, read;
}

rows! {
    /// Natural frequency of a branch at a rotary speed.
    #[derive(Debug, Clone, PartialEq)]
    pub struct CampbellRow {
        branch: usize => Ratio, "Number of the branch, from 0: lateral ones first";
        family: String => Words, "As in `modes.parquet`";
        number: usize => Ratio, "Number within the family, from 1";
        whirl: Option<String> => Words,
            "At the fastest speed: `forward`, `backward` or `planar`; empty for other families",
            null_where "the mode is not lateral";
        rotary_speed_rad_per_s: f64 => RotarySpeed, "Rotary speed";
        frequency_Hz: f64 => Frequency, "Natural frequency";
    }

    /// Columns of `campbell.parquet`: a row for each branch at each rotary speed.
    pub const CAMPBELL, read;
}

rows! {
    /// Response of the assembly at a rotary speed.
    #[derive(Debug, Clone, PartialEq)]
    pub struct ResponseRow {
        rotary_speed_rad_per_s: f64 => RotarySpeed, "Rotary speed";
        amplitude_m: f64 => Length,
            "Largest displacement of a node of the assembly from its position at rest";
        amplitude_md_m: f64 => Depth, "Measured depth of that node";
        bending_stress_Pa: f64 => Stress, "Largest bending stress added by the vibration";
        bending_stress_md_m: f64 => Depth, "Measured depth of that stress";
        component: String => Words, "The component of that stress";
    }

    /// Columns of `response.parquet`: a row for each rotary speed.
    pub const RESPONSE, read;
}
