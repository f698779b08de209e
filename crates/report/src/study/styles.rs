//! Styles of the curves of a study, and the properties that distinguish them.

use wholestring_study::{Figure, FigureData, Level, Source};
use wholestring_units::{Dimension, UnitSet};

use super::figure::{Curve, Series, names, title};
use crate::figure::{Ink, Key, Mark, Sample, Stroke};

/// Curve styles: the colour distinguishes the content, the line style the series.
pub(super) struct CurveStyles {
    series: Vec<Series>,
    series_names: Vec<String>,
    /// Names of the contents, by colour.
    shown: Vec<String>,
    shown_of: Box<dyn Fn(&Curve) -> String>,
}

impl CurveStyles {
    pub(super) fn of(curves: &[Curve], sweeps: &[String], units: UnitSet, figure: &Figure) -> Self {
        let mut series: Vec<Series> = Vec::new();
        for curve in curves {
            if !series.contains(&curve.series) {
                series.push(curve.series);
            }
        }
        // Dynamics are drawn solid, the soft string dashed.
        series.sort_by_key(|series| series.1.rank());
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
        let of_path = figure.y[0].column.source == Source::Path;
        Self {
            series_names: match &series[..] {
                // The well is the same for all models.
                [_] if of_path => vec![String::new()],
                _ => names(&series, sweeps),
            },
            series,
            shown,
            shown_of: Box::new(shown_of),
        }
    }

    /// Whether line styles are enough to distinguish the series.
    fn by_stroke(&self) -> bool {
        self.series.len() <= 2 && self.shown.len() > 1
    }

    /// Indices of its series and of its content.
    fn place(&self, curve: &Curve) -> (usize, usize) {
        let name = (self.shown_of)(curve);
        let series = self.series.iter().position(|series| *series == curve.series);
        let shown = self.shown.iter().position(|shown_name| *shown_name == name);
        (series.unwrap_or(0), shown.unwrap_or(0))
    }

    /// Name of a curve that distinguishes it from the others.
    pub(super) fn name(&self, curve: &Curve) -> String {
        let (series, shown) = self.place(curve);
        match self.series.len() {
            1 => self.shown[shown].clone(),
            _ => self.series_label(series, shown),
        }
    }

    /// A series and its content, in words.
    fn series_label(&self, series: usize, shown: usize) -> String {
        let both = [&self.series_names[series], &self.shown[shown]].map(String::as_str);
        let series_label: Vec<&str> = both.into_iter().filter(|name| !name.is_empty()).collect();
        series_label.join(", ")
    }

    pub(super) fn of_curve(&self, curve: &Curve) -> (usize, Stroke) {
        let (series, shown) = self.place(curve);
        let stroke = |second: bool| {
            if second { Stroke::Dashed } else { Stroke::Solid }
        };
        match self.by_stroke() {
            true => (shown, stroke(series == 1)),
            false => (series * self.shown.len() + shown, stroke_of(&curve.series)),
        }
    }

    pub(super) fn keys(&self) -> Vec<Key> {
        let key = |name: String, ink, stroke| Key { name, sample: Sample::Line(ink, stroke) };
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
            for j in 0..self.shown.len() {
                let ink = Ink::Line(i * self.shown.len() + j);
                keys.push(key(self.series_label(i, j), ink, stroke_of(series)));
            }
        }
        keys.retain(|key| !key.name.is_empty());
        keys
    }
}

/// Dynamics are drawn solid, the soft string dashed.
fn stroke_of(series: &Series) -> Stroke {
    match series.1.rank() {
        0 => Stroke::Solid,
        _ => Stroke::Dashed,
    }
}

/// Lines at the levels of the vertical axis; `worth` is its unit in SI.
pub(super) fn levels(figure: &Figure, worth: f64) -> Vec<Mark> {
    let levels = figure.levels.iter();
    let rule =
        |level: &Level| Mark::OwnRule { at: level.value / worth, label: level.label.clone() };
    levels.map(rule).collect()
}

/// A value with a space before its unit: `300m` as `300 m`.
fn apart(value: &str) -> String {
    let ends = value.char_indices().map(|(at, letter)| at + letter.len_utf8());
    let number = ends.rev().find(|end| value[..*end].parse::<f64>().is_ok());
    match number.map(|end| value.split_at(end)) {
        Some((number, unit)) if unit.starts_with(char::is_alphabetic) => format!("{number} {unit}"),
        _ => value.to_owned(),
    }
}

/// Keys with the same value in all curves.
fn constant(curves: &[Curve]) -> Vec<String> {
    let keys = curves.iter().flat_map(|curve| curve.values.iter().map(|(key, _)| key));
    let mut all: Vec<String> = keys.cloned().collect();
    all.sort();
    all.dedup();
    all.retain(|key| {
        let values = curves.iter().flat_map(|curve| &curve.values);
        let mut values = values.filter(|(name, _)| name == key).map(|(_, value)| value);
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
