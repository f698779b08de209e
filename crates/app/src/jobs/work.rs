//! What is asked for: a command of the program with its main options.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// Work on a saved case, as a command of the program does it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct JobRequest {
    /// The id of the case; none of a study, which names its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) case: Option<String>,
    /// The command.
    pub(crate) work: Work,
    /// Values by keys, as `--set KEY=VALUE` has them.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub(crate) set: BTreeMap<String, String>,
    /// What becomes of what lies in the folder of the results.
    #[serde(default)]
    pub(crate) if_there: IfThere,
}

/// What becomes of what lies in the folder of the results.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum IfThere {
    /// Finished results of the same work are replaced; what was begun is not, and other results
    /// are left alone.
    #[default]
    Protect,
    /// It is continued, as by `--resume`.
    Resume,
    /// It is replaced, as by `--overwrite`.
    Overwrite,
}

/// A command with its main options; what is left out is as on the command line.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub(crate) enum Work {
    /// `run`: every operation of the case by its models.
    Run {
        /// Models in place of the case's: `soft`, `stiff`, `dynamic`.
        #[serde(default)]
        models: Vec<String>,
        /// Whether the tables are written as CSV too.
        #[serde(default)]
        csv: bool,
    },
    /// `plan`: torque and drag at every depth of the bit.
    Plan {
        /// The id of a file of readings: another program's curves, laid over the plan.
        #[serde(default)]
        overlay: Option<String>,
    },
    /// `reach`: how far the well can go, and what stops it.
    Reach {
        /// Depth of the bit to begin with: `4000 m`.
        #[serde(default)]
        from: Option<String>,
        /// Deepest bit.
        #[serde(default)]
        to: Option<String>,
        /// Friction factors of all sections, one after the other.
        #[serde(default)]
        frictions: Vec<f64>,
        /// The operations: `drill`, `slide`.
        #[serde(default)]
        operations: Vec<String>,
        /// Whether the friction of what a helix presses to the wall is left out.
        #[serde(default)]
        no_helix_friction: bool,
    },
    /// `bha`: static analysis of the bottom-hole assembly.
    Bha {
        /// The operation.
        #[serde(default)]
        operation: Option<String>,
        /// Whether the whole string is solved.
        #[serde(default)]
        whole: bool,
        /// Tool faces of the bend: `0 deg..360 deg/15 deg`.
        #[serde(default)]
        toolface: Option<String>,
        /// Weights on bit: `20 kN..120 kN/20 kN`.
        #[serde(default)]
        weight: Option<String>,
        /// Inclinations of a straight hole.
        #[serde(default)]
        inclination: Option<String>,
        /// Rate at which those holes build: `2 deg/30m`.
        #[serde(default)]
        build: Option<String>,
    },
    /// `modes`: natural frequencies, critical speeds and torsional stability.
    Modes {
        /// The operation.
        #[serde(default)]
        operation: Option<String>,
    },
    /// `calibrate`: friction factors from what was read at the surface.
    Calibrate {
        /// The id of the file of readings.
        data: String,
        /// One friction factor for casing and open hole.
        #[serde(default)]
        one_factor: bool,
        /// A factor for each section of the hole in place of casing and open hole.
        #[serde(default)]
        by_section: bool,
        /// Friction around the hole apart from that along it.
        #[serde(default)]
        friction_around: bool,
        /// The block's weight, although the case gives it.
        #[serde(default)]
        block_weight: bool,
        /// The bit's torque on bottom.
        #[serde(default)]
        bit_torque: bool,
        /// What is held: `friction_cased=0.2`.
        #[serde(default)]
        hold: Vec<String>,
        /// The model that predicts: `soft` or `stiff`.
        #[serde(default)]
        model: Option<String>,
        /// Whether the string in motion is put beside the readings.
        #[serde(default)]
        check_dynamics: bool,
    },
    /// `sweep`: the case with all combinations of some values.
    Sweep {
        /// Values by keys: `friction=0.1,0.2,0.3`, `bit_depth=300m..4305m/300m`.
        vary: Vec<String>,
        /// What is kept of each case: `summary`, `tables` or `all`.
        #[serde(default)]
        keep: Option<String>,
    },
    /// `study`: the cases of a study, with its figures and tables.
    Study {
        /// The id of the study file.
        study: String,
    },
    /// `bit-test`: the bit alone on its rock.
    BitTest {},
}

impl Work {
    /// The command.
    pub(crate) fn command(&self) -> &'static str {
        match self {
            Self::Run { .. } => "run",
            Self::Plan { .. } => "plan",
            Self::Reach { .. } => "reach",
            Self::Bha { .. } => "bha",
            Self::Modes { .. } => "modes",
            Self::Calibrate { .. } => "calibrate",
            Self::Sweep { .. } => "sweep",
            Self::Study { .. } => "study",
            Self::BitTest {} => "bit-test",
        }
    }

    /// Whether what was stopped can be continued; the others take seconds, and begin anew.
    pub(crate) fn is_resumable(&self) -> bool {
        !matches!(self, Self::Bha { .. } | Self::Modes { .. } | Self::Calibrate { .. })
    }
}
