//! Side force and tilt of the bit against what was varied.

use super::{
    Bha, BhaSweep, BhaSweepPoint,
    shared::{conditions, three},
};
use crate::{
    figure::{Axis, Figure, Ink, Key, Layout, Mark, Panel, Range, Sample, Shape, Stroke},
    plots::Shown,
};

pub(super) fn figure(bha: &Bha, of: &BhaSweep, shown: Shown<'_>) -> Figure {
    let at = |value: f64| shown.value(value, &of.dimension);
    let panel = |title: &str, dimension: &str, pair: fn(&BhaSweepPoint) -> [f64; 2]| {
        let mut marks = Vec::new();
        for (side, stroke) in [(0, Stroke::Solid), (1, Stroke::Dashed)] {
            let points: Vec<(f64, f64)> = of
                .points
                .iter()
                .map(|point| (at(point.value), shown.value(pair(point)[side], dimension)))
                .collect();
            let ink = Ink::Line(side);
            marks.push(Mark::Curve { ink, stroke, points: points.clone() });
            marks.push(Mark::Points { ink, shape: Shape::of(side), points });
        }
        if let Some(now) = of.now {
            marks.push(Mark::SharedRule { at: at(now), label: String::new() });
        }
        Panel::new(Axis::new(shown.label(title, dimension), Range::Zero), marks)
    };
    let mut force = panel("Side force of the bit", "force", |point| point.side_force_N);
    let key = |name: &str, sample| Key { name: name.into(), sample };
    let marked = |side: usize, stroke| Sample::Marked(Ink::Line(side), stroke, Shape::of(side));
    let mut keys = vec![
        key("high side: builds", marked(0, Stroke::Solid)),
        key("right: turns right", marked(1, Stroke::Dashed)),
    ];
    if !of.zeros.is_empty() {
        let points = of.zeros.iter().map(|zero| (at(*zero), 0.0)).collect();
        let (ink, shape) = (Ink::Text, Shape::Diamond);
        force.marks.push(Mark::Points { ink, shape, points });
        let places: Vec<String> =
            of.zeros.iter().map(|zero| three(shown, *zero, &of.dimension)).collect();
        keys.push(key(&format!("holds at {}", places.join(", ")), Sample::Point(ink, shape)));
    }
    if let Some(now) = of.now {
        let name = format!("the case: {}", three(shown, now, &of.dimension));
        keys.push(key(&name, Sample::Line(Ink::Note, Stroke::Dashed)));
    }
    Figure {
        title: bha.head.title.clone(),
        subtitle: conditions(bha, shown),
        keys,
        layout: Layout::across(2, 180.0, 62.0),
        shared: Axis::new(shown.label(&of.title, &of.dimension), Range::Tight),
        panels: vec![force, panel("Tilt of the bit", "angle", |point| point.tilt_rad)],
        hole: Vec::new(),
    }
}
