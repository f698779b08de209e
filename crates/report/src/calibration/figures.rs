//! The pictures of a calibration.

use wholestring::operation::OperationKind;

use super::{Calibration, CalibrationPoint};
use crate::{
    Plot,
    figure::{
        Axis, Direction, Figure, Ink, Key, Layout, Mark, Panel, Range, Sample, Shape, Stroke,
    },
    operation_words::colour,
    plots::{Shown, named},
};

/// Readings from the left to the right, how they are said, and the operation whose colour they have: it
/// is the same on a plan's broomstick.
pub(crate) const READINGS: [(&str, &str, OperationKind); 5] = [
    ("slack_off", "slack-off", OperationKind::TripIn),
    ("rotating", "rotating", OperationKind::RotateOffBottom),
    ("pick_up", "pick-up", OperationKind::TripOut),
    ("torque", "torque off bottom", OperationKind::RotateOffBottom),
    ("torque_on_bottom", "torque on bottom", OperationKind::Drill),
];

/// Names of the pictures of a calibration: the broomstick, the residuals, the profiles.
pub const CALIBRATION_PICTURES: [&str; 3] =
    ["calibration_bands", "calibration", "calibration_profiles"];

/// The colour of the reading of this place.
fn ink(place: usize) -> Ink {
    Ink::Line(colour(READINGS[place].2.name()))
}

/// Pictures of a calibration, in these units.
pub fn calibration_plots(of: &Calibration, units: &str) -> Vec<Plot> {
    let drawing = Drawing { of, shown: Shown::new(&of.head.dimensions, units) };
    let figures = [drawing.broomstick(), drawing.residuals(), drawing.profiles()];
    named(CALIBRATION_PICTURES, figures.map(Some))
}

/// A calibration on its way to paper.
struct Drawing<'a> {
    of: &'a Calibration,
    shown: Shown<'a>,
}

fn dimension(is_torque: bool) -> &'static str {
    if is_torque { "torque" } else { "force" }
}

/// How readings are said.
pub(super) fn said(reading: &str) -> &str {
    READINGS.iter().find(|(name, ..)| *name == reading).map_or(reading, |(_, said, _)| said)
}

