//! Another program's curves over the broomsticks, and the differences of ours from them.

use wholestring::operation::OperationKind;
use wholestring_results::PlanOverlayRow;

use super::Plan;
use crate::{
    Grid, StudyPart, Verdict,
    cell::four,
    figure::{Ink, Key, Mark, Sample, Stroke},
    grid_cells::{head, row},
    plots::DisplayUnits,
};

/// The line of another program: no friction and no operation of this plan has it.
const LINE: (Ink, Stroke) = (Ink::Note, Stroke::LongDashed);

/// Largest number of letters of a file's name at a line.
const LETTERS: usize = 24;

/// A line for each of some operations, and the file's name at the end of the longest.
pub(super) fn marks(
    plan: &Plan,
    display: DisplayUnits<'_>,
    operations: &[OperationKind],
    dimension: &str,
) -> Vec<Mark> {
    let Some(overlay) = &plan.summary.overlay else { return Vec::new() };
    let mut marks = Vec::new();
    let mut longest: Option<(f64, f64)> = None;
    for operation in operations {
        let points: Vec<(f64, f64)> = first_model(plan, *operation, dimension)
            .map(|row| {
                (display.value(row.bit_depth_m, "length"), display.value(row.theirs, dimension))
            })
            .collect();
        let Some(end) = points.last() else { continue };
        // Of two equally long lines, the one on the right, next to the names of frictions.
        if longest.is_none_or(|other| *end > other) {
            longest = Some(*end);
        }
        marks.push(Mark::Curve { ink: LINE.0, stroke: LINE.1, points });
    }
    let text: String = overlay.file.chars().take(LETTERS).collect();
    marks.extend(longest.map(|at| Mark::Foot { at, text }));
    marks
}

/// Name of the line.
pub(super) fn keys(plan: &Plan, operations: &[OperationKind], dimension: &str) -> Option<Key> {
    let overlay = plan.summary.overlay.as_ref()?;
    let mut rows = operations.iter().flat_map(|operation| first_model(plan, *operation, dimension));
    rows.next()?;
    let name = format!("another program: {}", overlay.file);
    Some(Key { name, sample: Sample::Line(LINE.0, LINE.1) })
}

/// Rows of an operation once, down the hole.
fn first_model<'a>(
    plan: &'a Plan,
    operation: OperationKind,
    dimension: &'a str,
) -> impl Iterator<Item = &'a PlanOverlayRow> {
    let rows = plan.summary.overlay.iter().flat_map(|overlay| &overlay.rows);
    rows.filter(move |row| {
        plan.summary.models.first() == Some(&row.model)
            && row.operation == operation
            && (if row.is_torque { "torque" } else { "force" }) == dimension
    })
}

/// Description of the lines below the picture of hook loads, or of torques.
pub(super) fn caption(plan: &Plan, is_torque: bool) -> String {
    let Some(overlay) = &plan.summary.overlay else { return String::new() };
    let block = match is_torque {
        true => "",
        false => "; hook loads that include the block's weight are to the right by it",
    };
    let file = &overlay.file;
    format!(" Grey, long dashes: another program's values, from {file}, unchanged{block}.")
}

/// The differences of our curves from theirs in each operation.
pub(super) fn table(plan: &Plan, display: DisplayUnits<'_>) -> Option<StudyPart> {
    let overlay = plan.summary.overlay.as_ref()?;
    let heads = vec![
        head("operation", true),
        head("model", true),
        head("of", true),
        head("depths", false),
        head("mean difference", false),
        head("largest", false),
        head(format!("at bit depth, {}", display.symbol("length")), false),
        head("theirs at that depth", false),
        head("largest of theirs, %", false),
    ];
    let rows = overlay.differences.iter().map(|difference| {
        let dimension = if difference.is_torque { "torque" } else { "force" };
        let number = |value: f64| four(display.value(value, dimension));
        row(vec![
            difference.operation.words().to_owned(),
            difference.model.name().to_owned(),
            format!(
                "{}, {}",
                if difference.is_torque { "torque" } else { "hook load" },
                display.symbol(dimension)
            ),
            difference.count.to_string(),
            number(difference.mean),
            number(difference.largest),
            format!("{:.0}", display.value(difference.largest_at_m, "length")),
            number(difference.theirs_there),
            difference.largest_part.map_or_else(
                || "–".to_owned(),
                |part| format!("{:.1}", 100.0 * part).replace('-', "\u{2212}"),
            ),
        ])
    });
    let rows: Vec<Vec<(String, Verdict)>> = rows.collect();
    Some(StudyPart::Table {
        title: "Comparison with another program".into(),
        caption: format!(
            "Ours less theirs, from {}, at their depths: ours with the expected friction, \
             interpolated linearly between the depths of the plan, hook loads without the block.",
            overlay.file
        ),
        grid: Grid { heads, rows },
        files: "plan_overlay".into(),
        endings: &["csv", "parquet"],
    })
}
