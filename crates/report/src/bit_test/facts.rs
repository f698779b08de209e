//! Key facts of a bit test.

use serde_json::Value as Json;
use wholestring_results::BitTestSummary;

use crate::{Cell, Fact};

/// Key facts of bit, rock and grid.
pub(super) fn facts(summary: &BitTestSummary) -> Vec<Fact> {
    let test = &summary.settings["bit_test"];
    let number = |value: &Json| value.as_f64().unwrap_or(f64::NAN);
    vec![
        Fact::new("Bit diameter", Cell::quantity(2.0 * summary.bit_radius_m, "diameter")),
        Fact::new("Strength of the rock", Cell::quantity(summary.rock_strength_Pa, "stress")),
        Fact::new("Moving mass", Cell::quantity(number(&test["mass_kg"]), "mass")),
        Fact::new(
            "Revolutions",
            Cell::Text(format!(
                "{} after {}",
                number(&test["revolutions"]),
                number(&test["settle_revolutions"])
            )),
        ),
        Fact::new("Points", Cell::Text(summary.points.len().to_string())),
        Fact::new(
            "Torque over weight",
            match summary.response.torque_over_weight_and_radius {
                Some(slope) => Cell::Text(format!("{slope:.2} of the bit's radius")),
                None => Cell::Text("no slope: it takes two weights".into()),
            },
        ),
    ]
}
