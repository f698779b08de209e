//! JSON files of a bit test: `summary.json` of all, `point.json` of each point.

use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use wholestring::rock::{DrillingResponse, TrialOutcome};
use wholestring_judge::Check;

use crate::{
    ResultsError, Status,
    json::{read_versioned, write_json},
};

/// Version of the layout of the files of a bit test; raised when a key changes or is removed.
pub const BIT_TEST_VERSION: u32 = 1;

/// `summary.json` of a bit test.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BitTestSummary {
    /// [`BIT_TEST_VERSION`] of the program that wrote it.
    pub schema_version: u32,
    /// Name of the case.
    pub case: String,
    /// The case's settings with all defaults filled in.
    pub settings: Value,
    /// Unconfined strength of the rock, Pa.
    pub rock_strength_Pa: f64,
    /// Radius of the bit, m.
    pub bit_radius_m: f64,
    /// Common response of the finished points.
    pub response: DrillingResponse,
    /// The checks of the points, the most severe first.
    #[serde(default)]
    pub checks: Vec<Check>,
    /// Every point, speeds after speeds of one weight.
    pub points: Vec<BitTestPoint>,
}

impl BitTestSummary {
    /// The sentences of the checks that need attention.
    pub fn warnings(&self) -> Vec<String> {
        let open = self.checks.iter().filter(|check| !check.is_ok());
        open.map(|check| check.sentence.clone()).collect()
    }
}

/// One weight at one speed in the summary.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BitTestPoint {
    /// Name of the point, and of its folder.
    pub point: String,
    /// Progress of the point; also interrupted where it has not started.
    #[serde(flatten)]
    pub status: Status,
    /// Weight that is put on the bit, N.
    pub weight_on_bit_N: f64,
    /// Rotary speed, rad/s.
    pub rotary_speed_rad_per_s: f64,
    /// Its outcome, where it is finished.
    pub outcome: Option<TrialOutcome>,
}

/// `point.json`: a finished point by itself.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BitTestOutcome {
    /// [`BIT_TEST_VERSION`] of the program that wrote it.
    pub schema_version: u32,
    /// All settings that the point depends on: rock, face of the bit, test procedure, weight and
    /// speed.
    pub settings: Value,
    /// Its outcome.
    pub outcome: TrialOutcome,
}

impl BitTestSummary {
    /// Writes the summary as indented JSON.
    pub fn write(&self, path: &Path) -> Result<(), ResultsError> {
        write_json(self, path)
    }

    /// Reads back a summary, and refuses one of another [`BIT_TEST_VERSION`].
    pub fn read(path: &Path) -> Result<Self, ResultsError> {
        read_versioned(path, BIT_TEST_VERSION..=BIT_TEST_VERSION)
    }
}

impl BitTestOutcome {
    /// Writes the point as indented JSON.
    pub fn write(&self, path: &Path) -> Result<(), ResultsError> {
        write_json(self, path)
    }

    /// Reads back a point, and refuses one of another [`BIT_TEST_VERSION`].
    pub fn read(path: &Path) -> Result<Self, ResultsError> {
        read_versioned(path, BIT_TEST_VERSION..=BIT_TEST_VERSION)
    }
}
