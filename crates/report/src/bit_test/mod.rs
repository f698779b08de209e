//! The page of a bit that was tested alone on the rock, and its pictures.

mod figures;

pub use figures::bit_test_plots;

use serde_json::{Value as Json, json};
use wholestring::rock::TrialOutcome;
use wholestring_results::{BitTestSummary, Status, bit_test_common};
use wholestring_units::UnitSet;

use crate::{BottomPicture, Cell, Fact, PageHead, PageTable, Place, inputs::input_tables};

/// A bit test with the head of its page. Numbers are SI.
#[derive(Debug, Clone, PartialEq)]
pub struct BitTest {
    /// Head of the page, under the name of the case.
    pub head: PageHead,
    /// The answer.
    pub summary: BitTestSummary,
    /// The bottom of the hole at the end of each point of the summary.
    bottoms: Vec<Option<BottomPicture>>,
}

/// One weight at one speed that is finished.
pub(crate) struct TestedPoint<'a> {
    /// Its outcome.
    pub(crate) outcome: &'a TrialOutcome,
    /// The bottom of the hole at its end.
    pub(crate) bottom: Option<&'a BottomPicture>,
}

impl BitTest {
    /// The page of a bit test and of the bottoms of all points in the order of the summary; it opens
    /// in these units, by default in those of the case.
    pub fn new(
        summary: BitTestSummary,
        bottoms: Vec<Option<BottomPicture>>,
        units: Option<UnitSet>,
    ) -> Self {
        let title = format!("{}: bit test", summary.case);
        let head = PageHead::new(title, units, Some(&summary.settings), facts(&summary));
        Self { head, summary, bottoms }
    }

    /// Whether a point is finished.
    pub fn has_points(&self) -> bool {
        self.summary.points.iter().any(|point| point.outcome.is_some())
    }

    /// Number of missing points, and of those that failed; `None` where none is missing.
    pub(crate) fn message(&self) -> Option<String> {
        let points = &self.summary.points;
        let missing = points.iter().filter(|point| point.outcome.is_none()).count();
        let failed = points.iter().filter(|point| matches!(point.status, Status::Failed(_)));
        (missing > 0).then(|| {
            let (all, failed) = (points.len(), failed.count());
            format!("{missing} of {all} points are missing, {failed} of them failed.")
        })
    }

    /// Tables of all points and of the inputs that are common to them: rock, face of the bit and
    /// test procedure.
    pub(crate) fn page_tables(&self) -> Vec<PageTable> {
        let common = bit_test_common(&self.summary.settings);
        let mut inputs = input_tables(&json!({
            "bit_face": common["bit"]["face"],
            "bit_test": common["bit_test"],
            "rock": common["rock"],
        }));
        // A bit test has none of the other inputs of a case.
        inputs.retain(|table| !table.rows.is_empty());
        std::iter::once(self.page_table()).chain(inputs).collect()
    }

    /// The points by speed, then by weight.
    pub(crate) fn sorted(&self) -> Vec<TestedPoint<'_>> {
        let points = self.summary.points.iter().zip(&self.bottoms);
        let tested = points.filter_map(|(point, bottom)| {
            Some(TestedPoint { outcome: point.outcome.as_ref()?, bottom: bottom.as_ref() })
        });
        let mut points: Vec<TestedPoint<'_>> = tested.collect();
        points.sort_by(|a, b| {
            let (a, b) = (a.outcome, b.outcome);
            let speeds = a.rotary_speed_rad_per_s.total_cmp(&b.rotary_speed_rad_per_s);
            speeds.then(a.weight_borne_N.total_cmp(&b.weight_borne_N))
        });
        points
    }

    /// All numbers, a row for each point.
    fn page_table(&self) -> PageTable {
        let heads = [
            "Rotary speed",
            "Weight on bit",
            "Rate of penetration",
            "Depth of cut",
            "Torque",
            "Torque over weight and radius",
            "Specific energy",
        ];
        let mean = |value: f64, std: f64, dimension: &str| match Cell::quantity(value, dimension) {
            Cell::Quantity { value, dimension, .. } => {
                Cell::Quantity { value, dimension, std: Some(std).filter(|std| std.is_finite()) }
            }
            other => other,
        };
        let row = |point: &TestedPoint<'_>| {
            let outcome = point.outcome;
            let [weight_N, torque_N_m] = [outcome.weight_borne_N, outcome.torque_N_m];
            let ratio = torque_N_m / (weight_N * self.summary.bit_radius_m);
            let energy_Pa = outcome.specific_energy_Pa.unwrap_or(f64::NAN);
            vec![
                Cell::quantity(outcome.rotary_speed_rad_per_s, "rotary speed"),
                mean(weight_N, outcome.weight_on_bit_std_N, "force"),
                Cell::quantity(outcome.rate_of_penetration_m_per_s, "rate of penetration"),
                Cell::quantity(outcome.depth_of_cut_m, "diameter"),
                mean(torque_N_m, outcome.torque_std_N_m, "torque"),
                Cell::quantity(ratio, "ratio"),
                Cell::quantity(energy_Pa, "specific energy"),
            ]
        };
        PageTable {
            place: Place::Cases,
            title: "All points: mean ± standard deviation within a point".into(),
            heads: heads.map(String::from).to_vec(),
            rows: self.sorted().iter().map(row).collect(),
        }
    }
}

// Key facts of a bit test.

/// Key facts of bit, rock and grid.
fn facts(summary: &BitTestSummary) -> Vec<Fact> {
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

#[cfg(test)]
mod tests;
