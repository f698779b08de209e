//! A figure of a study as a picture.

use wholestring_judge::Severity as Grave;
use wholestring_study::{Figure, FigureData, Pointing, Quantity, Source};
use wholestring_units::Dimension;

use super::{
    figure::{Curve, StudyFigure, is_depth, label, title, unit},
    styles::{CurveStyles, levels},
};
use crate::{
    figure::{
        Axis, Direction, Figure as Picture, Hue, Ink, Key, Layout, Mark, Panel, Range, Sample,
        Shape,
    },
    plots::{ContactMap, contact_figure},
};

/// Size of a figure, and the height if depth points down.
const WIDTH_MM: f64 = 180.0;
const HEIGHT_MM: f64 = 90.0;
const TALL_MM: f64 = 120.0;

/// Size of a figure whose shared axis points down.
const UPRIGHT_MM: (f64, f64) = (130.0, 140.0);

/// Columns of the path's position in space, m.
const POSITIONS: [&str; 4] = ["north_m", "east_m", "tvd_m", "vertical_section_m"];

/// Curves with more points than this are drawn without dots.
const MAX_DOTS: usize = 60;

impl StudyFigure<'_> {
    /// The picture.
    pub fn picture(&self) -> Picture {
        let Self { figure, curves, sweeps, units } = *self;
        let y = &figure.y[0];
        let (y_unit, y_worth) = unit(y.column.dimension, y.column.name, units);
        let (x_name, x_range, (x_unit, x_worth)) = match &figure.data {
            FigureData::Summary { x, .. } => {
                (x.key.replace(['_', '.'], " "), Range::Tight, unit(x.dimension, "", units))
            }
            FigureData::Rows { x, .. }
            | FigureData::Times { x, .. }
            | FigureData::Depths { x, .. } => (
                title(x),
                range(x.column.name, figure, curves),
                unit(x.column.dimension, x.column.name, units),
            ),
            FigureData::Map { colour, .. } => {
                return map_picture(*self, colour);
            }
        };
        let y_names: Vec<String> = figure.y.iter().map(title).collect();
        let styles = CurveStyles::of(curves, sweeps, units, figure);
        let mut marks = levels(figure, y_worth);
        for curve in curves {
            let (colour, stroke) = styles.of_curve(curve);
            let points: Vec<(f64, f64)> =
                curve.points.iter().map(|(x, y)| (x / x_worth, y / y_worth)).collect();
            let (ink, shape) = (Ink::Line(colour), Shape::Circle);
            // Nodes between the joints of a string have no contact, and a line through them would fill
            // the picture.
            let single = matches!(figure.data, FigureData::Times { .. });
            if single || points.len() <= MAX_DOTS {
                let points = points.clone();
                marks.push(Mark::Points { ink, shape, points });
            }
            if !single {
                marks.push(Mark::Curve { ink, stroke, points });
            }
        }
        let mut keys = styles.keys();
        let errors = curves.iter().flat_map(|curve| &curve.errors);
        let errors: Vec<_> = errors.map(|(x, y)| (x / x_worth, y / y_worth)).collect();
        if !errors.is_empty() {
            keys.push(Key { name: "with errors".into(), sample: Sample::Ring(Grave::Error) });
            marks.push(Mark::Rings { level: Grave::Error, points: errors });
        }
        let upright = figure.x_axis == Pointing::Down;
        let x = match &figure.data {
            FigureData::Rows { x, .. } => Some(x),
            _ => None,
        };
        let plan = !upright && x.is_some_and(|x| is_position(x) && is_position(y));
        // A depth on the vertical axis, if no other quantity is drawn on it, increases downwards.
        let down = !upright && is_depth(y.column.name);
        let is_profile = down && y.column.source != Source::Summary;
        let own = Axis {
            down,
            // The force of a single node may be so large that all others would be invisible.
            clips: matches!(y.column.source, Source::Nodes | Source::Frames | Source::Wear),
            ..Axis::new(
                label(&y_names.join(", "), &y_unit),
                if is_profile || plan { Range::Tight } else { Range::Zero },
            )
        };
        Picture {
            title: figure.title.clone(),
            subtitle: String::new(),
            keys,
            layout: Layout {
                direction: match (upright, plan) {
                    (true, _) => Direction::Down,
                    (_, true) => Direction::Plan,
                    _ => Direction::Across,
                },
                columns: 1,
                width_mm: if upright { UPRIGHT_MM.0 } else { WIDTH_MM },
                panel_mm: match (upright, is_profile || plan) {
                    (true, _) => UPRIGHT_MM.1,
                    (_, true) => TALL_MM,
                    _ => HEIGHT_MM,
                },
            },
            shared: Axis {
                down: upright,
                ..Axis::new(label(&x_name, &x_unit), if plan { Range::Tight } else { x_range })
            },
            panels: vec![Panel { axis: own, marks, keys: Vec::new() }],
            hole: Vec::new(),
        }
    }
}

