//! `report.html` and the pictures of a bit test, made from the files in its folder.

use std::path::Path;

use serde_json::{Value as Json, json};
use wholestring::rock::TrialOutcome;
use wholestring_report::{
    BitTest, BitTestPoint, Cell, Fact, PageHead, PageTable, Plot, bit_test_html, bit_test_plots,
};
use wholestring_results::{BitTestSummary, ResultsError, Status};
use wholestring_units::UnitSet;

use super::{
    points::common,
    tables::{BOTTOM, LAW, POINTS},
};
use crate::{
    page::{history::bottom_picture, inputs::page_tables, table},
    results_kind::Results,
};

/// The picture that is drawn by default.
const DRILL_OFF: &str = "drill-off";

impl Results for BitTest {
    const NOUN: &'static str = "a bit test";
    const TABLE: &'static str = POINTS;
    const PICTURES: &'static [&'static str] = &[DRILL_OFF];
    const FILES: &'static [&'static str] = &[LAW];

    fn gather(folder: &Path, units: Option<UnitSet>) -> Result<Self, ResultsError> {
        let summary = BitTestSummary::read(&folder.join("summary.json"))?;
        let settings = &summary.settings;
        let mut points = Vec::new();
        for point in &summary.points {
            if let Some(outcome) = &point.outcome {
                let table = table(&folder.join(&point.point), BOTTOM)?;
                points.push(BitTestPoint {
                    bottom: bottom_picture(&table, &Vec::from_iter(0..table.rows())),
                    ..test_point(outcome)
                });
            }
        }
        let missing = summary.points.len() - points.len();
        let failed =
            |point: &&wholestring_results::BitTestPoint| matches!(point.status, Status::Failed(_));
        let failed = summary.points.iter().filter(failed).count();
        let message = (missing > 0).then(|| {
            let all = summary.points.len();
            format!("{missing} of {all} points are missing, {failed} of them failed.")
        });
        let title = format!("{}: bit test", summary.case);
        Ok(Self {
            head: PageHead::new(title, units, Some(settings), facts(&summary)),
            strength_Pa: summary.rock_strength_Pa,
            radius_m: summary.bit_radius_m,
            torque_by_weight: summary
                .response
                .torque_over_weight_m
                .zip(summary.response.torque_at_no_weight_N_m)
                .map(|(slope_m, offset_N_m)| [slope_m, offset_N_m]),
            points,
            message,
            page_tables: inputs(settings),
        })
    }

    fn html(&self) -> Option<String> {
        (!self.points.is_empty()).then(|| bit_test_html(self))
    }

    fn plots(&self) -> Vec<Plot> {
        bit_test_plots(self, &self.head.units)
    }
}

fn test_point(outcome: &TrialOutcome) -> BitTestPoint {
    BitTestPoint {
        weight_N: outcome.weight_borne_N,
        weight_std_N: outcome.weight_on_bit_std_N,
        rotary_rad_per_s: outcome.rotary_speed_rad_per_s,
        rate_m_per_s: outcome.rate_of_penetration_m_per_s,
        torque_N_m: outcome.torque_N_m,
        torque_std_N_m: outcome.torque_std_N_m,
        depth_of_cut_m: outcome.depth_of_cut_m,
        specific_energy_Pa: outcome.specific_energy_Pa.unwrap_or(f64::NAN),
        bottom: None,
    }
}

/// Settings common to all points, as tables.
fn inputs(settings: &Json) -> Vec<PageTable> {
    let common = common(settings);
    let mut page_tables = page_tables(&json!({
        "bit_face": common["bit"]["face"],
        "bit_test": common["bit_test"],
        "rock": common["rock"],
    }));
    // A bit test has none of the other inputs of a case.
    page_tables.retain(|page_table| !page_table.rows.is_empty());
    page_tables
}

/// Key facts of bit, rock and grid.
fn facts(summary: &BitTestSummary) -> Vec<Fact> {
    let test = &summary.settings["bit_test"];
    let number = |value: &Json| value.as_f64().unwrap_or(f64::NAN);
    let fact = |label: &str, value: Cell| Fact { label: label.into(), value };
    vec![
        fact("Bit diameter", Cell::quantity(2.0 * summary.bit_radius_m, "diameter")),
        fact("Strength of the rock", Cell::quantity(summary.rock_strength_Pa, "pressure")),
        fact("Moving mass", Cell::quantity(number(&test["mass_kg"]), "mass")),
        fact(
            "Revolutions",
            Cell::Text(format!(
                "{} after {}",
                number(&test["revolutions"]),
                number(&test["settle_revolutions"])
            )),
        ),
        fact("Points", Cell::Text(summary.points.len().to_string())),
        fact(
            "Torque over weight",
            match summary.response.torque_over_weight_and_radius {
                Some(slope) => Cell::Text(format!("{slope:.2} of the bit's radius")),
                None => Cell::Text("no slope: it takes two weights".into()),
            },
        ),
    ]
}
