//! What the bit takes away for what it is given: rate of penetration and torque against weight.

use super::{
    histories::run_keys,
    run::{Plot, Run, timed, title},
    shown::Shown,
};
use crate::{
    DrillOff,
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
    let panel = |title: &str, dimension: &str, values: &dyn Fn(&DrillOff) -> Vec<f64>| {
        let points = |(place, drilled): &(usize, &DrillOff)| {
            let weights = shown.values(&drilled.weight_N.values(), "force");
            let points = weights.into_iter().zip(shown.values(&values(drilled), dimension));
            let step = points.len().div_ceil(MAX).max(1);
            Mark::Points {
                ink: Ink::Line(*place),
                shape: Shape::Circle,
                points: points.step_by(step).collect(),
            }
        };
        Panel {
            axis: Axis::new(shown.label(title, dimension), Range::Near),
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
        shared: Axis::new(shown.label("Weight on bit", "force"), Range::Near),
        panels: vec![
            panel("Rate of penetration", "rate of penetration", &|of| of.rate_m_per_s.values()),
            panel("Torque on bit", "torque", &|of| of.torque_N_m.values()),
        ],
        hole: Vec::new(),
    };
    vec![Plot { name: format!("drill-off{suffix}"), figure }]
}
