//! Sheet of a plan's inputs: well, string, mud, rig, operations and campaign, a line for each.

use serde_json::{Map, Value as Json};
use wholestring_judge::strength::PSI_PA;
use wholestring_report::{Sheet, input_tables};
use wholestring_results::PlanSummary;
use wholestring_units::UnitSet;

use crate::input_lines::{self, inputs_of, lines};

/// Keys of the settings that a plan depends on, without those of the dynamics only.
const KEYS: [&str; 10] =
    ["name", "units", "well", "string", "bit", "mud", "rig", "operation", "buckling", "plan"];

/// The inputs of a plan.
pub(super) fn inputs_sheet(summary: &PlanSummary, units: UnitSet) -> Sheet {
    let mut rows: Vec<[String; 3]> = Vec::new();
    for key in KEYS {
        let Some(value) = summary.settings.get(key) else { continue };
        let value = if key == "plan" { as_read(value) } else { value.clone() };
        let one = Json::Object(Map::from_iter([(key.to_owned(), value)]));
        for table in input_tables(&one) {
            rows.extend(lines(&table, units));
        }
    }
    let campaign = |word: &str, texts: &[String]| -> Vec<[String; 3]> {
        let line = |text: &String| {
            let text = summary.texts.in_units(text, units);
            ["Campaign".to_owned(), word.to_owned(), text]
        };
        texts.iter().map(line).collect()
    };
    rows.extend(campaign("counted", &summary.counted));
    rows.extend(campaign("not counted", &summary.not_counted));
    inputs_of("The inputs of the plan with all defaults filled in", rows)
}

/// Settings of a plan for display: without the depths, which the roadmap lists, with only the
/// operations of the campaign, and with wear factors in their own unit.
fn as_read(plan: &Json) -> Json {
    let mut plan = plan.clone();
    let Some(settings) = plan.as_object_mut() else { return plan };
    settings.remove("bit_depths_m");
    let Some(campaign) = settings.get_mut("campaign").and_then(Json::as_object_mut) else {
        return plan;
    };
    campaign.remove("operations");
    if let Some(factors) = campaign.get_mut("wear_factors") {
        let per_psi = |per_Pa: &Json| {
            let of_unit = per_Pa.as_f64()? * PSI_PA * 1e10;
            Some(format!("{}e-10/psi", input_lines::number(of_unit)))
        };
        let usual = per_psi(&factors["usual_per_Pa"]);
        let own = factors["of_section_per_Pa"].as_array().into_iter().flatten();
        let of_section = |one: &Json| {
            let section = one[0].as_u64()? + 1;
            Some(format!("section {section} {}", per_psi(&one[1])?))
        };
        let all: Vec<String> = usual.into_iter().chain(own.filter_map(of_section)).collect();
        *factors = Json::String(all.join("; "));
    }
    plan
}
