//! Quantities against time.

use super::{
    catalogue::{TimePlot, bit_plots, time_plots},
    run::{Context, Plot},
};
use crate::{
    TimeRun,
    figure::{Axis, Ink, Key, Layout, Mark, Panel, Range, Sample, Shape, Stroke},
};

/// Each history in a figure of its own, and all in one; those of the bit apart.
pub(super) fn plots(context: Context<'_>) -> Vec<Plot> {
    let timed: Vec<(usize, &TimeRun)> = context.timed().collect();
    let ends = timed.iter().filter_map(|(_, run)| end_s(run));
    let end_s = ends.fold(0.0, f64::max);
    let drills = timed.iter().any(|(_, run)| run.drill_off.is_some());
    let bit = if drills { bit_plots() } else { Vec::new() };
    [("time", time_plots()), ("bit", bit)]
        .into_iter()
        .flat_map(|(name, plots)| {
            let panels: Vec<(&TimePlot, Panel)> = plots
                .iter()
                .filter_map(|plot| Some((plot, panel(plot, &timed, context)?)))
                .collect();
            group(name, &panels, end_s, context)
        })
        .collect()
}

/// Time of a run's last sample, s.
fn end_s(run: &TimeRun) -> Option<f64> {
    run.history.get("time_s")?.values().last().copied()
}

/// All panels in one figure of this name, and each in one of its own.
fn group(name: &str, panels: &[(&TimePlot, Panel)], end_s: f64, context: Context<'_>) -> Vec<Plot> {
    if panels.is_empty() {
        return Vec::new();
    }
    let figure = |panels: &[(&TimePlot, Panel)], panel_mm| {
        let time = Axis::new("Time, s", Range::Fixed(0.0, end_s));
        let panels = panels.iter().map(|(_, panel)| panel.clone()).collect();
        context.figure(Layout::across(1, 180.0, panel_mm), time, panels)
    };
    let all = context.plot(name, figure(panels, 26.0));
    let single = panels
        .iter()
        .map(|panel| context.plot(panel.0.name, figure(std::slice::from_ref(panel), 55.0)));
    std::iter::once(all).chain(single).collect()
}

/// Style of a column: for one run columns differ by colour, for two by stroke; set values are
/// dotted.
fn style(runs: usize, run: usize, place: usize, name: &str) -> (Ink, Stroke) {
    let is_set = name == "set";
    match (runs, is_set) {
        (1, true) => (Ink::Line(6), Stroke::Dotted),
        // The second colour is the soft string's.
        (1, false) => (Ink::Line([0, 2, 3][place.min(2)]), Stroke::Solid),
        (_, true) => (Ink::Line(run), Stroke::Dotted),
        (_, false) => {
            let strokes = [Stroke::Solid, Stroke::Dashed, Stroke::Dotted];
            (Ink::Line(run), strokes[place.min(2)])
        }
    }
}

fn panel(
    plot: &TimePlot,
    timed: &[(usize, &TimeRun)],
    Context { runs, operation, display, .. }: Context<'_>,
) -> Option<Panel> {
    let mut curves = Vec::new();
    let mut keys: Vec<Key> = Vec::new();
    let shapes = [Shape::Circle, Shape::Diamond];
    for (run, timed) in timed {
        let times = timed.history.get("time_s")?.values();
        for (place, (column, name)) in plot.columns.iter().enumerate() {
            let Some(values) = timed.history.get(*column) else {
                continue;
            };
            let values = display.values(&values.values(), plot.dimension);
            let points: Vec<(f64, f64)> = times.iter().copied().zip(values).collect();
            let (ink, stroke) = style(runs.len(), *run, place, name);
            let shape = shapes[place.min(1)];
            let sample_ink = if runs.len() == 1 { ink } else { Ink::Note };
            let lasting = plot.points.then(|| lasting(&points));
            let comes_and_goes = lasting.as_ref().is_some_and(|[curve, _]| curve.is_empty());
            let sample = if comes_and_goes {
                Sample::Point(sample_ink, shape)
            } else {
                Sample::Line(sample_ink, stroke)
            };
            if !keys.iter().any(|key| key.name == *name) {
                keys.push(Key { name: name.clone(), sample });
            }
            if let Some([runs, single]) = lasting {
                curves.push(Mark::Curve { ink, stroke, points: runs });
                curves.push(Mark::Points { ink, shape, points: single });
            } else {
                curves.push(Mark::Curve { ink, stroke, points });
            }
        }
    }
    let moves = |mark: &Mark| match mark {
        Mark::Curve { points, .. } | Mark::Points { points, .. } => {
            points.iter().any(|point| point.1 != 0.0 && point.1.is_finite())
        }
        _ => false,
    };
    if !curves.iter().any(moves) {
        return None;
    }
    if let (Some(column), [run]) = (plot.at_surface, runs) {
        let solved = run.report.solved.iter();
        let solved = solved.filter(|solved| solved.operation == operation);
        let at_rest = solved.filter_map(|solved| {
            let model = Some(solved.model).filter(|model| !model.in_time())?;
            let at_top = solved.profile.get(column)?.values().first().copied()?;
            at_top.is_finite().then_some((model.method(), at_top))
        });
        for (place, (model, value)) in (1..).zip(at_rest) {
            let value = display.value(value, plot.dimension);
            let end = end_s(timed[0].1)?;
            curves.push(Mark::Curve {
                ink: Ink::Line(place),
                stroke: Stroke::of(place),
                points: vec![(0.0, value), (end, value)],
            });
            keys.push(Key {
                name: model.curve_name.into(),
                sample: Sample::Line(Ink::Line(place), Stroke::of(place)),
            });
        }
    }
    if keys.len() == 1 {
        keys.clear();
    }
    let settling = timed.iter().map(|(_, run)| run.window_s).fold(0.0, f64::max);
    let mut marks = vec![Mark::Shade { from: 0.0, to: settling }];
    marks.extend(curves);
    let title = if plot.points { "Depth" } else { &plot.title };
    Some(Panel {
        axis: Axis {
            down: plot.points,
            min_span: display.value(plot.min_span, plot.dimension),
            ..Axis::new(display.label(title, plot.dimension), Range::Near)
        },
        marks,
        keys,
    })
}

/// The lasting points, as a curve with gaps, and the intermittent ones, few enough not to hide each
/// other.
fn lasting(points: &[(f64, f64)]) -> [Vec<(f64, f64)>; 2] {
    /// Number of consecutive samples that make a line.
    const LASTS: usize = 4;
    const MAX: usize = 200;
    let (mut curve, mut single) = (Vec::new(), Vec::new());
    for piece in points.split(|point| !point.1.is_finite()) {
        if piece.len() >= LASTS {
            curve.extend_from_slice(piece);
            curve.push((f64::NAN, f64::NAN));
        } else {
            single.extend_from_slice(piece);
        }
    }
    let step = single.len().div_ceil(MAX).max(1);
    [curve, single.into_iter().step_by(step).collect()]
}
