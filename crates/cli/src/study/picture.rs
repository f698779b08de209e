//! A figure of a study as a picture.

use wholestring_case::study::{Figure, FigureData, Source};
use wholestring_report::figure::{
    Axis, Direction, Figure as Picture, Ink, Key, Layout, Mark, Panel, Range, Sample, Shape, Stroke,
};
use wholestring_units::{Dimension, UnitSet};

use super::{
    answers::{Series, names},
    columns::{is_depth, label, title, unit},
    figure::{Curve, rank},
};

/// Size of a figure, and the height of one in which depth points down.
const WIDTH_MM: f64 = 180.0;
const HEIGHT_MM: f64 = 90.0;
const TALL_MM: f64 = 120.0;

/// Curves of more points than this are lines without dots.
const MOST_DOTS: usize = 60;

/// The figure as the text of an SVG file.
pub(super) fn draw(figure: &Figure, curves: &[Curve], sweeps: &[String], units: UnitSet) -> String {
    let y = &figure.y[0];
    let (y_unit, y_worth) = unit(y.column.dimension, y.column.name, units);
    let (x_name, x_range, (x_unit, x_worth)) = match &figure.data {
        FigureData::Summary { x, .. } => (
            x.key.replace(['_', '.'], " "),
            Range::Tight,
            unit(x.dimension, "", units),
        ),
        FigureData::Rows { x, .. } | FigureData::Times { x, .. } | FigureData::Depths { x, .. } => {
            (
                title(x),
                range(x.column.name),
                unit(x.column.dimension, x.column.name, units),
            )
        }
    };
    let y_names: Vec<String> = figure.y.iter().map(title).collect();
    let looks = Looks::of(curves, sweeps, units, figure);
    let mut marks: Vec<Mark> = figure
        .levels
        .iter()
        .map(|level| Mark::OwnRule {
            at: level.value / y_worth,
            label: level.label.clone(),
        })
        .collect();
    for curve in curves {
        let (colour, stroke) = looks.of_curve(curve);
        let points: Vec<(f64, f64)> = curve
            .points
            .iter()
            .map(|(x, y)| (x / x_worth, y / y_worth))
            .collect();
        let (ink, shape) = (Ink::Line(colour), Shape::Circle);
        // Nodes between the joints of a string touch nothing: a line would fill the picture.
        let single = matches!(figure.data, FigureData::Times { .. });
        if single || points.len() <= MOST_DOTS {
            let points = points.clone();
            marks.push(Mark::Points { ink, shape, points });
        }
        if !single {
            marks.push(Mark::Curve {
                ink,
                stroke,
                points,
            });
        }
    }
    // A depth against which nothing else is drawn points down the page.
    let down = y.column.source != Source::Summary && is_depth(y.column.name);
    let own = Axis {
        down,
        ..Axis::new(
            label(&y_names.join(", "), &y_unit),
            if down { Range::Tight } else { Range::Zero },
        )
    };
    Picture {
        title: figure.title.clone(),
        subtitle: String::new(),
        keys: looks.keys(),
        layout: Layout {
            direction: Direction::Across,
            columns: 1,
            width_mm: WIDTH_MM,
            panel_mm: if down { TALL_MM } else { HEIGHT_MM },
        },
        shared: Axis::new(label(&x_name, &x_unit), x_range),
        panels: vec![Panel {
            axis: own,
            marks,
            keys: Vec::new(),
        }],
        hole: Vec::new(),
    }
    .drawing()
    .svg()
}

/// Depth and time reach as far as they go, all else to zero.
fn range(name: &str) -> Range {
    if name == "time_s" || is_depth(name) {
        Range::Tight
    } else {
        Range::Zero
    }
}

/// Curves differ by colour in what they show, and by stroke in who says it.
struct Looks {
    series: Vec<Series>,
    series_names: Vec<String>,
    /// What curves show, by colour.
    shown: Vec<String>,
    shown_of: Box<dyn Fn(&Curve) -> String>,
}

