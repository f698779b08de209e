//! Job requests: a command of the program with its main options.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// A request to run a command of the program on a saved case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct JobRequest {
    /// The id of the case; none for a study, which names its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) case: Option<String>,
    /// The command.
    pub(crate) work: Work,
    /// Values by key, as in `--set KEY=VALUE`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub(crate) set: BTreeMap<String, String>,
    /// Treatment of existing files in the results folder.
    #[serde(default)]
    pub(crate) if_there: IfThere,
}

/// Treatment of existing files in the results folder.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum IfThere {
    /// Finished results of the same work are replaced; unfinished and other results are kept.
    #[default]
    Protect,
    /// The unfinished work is continued, as by `--resume`.
    Resume,
    /// Everything is replaced, as by `--overwrite`.
    Overwrite,
}

/// A command with its main options; omitted ones have the defaults of the command line.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub(crate) enum Work {
    /// `run`: every operation of the case by its models.
    Run {
        /// Models that replace the case's: `soft`, `stiff`, `dynamic`.
        #[serde(default)]
        models: Vec<String>,
        /// Whether the tables are written as CSV too.
        #[serde(default)]
        csv: bool,
    },
    /// `plan`: torque and drag at every bit depth.
    Plan {
        /// The id of a file of readings: another program's curves, overlaid on the plan.
        #[serde(default)]
        overlay: Option<String>,
    },
    /// `reach`: greatest depth of the well, and the limit that stops it.
    Reach {
        /// First bit depth: `4000 m`.
        #[serde(default)]
        from: Option<String>,
        /// Deepest bit depth.
        #[serde(default)]
        to: Option<String>,
        /// Friction factors, each applied to all hole sections.
        #[serde(default)]
        frictions: Vec<f64>,
        /// The operations: `drill`, `slide`.
        #[serde(default)]
        operations: Vec<String>,
        /// Whether the friction from the wall force of a helix is ignored.
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
        /// Build rate of those holes: `2 deg/30m`.
        #[serde(default)]
        build: Option<String>,
    },
    /// `modes`: natural frequencies, critical speeds and torsional stability.
    Modes {
        /// The operation.
        #[serde(default)]
        operation: Option<String>,
    },
    /// `calibrate`: friction factors from readings at the surface.
    Calibrate {
        /// The id of the file of readings.
        data: String,
        /// One friction factor for casing and open hole.
        #[serde(default)]
        one_factor: bool,
        /// A factor for each hole section instead of casing and open hole.
        #[serde(default)]
        by_section: bool,
        /// Rotational friction separate from axial friction.
        #[serde(default)]
        friction_around: bool,
        /// Fits the block weight although the case gives it.
        #[serde(default)]
        block_weight: bool,
        /// Fits the bit torque on bottom.
        #[serde(default)]
        bit_torque: bool,
        /// Fixed parameters: `friction_cased=0.2`.
        #[serde(default)]
        hold: Vec<String>,
        /// The model of the predictions: `soft` or `stiff`.
        #[serde(default)]
        model: Option<String>,
        /// Whether the dynamic model is compared with the readings.
        #[serde(default)]
        check_dynamics: bool,
    },
    /// `sweep`: the case with all combinations of given values.
    Sweep {
        /// Values by key: `friction=0.1,0.2,0.3`, `bit_depth=300m..4305m/300m`.
        vary: Vec<String>,
        /// Results to keep of each case: `summary`, `tables` or `all`.
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

    /// Whether stopped work can be continued; other commands take seconds, and start again.
    pub(crate) fn is_resumable(&self) -> bool {
        !matches!(self, Self::Bha { .. } | Self::Modes { .. } | Self::Calibrate { .. })
    }
}
