//! Measured readings, on the broomsticks and in a table.

use wholestring::operation::OperationKind;
use wholestring_results::PlanMeasured;

use super::Plan;
use crate::{
    Grid, StudyPart, Verdict,
    cell::four,
    draw::palette::operation_colour,
    figure::{Ink, Key, Mark, Sample, Shape},
    grid_cells::{head, row},
    plots::DisplayUnits,
};

/// The shape of measured points: no other model's points have it.
const SHAPE: Shape = Shape::Diamond;

/// Dimension of a reading.
fn dimension_of(measured: &PlanMeasured) -> &'static str {
    if measured.is_torque { "torque" } else { "force" }
}

/// Readings of some operations: filled in their colours, or grey where they are held out.
pub(super) fn marks(
    plan: &Plan,
    display: DisplayUnits<'_>,
    operations: &[OperationKind],
    dimension: &str,
) -> Vec<Mark> {
    let of_operation = |operation: OperationKind, held_out: bool| {
        let rows =
            first_model(plan).filter(|row| row.operation == operation && row.held_out == held_out);
        let rows = rows.filter(|row| dimension_of(row) == dimension);
        let place = |measured: &PlanMeasured| {
            let value = display.value(measured.beside_curves(), dimension);
            (display.value(measured.bit_depth_m, "length"), value)
        };
        rows.map(place).collect::<Vec<_>>()
    };
    let mut marks = Vec::new();
    for operation in operations {
        for (held_out, ink) in [(true, Ink::Note), (false, Ink::Line(operation_colour(*operation)))]
        {
            let points = of_operation(*operation, held_out);
            if !points.is_empty() {
                marks.push(Mark::Points { ink, shape: SHAPE, points });
            }
        }
    }
    marks
}

/// Names of the points.
pub(super) fn keys(plan: &Plan, operations: &[OperationKind], dimension: &str) -> Vec<Key> {
    let key = |held_out: bool, name: &str, ink: Ink| {
        let is = |measured: &PlanMeasured| {
            measured.held_out == held_out
                && dimension_of(measured) == dimension
                && operations.contains(&measured.operation)
        };
        first_model(plan)
            .any(is)
            .then(|| Key { name: name.to_owned(), sample: Sample::Point(ink, SHAPE) })
    };
    let used =
        operations.first().map_or(Ink::Note, |operation| Ink::Line(operation_colour(*operation)));
    [key(false, "measured", used), key(true, "measured, held out", Ink::Note)]
        .into_iter()
        .flatten()
        .collect()
}

/// Every reading once.
fn first_model(plan: &Plan) -> impl Iterator<Item = &PlanMeasured> {
    plan.summary
        .measured
        .iter()
        .filter(|measured| plan.summary.models.first() == Some(&measured.model))
}

/// Every reading with its predictions.
pub(super) fn table(plan: &Plan, display: DisplayUnits<'_>) -> Option<StudyPart> {
    if plan.summary.measured.is_empty() {
        return None;
    }
    let mut heads = vec![
        head("operation", true),
        head(format!("bit depth, {}", display.symbol("length")), false),
        head("place", true),
        head("model", true),
        head("of", true),
        head("measured", false),
    ];
    heads.extend(["low friction", "expected", "high", "residual"].map(|name| head(name, false)));
    heads.push(head("between", true));
    let rows = plan.summary.measured.iter().map(|measured| {
        let dimension = dimension_of(measured);
        let number = |value: f64| four(display.value(value, dimension));
        let weight = if measured.block_N > 0.0 { "weight with block" } else { "weight" };
        let kind = if measured.is_torque { "torque" } else { weight };
        let mut cells = vec![
            measured.operation.words().to_owned(),
            format!("{:.0}", display.value(measured.bit_depth_m, "length")),
            match measured.held_out {
                true => format!("{}, held out", measured.place),
                false => measured.place.clone(),
            },
            measured.model.name().to_owned(),
            format!("{kind}, {}", display.symbol(dimension)),
            number(measured.measured),
        ];
        cells.extend(measured.predicted.map(|value| number(value.unwrap_or(f64::NAN))));
        cells.push(number(measured.residual().unwrap_or(f64::NAN)));
        let mut cells = row(cells);
        cells.push(match (measured.between(), &measured.message) {
            (Some(true), _) => ("yes".to_owned(), Verdict::Agrees),
            (Some(false), _) => ("no".to_owned(), Verdict::Differs),
            (None, Some(_)) => ("no answer".to_owned(), Verdict::None),
            (None, None) => ("–".to_owned(), Verdict::None),
        });
        cells
    });
    Some(StudyPart::Table {
        title: "Measured".into(),
        caption: "Readings, and their predictions with low, expected and high friction for the \
                  string and the mud that were in the hole. A dash: friction does not change the \
                  value."
            .into(),
        grid: Grid { heads, rows: rows.collect() },
        files: "plan_measured".into(),
        endings: &["csv", "parquet"],
    })
}
