//! A quantity of a sweep against the varied key.

use super::{
    Drawn, SweepRow,
    drawing::{Drawing, judged},
};
use crate::figure::{Axis, Mark, Panel, Range};

impl Drawing<'_> {
    /// The panel of a scalar; `None` where no case has it.
    pub(super) fn panel(&self, plot: &Drawn) -> Option<Panel> {
        let dimension = plot.dimension();
        let value = |row: &SweepRow, end: &str| {
            let value = row.numbers.get(&format!("{}{end}", plot.scalar.quantity.name)).copied();
            self.display.value(value.unwrap_or(f64::NAN), dimension)
        };
        let (mut bands, mut curves, mut points) = (Vec::new(), Vec::new(), Vec::new());
        let mut names: Vec<(String, (f64, f64))> = Vec::new();
        for (place, family) in self.families.iter().enumerate() {
            let solved = self.operations.iter().enumerate();
            let solved = solved.flat_map(|solved| {
                let models = self.models.iter().enumerate();
                models.map(move |model| (solved, model))
            });
            for ((done, operation), (model, method)) in solved {
                let (ink, shape) = self.style(place, done);
                let mine = |row: &SweepRow| {
                    let values = self.others.iter().map(|key| row.values[*key].as_str());
                    row.model.is_some_and(|model| model.method() == *method)
                        && row.operation == Some(*operation)
                        && values.eq(family.iter().copied())
                };
                let mut rows: Vec<(f64, usize, &SweepRow)> = self
                    .sweep
                    .rows
                    .iter()
                    .enumerate()
                    .filter(|(_, row)| mine(row))
                    .map(|(place, row)| (self.along(row), place, row))
                    .collect();
                rows.sort_by(|a, b| a.0.total_cmp(&b.0));
                let column = |end: &str| -> Vec<(f64, f64)> {
                    rows.iter().map(|(at, _, row)| (*at, value(row, end))).collect()
                };
                let mean = column("");
                if !mean.iter().any(|(_, value)| value.is_finite()) {
                    continue;
                }
                let keys = self.keys_of(place, model, done);
                for marks in [&mut bands, &mut curves, &mut points] {
                    marks.push(Mark::Of { keys: keys.clone() });
                }
                let name = self.name(place, done);
                let last = mean.iter().rev().find(|(at, value)| (at + value).is_finite());
                // Where the curves of two models coincide, one name is enough.
                let is_named = names.iter().any(|(other, _)| *other == name);
                if let (Some(end), false) = (last, name.is_empty() || is_named) {
                    curves.push(Mark::Foot { at: *end, text: name.clone() });
                    names.push((name, *end));
                }
                let mut of_band = keys;
                of_band.push(self.band_key());
                bands.push(Mark::Of { keys: of_band });
                let ends = column("_p05").into_iter().zip(column("_p95"));
                bands.push(Mark::Band {
                    ink,
                    points: ends.map(|((at, low), (_, high))| (at, low, high)).collect(),
                });
                points.push(Mark::Points { ink, shape, points: mean.clone() });
                points.push(Mark::Spots {
                    points: mean.clone(),
                    rows: rows.iter().map(|(_, place, _)| *place).collect(),
                });
                for (key, level) in self.judged().into_iter().enumerate() {
                    let of_level = rows.iter().zip(&mean);
                    let of_level = of_level.filter(|((.., row), _)| judged(row) == Some(level));
                    let ringed: Vec<_> = of_level.map(|(_, point)| *point).collect();
                    if !ringed.is_empty() {
                        let mut of_ring = self.keys_of(place, model, done);
                        of_ring.push(self.first_judged() + key);
                        points.push(Mark::Of { keys: of_ring });
                        points.push(Mark::Rings { level, points: ringed });
                    }
                }
                curves.push(Mark::Curve {
                    ink,
                    stroke: self.stroke(place, model, done),
                    points: mean,
                });
            }
        }
        let least = self.display.value(plot.min_span, dimension);
        if names.len() > 2 && coincide(names.iter().map(|(_, end)| *end), least) {
            curves.retain(|mark| !matches!(mark, Mark::Foot { .. }));
            curves.push(Mark::Of { keys: Vec::new() });
            curves.push(Mark::Foot { at: names[0].1, text: format!("all {}", names.len()) });
        }
        (!curves.is_empty()).then(|| Panel {
            axis: Axis {
                // Depth points down wherever an axis can.
                down: dimension == "length",
                min_span: self.display.value(plot.min_span, dimension),
                ..Axis::new(self.display.label(plot.scalar.label, dimension), Range::Near)
            },
            marks: [bands, curves, points].concat(),
            keys: Vec::new(),
        })
    }
}

/// Whether ends of curves cannot be distinguished on an axis with this least span, so that their
/// names would be stacked at one point.
fn coincide(ends: impl Iterator<Item = (f64, f64)> + Clone, min_span: f64) -> bool {
    const PART: f64 = 0.02;
    let span = |along: fn((f64, f64)) -> f64| {
        let values = ends.clone().map(along);
        values.clone().fold(f64::NEG_INFINITY, f64::max) - values.fold(f64::INFINITY, f64::min)
    };
    span(|end| end.0) == 0.0 && span(|end| end.1) <= PART * min_span
}
