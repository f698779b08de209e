//! A figure of a study: its curves, and the labels of their quantities.

use wholestring::{
    operation::OperationKind,
    outcome::{self, ModelKind, SCALARS, TIME_SERIES, WELL_PATH},
};
use wholestring_results::{CONTACT, Column, FRAMES, NODES, TIME, Table, WEAR};
use wholestring_study::{Figure, FigureData, Quantity, Statistic};
use wholestring_units::{Dimension, UnitSet};

use super::StudyPart;
use crate::{cell::capital, dimensions::pretty_symbol, figure::Figure as Picture};

/// Identity of a result apart from its case: its sweep, the model and the operation. A column of a
/// table, a line style of a figure.
pub type Series = (usize, ModelKind, OperationKind);

/// A curve with all properties that distinguish it from the others.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Its series.
    pub series: Series,
    /// Values of the keys that are not on the axis.
    pub values: Vec<(String, String)>,
    /// The column, and the operations applied to it.
    pub quantity: Quantity,
    /// The statistic; `None` for values of one time or place.
    pub statistic: Option<Statistic>,
    /// Time, s, or depth, m, of the curve.
    pub at: Option<f64>,
    /// Points, SI; NaN for a missing value.
    pub points: Vec<(f64, f64)>,
    /// Points whose case has an error.
    pub errors: Vec<(f64, f64)>,
    /// Additional data of a map; `None` for a curve.
    pub map: Option<MapData>,
}

/// Additional data of a map. The points of a map are times and values, row after row in time.
#[derive(Debug, Clone, PartialEq)]
pub struct MapData {
    /// Depth of each point, m.
    pub depths_m: Vec<f64>,
    /// Start of the first row, s.
    pub from_s: f64,
    /// Start of the window of the statistics, s.
    pub window_from_s: f64,
    /// Depths of the casing shoes, m.
    pub shoes_m: Vec<f64>,
}

/// A figure of a study with its curves.
#[derive(Debug, Clone, Copy)]
pub struct StudyFigure<'a> {
    /// The figure.
    pub figure: &'a Figure,
    /// Its curves.
    pub curves: &'a [Curve],
    /// Names of the sweeps of the study.
    pub sweeps: &'a [String],
    /// Units of its axes.
    pub units: UnitSet,
}

impl StudyFigure<'_> {
    /// The figure as it is on the page; its files are in `figures`.
    pub fn part(&self, picture: Picture, painted: bool) -> StudyPart {
        StudyPart::Figure {
            title: self.figure.title.clone(),
            caption: self.figure.caption.clone(),
            figure: (!self.curves.is_empty()).then(|| Box::new(picture)),
            files: format!("figures/{}", self.figure.name),
            painted,
        }
    }

    /// Data of the curves, a row per point, SI; `keys` are those that the results vary.
    pub fn data(&self, keys: &[String]) -> Table {
        let mut points: Vec<(&Curve, f64, f64)> = Vec::new();
        for curve in self.curves {
            points.extend(curve.points.iter().map(|(x, y)| (curve, *x, *y)));
        }
        let text = |name: &str, value: &dyn Fn(&Curve) -> String| {
            Column::words(name, points.iter().map(|(curve, ..)| value(curve)).collect())
        };
        let number = |name: &str, values: Vec<f64>| {
            Column::numbers(name, values.into_iter().map(Some).collect())
        };
        let mut columns = vec![
            text("sweep", &|curve| self.sweeps[curve.series.0].clone()),
            text("model", &|curve| curve.series.1.name().to_owned()),
            text("operation", &|curve| curve.series.2.name().to_owned()),
        ];
        let axis = match &self.figure.data {
            FigureData::Summary { x, .. } => x.key.as_str(),
            FigureData::Rows { x, .. }
            | FigureData::Times { x, .. }
            | FigureData::Depths { x, .. } => x.column.name,
            FigureData::Map { .. } => "time_s",
        };
        for key in keys.iter().filter(|key| *key != axis) {
            columns.push(text(key, &|curve| {
                let found = curve.values.iter().find(|(name, _)| name == key);
                found.map_or_else(String::new, |(_, value)| value.clone())
            }));
        }
        let at = |name| {
            number(name, points.iter().map(|point| point.0.at.unwrap_or(f64::NAN)).collect())
        };
        match self.figure.data {
            FigureData::Times { .. } => columns.push(at("frame_s")),
            FigureData::Depths { .. } => columns.push(at("depth_m")),
            _ => {}
        }
        let x = number(axis, points.iter().map(|(_, x, _)| *x).collect());
        columns.push(x);
        if let FigureData::Map { .. } = self.figure.data {
            let maps = self.curves.iter().filter_map(|curve| curve.map.as_ref());
            columns
                .push(number("md_m", maps.flat_map(|map| map.depths_m.iter().copied()).collect()));
        }
        columns.push(text("quantity", &|curve| {
            let name = curve.quantity.column.name;
            let name = if curve.quantity.magnitude { format!("|{name}|") } else { name.to_owned() };
            match curve.statistic {
                Some(statistic) => format!("{name} {}", statistic.name()),
                None => name,
            }
        }));
        columns.push(number("value", points.iter().map(|(.., y)| *y).collect()));
        Table::new(columns)
    }
}