impl Looks {
    fn of(curves: &[Curve], sweeps: &[String], units: UnitSet, figure: &Figure) -> Self {
        let mut series: Vec<Series> = Vec::new();
        for curve in curves {
            if !series.contains(&curve.series) {
                series.push(curve.series.clone());
            }
        }
        // Dynamics are drawn full, the soft string beside them dashed.
        series.sort_by_key(rank);
        let by_time = matches!(figure.data, FigureData::Times { .. });
        let several = figure.y.len() > 1;
        let statistics =
            matches!(&figure.data, FigureData::Summary { statistics, .. } if statistics.len() > 1);
        let fixed: Vec<String> = constant(curves);
        let shown_of = move |curve: &Curve| {
            let mut parts: Vec<String> = Vec::new();
            if several {
                parts.push(title(&curve.quantity));
            }
            if let (true, Some(statistic)) = (statistics, curve.statistic) {
                parts.push(statistic.name());
            }
            let values = curve.values.iter().filter(|(key, _)| !fixed.contains(key));
            parts.extend(
                values.map(|(key, value)| format!("{} {}", key.replace('_', " "), apart(value))),
            );
            if let Some(at) = curve.at {
                parts.push(match by_time {
                    true => format!("{at:.2} s"),
                    false => Dimension::Length.format(at, units),
                });
            }
            parts.join(", ")
        };
        let mut shown: Vec<String> = Vec::new();
        for curve in curves {
            let name = shown_of(curve);
            if !shown.contains(&name) {
                shown.push(name);
            }
        }
        Self {
            series_names: names(&series, sweeps),
            series,
            shown,
            shown_of: Box::new(shown_of),
        }
    }

    /// Whether strokes are enough to tell the series apart.
    fn by_stroke(&self) -> bool {
        self.series.len() <= 2 && self.shown.len() > 1
    }

    fn of_curve(&self, curve: &Curve) -> (usize, Stroke) {
        let series = self
            .series
            .iter()
            .position(|of| *of == curve.series)
            .unwrap_or(0);
        let name = (self.shown_of)(curve);
        let shown = self.shown.iter().position(|of| *of == name).unwrap_or(0);
        let stroke = |second: bool| {
            if second {
                Stroke::Dashed
            } else {
                Stroke::Solid
            }
        };
        match self.by_stroke() {
            true => (shown, stroke(series == 1)),
            false => (series * self.shown.len() + shown, stroke_of(&curve.series)),
        }
    }

    fn keys(&self) -> Vec<Key> {
        let key = |name: String, ink, stroke| Key {
            name,
            sample: Sample::Line(ink, stroke),
        };
        if self.by_stroke() {
            let shown = self.shown.iter().enumerate();
            let shown = shown.map(|(i, name)| key(name.clone(), Ink::Line(i), Stroke::Solid));
            let strokes = [Stroke::Solid, Stroke::Dashed];
            let series = self.series_names.iter().zip(strokes);
            let series = series.filter(|_| self.series.len() > 1);
            return shown
                .chain(series.map(|(name, stroke)| key(name.clone(), Ink::Note, stroke)))
                .collect();
        }
        let mut keys = Vec::new();
        for (i, series) in self.series.iter().enumerate() {
            for (j, shown) in self.shown.iter().enumerate() {
                let both = [&self.series_names[i], shown].map(String::as_str);
                let told: Vec<&str> = both.into_iter().filter(|name| !name.is_empty()).collect();
                let ink = Ink::Line(i * self.shown.len() + j);
                keys.push(key(told.join(", "), ink, stroke_of(series)));
            }
        }
        keys
    }
}

/// Dynamics are drawn full, the soft string dashed.
fn stroke_of(series: &Series) -> Stroke {
    match rank(series) {
        0 => Stroke::Solid,
        _ => Stroke::Dashed,
    }
}

/// A value with a blank before its unit: `300m` as `300 m`.
fn apart(value: &str) -> String {
    let ends = value
        .char_indices()
        .map(|(at, letter)| at + letter.len_utf8());
    let number = ends.rev().find(|end| value[..*end].parse::<f64>().is_ok());
    match number.map(|end| value.split_at(end)) {
        Some((number, unit)) if unit.starts_with(char::is_alphabetic) => format!("{number} {unit}"),
        _ => value.to_owned(),
    }
}

/// Keys whose value is the same for all curves.
fn constant(curves: &[Curve]) -> Vec<String> {
    let keys = curves
        .iter()
        .flat_map(|curve| curve.values.iter().map(|(key, _)| key));
    let mut all: Vec<String> = keys.cloned().collect();
    all.sort();
    all.dedup();
    all.retain(|key| {
        let values = curves.iter().flat_map(|curve| &curve.values);
        let mut values = values
            .filter(|(name, _)| name == key)
            .map(|(_, value)| value);
        let first = values.next();
        values.all(|value| Some(value) == first)
    });
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_stand_apart_from_their_units() {
        for (value, expected) in [
            ("300m", "300 m"),
            ("4305 m", "4305 m"),
            ("0.3", "0.3"),
            ("drill", "drill"),
            ("6tf", "6 tf"),
        ] {
            assert_eq!(apart(value), expected);
        }
    }
}
