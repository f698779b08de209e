//! Another program's curves over the broomsticks, and how far ours lie from them.

use super::{Plan, PlanOverlayRow};
use crate::operation_words::{four, operation_name};
use crate::{
    Grid, StudyPart, Verdict,
    figure::{Ink, Key, Mark, Sample, Stroke},
    grid_cells::{head, row},
    plots::Shown,
};

/// The line of another program: no friction and no operation of ours has it.
const LINE: (Ink, Stroke) = (Ink::Note, Stroke::LongDashed);

/// Letters of a file's name at a line.
const LETTERS: usize = 24;

/// A line for each of some operations, and the file's name at the end of the longest.
pub(super) fn marks(
    plan: &Plan,
    shown: Shown<'_>,
    operations: &[&str],
    dimension: &str,
) -> Vec<Mark> {
    let Some(overlay) = &plan.overlay else { return Vec::new() };
    let mut marks = Vec::new();
    let mut longest: Option<(f64, f64)> = None;
    for operation in operations {
        let points: Vec<(f64, f64)> = first_model(plan, operation, dimension)
            .map(|of| (shown.value(of.bit_depth_m, "length"), shown.value(of.theirs, dimension)))
            .collect();
        let Some(end) = points.last() else { continue };
        // Of two as long the one on the right, beside the names of frictions.
        if longest.is_none_or(|other| *end > other) {
            longest = Some(*end);
        }
        marks.push(Mark::Curve { ink: LINE.0, stroke: LINE.1, points });
    }
    let text: String = overlay.file.chars().take(LETTERS).collect();
    marks.extend(longest.map(|at| Mark::Foot { at, text }));
    marks
}

/// What the line is called.
pub(super) fn keys(plan: &Plan, operations: &[&str], dimension: &str) -> Option<Key> {
    let overlay = plan.overlay.as_ref()?;
    let mut drawn = operations.iter().flat_map(|of| first_model(plan, of, dimension));
    drawn.next()?;
    let name = format!("another program: {}", overlay.file);
    Some(Key { name, sample: Sample::Line(LINE.0, LINE.1) })
}

/// Rows of an operation once, down the hole.
fn first_model<'a>(
    plan: &'a Plan,
    operation: &'a str,
    dimension: &'a str,
) -> impl Iterator<Item = &'a PlanOverlayRow> {
    let rows = plan.overlay.iter().flat_map(|of| &of.rows);
    rows.filter(move |of| {
        plan.models.first() == Some(&of.model)
            && of.operation == operation
            && of.dimension() == dimension
    })
}

/// What is said of the lines below the picture of hook loads, or of torques.
pub(super) fn caption(plan: &Plan, is_torque: bool) -> String {
    let Some(overlay) = &plan.overlay else { return String::new() };
    let block = match is_torque {
        true => "",
        false => "; hook loads that hold the block's weight lie to the right by it",
    };
    let file = &overlay.file;
    format!(
        " Grey, long dashes: what another program computed, of {file}, as it stands there{block}."
    )
}

/// Of each operation how far ours lies from theirs.
pub(super) fn table(plan: &Plan, shown: Shown<'_>) -> Option<StudyPart> {
    let overlay = plan.overlay.as_ref()?;
    let heads = vec![
        head("operation", true),
        head("model", true),
        head("of", true),
        head("depths", false),
        head("mean difference", false),
        head("largest", false),
        head(format!("at bit depth, {}", shown.symbol("length")), false),
        head("theirs there", false),
        head("largest of theirs, %", false),
    ];
    let rows = overlay.differences.iter().map(|of| {
        let dimension = if of.is_torque { "torque" } else { "force" };
        let number = |value: f64| four(shown.value(value, dimension));
        row(vec![
            operation_name(&of.operation),
            of.model.clone(),
            format!(
                "{}, {}",
                if of.is_torque { "torque" } else { "hook load" },
                shown.symbol(dimension)
            ),
            of.count.to_string(),
            number(of.mean),
            number(of.largest),
            format!("{:.0}", shown.value(of.largest_at_m, "length")),
            number(of.theirs_there),
            of.largest_part.map_or_else(
                || "–".to_owned(),
                |part| format!("{:.1}", 100.0 * part).replace('-', "\u{2212}"),
            ),
        ])
    });
    let rows: Vec<Vec<(String, Verdict)>> = rows.collect();
    Some(StudyPart::Table {
        title: "Beside another program".into(),
        caption: format!(
            "Ours less theirs, of {}, at their depths: ours with the friction that is expected, on a straight line \
             between the depths of the plan, hook loads without the block.",
            overlay.file
        ),
        grid: Grid { heads, rows },
        files: "plan_overlay".into(),
        endings: &["csv", "parquet"],
    })
}
