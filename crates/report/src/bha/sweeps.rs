//! Side force and tilt of the bit against the varied quantity.

use wholestring_results::BhaFound;

use super::{
    Bha,
    shared::{conditions, three},
    varied::Varied,
};
use crate::{
    figure::{Axis, Figure, Ink, Key, Layout, Mark, Panel, Range, Sample, Shape, Stroke},
    plots::DisplayUnits,
};

pub(super) fn figure(bha: &Bha, varied: &Varied<'_>, display: DisplayUnits<'_>) -> Figure {
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
