//! `plan.xlsx`: inputs, verdict and roadmap, the broomsticks as charts, and every table as a sheet.

use wholestring_report::{Sheet, Workbook};
use wholestring_results::{PlanSummary, Table, plan_peaks_table};
use wholestring_units::UnitSet;

use super::{
    charts::{BROOMSTICK, BUCKLING, HYDRAULICS, MEASURED, OVERLAY, SURFACE, charts},
    files::Tables,
    inputs_sheet::inputs_sheet,
    roadmap_sheet::roadmap_sheet,
    verdict_sheet::verdict_sheet,
};
use crate::{page::PROGRAM, sheet::sheet};

/// Rows of a table that are printed: a table of every depth or every joint is to be read on the
/// screen.
const PRINTED_ROWS: u32 = 50;

/// The workbook of a plan in these units.
pub(super) fn workbook(summary: &PlanSummary, found: &Tables, units: UnitSet) -> Workbook {
    let scattered = summary.uncertain.as_ref().map(|of| (of.table(), of.indices_table()));
    let measured = summary.measured_table();
    let overlay = summary.overlay.as_ref().map_or_else(|| Table::new(Vec::new()), |of| of.table());
    let peaks = plan_peaks_table(&summary.peaks);
    let surface = summary.surface_limits_table();
    let tables = [
        (
            BROOMSTICK,
            &summary.broomstick_table(),
            "A row for each depth of the bit of each model, operation and friction",
        ),
        (BUCKLING, &summary.buckling_table(), "Weights on bit under which the string buckles"),
        (
            SURFACE,
            &surface,
            "What hook load and torque may come to: the ends of lines in the charts",
        ),
        ("Fatigue", &found.fatigue, "What the campaign takes of the string's life"),
        ("Casing wear", &found.wear, "What the campaign takes of the casing"),
        ("Peaks", &peaks, "What a string that sets itself in motion comes to, by the dynamics"),
        ("Peaks against time", &found.peaks_time, "The same, sample by sample"),
        ("Friction", &summary.friction_table(), "Friction of each hole section at each level"),
        (
            HYDRAULICS,
            &summary.hydraulics_table(),
            "Pressures and equivalent densities with the bit at each depth",
        ),
        (
            MEASURED,
            &measured,
            "What was read, beside what the string in the hole is predicted to show",
        ),
        (OVERLAY, &overlay, "What another program computed, beside ours with expected friction"),
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
        let samples =
            samples.map(|table| ("Samples", table, "What was drawn of each uncertain number"));
        [
            (
                "Uncertain",
                bands,
                "How the samples of uncertain numbers scatter, in the unit of each row",
            ),
            (
                "Sensitivity",
                indices,
                "Sobol indices: the share of the variance that each uncertain number causes",
            ),
        ]
        .into_iter()
        .chain(samples)
    });
    let tables = tables.chain(scattered);
    let tables = tables.map(|(name, table, about)| sheet(name, table, about, units));
    let sheets: Vec<Sheet> = tables.collect();
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
