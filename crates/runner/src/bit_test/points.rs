//! The points of a bit test: every weight at every speed.

use std::{collections::BTreeSet, f64::consts::PI};

use serde_json::{Value, json};
use wholestring::rock::TrialSpec;
use wholestring_case::BitTest;
use wholestring_results::bit_test_common;
use wholestring_units::significant;

use crate::error::Error;

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
