//! Growth of steady rotation into stick-slip, over rotary speed and weight on bit.

use super::StabilityPicture;
use crate::{
    PageHead,
    figure::{Axis, Figure, Hue, Ink, Key, Layout, Map, Mark, Panel, Range, Sample, Shape, Stroke},
    plots::DisplayUnits,
};

/// Columns and rows with which the map is refined between those that were computed.
const FINE: usize = 8;

/// The map in a set of units (`si`, `metric` or `field`): growth in colours where it is unstable,
/// the threshold, and the case's own speed and weight.
pub(crate) fn stability_figure(picture: &StabilityPicture, head: &PageHead, units: &str) -> Figure {
    let display = DisplayUnits::new(&head.dimensions, units);
    let speed = |si: f64| display.value(si, "rotary speed");
    let weight = |si: f64| display.value(si, "force");
    let speeds = finer(&picture.speeds_rad_per_s);
    let weights = finer(&picture.weights_N);
    let values: Vec<f64> = speeds
        .iter()
        .flat_map(|s| weights.iter().map(move |w| picture.growth_at(*s, *w)))
        .map(|growth| if growth > 0.0 { growth } else { f64::NAN })
        .collect();
    let largest = values.iter().copied().filter(|value| value.is_finite()).fold(0.0, f64::max);
    let ends: Vec<f64> = speeds.windows(2).map(|pair| speed(0.5 * (pair[0] + pair[1]))).collect();
    let [first, last] = ends_of(&picture.speeds_rad_per_s).map(speed);
    let mut marks = Vec::new();
    let mut keys = Vec::new();
    if largest > 0.0 {
        marks.push(Mark::Map(Map {
            from: first,
            ends: ends.into_iter().chain([last]).collect(),
            middles: weights.iter().map(|w| weight(*w)).collect(),
            values,
            hue: Hue::Amount,
            largest,
            label: "Growth rate of the fastest growing motion, 1/s".into(),
            sides: None,
        }));
    }
    let line: Vec<(f64, f64)> = picture
        .thresholds_rad_per_s
        .iter()
        .zip(&picture.weights_N)
        .map(|(s, w)| (speed(*s), weight(*w)))
        .collect();
    if line.iter().any(|(s, _)| s.is_finite()) {
        marks.push(Mark::Curve { ink: Ink::Text, stroke: Stroke::Solid, points: line });
        keys.push(Key {
            name: "threshold: stable at all higher speeds".into(),
            sample: Sample::Line(Ink::Text, Stroke::Solid),
        });
    }
    let own = (speed(picture.own[0]), weight(picture.own[1]));
    marks.push(Mark::Points { ink: Ink::Error, shape: Shape::Diamond, points: vec![own] });
    keys.push(Key { name: "the case".into(), sample: Sample::Point(Ink::Error, Shape::Diamond) });
    let axis = |name: &str, dimension: &str, [from, to]: [f64; 2]| {
        Axis::new(display.label(name, dimension), Range::Fixed(from, to))
    };
    let rows = ends_of(&picture.weights_N).map(weight);
    let including = |[from, to]: [f64; 2], own: f64| [from.min(own), to.max(own)];
    Figure {
        title: head.title.clone(),
        subtitle: if largest > 0.0 {
            "torsional stability: coloured where steady rotation grows into stick-slip".into()
        } else {
            "torsional stability: stable at all these speeds and weights".into()
        },
        keys,
        layout: Layout::across(1, 140.0, 85.0),
        shared: axis("Rotary speed", "rotary speed", including([first, last], own.0)),
        panels: vec![Panel::new(axis("Weight on bit", "force", including(rows, own.1)), marks)],
        hole: Vec::new(),
    }
}

impl StabilityPicture {
    /// Growth between the points of the map.
    fn growth_at(&self, speed: f64, weight: f64) -> f64 {
        let [(i, right), (j, up)] =
            [place(&self.speeds_rad_per_s, speed), place(&self.weights_N, weight)];
        let columns = self.speeds_rad_per_s.len();
        let at = |row: usize, column: usize| {
            let rows = self.weights_N.len();
            let (row, column) =
                (row.min(rows.saturating_sub(1)), column.min(columns.saturating_sub(1)));
            self.growth_per_s.get(row * columns + column).copied().unwrap_or(f64::NAN)
        };
        let row = |j: usize| at(j, i) + right * (at(j, i + 1) - at(j, i));
        row(j) + up * (row(j + 1) - row(j))
    }
}

/// Position of a value among increasing ones: the index before it, and the part of the way to the
/// next.
fn place(values: &[f64], at: f64) -> (usize, f64) {
    let after = values.partition_point(|value| *value <= at).saturating_sub(1);
    let Some(next) = values.get(after + 1) else {
        return (after, 0.0);
    };
    (after, ((at - values[after]) / (next - values[after])).clamp(0.0, 1.0))
}

/// The same values with others between.
fn finer(values: &[f64]) -> Vec<f64> {
    let between = |pair: &[f64]| -> Vec<f64> {
        (0..FINE).map(|i| pair[0] + (pair[1] - pair[0]) * i as f64 / FINE as f64).collect()
    };
    values.windows(2).flat_map(between).chain(values.last().copied()).collect()
}

/// The first and the last.
fn ends_of(values: &[f64]) -> [f64; 2] {
    [values.first(), values.last()].map(|value| value.copied().unwrap_or(f64::NAN))
}
