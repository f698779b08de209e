//! Peaks of a string that is set in motion: their picture and their table.

use wholestring::operation::Event;
use wholestring_results::{PlanPeak, PlanPeakOf};

use super::{
    Plan,
    levels::{History, STROKES},
    limits::{FAR, surface_limit_is_near, surface_limit_title},
};
use crate::{
    Grid, StudyPart,
    cell::{capital, four},
    figure::{Axis, Figure, Ink, Key, Layout, Mark, Panel, Range, Sample, Shape},
    grid_cells::{head, row},
    plots::DisplayUnits,
    thin::thinned,
};

/// Largest number of points of a curve.
const POINTS: usize = 600;

/// Quantity of a panel.
#[derive(Clone, Copy)]
struct Shows {
    title: &'static str,
    dimension: &'static str,
    series: fn(&History) -> &[f64],
    peak: fn(&PlanPeak) -> Option<PlanPeakOf>,
}

const HOOK: Shows = Shows {
    title: "hook load",
    dimension: "force",
    series: |history| &history.hook_load_N,
    peak: |event| event.hook_load_N,
};
const TORQUE: Shows = Shows {
    title: "surface torque",
    dimension: "torque",
    series: |history| &history.surface_torque_N_m,
    peak: |event| event.surface_torque_N_m,
};
const PUMP: Shows = Shows {
    title: "pump pressure",
    dimension: "pressure",
    series: |history| &history.pump_pressure_Pa,
    peak: |event| event.pump_pressure_Pa,
};

/// Quantities of an event, in their order.
const QUANTITIES: [Shows; 3] = [HOOK, TORQUE, PUMP];

/// Name of an event: `pick-up from slips`.
fn name(event: &PlanPeak) -> &str {
    match Event::from_name(&event.event) {
        Some(event) => event.label(),
        None => &event.event,
    }
}

/// Pressure that breaks the gel, Pa, where it is known.
fn gel_Pa(event: &PlanPeak) -> Option<f64> {
    event.gel.map(|gel| gel.bore_Pa + gel.annulus_Pa)
}

/// Depths of the events, increasing.
fn depths_m(plan: &Plan) -> Vec<f64> {
    let mut depths: Vec<f64> = plan.summary.peaks.iter().map(|event| event.bit_depth_m).collect();
    depths.sort_by(f64::total_cmp);
    depths.dedup();
    depths
}

/// Names of the events, in their order.
fn names(plan: &Plan) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for event in plan.summary.peaks.iter().map(name) {
        if !names.contains(&event) {
            names.push(event);
        }
    }
    names
}

/// Each event against time: hook load, and torque or pressure where the string turns or the pump
/// starts.
pub(super) fn figure(plan: &Plan, display: DisplayUnits<'_>) -> Option<Figure> {
    let mut panels = Vec::new();
    for title in names(plan) {
        for shows in QUANTITIES {
            // A string that rotates without axial motion has no change of hook load.
            let is_shown = |(event, _): &(&PlanPeak, &History)| {
                let turns = event.surface_torque_N_m.is_some() && shows.dimension == "force";
                name(event) == title && (shows.peak)(event).is_some() && !turns
            };
            let events: Vec<_> = plan.events().filter(is_shown).collect();
            if !events.is_empty() {
                panels.push(panel(plan, display, title, shows, &events));
            }
        }
    }
    if panels.is_empty() {
        return None;
    }
    let depths = depths_m(plan).into_iter().enumerate().map(|(place, depth_m)| Key {
        name: format!("bit at {}", display.quantity(depth_m.round(), "length")),
        sample: Sample::Line(Ink::Line(place), STROKES[1]),
    });
    let levels = plan.levels.iter();
    let levels = levels
        .filter(|level| plan.summary.peaks.iter().any(|event| event.friction == level.friction));
    let several = levels.clone().count() > 1;
    let levels = levels.filter(|_| several).map(|level| {
        let name = format!("{} friction, {}", level.name(), level.label);
        Key { name, sample: Sample::Line(Ink::Note, level.stroke()) }
    });
    let peak = Key { name: "peak".to_owned(), sample: Sample::Point(Ink::Note, Shape::Circle) };
    let keys = depths.chain(levels).chain([peak]).collect();
    Some(Figure {
        title: plan.head.title.clone(),
        subtitle: "by the dynamics, from a string that hangs at rest; without block".to_owned(),
        keys,
        layout: Layout::across(panels.len().min(2), 180.0, 55.0),
        shared: Axis::new("Time from the beginning, s", Range::Tight),
        panels,
        hole: Vec::new(),
    })
}

