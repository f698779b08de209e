//! Bending moment and stress along the assembly.

use super::{
    Bha,
    shared::{conditions, shown_to_m},
};
use crate::{
    figure::{Axis, Figure, Ink, Key, Layout, Mark, Panel, Range, Sample, Stroke},
    plots::DisplayUnits,
};

/// A curve along the assembly: its place among the colours, its stroke, its name and its values.
type Curve<'a> = (usize, Stroke, &'static str, &'a [f64]);

pub(super) fn figure(bha: &Bha, display: DisplayUnits<'_>) -> Figure {
    let to_m = shown_to_m(bha);
    let nodes = &bha.nodes;
    let size: Vec<f64> =
        nodes.moment_N_m[0].iter().zip(&nodes.moment_N_m[1]).map(|(a, b)| a.hypot(*b)).collect();
    let panel = |title: &str, dimension: &str, curves: &[Curve<'_>]| {
        let marks = curves.iter().map(|(place, stroke, _, values)| {
            let shown = nodes.from_bit_m.iter().zip(*values).filter(|(at, _)| **at <= to_m);
            let points = shown
                .map(|(at, value)| (display.value(*at, "length"), display.value(*value, dimension)))
                .collect();
            Mark::Curve { ink: Ink::Line(*place), stroke: *stroke, points }
        });
        let mut marks: Vec<Mark> = marks.collect();
        for at_m in bha.sensors_m() {
            let at = display.value(at_m, "length");
            marks.push(Mark::SharedRule { at, label: String::new() });
        }
        let mut panel = Panel::new(Axis::new(display.label(title, dimension), Range::Zero), marks);
        panel.keys = curves
            .iter()
            .map(|(place, stroke, name, _)| Key {
                name: (*name).into(),
                sample: Sample::Line(Ink::Line(*place), *stroke),
            })
            .collect();
        panel
    };
    let moments: [Curve<'_>; 3] = [
        (0, Stroke::Solid, "size", &size),
        (1, Stroke::Dashed, "to the high side", &nodes.moment_N_m[0]),
        (2, Stroke::ShortDashed, "to the right", &nodes.moment_N_m[1]),
    ];
    let stresses: [Curve<'_>; 2] = [
        (0, Stroke::Solid, "von Mises", &nodes.von_mises_stress_Pa),
        (1, Stroke::Dashed, "bending", &nodes.bending_stress_Pa),
    ];
    let to = display.value(to_m, "length");
    Figure {
        title: bha.head.title.clone(),
        subtitle: conditions(bha, display),
        keys: Vec::new(),
        layout: Layout::across(1, 180.0, 46.0),
        shared: Axis::new(display.label("Distance from the bit", "length"), Range::Fixed(0.0, to)),
        panels: vec![
            panel("Bending moment", "torque", &moments),
            panel("Stress", "stress", &stresses),
        ],
        hole: Vec::new(),
    }
}
