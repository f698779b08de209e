//! Peaks of a string that sets itself in motion: their picture and their table.

use super::{FAR, Plan, PlanEvent, PlanPeakRow, broomstick::STROKES};
use crate::grid_cells::{head, row};
use crate::operation_words::four;
use crate::{
    Grid, StudyPart,
    figure::{Axis, Figure, Ink, Key, Layout, Mark, Panel, Range, Sample, Shape},
    plots::Shown,
    thin::thinned,
};

/// Points of a curve.
const POINTS: usize = 600;

/// What a panel shows.
#[derive(Clone, Copy)]
struct Shows {
    title: &'static str,
    dimension: &'static str,
    series: fn(&PlanEvent) -> &[f64],
    peak: fn(&PlanEvent) -> Option<&PlanPeakRow>,
}

const HOOK: Shows = Shows {
    title: "hook load",
    dimension: "force",
    series: |of| &of.hook_load_N,
    peak: |of| of.peaks.iter().find(|of| of.quantity == "hook load"),
};
const TORQUE: Shows = Shows {
    title: "surface torque",
    dimension: "torque",
    series: |of| &of.torque_N_m,
    peak: |of| of.peaks.iter().find(|of| of.quantity == "surface torque"),
};
const PUMP: Shows = Shows {
    title: "pump pressure",
    dimension: "pressure",
    series: |of| &of.pump_Pa,
    peak: |of| of.peaks.iter().find(|of| of.quantity == "pump pressure"),
};

/// Depths of the events, growing.
fn depths_m(plan: &Plan) -> Vec<f64> {
    let mut depths: Vec<f64> = plan.events.iter().map(|of| of.bit_depth_m).collect();
    depths.sort_by(f64::total_cmp);
    depths.dedup();
    depths
}

/// Names of the events, in their order.
fn names(plan: &Plan) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for of in &plan.events {
        if !names.contains(&of.name.as_str()) {
            names.push(&of.name);
        }
    }
    names
}