/// Whether a column is a position in space; two of them have the same scale.
fn is_position(quantity: &Quantity) -> bool {
    quantity.column.source == Source::Path && POSITIONS.contains(&quantity.column.name)
}

/// Depth is drawn over the range of its data, time over the requested range, other quantities from
/// zero.
fn range(name: &str, figure: &Figure, curves: &[Curve]) -> Range {
    let window_s = match figure.data {
        FigureData::Rows { window_s, .. } | FigureData::Depths { window_s, .. } => window_s,
        _ => None,
    };
    let times = curves.iter().flat_map(|curve| &curve.points);
    let last_s = times.map(|(time_s, _)| *time_s).fold(0.0, f64::max);
    let [from_s, to_s] = window_s.unwrap_or([0.0, last_s]);
    if name == "time_s" && last_s > from_s {
        Range::Fixed(from_s, to_s.min(last_s * (1.0 + 1e-2)))
    } else if is_depth(name) {
        Range::Tight
    } else {
        Range::Zero
    }
}

// Contact over time and depth, as a map for each case.

/// The maps, one below the other.
fn map_picture(
    StudyFigure { figure, curves, sweeps, units }: StudyFigure<'_>,
    colour: &Quantity,
) -> Picture {
    let (name, dimension) = (colour.column.name, colour.column.dimension);
    let (symbol, worth) = unit(dimension, name, units);
    let (length, metre) = unit(Some(Dimension::Length), "", units);
    let hue = match name == "side_force_N_per_m" && !colour.magnitude {
        true => Hue::Side,
        false => Hue::Amount,
    };
    let styles = CurveStyles::of(curves, sweeps, units, figure);
    let of_curve = |curve: &Curve| {
        let map = curve.map.as_ref()?;
        let mut ends: Vec<f64> = curve.points.iter().map(|(time_s, _)| *time_s).collect();
        ends.dedup();
        let stretches = curve.points.len() / ends.len();
        // The string moves down as it drills; this is the mean position of each stretch.
        let middle = |stretch: usize| {
            let depths = map.depths_m.iter().skip(stretch).step_by(stretches);
            depths.sum::<f64>() / (ends.len() as f64 * metre)
        };
        let case = match curves.len() {
            1 => "Measured depth".to_owned(),
            _ => styles.name(curve),
        };
        Some(ContactMap {
            label: label(&case, &length),
            from: map.from_s,
            middles: (0..stretches).map(middle).collect(),
            values: curve.points.iter().map(|(_, si)| si / worth).collect(),
            window_from: map.window_from_s,
            shoes: map.shoes_m.iter().map(|si| si / metre).collect(),
            marks: levels(figure, metre),
            ends,
        })
    };
    contact_figure(
        figure.title.clone(),
        String::new(),
        (&label(&title(colour), &symbol), hue),
        curves.iter().filter_map(of_curve).collect(),
    )
}
