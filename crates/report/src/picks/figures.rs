//! The pictures of weights picked from a log.

use wholestring_import::picking::{Channel, Detail, Estimate, Kind, Picks, Window};
use wholestring_units::UnitSet;

use super::{KINDS, PickedLog, ink, number_and_work};
use crate::{
    figure::{
        Axis, Direction, Figure, Ink, Key, Layout, Mark, Panel, Range, Sample, Shape, Stroke,
    },
    plots::DisplayUnits,
};

/// The whole log with the picked windows, in these units.
pub(super) fn log_figure(log: &PickedLog<'_>, units: &str) -> Figure {
    const HOUR_S: f64 = 3600.0;
    let drawing =
        Drawing { log, display: DisplayUnits::new(&log.head.dimensions, units), tick_s: HOUR_S };
    let trace = |channel| log.picks.overview.points(channel);
    let points = |which: Which| {
        move |kind: Kind| {
            let own = log.picks.windows.iter().filter(|window| window.kind == kind);
            let places = own.filter_map(|window| {
                let value = which.of(window)?.value - which.added_N(log);
                let middle_s = 0.5 * (window.from_s + window.to_s);
                Some((middle_s / HOUR_S, drawing.display.value(value, which.dimension())))
            });
            places.collect::<Vec<_>>()
        }
    };
    let depth = {
        let curve = drawing.curve(&trace(Channel::BitDepth), "length");
        let label = drawing.display.label("Bit depth", "length");
        Panel::new(Axis { down: true, ..Axis::new(label, Range::Near) }, vec![curve])
    };
    let weight = drawing.panel("Hook load", &trace(Channel::HookLoad), "force", |marks| {
        marks.extend(drawing.in_slips());
        marks.extend(KINDS.map(|kind| dots(kind, points(Which::Weight)(kind))));
    });
    let torque = drawing.panel("Torque", &trace(Channel::Torque), "torque", |marks| {
        marks.extend(KINDS.map(|kind| dots(kind, points(Which::Torque)(kind))));
    });
    let mut panels = vec![depth];
    panels.extend(weight);
    panels.extend(torque);
    let keys = drawing.keys(|kind| Sample::Point(ink(kind), shape(kind)), &log.picks.windows);
    let shared = Axis::new("Time, h", Range::Tight);
    figure(&log.head.title, shared, Layout::across(1, 180.0, 42.0), panels, keys)
}

/// The picked values against depth, in these units.
pub(super) fn depth_figure(log: &PickedLog<'_>, units: &str) -> Figure {
    let display = DisplayUnits::new(&log.head.dimensions, units);
    let drawing = Drawing { log, display, tick_s: 1.0 };
    let panel = |label: &str, which: Which| {
        let mut marks = Vec::new();
        for kind in KINDS {
            let own = log.picks.windows.iter().filter(|window| window.kind == kind);
            let (mut places, mut bars) = (Vec::new(), Vec::new());
            for window in own {
                let Some(Estimate { value, standard_error, .. }) = which.of(window) else {
                    continue;
                };
                let depth = display.value(window.bit_depth_m, "length");
                let at = |value: f64| (depth, display.value(value, which.dimension()));
                places.push(at(value));
                bars.push([at(value - standard_error), at(value + standard_error)]);
            }
            if !places.is_empty() {
                marks.push(Mark::Bars { ink: ink(kind), bars });
                marks.push(dots(kind, places));
            }
        }
        let label = display.label(label, which.dimension());
        (!marks.is_empty()).then(|| Panel::new(Axis::new(label, Range::Near), marks))
    };
    let panels: Vec<Panel> =
        [panel("Hook load with the block", Which::Weight), panel("Torque", Which::Torque)]
            .into_iter()
            .flatten()
            .collect();
    let label = display.label("Measured depth of the bit", "length");
    let shared = Axis { down: true, ..Axis::new(label, Range::Near) };
    let columns = panels.len().max(1);
    let layout = Layout { direction: Direction::Down, columns, width_mm: 180.0, panel_mm: 95.0 };
    let keys = drawing.keys(|kind| Sample::Point(ink(kind), shape(kind)), &log.picks.windows);
    figure(&log.head.title, shared, layout, panels, keys)
}

/// A stand of a log with its windows, in these units.
pub fn picked_stand_figure(picks: &Picks, stand: &Detail, units: UnitSet) -> Figure {
    stand_figure(&PickedLog::new(picks, units), stand, units.name())
}

