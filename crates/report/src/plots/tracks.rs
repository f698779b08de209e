//! Quantities against measured depth, which points down.

use super::{
    buckling,
    catalogue::{RULES, Source, Track, tracks},
    display::DisplayUnits,
    found::Found,
    near,
    run::{Plot, Run, title},
    styles::CurveStyles,
};
use crate::{
    Well,
    figure::{
        Axis, Direction, Figure, Ink, Interval, Key, Layout, Mark, Panel, Range, Sample, Stroke,
    },
};

/// Largest number of tracks in a line of a page.
const IN_A_LINE: usize = 4;

/// All tracks in one figure, then each in one of its own; empty ones are left out.
pub(super) fn plots(
    runs: &[Run<'_>],
    styles: &CurveStyles<'_>,
    display: DisplayUnits<'_>,
    subtitle: &str,
    suffix: &str,
) -> Vec<Plot> {
    let all = tracks();
    let mut tracks: Vec<(&Track, Panel)> = all
        .iter()
        .filter_map(|track| Some((track, panel(track, runs, styles, display)?)))
        .collect();
    let found = Found::of(styles);
    for (_, panel) in &mut tracks {
        panel.marks.splice(0..0, found.marks(display));
    }
    let figure = |tracks: &[(&Track, Panel)], columns, width_mm, panel_mm| Figure {
        title: title(runs),
        subtitle: subtitle.to_owned(),
        keys: [keys(tracks, styles), found.keys()].concat(),
        layout: Layout { direction: Direction::Down, columns, width_mm, panel_mm },
        shared: Axis {
            down: true,
            ..Axis::new(display.label("Measured depth", "length"), Range::Tight)
        },
        panels: tracks.iter().map(|(_, panel)| panel.clone()).collect(),
        hole: hole(runs, display),
    };
    if tracks.is_empty() {
        return Vec::new();
    }
    let lines = tracks.len().div_ceil(IN_A_LINE);
    let columns = tracks.len().div_ceil(lines);
    let height = if lines > 1 { 92.0 } else { 150.0 };
    let all =
        Plot { name: format!("profile{suffix}"), figure: figure(&tracks, columns, 180.0, height) };
    let single = tracks.iter().map(|track| Plot {
        name: format!("{}{suffix}", track.0.name),
        figure: figure(std::slice::from_ref(track), 1, 85.0, 100.0),
    });
    std::iter::once(all).chain(single).collect()
}

/// Keys of the curves, bands and areas of these tracks.
fn keys(tracks: &[(&Track, Panel)], styles: &CurveStyles<'_>) -> Vec<Key> {
    let marks = || tracks.iter().flat_map(|(_, panel)| &panel.marks);
    let mut keys = if tracks.iter().all(|(track, _)| track.from == Source::Well) {
        Vec::new()
    } else {
        let is_of = |mark: &Mark, ink: Ink, stroke: Stroke| match mark {
            Mark::Curve { stroke: own, .. } if ink == Ink::Note => *own == stroke,
            Mark::Curve { ink: own, .. } if !styles.alone() => *own == ink,
            Mark::Curve { ink: own_ink, stroke: own_stroke, .. } => {
                (*own_ink, *own_stroke) == (ink, stroke)
            }
            _ => false,
        };
        let is_drawn = |key: &Key| match key.sample {
            Sample::Line(ink, stroke) => marks().any(|mark| is_of(mark, ink, stroke)),
            _ => true,
        };
        styles.keys().into_iter().filter(is_drawn).collect()
    };
    keys.extend(buckling::keys(marks()));
    let dotted = |mark: &Mark| matches!(mark, Mark::Curve { stroke: Stroke::Dotted, .. });
    if marks().any(dotted) {
        keys.push(styles.between_key());
    }
    if marks().any(|mark| matches!(mark, Mark::Band { .. })) {
        keys.push(styles.band_key());
    }
    if marks().any(|mark| matches!(mark, Mark::Sides { .. })) {
        for (name, ink) in [("on the high side", Ink::HighSide), ("on the low side", Ink::LowSide)]
        {
            keys.push(Key { name: name.into(), sample: Sample::Area(ink) });
        }
    }
    keys
}

fn panel(
    track: &Track,
    runs: &[Run<'_>],
    styles: &CurveStyles<'_>,
    display: DisplayUnits<'_>,
) -> Option<Panel> {
    let marks = match track.from {
        Source::Well => well_marks(track, runs, display),
        _ => solved_marks(track, styles, display),
    };
    if marks.is_empty() {
        return None;
    }
    let range = match track.range {
        Some([from, to]) => {
            let end = |si| display.value(si, track.shows.dimension);
            Range::Fixed(end(from), end(to))
        }
        None if track.zero => Range::Zero,
        None => Range::Near,
    };
    Some(Panel {
        axis: Axis {
            clips: track.from == Source::Profile && track.range.is_none(),
            min_span: display.value(track.min_span, track.shows.dimension),
            sides: track.sides.then(|| ["low side".to_owned(), "high side".to_owned()]),
            ..Axis::new(display.label(&track.shows.title, track.shows.dimension), range)
        },
        marks,
        keys: Vec::new(),
    })
}

/// Points of a column in the reader's units.
fn points(
    depths: &[f64],
    values: &[f64],
    display: DisplayUnits<'_>,
    dimension: &str,
) -> Vec<(f64, f64)> {
    let depths = display.values(depths, "length");
    depths.into_iter().zip(display.values(values, dimension)).collect()
}

fn solved_marks(track: &Track, styles: &CurveStyles<'_>, display: DisplayUnits<'_>) -> Vec<Mark> {
    let (mut areas, mut bands, mut curves) = (Vec::new(), Vec::new(), Vec::new());
    for (run, solved) in styles.solved() {
        let table = match track.from {
            Source::Wear => &solved.wear,
            _ => &solved.profile,
        };
        let column = |name: &str| table.get(name).map(crate::Packed::values);
        let (Some(depths), Some(mut values)) = (column("md_m"), column(track.shows.column)) else {
            continue;
        };
        let mut band = track.band.and_then(|[low, high]| Some((column(low)?, column(high)?)));
        let reach = |far_m: f64| match (depths.first(), depths.last()) {
            (Some(first), Some(last)) => last - first > far_m,
            _ => false,
        };
        if track.touches {
            values = near::largest(&depths, &values, RULES.joint_reach_m);
        }
        // In a coarse view two curves, at the joints and between them; the band is the joints' own.
        let mut between = None;
        if track.swings && reach(RULES.far_m) {
            let smallest = near::smallest(&depths, &values, RULES.joint_reach_m);
            let joints = near::row_of_largest(&depths, &values, RULES.joint_reach_m);
            let at_joints =
                |values: &[f64]| joints.iter().map(|row| values[*row]).collect::<Vec<f64>>();
            values = at_joints(&values);
            band = band.map(|(low, high)| (at_joints(&low), at_joints(&high)));
            between = differs(&smallest, &values).then_some(smallest);
        }
        let (ink, stroke) = styles.of(run, solved);
        let points = |values: &[f64]| points(&depths, values, display, track.shows.dimension);
        if let Some((low, high)) = band {
            let ends = points(&low).into_iter().zip(points(&high));
            bands.push(Mark::Band {
                ink,
                points: ends.map(|((md, low), (_, high))| (md, low, high)).collect(),
            });
        }
        let points = points(&values);
        if track.sides && styles.is_first(solved) {
            areas.push(Mark::Sides { points: points.clone() });
        }
        curves.push(Mark::Curve { ink, stroke, points });
        curves.extend(between.map(|values| Mark::Curve {
            ink,
            stroke: Stroke::Dotted,
            points: self::points(&depths, &values, display, track.shows.dimension),
        }));
    }
    // Dashed lines are drawn over full ones, which would hide them.
    curves
        .sort_by_key(|mark| matches!(mark, Mark::Curve { stroke, .. } if *stroke != Stroke::Solid));
    // The loads they are compared with, below them; none where there are no curves.
    let loads =
        if curves.is_empty() { Vec::new() } else { buckling::marks(track, styles, display) };
    let cutoffs = cutoff(track, styles, display).into_iter().collect();
    [areas, bands, loads, curves, cutoffs].concat()
}

/// Whether a curve would be distinguishable from another.
fn differs(one: &[f64], other: &[f64]) -> bool {
    let largest = other.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    let off = one.iter().zip(other).map(|(a, b)| (a - b).abs());
    off.fold(0.0, f64::max) > RULES.min_difference * largest
}

/// A curve of the path: a single one where all runs are on the same.
fn well_marks(track: &Track, runs: &[Run<'_>], display: DisplayUnits<'_>) -> Vec<Mark> {
    let column = |well: &Well| {
        let values = |name: &str| well.columns.get(name).map(crate::Packed::values);
        let (depths, values) = (values("md_m")?, values(track.shows.column)?);
        Some(points(&depths, &values, display, track.shows.dimension))
    };
    let mut curves: Vec<Vec<(f64, f64)>> =
        runs.iter().filter_map(|run| column(&run.report.well)).collect();
    // A longer run on the same well includes the path of a shorter one.
    curves.retain(|points| !points.is_empty());
    let same = runs.iter().all(|run| run.report.well == runs[0].report.well);
    if same {
        curves.truncate(1);
    }
    let curves = curves.into_iter().enumerate();
    curves
        .map(|(index, points)| Mark::Curve {
            ink: if same { Ink::Text } else { Ink::Line(index) },
            stroke: Stroke::Solid,
            points,
        })
        .collect()
}

/// Rule at the cut-off depth of the first curve of a track whose sign is a side of the hole.
fn cutoff(track: &Track, styles: &CurveStyles<'_>, display: DisplayUnits<'_>) -> Option<Mark> {
    let (_, first) = styles.solved().find(|(_, solved)| styles.is_first(solved))?;
    let at = display.value(first.cutoff_depth_m.filter(|_| track.sides)?, "length");
    Some(Mark::SharedRule { at, label: "cut-off".into() })
}

/// The hole; empty where the runs differ in it.
fn hole(runs: &[Run<'_>], display: DisplayUnits<'_>) -> Vec<Interval> {
    let sections = &runs[0].report.hole;
    let alike = |other: &[crate::Section]| {
        other.len() == sections.len()
            && other.iter().zip(sections).all(|(a, b)| {
                (a.kind == b.kind) && (a.to_m, a.diameter_m) == (b.to_m, b.diameter_m)
            })
    };
    if !runs.iter().all(|run| alike(&run.report.hole)) {
        return Vec::new();
    }
    let deepest = |run: &Run<'_>| run.report.string.last().map_or(f64::INFINITY, |part| part.to_m);
    let bit_m = runs.iter().map(deepest).fold(0.0, f64::max);
    let sections = sections.iter();
    sections
        .map(|section| {
            let cased = section.kind == "casing";
            let name = if cased { "casing" } else { "open hole" };
            let diameter = display.quantity(section.diameter_m, "diameter");
            Interval {
                from: display.value(section.from_m, "length"),
                to: display.value(section.to_m.min(bit_m), "length"),
                cased,
                shoe: cased && section.to_m <= bit_m,
                label: format!("{name}, {diameter}"),
            }
        })
        .collect()
}
