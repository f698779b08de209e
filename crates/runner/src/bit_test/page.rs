//! `report.html` and the pictures of a bit test, made from the files that it left.

use std::path::Path;

use serde_json::{Value as Json, json};
use wholestring::rock::TrialOutcome;
use wholestring_report::{
    BitTest, BitTestPoint, Cell, Fact, PageTable, bit_test_html, bit_test_plots,
};
use wholestring_results::{BitTestSummary, ResultsError, ResultsFolder, Status};
use wholestring_units::UnitSet;

use super::{
    points::common,
    tables::{BOTTOM, OPERATION, POINTS},
};
use crate::page::{self, FILE, history::bottom, inputs::page_tables, table, write_picture};

/// The picture that is drawn unasked.
const DRILL_OFF: &str = "drill-off";

/// Whether a folder is one that a bit test wrote to.
pub(crate) fn is_bit_test(folder: &Path) -> bool {
    folder.join(format!("{POINTS}.parquet")).is_file()
}

/// Writes the page of a test and the picture of its drill-off; neither where no point is finished.
pub(crate) fn write(folder: &ResultsFolder, test: &BitTest) -> Result<(), ResultsError> {
    let plots = bit_test_plots(test, &test.head.units);
    let Some(drill_off) = plots.iter().find(|plot| plot.name == DRILL_OFF) else {
        folder.remove(FILE)?;
        return folder.remove(&format!("{DRILL_OFF}.svg"));
    };
    folder.write_file(FILE, bit_test_html(test).as_bytes())?;
    write_picture(folder, &drill_off.name, &drill_off.figure, false)
}

/// Everything that is reported of a bit test.
pub(crate) fn gather(folder: &Path, units: Option<UnitSet>) -> Result<BitTest, ResultsError> {
    let summary = BitTestSummary::read(&folder.join("summary.json"))?;
    let settings = &summary.settings;
    let mut points = Vec::new();
    for point in &summary.points {
        if let Some(outcome) = &point.outcome {
            let table = table(&folder.join(&point.point), BOTTOM)?;
            points.push(BitTestPoint { bottom: bottom(&table, OPERATION), ..test_point(outcome) });
        }
    }
    let missing = summary.points.len() - points.len();
    let failed = |of: &&wholestring_results::BitTestPoint| matches!(of.status, Status::Failed(_));
    let failed = summary.points.iter().filter(failed).count();
    let message = (missing > 0).then(|| {
        let all = summary.points.len();
        format!("{missing} of {all} points are missing, {failed} of them failed.")
    });
    let title = format!("{}: bit test", summary.case);
    Ok(BitTest {
        head: page::head(title, units, Some(settings), facts(&summary)),
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

/// What all points have in common, as tables.
fn inputs(settings: &Json) -> Vec<PageTable> {
    let common = common(settings);
    let mut page_tables = page_tables(&json!({
        "bit_face": common["bit"]["face"],
        "bit_test": common["bit_test"],
        "rock": common["rock"],
    }));
    // Of the case itself there is nothing.
    page_tables.retain(|page_table| !page_table.rows.is_empty());
    page_tables
}

/// Bit, rock and grid in a few facts.
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
