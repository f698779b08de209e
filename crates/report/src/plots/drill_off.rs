//! Response of the bit to its weight: rate of penetration and torque against weight.

use super::{
    catalogue::{DrillOffPlot, drill_off_plots},
    run::{Context, Plot},
};
use std::collections::BTreeMap;

use crate::{
    Packed,
    figure::{Axis, Ink, Layout, Mark, Panel, Range, Shape},
};

/// Largest number of points of each run, because more would hide each other.
const MAX: usize = 400;

/// The samples of the window, of two runs in two colours.
pub(super) fn plots(context: Context<'_>) -> Vec<Plot> {
    let display = context.display;
    let drilled: Vec<(usize, &BTreeMap<String, Packed>)> = context
        .timed()
        .filter_map(|(place, timed)| Some((place, timed.drill_off.as_ref()?)))
        .collect();
    if drilled.is_empty() {
        return Vec::new();
    }
    let [weight, others @ ..] = drill_off_plots();
    let axis = |plot: &DrillOffPlot| {
        Axis::new(display.label(&plot.shows.title, plot.shows.dimension), Range::Near)
    };
    let panel = |plot: &DrillOffPlot| {
        let points = |(place, drilled): &(usize, &BTreeMap<String, Packed>)| {
            let values = |plot: &DrillOffPlot| {
                let values = drilled.get(plot.shows.column).map(Packed::values);
                display.values(&values.unwrap_or_default(), plot.shows.dimension)
            };
            let points = values(&weight).into_iter().zip(values(plot));
            let step = points.len().div_ceil(MAX).max(1);
            Mark::Points {
                ink: Ink::Line(*place),
                shape: Shape::Circle,
                points: points.step_by(step).collect(),
            }
        };
        Panel::new(axis(plot), drilled.iter().map(points).collect())
    };
    let panels = others.iter().map(panel).collect();
    vec![
        context.plot(
            "drill-off",
            context.figure(Layout::across(2, 180.0, 65.0), axis(&weight), panels),
        ),
    ]
}