fn panel(
    plan: &Plan,
    display: DisplayUnits<'_>,
    title: &str,
    shows: Shows,
    events: &[(&PlanPeak, &History)],
) -> Panel {
    let depths = depths_m(plan);
    let mut marks = Vec::new();
    let value = |si: f64| display.value(si, shows.dimension);
    let mut largest: f64 = 0.0;
    for (event, history) in events {
        let place = depths.iter().position(|depth| *depth == event.bit_depth_m).unwrap_or(0);
        let (ink, stroke) = (Ink::Line(place), plan.level(event.friction).stroke());
        let (times_s, thin) = thinned(&history.time_s, &[(shows.series)(history)], POINTS);
        let points = times_s.into_iter().zip(thin.into_iter().flatten());
        let points = points.map(|(time_s, si)| (time_s, value(si))).collect();
        marks.push(Mark::Curve { ink, stroke, points });
        if let Some(peak) = (shows.peak)(event) {
            largest = largest.max(peak.peak.abs());
            let points = vec![(peak.time_s, value(peak.peak))];
            marks.push(Mark::Points { ink, shape: Shape::Circle, points });
        }
        if let (Some(gel_Pa), "pressure") = (gel_Pa(event), shows.dimension) {
            largest = largest.max(gel_Pa);
            let label = match depths.len() {
                1 => "gel".to_owned(),
                _ => format!("gel, {}", display.quantity(event.bit_depth_m.round(), "length")),
            };
            marks.push(Mark::OwnRule { at: value(gel_Pa), label });
        }
    }
    let has_mud = !plan.summary.hydraulics.is_empty();
    let pump_Pa = plan.summary.pump_pressure_limit_Pa().filter(|_| has_mud);
    let pump_Pa = pump_Pa.filter(|limit| shows.dimension == "pressure" && *limit <= FAR * largest);
    marks.extend(pump_Pa.map(|at| Mark::OwnRule { at: value(at), label: "limit".to_owned() }));
    let near = plan.surface(shows.dimension).filter(|limit| surface_limit_is_near(limit, largest));
    marks.extend(near.map(|near| Mark::OwnRule {
        at: value(near.allowed),
        label: surface_limit_title(near).to_owned(),
    }));
    let range = if shows.dimension == "force" { Range::Near } else { Range::Zero };
    let title = format!("{}: {}", capital(title), shows.title);
    Panel::new(Axis::new(display.label(&title, shows.dimension), range), marks)
}

/// Every peak.
pub(super) fn table(plan: &Plan, display: DisplayUnits<'_>) -> Option<StudyPart> {
    let heads = vec![
        head("event", true),
        head("quantity", true),
        head("friction", true),
        head("bit at", false),
        head("at rest", false),
        head("peak", false),
        head("after, s", false),
        head("final value", false),
        head("peak over final value", false),
        head("overshoot", false),
        head("note", true),
    ];
    let quantity = |si: f64, dimension: &str| {
        format!("{} {}", four(display.value(si, dimension)), display.symbol(dimension))
    };
    let mut rows = Vec::new();
    for event in &plan.summary.peaks {
        let level = event.friction.name();
        let bit = display.quantity(event.bit_depth_m.round(), "length");
        let first_cells = |title: &str| [name(event), title, level, &bit].map(str::to_owned);
        let peaks = QUANTITIES.iter().filter_map(|shows| Some((shows, (shows.peak)(event)?)));
        let peaks: Vec<_> = peaks.collect();
        for (place, (shows, peak)) in peaks.iter().enumerate() {
            let note =
                if place == 0 { event.message.clone().unwrap_or_default() } else { String::new() };
            let cells = [
                quantity(peak.at_rest, shows.dimension),
                quantity(peak.peak, shows.dimension),
                format!("{:.2}", peak.time_s),
                quantity(peak.steady, shows.dimension),
                peak.ratio.map_or_else(String::new, |ratio| format!("{ratio:.3}")),
                peak.overshoot.map_or_else(String::new, |part| format!("{:.1} %", 100.0 * part)),
                note,
            ];
            rows.push(row(first_cells(shows.title).into_iter().chain(cells).collect()));
        }
        if let Some((gel, gel_Pa)) = event.gel.zip(gel_Pa(event)) {
            let note = format!(
                "all of the gel at once; lifts the string by {}",
                quantity(gel.lift_N, "force")
            );
            let cells = [
                String::new(),
                quantity(gel_Pa, "pressure"),
                String::new(),
                String::new(),
                String::new(),
                String::new(),
                note,
            ];
            rows.push(row(first_cells("to break the gel").into_iter().chain(cells).collect()));
        }
        if peaks.is_empty() {
            let mut cells = vec![String::new(); 7];
            cells[6] = event.message.clone().unwrap_or_default();
            rows.push(row(first_cells("no answer").into_iter().chain(cells).collect()));
        }
    }
    (!rows.is_empty()).then(|| StudyPart::Table {
        title: "Peaks".to_owned(),
        caption: "Response of a string that is set in motion from rest, by the dynamics: the \
            sample farthest from the value at rest, and the final value, the mean over the last \
            quarter of the observed time. Overshoot: excess of the peak over the final value, as a \
            part of the change. Their limits are among the others, with the model \"dynamics\"."
            .to_owned(),
        grid: Grid { heads, rows },
        files: "plan_peaks".to_owned(),
        endings: &["csv", "parquet"],
    })
}
