//! JSON files of a bit test: `summary.json` of all, `point.json` of each point.

use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use wholestring::rock::{DrillingResponse, TrialOutcome};
use wholestring_judge::Check;

use crate::{
    ResultsError, Status,
    json::{read_versioned, write_json},
    row::rows,
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

rows! {
    /// One weight at one speed in the summary.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct BitTestPoint {
        point: String => Words, "Name of the point, and of its folder: `wob=60kN,rpm=120`";
        #[serde(flatten)]
        status: Status,
            "Progress of the point; also interrupted where it has not started";
        weight_on_bit_N: f64 => Force, "Applied weight on bit";
        rotary_speed_rad_per_s: f64 => RotarySpeed, "Rotary speed of the bit";
        outcome: Option<TrialOutcome>, "Its outcome, where it is finished", columns {
            rate_of_penetration_m_per_s => RateOfPenetration, "Mean rate of penetration";
            rate_of_penetration_error_m_per_s => RateOfPenetration,
                "Standard error of that mean, from its revolutions; `null` for less than two",
                null_where "there are less than two revolutions";
            depth_of_cut_m => Length, "Mean depth of cut per revolution";
            torque_N_m => Torque, "Mean torque of the bit on the rock";
            torque_error_N_m => Torque,
                "Standard error of that mean, from its revolutions; `null` for less than two",
                null_where "there are less than two revolutions";
            torque_std_N_m => Torque,
                "Standard deviation of the torque, of means over `averaging_time_s`";
            weight_borne_N => Force,
                "Mean weight carried by the rock: the weight on bit less the bit's inertia";
            weight_on_bit_std_N => Force,
                "Standard deviation of the weight carried by the rock, of means over \
                 `averaging_time_s`";
            specific_energy_Pa => Stress,
                "Work of the bit per volume of broken rock; `null` where none broke",
                null_where "no rock broke";
            mechanical_specific_energy_Pa => Stress,
                "Work of the bit per volume of hole, section times advance; `null` where the bit \
                 did not advance",
                null_where "the bit did not advance";
            bricks_broken => Ratio, "Elements of the rock broken by the bit";
            kinetic_fraction => Ratio,
                "Largest kinetic energy of the rock over the work of its deformation";
            revolutions => Ratio, "Counted revolutions";
            time_s => Time, "Counted time";
            averaging_time_s => Time,
                "Averaging time of the means of which standard deviations are computed";
        };
        status = |point| word(&point.status) => Words, "`complete`, `interrupted` or `failed`";
        message = |point| reason(&point.status) => Words, "Reason of a failure; else empty",
            null_where "it did not fail";
    }

    /// Columns of `bit-test.parquet`: the bit alone on its rock, a row for each weight at each
    /// speed.
    pub const BIT_TEST;
}

/// The status in the table.
const fn word(status: &Status) -> &'static str {
    match status {
        Status::Complete => "complete",
        Status::Interrupted => "interrupted",
        Status::Failed(_) => "failed",
    }
}

/// Reason of a failure.
fn reason(status: &Status) -> Option<&str> {
    match status {
        Status::Complete | Status::Interrupted => None,
        Status::Failed(reason) => Some(reason),
    }
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

/// Settings common to all points of a test: rock, face of the bit and test procedure, from the
/// settings of a case.
pub fn bit_test_common(settings: &Value) -> Value {
    let mut test = settings["bit_test"].clone();
    if let Some(test) = test.as_object_mut() {
        test.remove("wob_N");
        test.remove("rotary_speed_rad_per_s");
    }
    json!({
        "bit": { "face": settings["bit"]["face"] },
        "bit_test": test,
        "rock": settings["rock"],
    })
}

// The pattern on the bottom of the hole.

rows! {
    /// A cell of the bottom of a hole.
    #[derive(Debug, Clone, PartialEq)]
    pub struct BottomHoleCell {
        operation: String => Words, "`drill`, `slide`, ...";
        radius_m: f64 => Length, "Radius of the middle of the ring";
        angle_rad: f64 => Angle,
            "Angle of the middle of the sector from the high side towards the right, looking down \
             the hole";
        depth_m: Option<f64> => Length,
            "Depth of the uppermost rock, below the nose of the bit; `null` where no \
             rock is left",
            null_where "no rock is left";
    }

    /// Columns of `bottom_hole.parquet`: the pattern on the bottom of the hole at the end, one row
    /// per cell, ring after ring from the axis outwards, for each operation whose bit was on solid
    /// rock.
    pub const BOTTOM_HOLE;
}