pub(super) fn stand_figure(log: &PickedLog<'_>, stand: &Detail, units: &str) -> Figure {
    const MINUTE_S: f64 = 60.0;
    let drawing =
        Drawing { log, display: DisplayUnits::new(&log.head.dimensions, units), tick_s: MINUTE_S };
    let starts = [Channel::HookLoad, Channel::Block].map(|channel| stand.trace.points(channel));
    let start_s = starts.iter().flatten().map(|point| point.0).fold(f64::INFINITY, f64::min);
    let from_start = |points: &[(f64, f64)]| -> Vec<(f64, f64)> {
        points.iter().map(|(time_s, value)| (time_s - start_s, *value)).collect()
    };
    let minutes = |time_s: f64| (time_s - start_s) / MINUTE_S;
    let panel = |label: &str, channel: Channel, dimension: &str, which: Option<Which>| {
        let trace = stand.trace.points(channel);
        drawing.panel(label, &from_start(&trace), dimension, |marks| {
            let values = trace.iter().map(|point| drawing.display.value(point.1, dimension));
            let values = values.filter(|value| value.is_finite());
            let (low, high) = values
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
                    (low.min(value), high.max(value))
                });
            let trace = std::mem::take(marks);
            for refused in &stand.refused {
                let [from, to] = [refused.from_s, refused.to_s].map(minutes);
                marks.push(Mark::Shade { from, to });
            }
            for window in &stand.windows {
                let [from, to] = [window.from_s, window.to_s].map(minutes);
                let points = vec![(from, low, high), (to, low, high)];
                marks.push(Mark::Band { ink: ink(window.kind), points });
            }
            marks.extend(trace);
            for window in &stand.windows {
                let Some((which, of_window)) =
                    which.and_then(|which| Some((which, which.of(window)?)))
                else {
                    continue;
                };
                let [from, to] = [window.from_s, window.to_s].map(minutes);
                let logged = of_window.value - which.added_N(log);
                let value = drawing.display.value(logged, dimension);
                let points = vec![(from, value), (to, value)];
                let ink = ink(window.kind);
                marks.push(Mark::Points { ink, shape: shape(window.kind), points: points.clone() });
                marks.push(Mark::Curve { ink, stroke: Stroke::Solid, points });
                let text = drawing.display.quantity(of_window.value, dimension);
                marks.push(Mark::Name { at: (0.5 * (from + to), value), text });
            }
        })
    };
    let panels = [
        panel("Block", Channel::Block, "length", None),
        panel("Hook load", Channel::HookLoad, "force", Some(Which::Weight)),
        panel("Torque", Channel::Torque, "torque", Some(Which::Torque)),
        panel("Rotary speed", Channel::Rotary, "rotary speed", None),
    ];
    let mut keys = drawing.keys(|kind| Sample::Band(ink(kind)), &stand.windows);
    if !stand.refused.is_empty() {
        keys.push(Key { name: "refused".to_owned(), sample: Sample::Area(Ink::Settling) });
    }
    let title = format!("{}: stand {}", log.head.title, number_and_work(stand));
    let shared = Axis::new("Time since the string was lifted out of slips, min", Range::Tight);
    let panels = panels.into_iter().flatten().collect();
    figure(&title, shared, Layout::across(1, 180.0, 26.0), panels, keys)
}

/// Weight or torque.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Which {
    Weight,
    Torque,
}

impl Which {
    fn of(self, window: &Window) -> Option<Estimate> {
        match self {
            Self::Weight => window.weight_N,
            Self::Torque => window.torque_N_m,
        }
    }

    fn dimension(self) -> &'static str {
        match self {
            Self::Weight => "force",
            Self::Torque => "torque",
        }
    }

    /// Addition of a picked value to the logged ones.
    fn added_N(self, log: &PickedLog<'_>) -> f64 {
        if self == Self::Weight { log.picks.block.added_N() } else { 0.0 }
    }
}

/// Drawing of a log's pictures.
#[derive(Clone, Copy)]
struct Drawing<'a> {
    log: &'a PickedLog<'a>,
    display: DisplayUnits<'a>,
    /// Unit of the axis of time, s.
    tick_s: f64,
}

impl Drawing<'_> {
    fn curve(&self, trace: &[(f64, f64)], dimension: &str) -> Mark {
        let place =
            |(time_s, si): &(f64, f64)| (time_s / self.tick_s, self.display.value(*si, dimension));
        let points = trace.iter().map(place).collect();
        Mark::Curve { ink: Ink::Note, stroke: Stroke::Solid, points }
    }

    /// A panel of a trace; `None` where it is empty or zero throughout.
    fn panel(
        &self,
        label: &str,
        trace: &[(f64, f64)],
        dimension: &str,
        more: impl FnOnce(&mut Vec<Mark>),
    ) -> Option<Panel> {
        if !trace.iter().any(|point| point.1.is_finite() && point.1 != 0.0) {
            return None;
        }
        let mut marks = vec![self.curve(trace, dimension)];
        more(&mut marks);
        let axis =
            Axis { clips: true, ..Axis::new(self.display.label(label, dimension), Range::Near) };
        Some(Panel::new(axis, marks))
    }

    fn in_slips(&self) -> Option<Mark> {
        let at = self.display.value(self.log.picks.block.slips_N?, "force");
        Some(Mark::OwnRule { at, label: "in slips".to_owned() })
    }

    fn keys(&self, sample: impl Fn(Kind) -> Sample, windows: &[Window]) -> Vec<Key> {
        let there = |kind: &Kind| windows.iter().any(|window| window.kind == *kind);
        let key = |kind: Kind| Key { name: kind.words().to_owned(), sample: sample(kind) };
        KINDS.into_iter().filter(there).map(key).collect()
    }
}

fn shape(kind: Kind) -> Shape {
    let place = KINDS.iter().position(|other| *other == kind);
    Shape::of(place.unwrap_or(0))
}

fn dots(kind: Kind, points: Vec<(f64, f64)>) -> Mark {
    Mark::Points { ink: ink(kind), shape: shape(kind), points }
}

fn figure(title: &str, shared: Axis, layout: Layout, panels: Vec<Panel>, keys: Vec<Key>) -> Figure {
    Figure {
        title: title.to_owned(),
        subtitle: String::new(),
        keys,
        layout,
        shared,
        panels,
        hole: Vec::new(),
    }
}