impl Drawing<'_> {
    fn figure(&self, shared: Axis, layout: Layout, panels: Vec<Panel>, keys: Vec<Key>) -> Figure {
        let facts = self.of.head.facts.iter().filter_map(|fact| self.shown.fact(fact));
        Figure {
            title: self.of.head.title.clone(),
            subtitle: facts.collect::<Vec<_>>().join("; "),
            keys,
            layout,
            shared,
            panels,
            hole: Vec::new(),
        }
    }

    fn depth(&self) -> Axis {
        let label = self.shown.label("Measured depth of the bit", "length");
        Axis { down: true, ..Axis::new(label, Range::Near) }
    }

    fn place(&self, of: &CalibrationPoint, value: f64) -> (f64, f64) {
        (self.shown.value(of.bit_depth_m, "length"), value)
    }

    /// Those of a name that the numbers were found from, or those that are held against them.
    fn marks_of(
        &self,
        name: &str,
        place: usize,
        value: impl Fn(&CalibrationPoint) -> f64,
    ) -> [Mark; 2] {
        [(true, ink(place)), (false, Ink::Note)].map(|(used, ink)| {
            let points = self.points_of(name).filter(|of| of.used == used);
            let points = points.map(|of| self.place(of, value(of))).collect();
            Mark::Points { ink, shape: Shape::of(place), points }
        })
    }

    fn points_of<'b>(&'b self, name: &'b str) -> impl Iterator<Item = &'b CalibrationPoint> {
        self.of.points.iter().filter(move |of| of.reading == name)
    }

    /// Whether there are readings or predictions of a name.
    fn has(&self, name: &str) -> bool {
        self.points_of(name).next().is_some() || self.of.bands.iter().any(|of| of.reading == name)
    }

    fn read(&self, torques: bool) -> Vec<(usize, &'static str, &'static str)> {
        let names = READINGS.into_iter().enumerate();
        let named = names.filter(|(_, (name, ..))| name.starts_with("torque") == torques);
        named
            .filter(|(_, (name, ..))| self.has(name))
            .map(|(place, (name, said, _))| (place, name, said))
            .collect()
    }

    fn panel_of_bands(&self, torques: bool, label: &str) -> Panel {
        let kind = dimension(torques);
        let mut marks = Vec::new();
        for (place, name, _) in self.read(torques) {
            let ink = ink(place);
            let mut cases: Vec<&str> = Vec::new();
            for band in &self.of.bands {
                if !cases.contains(&band.case.as_str()) {
                    cases.push(&band.case);
                }
            }
            for case in cases {
                let bands = self.of.bands.iter();
                let bands = bands.filter(|of| of.reading == name && of.case == case);
                let at = |of: &super::CalibrationBand| self.shown.value(of.bit_depth_m, "length");
                let band = |ends: [f64; 2]| ends.map(|end| self.shown.value(end, kind));
                let points = bands.clone().map(|of| {
                    let [from, to] = band(of.reading_band);
                    (at(of), from, to)
                });
                marks.push(Mark::Band { ink, points: points.collect() });
                let points = bands.clone().map(|of| {
                    let [from, to] = band(of.mean);
                    (at(of), from, to)
                });
                marks.push(Mark::Band { ink, points: points.collect() });
                let points = bands.map(|of| (at(of), self.shown.value(of.predicted, kind)));
                marks.push(Mark::Curve { ink, stroke: Stroke::Solid, points: points.collect() });
            }
        }
        // Above all bands.
        for (place, name, _) in self.read(torques) {
            marks.extend(self.marks_of(name, place, |of| self.shown.value(of.measured, kind)));
        }
        Panel::new(Axis::new(self.shown.label(label, kind), Range::Near), marks)
    }

    fn keys(&self, of: impl Fn(Ink, Shape) -> Sample) -> Vec<Key> {
        let mut all = self.read(false);
        all.extend(self.read(true));
        let key = |(place, _, said): (usize, &str, &str)| Key {
            name: said.to_owned(),
            sample: of(ink(place), Shape::of(place)),
        };
        let mut keys: Vec<Key> = all.into_iter().map(key).collect();
        if self.of.points.iter().any(|of| !of.used) {
            keys.push(Key { name: "held out".to_owned(), sample: of(Ink::Note, Shape::Circle) });
        }
        keys
    }

    fn layout(columns: usize) -> Layout {
        Layout { direction: Direction::Down, columns, width_mm: 180.0, panel_mm: 105.0 }
    }

    fn broomstick(&self) -> Figure {
        let panels =
            vec![self.panel_of_bands(false, "Hook load"), self.panel_of_bands(true, "Torque")];
        let keys = self.keys(|ink, shape| Sample::Marked(ink, Stroke::Solid, shape));
        self.figure(self.depth(), Self::layout(2), panels, keys)
    }

    fn residuals(&self) -> Figure {
        let beyond = self.of.outlier_beyond;
        let largest = self.of.points.iter().map(|of| of.standardised.abs()).fold(beyond, f64::max);
        let panel = |torques: bool, label: &str| {
            let mut marks = Vec::new();
            for at in [0.0, -beyond, beyond] {
                marks.push(Mark::OwnRule { at, label: String::new() });
            }
            for (place, name, _) in self.read(torques) {
                marks.extend(self.marks_of(name, place, |of| of.standardised));
            }
            let range = Range::Fixed(-1.1 * largest, 1.1 * largest);
            Panel::new(Axis::new(format!("{label}, standard errors"), range), marks)
        };
        let mut panels = vec![panel(false, "Residual of weights")];
        if !self.read(true).is_empty() {
            panels.push(panel(true, "Residual of torques"));
        }
        let keys = self.keys(Sample::Point);
        self.figure(self.depth(), Self::layout(panels.len()), panels, keys)
    }

    fn profiles(&self) -> Figure {
        let panel = |row: &super::CalibratedRow| {
            let scale = row.standard_error.or_else(|| {
                // At its bound: as far as the parabola's.
                let last = row.profile.last().filter(|of| of[2] > 0.0)?;
                Some((last[0] - row.value).abs() / last[2].sqrt())
            });
            let scale = scale.unwrap_or(1.0);
            let curve = |of: usize| {
                let points = row.profile.iter().map(|at| ((at[0] - row.value) / scale, at[of]));
                points.collect()
            };
            let solid = Mark::Curve { ink: Ink::Line(0), stroke: Stroke::Solid, points: curve(1) };
            let dashed =
                Mark::Curve { ink: Ink::Line(1), stroke: Stroke::Dashed, points: curve(2) };
            let ends = row.interval.into_iter().flatten();
            let ends = ends.map(|end| Mark::SharedRule {
                at: (end - row.value) / scale,
                label: String::new(),
            });
            let mut marks = vec![dashed, solid];
            marks.extend(ends);
            Panel::new(Axis::new(format!("χ² above its least: {}", row.words), Range::Zero), marks)
        };
        let panels: Vec<Panel> = self.of.estimates.iter().map(panel).collect();
        let key = |name: &str, place: usize, stroke: Stroke| Key {
            name: name.to_owned(),
            sample: Sample::Line(Ink::Line(place), stroke),
        };
        let keys = vec![
            key("likelihood", 0, Stroke::Solid),
            key("by the standard error", 1, Stroke::Dashed),
        ];
        let shared = Axis::new("Held so many standard errors from the best", Range::Tight);
        let columns = panels.len().clamp(1, 2);
        self.figure(shared, Layout::across(columns, 180.0, 70.0), panels, keys)
    }
}
