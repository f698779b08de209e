//! `plan.xlsx`: inputs, verdict and roadmap, the broomsticks as charts, and every table as a sheet.

use wholestring_report::{Sheet, Workbook};
use wholestring_results::{PlanPeak, PlanSummary, Row as _, Table};
use wholestring_units::UnitSet;

use super::{
    charts::{BROOMSTICK, BUCKLING, HYDRAULICS, MEASURED, OVERLAY, SURFACE, charts},
    files::Tables,
    inputs_sheet::inputs_sheet,
    roadmap_sheet::roadmap_sheet,
    verdict_sheet::{unchecked_sheet, verdict_sheet},
};
use crate::{page::PROGRAM, sheet::sheet};

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
