//! The numbers of a table.

use wholestring::dynamics::Statistic as Distribution;
use wholestring_report::study::{Series, StudyTable};
use wholestring_results::ResultsError;
use wholestring_study::{Number, NumberTable, Row, Selection, Shape, Source, Statistic};
use wholestring_units::UnitSet;

use super::{
    frames::{at_depth, at_times},
    results::{CaseResult, CaseResults},
};

/// The numbers of a table.
pub(super) fn numbers<'a>(
    table: &'a NumberTable,
    results: &CaseResults,
    sweeps: &'a [String],
    units: UnitSet,
) -> Result<StudyTable<'a>, ResultsError> {
    let mut series = Vec::new();
    for key in table.rows.iter().flat_map(|row| results.series(&row.chosen)) {
        if !series.contains(&key) {
            series.push(key);
        }
    }
    series.sort_by_key(|(sweep, ..)| *sweep);
    let numbers = table.rows.iter().map(|row| {
        let row_series = results.series(&row.chosen);
        let number = |series: &Series| match row_series.contains(series) {
            true => computed(row, series, results),
            false => Ok(None),
        };
        series.iter().map(number).collect()
    });
    let numbers = numbers.collect::<Result<_, _>>()?;
    Ok(StudyTable { table, series, numbers, sweeps, units })
}

/// The number of a row for a series.
fn computed(
    row: &Row,
    series: &Series,
    results: &CaseResults,
) -> Result<Option<f64>, ResultsError> {
    let only = &row.chosen.only;
    let Some(mut value) = of_cases(row, series, results, only)? else {
        return Ok(None);
    };
    for (other, divide) in [(&row.less, false), (&row.over, true)] {
        let Some(other) = other else { continue };
        let Some(other) = of_cases(row, series, results, &only.narrowed(other))? else {
            return Ok(None);
        };
        value = if divide { value / other } else { value - other };
    }
    if let Some(model) = row.over_model {
        let (sweep, _, operation) = series;
        let Some(other) = of_cases(row, &(*sweep, model, *operation), results, only)? else {
            return Ok(None);
        };
        value /= other;
    }
    Ok(Some(value).filter(|value| value.is_finite()))
}

/// The number of one case, or a property of the numbers along a key.
fn of_cases(
    row: &Row,
    series: &Series,
    results: &CaseResults,
    only: &Selection,
) -> Result<Option<f64>, ResultsError> {
    let mut cases = results.of(series, only);
    let Some((key, shape)) = &row.along else {
        return match cases.next() {
            Some(result) => number(&row.number, result),
            None => Ok(None),
        };
    };
    let mut points = Vec::new();
    for result in cases {
        let place = result.value(key).and_then(quantity);
        if let (Some(place), Some(value)) = (place, number(&row.number, result)?) {
            points.push((place, value));
        }
    }
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    Ok(shape_of(*shape, &points))
}

/// Leading number of a value; the values of one key have the same unit.
fn quantity(value: &str) -> Option<f64> {
    let ends = value.char_indices().map(|(at, letter)| at + letter.len_utf8());
    let number = |end: usize| value[..end].trim().parse::<f64>().ok();
    ends.rev().find_map(number)
}

fn shape_of(shape: Shape, points: &[(f64, f64)]) -> Option<f64> {
    let values: Vec<f64> = points.iter().map(|(_, value)| *value).collect();
    match shape {
        Shape::Least => values.into_iter().reduce(f64::min),
        Shape::Most => values.into_iter().reduce(f64::max),
        Shape::Growth => {
            let steps = values.windows(2);
            let count = steps.len();
            let up = steps.filter(|pair| pair[1] > pair[0]).count();
            (count > 0).then(|| up as f64 / count as f64)
        }
        Shape::Linearity => {
            let n = points.len() as f64;
            let mean =
                |value: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(value).sum::<f64>() / n;
            let (x, y) = (mean(&|point| point.0), mean(&|point| point.1));
            let xy = mean(&|point| (point.0 - x) * (point.1 - y));
            let (xx, yy) =
                (mean(&|point| (point.0 - x).powi(2)), mean(&|point| (point.1 - y).powi(2)));
            (points.len() > 2 && xx * yy > 0.0).then(|| xy * xy / (xx * yy))
        }
    }
}

