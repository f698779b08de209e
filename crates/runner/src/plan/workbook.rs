//! `plan.xlsx`: inputs, verdict and roadmap, the broomsticks as charts, and every table as a sheet.

use serde_json::{Map, Value as Json};
use wholestring::{operation::OperationKind, outcome::ModelKind, well::FrictionLevel};
use wholestring_judge::strength::PSI_PA;
use wholestring_report::{Cells, Sheet, SheetColumn, Workbook, input_tables, pretty_symbol};
use wholestring_results::{PlanCheck, PlanPeak, PlanPoint, PlanSummary, Row as _, Table};
use wholestring_units::{Dimension, UnitSet};

use super::{
    charts::{BROOMSTICK, BUCKLING, HYDRAULICS, MEASURED, OVERLAY, SURFACE, charts},
    files::Tables,
};
use crate::{
    page::PROGRAM,
    sheet::{self, inputs_of, lines, sheet},
};

/// Printed rows of a table; tables of every depth or every joint are intended for the screen.
const PRINTED_ROWS: u32 = 50;

/// The workbook of a plan in these units.
pub(super) fn workbook(summary: &PlanSummary, found: &Tables, units: UnitSet) -> Workbook {
    let scattered =
        summary.uncertain.as_ref().map(|uncertain| (uncertain.table(), uncertain.indices_table()));
    let measured = summary.measured_table();
    let overlay =
        summary.overlay.as_ref().map_or_else(|| Table::new(Vec::new()), |overlay| overlay.table());
    let peaks = PlanPeak::table(&summary.peaks);
    let surface = summary.surface_limits_table();
    let tables = [
        (
            BROOMSTICK,
            &summary.broomstick_table(),
            "A row for each depth of the bit of each model, operation and friction",
        ),
        (BUCKLING, &summary.buckling_table(), "Weights on bit under which the string buckles"),
        (SURFACE, &surface, "Limits of hook load and torque: the ends of lines in the charts"),
        (
            "Along the string",
            &found.along,
            "The string at every 30 m or 100 ft, with the bit at the deepest depth and the expected \
             friction, by the soft string",
        ),
        ("Fatigue", &found.fatigue, "Fatigue damage of the string by the campaign"),
        ("Casing wear", &found.wear, "Casing wear by the campaign"),
        ("Peaks", &peaks, "Peak loads of a string that is set in motion, from the dynamics"),
        ("Peaks against time", &found.peaks_time, "The same, sample by sample"),
        ("Friction", &summary.friction_table(), "Friction of each hole section at each level"),
        (
            HYDRAULICS,
            &summary.hydraulics_table(),
            "Pressures and equivalent densities with the bit at each depth",
        ),
        (MEASURED, &measured, "Readings, and the predictions for the string in the hole"),
        (
            OVERLAY,
            &overlay,
            "Results of another program, and those of the plan with expected friction",
        ),
    ];
    let is_there = |name: &str| match name {
        HYDRAULICS => !summary.hydraulics.is_empty(),
        SURFACE => !summary.surface_limits.is_empty(),
        "Along the string" => !found.along.columns().is_empty(),
        "Peaks" | "Peaks against time" => !summary.peaks.is_empty(),
        MEASURED => !summary.measured.is_empty(),
        OVERLAY => summary.overlay.is_some(),
        _ => true,
    };
    let tables = tables.into_iter().filter(|(name, ..)| is_there(name));
    let scattered = scattered.iter().flat_map(|(bands, indices)| {
        let samples = found.samples.as_ref();
        let samples = samples.map(|table| ("Samples", table, "Samples of each uncertain input"));
        [
            (
                "Uncertain",
                bands,
                "Scatter of the results for uncertain inputs, in the unit of each row",
            ),
            (
                "Sensitivity",
                indices,
                "Sobol indices: the share of the variance that each uncertain input causes",
            ),
        ]
        .into_iter()
        .chain(samples)
    });
    let tables = tables.chain(scattered);
    let tables = tables.map(|(name, table, about)| sheet(name, table, about, units));
    let sheets: Vec<Sheet> = unchecked_sheet(summary, units).into_iter().chain(tables).collect();
    let first = [inputs_sheet, verdict_sheet, roadmap_sheet].map(|make| make(summary, units));
    let charts = charts(summary, &sheets);
    Workbook {
        title: format!("{}: plan", summary.case),
        about: vec![format!("Made by {PROGRAM}. Units are those of the headings.")],
        first: first.into(),
        charts,
        sheets,
        printed_rows: Some(PRINTED_ROWS),
    }
}

// Sheet of a plan's inputs: well, string, mud, rig, operations and campaign, a line for each.

/// Keys of the settings that a plan depends on, without those of the dynamics only.
const KEYS: [&str; 10] =
    ["name", "units", "well", "string", "bit", "mud", "rig", "operation", "buckling", "plan"];

