//! The pictures of a calibration.

use wholestring::operation::OperationKind;
use wholestring_results::{CalibrationBand, CalibrationProfile, CalibrationReading, EstimateFound};

use super::Calibration;
use crate::{
    Plot,
    draw::palette::operation_colour,
    figure::{
        Axis, Direction, Figure, Ink, Key, Layout, Mark, Panel, Range, Sample, Shape, Stroke,
    },
    plots::{DisplayUnits, named},
};

/// Readings from left to right, their wording, and the operation whose colour they have, as on a
/// plan's broomstick.
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
    Ink::Line(operation_colour(READINGS[place].2))
}

/// Pictures of a calibration, in these units.
pub fn calibration_plots(calibration: &Calibration, units: &str) -> Vec<Plot> {
    let drawing =
        Drawing { calibration, display: DisplayUnits::new(&calibration.head.dimensions, units) };
    let figures = [drawing.broomstick(), drawing.residuals(), drawing.profiles()];
    named(CALIBRATION_PICTURES, figures.map(Some))
}

/// Drawing of a calibration's pictures.
struct Drawing<'a> {
    calibration: &'a Calibration,
    display: DisplayUnits<'a>,
}

fn dimension(is_torque: bool) -> &'static str {
    if is_torque { "torque" } else { "force" }
}

/// Wording of a reading.
pub fn reading_words(reading: &str) -> &str {
    READINGS.iter().find(|(name, ..)| *name == reading).map_or(reading, |(_, words, _)| words)
}