/// The number in one result.
fn number(number: &Number, result: &CaseResult) -> Result<Option<f64>, ResultsError> {
    let quantity = &number.quantity;
    let source = quantity.column.source;
    let name = quantity.column.name;
    let window_s = || -> Result<[f64; 2], ResultsError> {
        match number.window_s {
            Some(window_s) => Ok(window_s),
            None => Ok([result.window_from_s()?, f64::INFINITY]),
        }
    };
    let values: Vec<f64> = match source {
        Source::Summary => return Ok(result.summary(quantity, number.statistic)),
        Source::Nodes | Source::Wear | Source::Path => {
            let rows = result.rows(source, ["md_m", name])?;
            match number.depth_m {
                Some(depth_m) => nearest(rows.into_iter().map(|[md, value]| (md, value)), depth_m),
                None => rows.into_iter().map(|[_, value]| value).collect(),
            }
        }
        Source::Time => {
            let rows = result.rows(source, ["time_s", name])?.into_iter();
            match number.time_s {
                Some(time_s) => nearest(rows.map(|[at, value]| (at, value)), time_s),
                None => {
                    let [from, to] = window_s()?;
                    rows.filter(|[at, _]| (from..=to).contains(at))
                        .map(|[_, value]| value)
                        .collect()
                }
            }
        }
        Source::Contact => {
            let rows = result.rows(source, ["time_s", "md_m", name])?;
            let rows = match number.time_s {
                Some(time_s) => nearest_by(rows, time_s, |[at, ..]| *at),
                None => {
                    let [from, to] = window_s()?;
                    // A row is an average since the one before, so a row that ends at the start of
                    // the window is outside it.
                    let mut rows = rows;
                    rows.retain(|[at, ..]| *at > from && *at <= to);
                    rows
                }
            };
            let rows = match number.depth_m {
                Some(depth_m) => rows
                    .chunk_by(|a, b| a[0] == b[0])
                    .flat_map(|row| nearest_by(row.to_vec(), depth_m, |[_, md, _]| *md))
                    .collect(),
                None => rows,
            };
            rows.into_iter().map(|[.., value]| value).collect()
        }
        Source::Frames => match (number.depth_m, number.time_s) {
            (Some(depth_m), None) => {
                let rows = at_depth(result, depth_m, Some(window_s()?), [quantity])?;
                rows.into_iter().map(|(_, [value])| value).collect()
            }
            (Some(depth_m), Some(time_s)) => {
                let rows = at_depth(result, depth_m, None, [quantity])?;
                nearest(rows.into_iter().map(|(at, [value])| (at, value)), time_s)
            }
            (None, time_s) => {
                let times = [time_s.unwrap_or_default()];
                let frames = at_times(result, quantity, quantity, &times)?;
                let points = frames.into_iter().flat_map(|(_, points)| points);
                points.map(|(_, value)| value).collect()
            }
        },
    };
    let finite = values.into_iter().filter(|value| value.is_finite());
    let values: Vec<f64> = match quantity.magnitude {
        true => finite.map(f64::abs).collect(),
        false => finite.collect(),
    };
    Ok(statistic(number.statistic, &values))
}

/// Value at the nearest position.
fn nearest(rows: impl Iterator<Item = (f64, f64)>, target: f64) -> Vec<f64> {
    let valid = rows.filter(|(_, value)| value.is_finite());
    let best = valid.min_by(|a, b| (a.0 - target).abs().total_cmp(&(b.0 - target).abs()));
    best.into_iter().map(|(_, value)| value).collect()
}

/// Rows at the nearest position.
fn nearest_by(
    mut rows: Vec<[f64; 3]>,
    target: f64,
    place: impl Fn(&[f64; 3]) -> f64,
) -> Vec<[f64; 3]> {
    let off = |row: &[f64; 3]| (place(row) - target).abs();
    let least = rows.iter().map(off).fold(f64::INFINITY, f64::min);
    rows.retain(|row| off(row) <= least);
    rows
}

fn statistic(statistic: Statistic, values: &[f64]) -> Option<f64> {
    let distribution = Distribution::of(values)?;
    Some(match statistic {
        Statistic::Mean => distribution.mean,
        Statistic::Std => distribution.std,
        Statistic::MeanPlusStd => distribution.mean + distribution.std,
        Statistic::Min => distribution.min,
        Statistic::Max => distribution.max,
        Statistic::Percentile(percent) => Distribution::percentile(values, percent / 100.0)?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shapes_of_numbers_along_a_key() {
        let points: Vec<(f64, f64)> =
            (0..10).map(|i| (f64::from(i), 3.0 + 2.0 * f64::from(i))).collect();
        assert!((shape_of(Shape::Linearity, &points).unwrap() - 1.0).abs() < 1e-12);
        assert_eq!(shape_of(Shape::Growth, &points), Some(1.0));
        let bent = [(0.0, 0.0), (1.0, 1.0), (2.0, 0.0)];
        assert!(shape_of(Shape::Linearity, &bent).unwrap() < 1e-12);
        assert_eq!(shape_of(Shape::Growth, &bent), Some(0.5));
        assert_eq!(shape_of(Shape::Most, &bent), Some(1.0));
        assert_eq!(shape_of(Shape::Least, &[]), None);
        assert_eq!(shape_of(Shape::Linearity, &bent[..2]), None);
    }

    #[test]
    fn values_of_a_key_are_read_as_numbers() {
        assert_eq!(quantity("4305 m"), Some(4305.0));
        assert_eq!(quantity("0.3"), Some(0.3));
        assert_eq!(quantity("1e3m"), Some(1000.0));
        assert_eq!(quantity("drill"), None);
    }
}