/// Each event against time: hook load, and torque or pressure where the string turns or the pump starts.
pub(super) fn figure(plan: &Plan, shown: Shown<'_>) -> Option<Figure> {
    let mut panels = Vec::new();
    for name in names(plan) {
        for shows in [HOOK, TORQUE, PUMP] {
            // What turns and does not move along pulls no more than before.
            let is_shown = |of: &&PlanEvent| {
                let turns = (TORQUE.peak)(of).is_some() && shows.dimension == "force";
                of.name == name && (shows.peak)(of).is_some() && !turns
            };
            let events: Vec<&PlanEvent> = plan.events.iter().filter(is_shown).collect();
            if !events.is_empty() {
                panels.push(panel(plan, shown, name, shows, &events));
            }
        }
    }
    if panels.is_empty() {
        return None;
    }
    let depths = depths_m(plan).into_iter().enumerate().map(|(place, depth_m)| Key {
        name: format!("bit at {}", shown.quantity(depth_m.round(), "length")),
        sample: Sample::Line(Ink::Line(place), STROKES[1]),
    });
    let mut levels: Vec<usize> = plan.events.iter().map(|of| of.level).collect();
    levels.sort_unstable();
    levels.dedup();
    let several = levels.len() > 1;
    let levels = levels.into_iter().filter(|_| several).filter_map(|level| {
        let of = plan.levels.get(level)?;
        let name = format!("{} friction, {}", of.name, of.label);
        Some(Key { name, sample: Sample::Line(Ink::Note, STROKES[level % STROKES.len()]) })
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

fn panel(plan: &Plan, shown: Shown<'_>, name: &str, shows: Shows, events: &[&PlanEvent]) -> Panel {
    let depths = depths_m(plan);
    let mut marks = Vec::new();
    let value = |si: f64| shown.value(si, shows.dimension);
    let mut largest: f64 = 0.0;
    for of in events {
        let place = depths.iter().position(|depth| *depth == of.bit_depth_m).unwrap_or(0);
        let (ink, stroke) = (Ink::Line(place), STROKES[of.level % STROKES.len()]);
        let (times_s, thin) = thinned(&of.time_s, &[(shows.series)(of)], POINTS);
        let points = times_s.into_iter().zip(thin.into_iter().flatten());
        let points = points.map(|(time_s, si)| (time_s, value(si))).collect();
        marks.push(Mark::Curve { ink, stroke, points });
        if let Some(peak) = (shows.peak)(of) {
            largest = largest.max(peak.peak.abs());
            let points = vec![(peak.time_s, value(peak.peak))];
            marks.push(Mark::Points { ink, shape: Shape::Circle, points });
        }
        if let (Some(gel_Pa), "pressure") = (of.gel_Pa, shows.dimension) {
            largest = largest.max(gel_Pa);
            let label = match depths.len() {
                1 => "gel".to_owned(),
                _ => format!("gel, {}", shown.quantity(of.bit_depth_m.round(), "length")),
            };
            marks.push(Mark::OwnRule { at: value(gel_Pa), label });
        }
    }
    let pump_Pa = plan.mud.as_ref().and_then(|mud| mud.pump_limit_Pa);
    let pump_Pa = pump_Pa.filter(|limit| shows.dimension == "pressure" && *limit <= FAR * largest);
    marks.extend(pump_Pa.map(|at| Mark::OwnRule { at: value(at), label: "limit".to_owned() }));
    let near = plan.surface(shows.dimension).filter(|of| of.is_near(largest));
    marks.extend(near.map(|of| Mark::OwnRule { at: value(of.allowed), label: of.title.clone() }));
    let range = if shows.dimension == "force" { Range::Near } else { Range::Zero };
    let title = format!("{}: {}", capital(name), shows.title);
    Panel::new(Axis::new(shown.label(&title, shows.dimension), range), marks)
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// Every peak.
pub(super) fn table(plan: &Plan, shown: Shown<'_>) -> Option<StudyPart> {
    let heads = vec![
        head("event", true),
        head("quantity", true),
        head("friction", true),
        head("bit at", false),
        head("at rest", false),
        head("peak", false),
        head("after, s", false),
        head("comes to", false),
        head("peak over that", false),
        head("beyond the change", false),
        head("note", true),
    ];
    let quantity = |si: f64, dimension: &str| {
        format!("{} {}", four(shown.value(si, dimension)), shown.symbol(dimension))
    };
    let part = |of: f64| match of.is_nan() {
        true => String::new(),
        false => format!("{:.1} %", 100.0 * of),
    };
    let mut rows = Vec::new();
    for event in &plan.events {
        let level = plan.levels.get(event.level).map_or("", |of| of.name.as_str());
        let bit = shown.quantity(event.bit_depth_m.round(), "length");
        let whose =
            |what: &str| [event.name.clone(), what.to_owned(), level.to_owned(), bit.clone()];
        for (place, of) in event.peaks.iter().enumerate() {
            let note =
                if place == 0 { event.message.clone().unwrap_or_default() } else { String::new() };
            let cells = [
                quantity(of.at_rest, &of.dimension),
                quantity(of.peak, &of.dimension),
                format!("{:.2}", of.time_s),
                quantity(of.steady, &of.dimension),
                if of.ratio.is_nan() { String::new() } else { format!("{:.3}", of.ratio) },
                part(of.overshoot),
                note,
            ];
            rows.push(row(whose(of.quantity).into_iter().chain(cells).collect()));
        }
        if let Some(gel_Pa) = event.gel_Pa {
            let note = format!(
                "all of the gel at once; lifts the string by {}",
                quantity(event.gel_lift_N, "force")
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
            rows.push(row(whose("to break the gel").into_iter().chain(cells).collect()));
        }
        if event.peaks.is_empty() {
            let mut cells = vec![String::new(); 7];
            cells[6] = event.message.clone().unwrap_or_default();
            rows.push(row(whose("no answer").into_iter().chain(cells).collect()));
        }
    }
    (!rows.is_empty()).then(|| StudyPart::Table {
        title: "Peaks".to_owned(),
        caption: "What a string that hangs at rest comes to as it sets itself in motion, by the dynamics: what \
            it is farthest from rest at, and the mean over the last quarter of the watch. Beyond the change: what \
            the peak has over that, as a part of what changes. Their limits stand among the others, as of \
            \"dynamics\"."
            .to_owned(),
        grid: Grid { heads, rows },
        files: "plan_peaks".to_owned(),
        endings: &["csv", "parquet"],
    })
}
