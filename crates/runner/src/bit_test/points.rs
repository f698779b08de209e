//! The points of a bit test: every weight at every speed.

use std::{borrow::Cow, collections::BTreeSet, f64::consts::PI, path::Path};

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use wholestring::rock::{DrillingSpec, Trial, TrialOutcome, TrialSpec};
use wholestring_case::BitTest;
use wholestring_results::{
    BIT_TEST_VERSION, BitTestOutcome, ResultsError, ResultsFolder, bit_test_common,
};
use wholestring_units::significant;

use crate::{checkpoint::difference, error::Error};

/// One weight at one speed.
pub(super) struct Point {
    /// Name of its folder: `wob=60kN,rpm=120`.
    pub(super) name: String,
    pub(super) spec: TrialSpec,
    /// All settings that its outcome depends on.
    pub(super) settings: Value,
}

/// Digits of a number in the name of a folder.
const DIGITS: usize = 9;

/// Rotary speed in rev/min, without digits added by the conversion.
pub(super) fn rpm(rad_per_s: f64) -> f64 {
    significant(rad_per_s * 30.0 / PI, 12)
}

/// The points, ordered by weight, then by speed.
pub(super) fn points(test: &BitTest, settings: &Value) -> Result<Vec<Point>, Error> {
    let common = bit_test_common(settings);
    let point = |weight_N: f64, rotary_rad_per_s: f64| {
        let mut settings = common.clone();
        settings["bit_test"]["weight_on_bit_N"] = json!(weight_N);
        settings["bit_test"]["rotary_speed_rad_per_s"] = json!(rotary_rad_per_s);
        Point {
            name: format!(
                "wob={}kN,rpm={}",
                significant(1e-3 * weight_N, DIGITS),
                significant(rpm(rotary_rad_per_s), DIGITS)
            ),
            spec: TrialSpec {
                weight_N,
                rotary_rad_per_s,
                mass_kg: test.mass_kg,
                settle_revolutions: test.settle_revolutions,
                revolutions: test.revolutions,
                averaging_s: test.averaging_s,
                step_s: test.step_s,
            },
            settings,
        }
    };
    let points: Vec<Point> = test
        .weights_N
        .iter()
        .flat_map(|weight| {
            let speeds = test.rotary_speeds_rad_per_s.iter();
            speeds.map(|speed| point(*weight, *speed))
        })
        .collect();
    let mut names = BTreeSet::new();
    match points.iter().find(|point| !names.insert(&point.name)) {
        Some(twice) => Err(Error::BadInput(format!(
            "two points of the test are {}: weights and speeds must differ in their first \
             {DIGITS} digits",
            twice.name
        ))),
        None => Ok(points),
    }
}

// Files in the folder of a point, before and after it is finished.

/// Name of the file of a finished point.
const FILE: &str = "point.json";

/// A trial as stored in its checkpoint.
#[derive(Serialize, Deserialize)]
pub(super) struct PointCheckpoint<'a> {
    /// The point's settings, as JSON.
    settings: String,
    pub(super) trial: Cow<'a, Trial>,
}

impl<'a> PointCheckpoint<'a> {
    pub(super) fn new(point: &Point, trial: &'a Trial) -> Self {
        Self { settings: point.settings.to_string(), trial: Cow::Borrowed(trial) }
    }
}

impl PointCheckpoint<'static> {
    /// Reads the checkpoint in the folder of the point, if there is one.
    ///
    /// # Errors
    /// The reason why the point cannot continue from it.
    pub(super) fn read(
        folder: &ResultsFolder,
        point: &Point,
        drilling: &DrillingSpec,
    ) -> Result<Option<Self>, String> {
        let stored: Option<Self> = folder.read_checkpoint().map_err(|e| e.to_string())?;
        let Some(stored) = stored else {
            return Ok(None);
        };
        let settings: Value = serde_json::from_str(&stored.settings).map_err(|e| e.to_string())?;
        let place = folder.path().display();
        if let Some(difference) = difference(&settings, &point.settings) {
            return Err(format!("the checkpoint in {place} is of another test: {difference}"));
        }
        let valid = stored.trial.check(&point.spec, drilling);
        valid.map_err(|error| format!("the checkpoint in {place} cannot be continued: {error}"))?;
        Ok(Some(stored))
    }
}

/// Reads the outcome of a finished trial from the folder of the point; `None` if it is not finished
/// or belongs to another test.
pub(super) fn finished(folder: &Path, point: &Point) -> Option<TrialOutcome> {
    let there = BitTestOutcome::read(&folder.join(FILE)).ok()?;
    difference(&there.settings, &point.settings).is_none().then_some(there.outcome)
}

/// Marks the point as finished.
pub(super) fn finish(
    folder: &ResultsFolder,
    point: &Point,
    outcome: TrialOutcome,
) -> Result<(), ResultsError> {
    let done = BitTestOutcome {
        schema_version: BIT_TEST_VERSION,
        settings: point.settings.clone(),
        outcome,
    };
    done.write(&folder.path().join(FILE))
}

/// Restarts the point: removes the files that an earlier test left of it.
pub(super) fn begin(folder: &ResultsFolder) -> Result<(), ResultsError> {
    folder.remove(FILE)?;
    folder.remove_checkpoint()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn speeds_have_the_digits_they_were_given_with() {
        for speed_rpm in [1.0, 59.7, 120.0, 333.0] {
            assert_eq!(rpm(speed_rpm * PI / 30.0), speed_rpm);
        }
    }

    #[test]
    fn the_grid_is_no_part_of_what_points_depend_on() {
        let settings = json!({
            "bit": { "law": "rate", "face": { "blades": 5 } },
            "bit_test": { "wob_N": [1.0], "rotary_speed_rad_per_s": [2.0], "mass_kg": 3.0 },
            "rock": { "strength_Pa": 4.0 },
        });
        assert_eq!(
            bit_test_common(&settings),
            json!({
                "bit": { "face": { "blades": 5 } },
                "bit_test": { "mass_kg": 3.0 },
                "rock": { "strength_Pa": 4.0 },
            })
        );
    }
}
