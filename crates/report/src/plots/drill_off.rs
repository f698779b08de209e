//! What the bit takes away for what it is given: rate of penetration and torque against weight.

use super::{
    catalogue::{DrillOffPlot, drill_off_plots},
    run::{Drawn, Plot},
};
use crate::{
    DrillOff, Packed,
    figure::{Axis, Ink, Layout, Mark, Panel, Range, Shape},
};

/// Points of each run: more would hide each other.
const MAX: usize = 400;

/// The samples of the window, of two runs in two colours.
pub(super) fn plots(drawn: Drawn<'_>) -> Vec<Plot> {
    let shown = drawn.shown;
    let drilled: Vec<(usize, &DrillOff)> = drawn
        .timed()
        .filter_map(|(place, timed)| Some((place, timed.drill_off.as_ref()?)))
        .collect();
    if drilled.is_empty() {
        return Vec::new();
    }
    let [weight, others @ ..] = drill_off_plots();
    let axis = |of: &DrillOffPlot| {
        Axis::new(shown.label(&of.shows.title, of.shows.dimension), Range::Near)
    };
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
        Panel::new(axis(of), drilled.iter().map(points).collect())
    };
    let panels = others.iter().map(panel).collect();
    vec![
        drawn
            .plot("drill-off", drawn.figure(Layout::across(2, 180.0, 65.0), axis(&weight), panels)),
    ]
}
