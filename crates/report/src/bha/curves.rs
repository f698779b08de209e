//! Curves of an assembly: bending moment and stress along it, and side force and tilt of the bit
//! against the varied quantity.

use wholestring_results::BhaFound;
use wholestring_units::significant;

use super::{Bha, nodes::Varied};
use crate::{
    figure::{Axis, Figure, Ink, Key, Layout, Mark, Panel, Range, Sample, Shape, Stroke},
    plots::DisplayUnits,
};

/// A curve along the assembly: its place among the colours, its stroke, its name and its values.
type Curve<'a> = (usize, Stroke, &'static str, &'a [f64]);

pub(super) fn bending_figure(bha: &Bha, display: DisplayUnits<'_>) -> Figure {
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

// Side force and tilt of the bit against the varied quantity.

pub(super) fn sweeps_figure(bha: &Bha, varied: &Varied<'_>, display: DisplayUnits<'_>) -> Figure {
    let at = |value: f64| display.value(value, varied.dimension);
    let panel = |title: &str, dimension: &str, pair: fn(&BhaFound) -> [f64; 2]| {
        let mut marks = Vec::new();
        for (side, stroke) in [(0, Stroke::Solid), (1, Stroke::Dashed)] {
            let points: Vec<(f64, f64)> = varied
                .points
                .iter()
                .map(|(value, found)| (at(*value), display.value(pair(found)[side], dimension)))
                .collect();
            let ink = Ink::Line(side);
            marks.push(Mark::Curve { ink, stroke, points: points.clone() });
            marks.push(Mark::Points { ink, shape: Shape::of(side), points });
        }
        if let Some(now) = varied.now {
            marks.push(Mark::SharedRule { at: at(now), label: String::new() });
        }
        Panel::new(Axis::new(display.label(title, dimension), Range::Zero), marks)
    };
    let mut force = panel("Side force of the bit", "force", |found| found.side_force_N);
    let key = |name: &str, sample| Key { name: name.into(), sample };
    let marked = |side: usize, stroke| Sample::Marked(Ink::Line(side), stroke, Shape::of(side));
    let mut keys = vec![
        key("high side: builds", marked(0, Stroke::Solid)),
        key("right: turns right", marked(1, Stroke::Dashed)),
    ];
    if !varied.zeros.is_empty() {
        let points = varied.zeros.iter().map(|zero| (at(*zero), 0.0)).collect();
        let (ink, shape) = (Ink::Text, Shape::Diamond);
        force.marks.push(Mark::Points { ink, shape, points });
        let places: Vec<String> =
            varied.zeros.iter().map(|zero| three(display, *zero, varied.dimension)).collect();
        keys.push(key(&format!("holds at {}", places.join(", ")), Sample::Point(ink, shape)));
    }
    if let Some(now) = varied.now {
        let name = format!("the case: {}", three(display, now, varied.dimension));
        keys.push(key(&name, Sample::Line(Ink::Note, Stroke::Dashed)));
    }
    Figure {
        title: bha.head.title.clone(),
        subtitle: conditions(bha, display),
        keys,
        layout: Layout::across(2, 180.0, 62.0),
        shared: Axis::new(display.label(varied.title, varied.dimension), Range::Tight),
        panels: vec![force, panel("Tilt of the bit", "angle", |found| found.tilt_rad)],
        hole: Vec::new(),
    }
}

// Common parts of the pictures of an assembly.

/// Distance from the bit up to which a picture along the assembly extends, m: a little above its
/// collars, below the jointed pipe, where it has any; its end otherwise.
pub(super) fn shown_to_m(bha: &Bha) -> f64 {
    const ABOVE: f64 = 1.1;
    let solved_m = bha.nodes.from_bit_m.last().copied().unwrap_or(0.0);
    let length_m = bha.summary.state.length_m;
    let mut parts = bha.summary.parts.iter();
    let jointed = parts.find(|part| part.joint_od_m.is_some()).map(|part| part.from_bit_m);
    let collars_m = jointed.filter(|from_m| *from_m > 0.0).unwrap_or(length_m);
    (ABOVE * collars_m.min(length_m)).min(solved_m)
}

/// A quantity in three digits, with its unit.
pub(super) fn three(display: DisplayUnits<'_>, si: f64, dimension: &str) -> String {
    let number = significant(display.value(si, dimension), 3).to_string().replace('-', "\u{2212}");
    format!("{number} {}", display.symbol(dimension)).trim_end().to_owned()
}

/// The facts of the head, on one line.
pub(super) fn conditions(bha: &Bha, display: DisplayUnits<'_>) -> String {
    let facts = bha.head.facts.iter().take(5);
    facts.filter_map(|fact| display.fact(fact)).collect::<Vec<_>>().join("; ")
}
