//! The nine commands with their options; omitted ones have the defaults of the command line.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};
use wholestring::{operation::OperationKind, outcome::ModelKind};

use super::options;
use crate::keep::Keep;

/// A command with its options.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Work {
    /// `run`: every operation of the case by its models.
    Run {
        /// Models that replace the case's: `soft`, `stiff`, `dynamic`.
        #[serde(default)]
        #[cfg_attr(feature = "openapi", schema(value_type = Vec<String>))]
        models: Vec<ModelKind>,
        /// Whether the tables are written as CSV too.
        #[serde(default)]
        csv: bool,
    },
    /// `plan`: torque and drag at every bit depth.
    Plan {
        /// File of readings: another program's curves, overlaid on the plan.
        #[serde(default)]
        #[cfg_attr(feature = "openapi", schema(value_type = Option<String>))]
        overlay: Option<PathBuf>,
        /// Whether PNG images are written too.
        #[serde(default)]
        png: bool,
    },
    /// `reach`: greatest depth of the well, and the limit that stops it.
    Reach(ReachOptions),
    /// `bha`: static analysis of the bottom-hole assembly.
    Bha(BhaOptions),
    /// `modes`: natural frequencies, critical speeds and torsional stability.
    Modes {
        /// The operation; the first of the case by default.
        #[serde(default, deserialize_with = "options::one_operation")]
        #[cfg_attr(feature = "openapi", schema(value_type = Option<String>))]
        operation: Option<OperationKind>,
        /// Whether PNG images are written too.
        #[serde(default)]
        png: bool,
    },
    /// `calibrate`: friction factors from readings at the surface.
    Calibrate(CalibrateOptions),
    /// `sweep`: the case with all combinations of given values.
    Sweep(SweepOptions),
    /// `study`: the cases of a study, with its figures and tables.
    Study(StudyOptions),
    /// `bit-test`: the bit alone on its rock.
    BitTest {
        /// Share of the points to drill, such as `1/4`.
        #[serde(default)]
        shard: Option<String>,
        /// Whether the tables are written as CSV too.
        #[serde(default)]
        csv: bool,
    },
}

/// Options of `reach`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(default, deny_unknown_fields)]
pub struct ReachOptions {
    /// First bit depth: `4000 m`.
    pub from: Option<String>,
    /// Deepest bit depth.
    pub to: Option<String>,
    /// Friction factors, each applied to all hole sections.
    pub frictions: Vec<f64>,
    /// The operations: `drill`, `slide`.
    #[serde(deserialize_with = "options::operations")]
    #[cfg_attr(feature = "openapi", schema(value_type = Vec<String>))]
    pub operations: Vec<OperationKind>,
    /// Whether the friction from the wall force of a helix is ignored.
    pub no_helix_friction: bool,
    /// Whether the string stops at the onset of its helix, although it could advance buckled.
    pub stop_at_helix: bool,
    /// Whether a PNG image is written too.
    pub png: bool,
}

/// Options of `bha`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(default, deny_unknown_fields)]
pub struct BhaOptions {
    /// The operation; the first that drills by default.
    #[serde(deserialize_with = "options::one_operation")]
    #[cfg_attr(feature = "openapi", schema(value_type = Option<String>))]
    pub operation: Option<OperationKind>,
    /// Whether the whole string is solved.
    pub whole: bool,
    /// Tool faces of the bend: `0 deg..360 deg/15 deg`.
    pub toolface: Option<String>,
    /// Weights on bit: `20 kN..120 kN/20 kN`.
    pub weight: Option<String>,
    /// Inclinations of a straight hole.
    pub inclination: Option<String>,
    /// Build rate of those holes: `2 deg/30m`.
    pub build: Option<String>,
    /// Whether the tables are written as CSV too.
    pub csv: bool,
}

