//! Data of the curves of a figure.

use wholestring_report::study::{Curve, MapData};
use wholestring_results::ResultsError;
use wholestring_study::{Figure, FigureData, Quantity, Source, Statistic};

use super::{
    frames::{at_depth, at_times, signed, within},
    results::{CaseResult, CaseResults},
};

/// All curves of a figure.
pub(super) fn curves(figure: &Figure, results: &CaseResults) -> Result<Vec<Curve>, ResultsError> {
    let chosen: Vec<&CaseResult> = results.chosen(&figure.chosen).collect();
    let mut curves = Vec::new();
    for quantity in &figure.y {
        match &figure.data {
            FigureData::Summary { x, statistics } => {
                for statistic in statistics {
                    for result in &chosen {
                        let place = result.value(&x.key).and_then(|value| x.number(value));
                        let value = result.summary(quantity, *statistic);
                        // A soft string has no spread, so its curve is left out.
                        if let (Some(place), Some(value)) = (place, value) {
                            let mut curve = blank(result, Some(&x.key), quantity, Some(*statistic));
                            curve.points.push((place, value));
                            if result.has_error() {
                                curve.errors.push((place, value));
                            }
                            put(&mut curves, curve);
                        }
                    }
                }
            }
            FigureData::Rows { x, window_s } => {
                for result in &chosen {
                    let mut curve = blank(result, None, quantity, None);
                    curve.points = rows(result, x, quantity, *window_s)?;
                    // Most cases have the same well, which is drawn once.
                    let again =
                        |other: &Curve| other.quantity == *quantity && other.points == curve.points;
                    if quantity.column.source != Source::Path || !curves.iter().any(again) {
                        curves.push(curve);
                    }
                }
            }
            FigureData::Times { x, times_s } => {
                for result in &chosen {
                    for (at, points) in at_times(result, x, quantity, times_s)? {
                        let mut curve = blank(result, None, quantity, None);
                        (curve.at, curve.points) = (Some(at), points);
                        curves.push(curve);
                    }
                }
            }
            FigureData::Map { colour, window_s } => {
                for result in &chosen {
                    let mut curve = blank(result, None, colour, None);
                    let (points, map) = map(result, colour, *window_s)?;
                    (curve.points, curve.map) = (points, Some(map));
                    curves.push(curve);
                }
            }
            FigureData::Depths { x, depths_m, window_s } => {
                for result in &chosen {
                    for depth_m in depths_m {
                        let mut curve = blank(result, None, quantity, None);
                        curve.at = Some(*depth_m);
                        let rows = at_depth(result, *depth_m, *window_s, [x, quantity])?;
                        curve.points = rows.iter().map(|(_, [x, y])| (*x, *y)).collect();
                        curves.push(curve);
                    }
                }
            }
        }
    }
    curves.retain(|curve| !curve.points.is_empty());
    Ok(curves)
}

fn blank(
    result: &CaseResult,
    axis: Option<&str>,
    quantity: &Quantity,
    statistic: Option<Statistic>,
) -> Curve {
    let all = result.keys.iter().zip(&result.values);
    let others = all.filter(|(key, _)| axis != Some(key.as_str()));
    Curve {
        series: result.series(),
        values: others.map(|(key, value)| (key.clone(), value.clone())).collect(),
        quantity: *quantity,
        statistic,
        at: None,
        points: Vec::new(),
        errors: Vec::new(),
        map: None,
    }
}

/// Appends the points of a curve to the matching one, or adds it.
fn put(curves: &mut Vec<Curve>, like: Curve) {
    let alike = |curve: &&mut Curve| {
        curve.series == like.series
            && curve.values == like.values
            && curve.quantity == like.quantity
            && curve.statistic == like.statistic
    };
    match curves.iter_mut().find(alike) {
        Some(curve) => {
            curve.points.extend(like.points);
            curve.errors.extend(like.errors);
        }
        None => curves.push(like),
    }
}

fn rows(
    result: &CaseResult,
    x: &Quantity,
    y: &Quantity,
    window_s: Option<[f64; 2]>,
) -> Result<Vec<(f64, f64)>, ResultsError> {
    let (source, columns) = (y.column.source, [x.column.name, y.column.name]);
    if source == Source::Time {
        let rows = result.rows(source, [columns[0], columns[1], "time_s"])?;
        let in_window = rows.iter().filter(|[_, _, time_s]| within(window_s, *time_s));
        return Ok(in_window.map(|[a, b, _]| (signed(x, *a), signed(y, *b))).collect());
    }
    let rows = result.rows(source, columns)?;
    Ok(rows.iter().map(|[a, b]| (signed(x, *a), signed(y, *b))).collect())
}

/// Times and values of a map.
fn map(
    result: &CaseResult,
    colour: &Quantity,
    window_s: Option<[f64; 2]>,
) -> Result<(Vec<(f64, f64)>, MapData), ResultsError> {
    let rows = result.rows(Source::Contact, ["time_s", "md_m", colour.column.name])?;
    let [from_s, to_s] = window_s.unwrap_or([0.0, f64::INFINITY]);
    // A row is an average since the one before, so a row that ends at the start of the window is
    // outside it.
    let before = rows.iter().map(|[time_s, ..]| *time_s);
    let before = before.take_while(|time_s| *time_s <= from_s + 1e-6);
    let from_s = before.fold(0.0, f64::max);
    let mut depths_m = Vec::new();
    let mut points = Vec::new();
    let seen = |time_s: f64| time_s > from_s && time_s <= to_s + 1e-6;
    for [time_s, md_m, value] in rows.into_iter().filter(|[time_s, ..]| seen(*time_s)) {
        depths_m.push(md_m);
        points.push((time_s, signed(colour, value)));
    }
    let map = MapData {
        depths_m,
        from_s,
        window_from_s: result.window_from_s()?,
        shoes_m: result.shoes_m()?,
    };
    Ok((points, map))
}
