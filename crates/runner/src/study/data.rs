//! Data of a figure as a table.

use wholestring_results::{Column, Table};
use wholestring_study::{Figure, FigureData};

use super::{
    curve::Curve,
    results::{CaseResults, keys_of},
};

/// Data of the curves, a row per point, SI.
pub(super) fn table(
    figure: &Figure,
    curves: &[Curve],
    results: &CaseResults,
    sweeps: &[String],
) -> Table {
    let mut points: Vec<(&Curve, f64, f64)> = Vec::new();
    for curve in curves {
        points.extend(curve.points.iter().map(|(x, y)| (curve, *x, *y)));
    }
    let text = |name: &str, value: &dyn Fn(&Curve) -> String| {
        Column::words(name, points.iter().map(|(curve, ..)| value(curve)).collect())
    };
    let number = |name: &str, values: Vec<f64>| {
        Column::numbers(name, values.into_iter().map(Some).collect())
    };
    let mut columns = vec![
        text("sweep", &|curve| sweeps[curve.series.0].clone()),
        text("model", &|curve| curve.series.1.name().to_owned()),
        text("operation", &|curve| curve.series.2.name().to_owned()),
    ];
    let axis = match &figure.data {
        FigureData::Summary { x, .. } => x.key.as_str(),
        FigureData::Rows { x, .. } | FigureData::Times { x, .. } | FigureData::Depths { x, .. } => {
            x.column.name
        }
        FigureData::Map { .. } => "time_s",
    };
    for key in keys_of(results.chosen(&figure.chosen)).iter().filter(|key| *key != axis) {
        columns.push(text(key, &|curve| {
            let found = curve.values.iter().find(|(name, _)| name == key);
            found.map_or_else(String::new, |(_, value)| value.clone())
        }));
    }
    let at =
        |name| number(name, points.iter().map(|point| point.0.at.unwrap_or(f64::NAN)).collect());
    match figure.data {
        FigureData::Times { .. } => columns.push(at("frame_s")),
        FigureData::Depths { .. } => columns.push(at("depth_m")),
        _ => {}
    }
    let x = number(axis, points.iter().map(|(_, x, _)| *x).collect());
    columns.push(x);
    if let FigureData::Map { .. } = figure.data {
        let maps = curves.iter().filter_map(|curve| curve.map.as_ref());
        columns.push(number("md_m", maps.flat_map(|map| map.depths_m.iter().copied()).collect()));
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
