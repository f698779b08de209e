//! A figure of a study as a picture.

use wholestring_case::study::{Figure, FigureData, Source};
use wholestring_report::{Chart, Curve as Line, Entry, Level, Scale, Stroke, chart_svg};
use wholestring_units::{Dimension, UnitSet};

use super::{
    answers::{Series, names},
    columns::{is_depth, label, title, unit},
    figure::{Curve, rank},
};

/// The figure as the text of an SVG file.
pub(super) fn draw(figure: &Figure, curves: &[Curve], sweeps: &[String], units: UnitSet) -> String {
    let y = &figure.y[0];
    let (y_unit, y_worth) = unit(y.column.dimension, y.column.name, units);
    let (x_name, x_depth, (x_unit, x_worth)) = match &figure.data {
        FigureData::Summary { x, .. } => (
            x.key.replace(['_', '.'], " "),
            true,
            unit(x.dimension, "", units),
        ),
        FigureData::Rows { x, .. } | FigureData::Times { x, .. } | FigureData::Depths { x, .. } => {
            let exact = x.column.name == "time_s" || is_depth(x.column.name);
            (
                title(x),
                exact,
                unit(x.column.dimension, x.column.name, units),
            )
        }
    };
    let y_names: Vec<String> = figure.y.iter().map(title).collect();
    let looks = Looks::of(curves, sweeps, units, figure);
    chart_svg(&Chart {
        title: figure.title.clone(),
        subtitle: String::new(),
        x: Scale {
            label: label(&x_name, &x_unit),
            exact: x_depth,
        },
        y: Scale {
            label: label(&y_names.join(", "), &y_unit),
            exact: y.column.source != Source::Summary && is_depth(y.column.name),
        },
        legend: looks.entries(),
        curves: curves
            .iter()
            .map(|curve| {
                let (colour, stroke) = looks.of_curve(curve);
                Line {
                    colour,
                    stroke,
                    points: curve
                        .points
                        .iter()
                        .map(|(x, y)| (x / x_worth, y / y_worth))
                        .collect(),
                }
            })
            .collect(),
        levels: figure
            .levels
            .iter()
            .map(|level| Level {
                label: level.label.clone(),
                value: level.value / y_worth,
            })
            .collect(),
    })
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
            false => (
                series * self.shown.len() + shown,
                stroke(rank(&curve.series) == 1),
            ),
        }
    }

    fn entries(&self) -> Vec<Entry> {
        let entry = |name: String, colour, stroke| Entry {
            name,
            colour,
            stroke,
        };
        if self.by_stroke() {
            let shown = self.shown.iter().enumerate();
            let colours = shown.map(|(i, name)| entry(name.clone(), Some(i), Stroke::Solid));
            let strokes = [Stroke::Solid, Stroke::Dashed];
            let series = self.series_names.iter().zip(strokes);
            let series = series.filter(|_| self.series.len() > 1);
            return colours
                .chain(series.map(|(name, stroke)| entry(name.clone(), None, stroke)))
                .collect();
        }
        let mut entries = Vec::new();
        for (i, series) in self.series.iter().enumerate() {
            let stroke = if rank(series) == 1 {
                Stroke::Dashed
            } else {
                Stroke::Solid
            };
            for (j, shown) in self.shown.iter().enumerate() {
                let both = [&self.series_names[i], shown].map(String::as_str);
                let told: Vec<&str> = both.into_iter().filter(|name| !name.is_empty()).collect();
                entries.push(entry(
                    told.join(", "),
                    Some(i * self.shown.len() + j),
                    stroke,
                ));
            }
        }
        entries
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