/// Names of series, by the properties that distinguish them.
pub(super) fn names(series: &[Series], sweeps: &[String]) -> Vec<String> {
    let differ = |part: &dyn Fn(&Series) -> String| {
        let mut all: Vec<String> = series.iter().map(part).collect();
        all.sort();
        all.dedup();
        all.len() > 1
    };
    let parts: [&dyn Fn(&Series) -> String; 3] = [
        &|(sweep, _, _)| sweeps[*sweep].clone(),
        &|(_, model, _)| model.method().long_name.into(),
        &|(_, _, operation)| operation.words().to_owned(),
    ];
    let mut differing: Vec<_> = parts.iter().filter(|part| differ(part)).collect();
    if differing.is_empty() {
        differing.push(&parts[1]);
    }
    let name =
        |series: &Series| differing.iter().map(|part| part(series)).collect::<Vec<_>>().join(", ");
    series.iter().map(name).collect()
}

/// Declaration of a column by its name, which has one meaning in all sources.
fn named(name: &str) -> Option<outcome::Quantity> {
    let in_time = TIME_SERIES.iter().map(|series| series.quantity);
    let scalars = SCALARS.iter().map(|scalar| scalar.quantity).chain(in_time);
    let tables = [NODES, WEAR, TIME, FRAMES, CONTACT].into_iter().flatten().copied();
    let path = WELL_PATH.iter().map(|column| column.quantity);
    scalars.chain(tables).chain(path).find(|quantity| quantity.name == name)
}

/// Label of a column: `hook load`.
fn words(name: &str) -> String {
    if name == "cutoff_depth_m" {
        return "cut-off depth".to_owned();
    }
    named(name).map_or_else(|| name.replace('_', " "), |quantity| quantity.words())
}

/// Label of a quantity, without its unit.
pub(super) fn title(quantity: &Quantity) -> String {
    let words = words(quantity.column.name);
    match quantity.magnitude {
        true => format!("magnitude of {words}"),
        false => words,
    }
}

/// Display unit of a quantity, and its value in SI.
pub(super) fn unit(dimension: Option<Dimension>, name: &str, units: UnitSet) -> (String, f64) {
    if let Some(dimension) = dimension {
        let unit = dimension.unit_in(units);
        return (pretty_symbol(unit.symbol), unit.factor);
    }
    let plain = named(name).map_or("", |quantity| quantity.unit);
    (plain.to_owned(), 1.0)
}

/// Label of a name and its unit, with a capital: `Hook load, kN`.
pub(super) fn label(name: &str, unit: &str) -> String {
    match unit {
        "" => capital(name),
        unit => format!("{}, {unit}", capital(name)),
    }
}

/// Whether the column is a depth, which is drawn downwards and, as for time, without margins.
pub(super) fn is_depth(name: &str) -> bool {
    matches!(name, "md_m" | "tvd_m" | "bit_depth_m" | "cutoff_depth_m")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_column_has_the_words_of_its_declaration() {
        for (name, expected) in [
            ("hook_load_N", "hook load"),
            ("twist_rad", "twist"),
            ("side_force_N_per_m", "side force"),
            ("friction_torque_N_m_per_m", "friction torque"),
            ("wear_work_J_per_m", "wear work"),
            ("time_s", "time"),
            ("contact_force_N", "contact force"),
            ("dogleg_severity_rad_per_m", "dogleg severity"),
            ("md_m", "measured depth"),
        ] {
            assert_eq!(words(name), expected);
        }
        assert_eq!(label("hook load", "kN"), "Hook load, kN");
        assert_eq!(unit(None, "wear_work_J_per_m", UnitSet::Field), ("J/m".into(), 1.0));
    }
}