impl Drawing<'_> {
    fn figure(&self, shared: Axis, layout: Layout, panels: Vec<Panel>, keys: Vec<Key>) -> Figure {
        let facts = self.calibration.head.facts.iter().filter_map(|fact| self.display.fact(fact));
        Figure {
            title: self.calibration.head.title.clone(),
            subtitle: facts.collect::<Vec<_>>().join("; "),
            keys,
            layout,
            shared,
            panels,
            hole: Vec::new(),
        }
    }

    fn depth(&self) -> Axis {
        let label = self.display.label("Measured depth of the bit", "length");
        Axis { down: true, ..Axis::new(label, Range::Near) }
    }

    fn place(&self, point: &CalibrationReading, value: f64) -> (f64, f64) {
        (self.display.value(point.bit_depth_m, "length"), value)
    }

    /// The points of a reading that were used in the fit, or those that are compared with it.
    fn marks_of(
        &self,
        name: &str,
        place: usize,
        value: impl Fn(&CalibrationReading) -> f64,
    ) -> [Mark; 2] {
        [(true, ink(place)), (false, Ink::Note)].map(|(used, ink)| {
            let points = self.points_of(name).filter(|points_of| points_of.used == used);
            let points = points.map(|point| self.place(point, value(point))).collect();
            Mark::Points { ink, shape: Shape::of(place), points }
        })
    }

    fn points_of<'b>(&'b self, name: &'b str) -> impl Iterator<Item = &'b CalibrationReading> {
        self.calibration.rows.readings.iter().filter(move |point| point.reading == name)
    }

    /// Whether there are readings or predictions of a name.
    fn has(&self, name: &str) -> bool {
        self.points_of(name).next().is_some()
            || self.calibration.rows.bands.iter().any(|band| band.reading == name)
    }

    fn read(&self, torques: bool) -> Vec<(usize, &'static str, &'static str)> {
        let names = READINGS.into_iter().enumerate();
        let named = names.filter(|(_, (name, ..))| name.starts_with("torque") == torques);
        named
            .filter(|(_, (name, ..))| self.has(name))
            .map(|(place, (name, words, _))| (place, name, words))
            .collect()
    }

    fn panel_of_bands(&self, torques: bool, label: &str) -> Panel {
        let kind = dimension(torques);
        let mut marks = Vec::new();
        for (place, name, _) in self.read(torques) {
            let ink = ink(place);
            let mut cases: Vec<&str> = Vec::new();
            for band in &self.calibration.rows.bands {
                if !cases.contains(&band.case.as_str()) {
                    cases.push(&band.case);
                }
            }
            for case in cases {
                let bands = self.calibration.rows.bands.iter();
                let bands = bands.filter(|band| band.reading == name && band.case == case);
                let at = |band: &CalibrationBand| self.display.value(band.bit_depth_m, "length");
                let value = |end: f64| self.display.value(end, kind);
                let points = bands
                    .clone()
                    .map(|band| (at(band), value(band.reading_low), value(band.reading_high)));
                marks.push(Mark::Band { ink, points: points.collect() });
                let points = bands
                    .clone()
                    .map(|band| (at(band), value(band.mean_low), value(band.mean_high)));
                marks.push(Mark::Band { ink, points: points.collect() });
                let points = bands.map(|band| (at(band), value(band.predicted)));
                marks.push(Mark::Curve { ink, stroke: Stroke::Solid, points: points.collect() });
            }
        }
        // Above all bands.
        for (place, name, _) in self.read(torques) {
            marks.extend(
                self.marks_of(name, place, |point| self.display.value(point.measured, kind)),
            );
        }
        Panel::new(Axis::new(self.display.label(label, kind), Range::Near), marks)
    }

    fn keys(&self, sample: impl Fn(Ink, Shape) -> Sample) -> Vec<Key> {
        let mut all = self.read(false);
        all.extend(self.read(true));
        let key = |(place, _, words): (usize, &str, &str)| Key {
            name: words.to_owned(),
            sample: sample(ink(place), Shape::of(place)),
        };
        let mut keys: Vec<Key> = all.into_iter().map(key).collect();
        if self.calibration.rows.readings.iter().any(|point| !point.used) {
            keys.push(Key {
                name: "held out".to_owned(),
                sample: sample(Ink::Note, Shape::Circle),
            });
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
        let beyond = self.calibration.summary.outlier_beyond;
        let largest = self
            .calibration
            .rows
            .readings
            .iter()
            .map(|point| point.standardised.abs())
            .fold(beyond, f64::max);
        let panel = |torques: bool, label: &str| {
            let mut marks = Vec::new();
            for at in [0.0, -beyond, beyond] {
                marks.push(Mark::OwnRule { at, label: String::new() });
            }
            for (place, name, _) in self.read(torques) {
                marks.extend(self.marks_of(name, place, |point| point.standardised));
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
        let panel = |row: &EstimateFound| {
            let profile = self.calibration.rows.profiles.iter();
            let profile: Vec<&CalibrationProfile> =
                profile.filter(|point| point.parameter == row.parameter).collect();
            let scale = row.standard_error.or_else(|| {
                // At its bound, as far as the parabola extends.
                let last = profile.last().filter(|end| end.parabola > 0.0)?;
                Some((last.value - row.value).abs() / last.parabola.sqrt())
            });
            let scale = scale.unwrap_or(1.0);
            let curve = |value: fn(&CalibrationProfile) -> f64| {
                let points =
                    profile.iter().map(|point| ((point.value - row.value) / scale, value(point)));
                points.collect()
            };
            let [ink, other] = [0, 1].map(Ink::Line);
            let points = curve(|point| point.excess);
            let solid = Mark::Curve { ink, stroke: Stroke::Solid, points };
            let points = curve(|point| point.parabola);
            let dashed = Mark::Curve { ink: other, stroke: Stroke::Dashed, points };
            let ends = row.interval.into_iter().flatten();
            let ends = ends.map(|end| Mark::SharedRule {
                at: (end - row.value) / scale,
                label: String::new(),
            });
            let mut marks = vec![dashed, solid];
            marks.extend(ends);
            Panel::new(Axis::new(format!("χ² above its least: {}", row.words), Range::Zero), marks)
        };
        let estimates = self.calibration.summary.estimates.iter();
        let panels: Vec<Panel> = estimates.map(panel).collect();
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