/// Options of `calibrate`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(deny_unknown_fields)]
pub struct CalibrateOptions {
    /// The file of readings.
    #[cfg_attr(feature = "openapi", schema(value_type = String))]
    pub data: PathBuf,
    /// Case files of the other strings that were in the hole.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(feature = "openapi", schema(value_type = Vec<String>))]
    pub other_cases: Vec<PathBuf>,
    /// One friction factor for casing and open hole.
    #[serde(default)]
    pub one_factor: bool,
    /// A factor for each hole section instead of casing and open hole.
    #[serde(default)]
    pub by_section: bool,
    /// Rotational friction separate from axial friction.
    #[serde(default)]
    pub friction_around: bool,
    /// Fits the block weight although the case gives it.
    #[serde(default)]
    pub block_weight: bool,
    /// Fits the bit torque on bottom.
    #[serde(default)]
    pub bit_torque: bool,
    /// Fixed parameters: `friction_cased=0.2`.
    #[serde(default)]
    pub hold: Vec<String>,
    /// Standard error of pick-up and slack-off weights, such as `12 kN`; estimated by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub weight_error: Option<String>,
    /// Standard error of rotating weights; estimated by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rotating_error: Option<String>,
    /// Standard error of torques, such as `500 N.m`; estimated by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub torque_error: Option<String>,
    /// Number of standard errors beyond which a residual is an outlier; 3 by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub outlier: Option<String>,
    /// Excludes the outliers from the fit.
    #[serde(default)]
    pub without_outliers: bool,
    /// Confidence of the bands, %; 90 by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub band: Option<String>,
    /// The model of the predictions: `soft`, the default, or `stiff`.
    #[serde(default)]
    #[cfg_attr(feature = "openapi", schema(value_type = Option<String>))]
    pub model: Option<ModelKind>,
    /// Whether the dynamic model is compared with the readings.
    #[serde(default)]
    pub check_dynamics: bool,
    /// Bit depths of that comparison, such as `2100 m`; the shallowest, the middle and the deepest
    /// by default.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub check_depths: Vec<String>,
    /// Whether PNG images are written too.
    #[serde(default)]
    pub png: bool,
}

/// Options of work on many cases: of `sweep` and `study`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(default)]
pub struct CasesOptions {
    /// Results to keep of each case: `summary`, `tables` or `all`.
    #[serde(deserialize_with = "options::kept")]
    #[cfg_attr(feature = "openapi", schema(value_type = Option<String>))]
    pub keep: Option<Keep>,
    /// Share of the cases to solve, such as `1/4`.
    pub shard: Option<String>,
    /// Whether the tables that are kept are written as CSV too.
    pub csv: bool,
}

/// Options of `sweep`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(deny_unknown_fields)]
pub struct SweepOptions {
    /// The varied keys with their values.
    pub vary: Vec<Varied>,
    /// Whether the keys are varied together: the n-th case has the n-th value of every key.
    #[serde(default)]
    pub together: bool,
    /// Options of its cases.
    #[serde(flatten)]
    pub cases: CasesOptions,
}

/// A varied key with its values.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(untagged, deny_unknown_fields)]
#[serde(expecting = "`vary`: expected a text such as friction=0.1,0.2, or a key with its values")]
pub enum Varied {
    /// As by `--vary`: `friction=0.1,0.2,0.3`, `bit_depth=300m..4305m/300m`.
    Text(String),
    /// A list, such as samples, which may be equal.
    List {
        /// Dotted or short key.
        key: String,
        /// Values as by `--set`.
        values: Vec<String>,
    },
}

/// Options of `study`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(deny_unknown_fields)]
pub struct StudyOptions {
    /// The study file.
    #[cfg_attr(feature = "openapi", schema(value_type = String))]
    pub study: PathBuf,
    /// Options of its cases.
    #[serde(flatten)]
    pub cases: CasesOptions,
    /// Whether PNG images are written too.
    #[serde(default)]
    pub png: bool,
}

impl Work {
    /// The command.
    pub fn command(&self) -> &'static str {
        match self {
            Self::Run { .. } => "run",
            Self::Plan { .. } => "plan",
            Self::Reach(_) => "reach",
            Self::Bha(_) => "bha",
            Self::Modes { .. } => "modes",
            Self::Calibrate(_) => "calibrate",
            Self::Sweep(_) => "sweep",
            Self::Study(_) => "study",
            Self::BitTest { .. } => "bit-test",
        }
    }

    /// Whether stopped work can be continued; other commands take seconds, and start again.
    pub fn is_resumable(&self) -> bool {
        !matches!(self, Self::Bha(_) | Self::Modes { .. } | Self::Calibrate(_))
    }

    /// Whether the work writes checkpoints, so that the time between them can be chosen.
    pub(super) fn has_checkpoints(&self) -> bool {
        self.is_resumable() && !matches!(self, Self::Reach(_))
    }
}