/// The inputs of a plan.
fn inputs_sheet(summary: &PlanSummary, units: UnitSet) -> Sheet {
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
            Some(format!("{}e-10/psi", sheet::number(of_unit)))
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

// Roadmap of a plan: hook loads and torques of every operation, a row for each depth of the bit.

/// A row for each depth of each model.
fn roadmap_sheet(summary: &PlanSummary, units: UnitSet) -> Sheet {
    let depths_m = &summary.bit_depths_m;
    let rows: Vec<(ModelKind, f64)> = summary
        .models
        .iter()
        .copied()
        .flat_map(|model| depths_m.iter().map(move |depth_m| (model, *depth_m)))
        .collect();
    let length = Dimension::Length.unit_in(units);
    let mut columns = vec![SheetColumn {
        heading: "bit depth".to_owned(),
        unit: length.symbol.to_owned(),
        meaning: "Measured depth of the bit".to_owned(),
        cells: Cells::Numbers(rows.iter().map(|row| Some(length.from_si(row.1))).collect()),
    }];
    if summary.models.len() > 1 {
        columns.insert(
            0,
            SheetColumn {
                heading: "model".to_owned(),
                unit: String::new(),
                meaning: "The model that found it".to_owned(),
                cells: Cells::Words(rows.iter().map(|row| row.0.name().to_owned()).collect()),
            },
        );
    }
    let mut add = |operation: OperationKind,
                   what: &str,
                   dimension: Dimension,
                   quantity: fn(&PlanPoint) -> Option<f64>| {
        let unit = dimension.unit_in(units);
        for level in FrictionLevel::ALL {
            let value = |(model, depth_m): &(ModelKind, f64)| {
                let mut curve = summary.curve(*model, operation, level);
                let point = curve.find(|point| point.bit_depth_m == *depth_m)?;
                Some(unit.from_si(quantity(point)?))
            };
            columns.push(SheetColumn {
                heading: format!("{operation} {what} {level}"),
                unit: pretty_symbol(unit.symbol),
                meaning: format!(
                    "{} of {operation} with {level} friction; empty without an answer, which is on the \
                     sheet Verdict",
                    if what == "torque" { "Surface torque" } else { "Hook load without block" }
                ),
                cells: Cells::Numbers(rows.iter().map(value).collect()),
            });
        }
    };
    for operation in &summary.operations {
        add(*operation, "hook load", Dimension::Force, |point| Some(point.scalars?.hook_load_N));
    }
    for operation in summary.operations.iter().filter(|operation| operation.rotates()) {
        add(*operation, "torque", Dimension::Torque, |point| {
            Some(point.scalars?.surface_torque_N_m)
        });
    }
    let about = "A row for each depth of the bit: hook load without block and surface torque \
        with low, expected and high friction";
    Sheet { name: "Roadmap".to_owned(), about: about.to_owned(), columns }
}

// Sheets of a plan's checks for a reader: the verdict, and what was not checked.

/// Checks of a plan: the most severe for each kind and operation.
fn verdict_sheet(summary: &PlanSummary, units: UnitSet) -> Sheet {
    let mut rows: Vec<&PlanCheck> = summary.checks.iter().collect();
    rows.sort_by_key(|row| std::cmp::Reverse(row.check.severity));
    let words = |heading: &str, meaning: &str, word: &dyn Fn(&PlanCheck) -> String| SheetColumn {
        heading: heading.to_owned(),
        unit: String::new(),
        meaning: meaning.to_owned(),
        cells: Cells::Words(rows.iter().map(|row| word(row)).collect()),
    };
    let length = Dimension::Length.unit_in(units);
    let number = |[heading, unit, meaning]: [&str; 3],
                  number: &dyn Fn(&PlanCheck) -> Option<f64>| {
        SheetColumn {
            heading: heading.to_owned(),
            unit: unit.to_owned(),
            meaning: meaning.to_owned(),
            cells: Cells::Numbers(rows.iter().map(|row| number(row)).collect()),
        }
    };
    let columns = vec![
        words("severity", "How serious it is", &|row| row.check.severity.name().to_owned()),
        words("verdict", "The verdict in words", &|row| row.check.verdict.words().to_owned()),
        words("check", "What is compared or reported", &|row| row.check.kind.label().to_owned()),
        words("operation", "The operation", &|row| row.operation.words().to_owned()),
        words("model", "The model that found it", &|row| row.model.name().to_owned()),
        words("friction", "Low, expected or high", &|row| row.friction.name().to_owned()),
        number(["bit depth", length.symbol, "Measured depth of the bit"], &|row| {
            Some(length.from_si(row.bit_depth_m))
        }),
        words("component", "The component; empty of the rig", &|row| {
            row.check.component.clone().unwrap_or_default()
        }),
        number(["measured depth", length.symbol, "Measured depth of the place"], &|row| {
            Some(length.from_si(row.check.md_m?))
        }),
        number(["factor", "", "Capacity over load"], &|row| row.check.factor),
        number(["required", "", "Required factor"], &|row| row.check.required),
        words("sentence", "The check as a sentence", &|row| row.check.sentence_in(units)),
    ];
    let about = "Of each kind of check and each operation the most severe of all models, depths and \
        frictions; plan_limits.csv has every depth and component";
    Sheet { name: "Verdict".to_owned(), about: about.to_owned(), columns }
}

/// Limits that were not checked, and what the plan leaves out; `None` where there is nothing.
fn unchecked_sheet(summary: &PlanSummary, units: UnitSet) -> Option<Sheet> {
    let phrases = summary.unchecked.iter().map(|phrase| summary.texts.in_units(phrase, units));
    let column = SheetColumn {
        heading: "not checked".to_owned(),
        unit: String::new(),
        meaning: "Limits, with the number that is missing, and other parts left out".to_owned(),
        cells: Cells::Words(phrases.collect()),
    };
    let about = "What the verdict does not include";
    (!summary.unchecked.is_empty()).then(|| Sheet {
        name: "Not checked".to_owned(),
        about: about.to_owned(),
        columns: vec![column],
    })
}
