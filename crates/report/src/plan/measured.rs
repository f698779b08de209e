//! What was measured, on the broomsticks and in a table.

use super::{Plan, PlanMeasured};
use crate::operation_words::{colour, four, operation_name};
use crate::{
    Grid, StudyPart, Verdict,
    figure::{Ink, Key, Mark, Sample, Shape},
    grid_cells::{head, row},
    plots::Shown,
};

/// The shape of what was measured: no other model's points have it.
const SHAPE: Shape = Shape::Diamond;

/// What was read of some operations: filled in their colours, or grey where it is held out.
pub(super) fn marks(
    plan: &Plan,
    shown: Shown<'_>,
    operations: &[&str],
    dimension: &str,
) -> Vec<Mark> {
    let of_operation = |name: &str, held_out: bool| {
        let rows = first_model(plan).filter(|of| of.operation == name && of.held_out == held_out);
        let rows = rows.filter(|of| of.dimension() == dimension);
        let place = |of: &PlanMeasured| {
            let value = shown.value(of.measured - of.block_N, dimension);
            (shown.value(of.bit_depth_m, "length"), value)
        };
        rows.map(place).collect::<Vec<_>>()
    };
    let mut marks = Vec::new();
    for operation in operations {
        for (held_out, ink) in [(true, Ink::Note), (false, Ink::Line(colour(operation)))] {
            let points = of_operation(operation, held_out);
            if !points.is_empty() {
                marks.push(Mark::Points { ink, shape: SHAPE, points });
            }
        }
    }
    marks
}

/// What the points are called.
pub(super) fn keys(plan: &Plan, operations: &[&str], dimension: &str) -> Vec<Key> {
    let key = |held_out: bool, name: &str, ink: Ink| {
        let is = |of: &PlanMeasured| {
            of.held_out == held_out
                && of.dimension() == dimension
                && operations.contains(&of.operation.as_str())
        };
        first_model(plan)
            .any(is)
            .then(|| Key { name: name.to_owned(), sample: Sample::Point(ink, SHAPE) })
    };
    let used = operations.first().map_or(Ink::Note, |of| Ink::Line(colour(of)));
    [key(false, "measured", used), key(true, "measured, held out", Ink::Note)]
        .into_iter()
        .flatten()
        .collect()
}

/// Every reading once.
fn first_model(plan: &Plan) -> impl Iterator<Item = &PlanMeasured> {
    plan.measured.iter().filter(|of| plan.models.first() == Some(&of.model))
}

/// Every reading beside its predictions.
pub(super) fn table(plan: &Plan, shown: Shown<'_>) -> Option<StudyPart> {
    if plan.measured.is_empty() {
        return None;
    }
    let mut heads = vec![
        head("operation", true),
        head(format!("bit depth, {}", shown.symbol("length")), false),
        head("place", true),
        head("model", true),
        head("of", true),
        head("measured", false),
    ];
    heads.extend(["low friction", "expected", "high", "residual"].map(|of| head(of, false)));
    heads.push(head("between", true));
    let rows = plan.measured.iter().map(|of| {
        let dimension = of.dimension();
        let number = |value: f64| four(shown.value(value, dimension));
        let weight = if of.block_N > 0.0 { "weight with block" } else { "weight" };
        let kind = if of.is_torque { "torque" } else { weight };
        let mut cells = vec![
            operation_name(&of.operation),
            format!("{:.0}", shown.value(of.bit_depth_m, "length")),
            match of.held_out {
                true => format!("{}, held out", of.place),
                false => of.place.clone(),
            },
            of.model.clone(),
            format!("{kind}, {}", shown.symbol(dimension)),
            number(of.measured),
        ];
        cells.extend(of.predicted.map(number));
        cells.push(number(of.measured - of.predicted[1]));
        let mut cells = row(cells);
        cells.push(match (of.between, &of.message) {
            (Some(true), _) => ("yes".to_owned(), Verdict::Agrees),
            (Some(false), _) => ("no".to_owned(), Verdict::Differs),
            (None, Some(_)) => ("no answer".to_owned(), Verdict::None),
            (None, None) => ("–".to_owned(), Verdict::None),
        });
        cells
    });
    Some(StudyPart::Table {
        title: "Measured".into(),
        caption: "What was read, beside what low, expected and high friction make of the string and the mud that \
                  were in the hole. A dash stands where friction does not move it."
            .into(),
        grid: Grid { heads, rows: rows.collect() },
        files: "plan_measured".into(),
        endings: &["csv", "parquet"],
    })
}
