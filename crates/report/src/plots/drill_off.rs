//! What the bit takes away for what it is given: rate of penetration and torque against weight.

use super::{
    catalogue::{DrillOffPlot, drill_off_plots},
    histories::run_keys,
    run::{Plot, Run, timed, title},
    shown::Shown,
};
use crate::{
    DrillOff, Packed,
    figure::{Axis, Direction, Figure, Ink, Layout, Mark, Panel, Range, Shape},
};

/// Points of each run: more would hide each other.
const MAX: usize = 400;

/// The samples of the window, of two runs in two colours.
pub(super) fn plots(
    runs: &[Run<'_>],
    operation: &str,
    shown: Shown<'_>,
    subtitle: &str,
    suffix: &str,
) -> Vec<Plot> {
    let drilled: Vec<(usize, &DrillOff)> = timed(runs, operation)
        .filter_map(|(place, timed)| Some((place, timed.drill_off.as_ref()?)))
        .collect();
    if drilled.is_empty() {
        return Vec::new();
    }
    let [weight, others @ ..] = drill_off_plots();
    let panel = |of: &DrillOffPlot| {
        let points = |(place, drilled): &(usize, &DrillOff)| {
            let values = |of: &DrillOffPlot| {
                let values = drilled.columns.get(of.shows.column).map(Packed::values);
                shown.values(&values.unwrap_or_default(), of.shows.dimension)
            };
            let points = values(&weight).into_iter().zip(values(of));
            let step = points.len().div_ceil(MAX).max(1);
            Mark::Points {
                ink: Ink::Line(*place),
                shape: Shape::Circle,
                points: points.step_by(step).collect(),
            }
        };
        Panel {
            axis: Axis::new(shown.label(&of.shows.title, of.shows.dimension), Range::Near),
            marks: drilled.iter().map(points).collect(),
            keys: Vec::new(),
        }
    };
    let figure = Figure {
        title: title(runs),
        subtitle: subtitle.to_owned(),
        keys: run_keys(runs),
        layout: Layout {
            direction: Direction::Across,
            columns: 2,
            width_mm: 180.0,
            panel_mm: 65.0,
        },
        shared: Axis::new(shown.label(&weight.shows.title, weight.shows.dimension), Range::Near),
        panels: others.iter().map(panel).collect(),
        hole: Vec::new(),
    };
    vec![Plot { name: format!("drill-off{suffix}"), figure }]
}
