//! Side force and tilt of the bit against the varied quantity.

use super::{
    Bha, BhaSweep, BhaSweepPoint,
    shared::{conditions, three},
};
use crate::{
    figure::{Axis, Figure, Ink, Key, Layout, Mark, Panel, Range, Sample, Shape, Stroke},
    plots::DisplayUnits,
};

pub(super) fn figure(bha: &Bha, sweep: &BhaSweep, display: DisplayUnits<'_>) -> Figure {
    let at = |value: f64| display.value(value, &sweep.dimension);
    let panel = |title: &str, dimension: &str, pair: fn(&BhaSweepPoint) -> [f64; 2]| {
        let mut marks = Vec::new();
        for (side, stroke) in [(0, Stroke::Solid), (1, Stroke::Dashed)] {
            let points: Vec<(f64, f64)> = sweep
                .points
                .iter()
                .map(|point| (at(point.value), display.value(pair(point)[side], dimension)))
                .collect();
            let ink = Ink::Line(side);
            marks.push(Mark::Curve { ink, stroke, points: points.clone() });
            marks.push(Mark::Points { ink, shape: Shape::of(side), points });
        }
        if let Some(now) = sweep.now {
            marks.push(Mark::SharedRule { at: at(now), label: String::new() });
        }
        Panel::new(Axis::new(display.label(title, dimension), Range::Zero), marks)
    };
    let mut force = panel("Side force of the bit", "force", |point| point.side_force_N);
    let key = |name: &str, sample| Key { name: name.into(), sample };
    let marked = |side: usize, stroke| Sample::Marked(Ink::Line(side), stroke, Shape::of(side));
    let mut keys = vec![
        key("high side: builds", marked(0, Stroke::Solid)),
        key("right: turns right", marked(1, Stroke::Dashed)),
    ];
    if !sweep.zeros.is_empty() {
        let points = sweep.zeros.iter().map(|zero| (at(*zero), 0.0)).collect();
        let (ink, shape) = (Ink::Text, Shape::Diamond);
        force.marks.push(Mark::Points { ink, shape, points });
        let places: Vec<String> =
            sweep.zeros.iter().map(|zero| three(display, *zero, &sweep.dimension)).collect();
        keys.push(key(&format!("holds at {}", places.join(", ")), Sample::Point(ink, shape)));
    }
    if let Some(now) = sweep.now {
        let name = format!("the case: {}", three(display, now, &sweep.dimension));
        keys.push(key(&name, Sample::Line(Ink::Note, Stroke::Dashed)));
    }
    Figure {
        title: bha.head.title.clone(),
        subtitle: conditions(bha, display),
        keys,
        layout: Layout::across(2, 180.0, 62.0),
        shared: Axis::new(display.label(&sweep.title, &sweep.dimension), Range::Tight),
        panels: vec![force, panel("Tilt of the bit", "angle", |point| point.tilt_rad)],
        hole: Vec::new(),
    }
}
