//! A value of a window and its standard error.

/// A value picked from a window.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The value, SI.
    pub value: f64,
    /// Spread of single rows about it: 1.4826 times the median distance, which is the standard
    /// deviation of normal noise.
    pub spread: f64,
    /// Its standard error, from the spread and the number of independent rows.
    pub standard_error: f64,
    /// Number of rows used.
    pub rows: usize,
}

/// Standard deviation of normal noise over its median distance from the median.
const OF_MEDIAN_DISTANCE: f64 = 1.4826;

/// Standard error of a median over that of a mean, for normal noise: √(π/2).
const OF_MEDIAN: f64 = 1.2533;

impl Estimate {
    /// Estimates by the median, which is insensitive to single spikes and remains of a transient.
    pub(super) fn by_median(values: &[f64]) -> Option<Self> {
        let value = median(&mut values.to_vec())?;
        let spread = spread(values, value).max(rounding(values));
        let count = independent(values, value);
        let standard_error = OF_MEDIAN * spread / count.sqrt();
        Some(Self { value, spread, standard_error, rows: values.len() })
    }

    /// Estimates by the mean of the values within three spreads of the median: the swings of a
    /// string in stick-slip are longer on one side of it than on the other, and friction acts by
    /// their mean.
    pub(super) fn by_mean(values: &[f64]) -> Option<Self> {
        let middle = median(&mut values.to_vec())?;
        let reach = 3.0 * spread(values, middle);
        let inliers: Vec<f64> =
            values.iter().copied().filter(|value| (value - middle).abs() <= reach).collect();
        let rows = inliers.len() as f64;
        let value = inliers.iter().sum::<f64>() / rows;
        let squares = inliers.iter().map(|inlier| (inlier - value).powi(2)).sum::<f64>();
        let spread = (squares / rows).sqrt().max(rounding(values));
        let standard_error = spread / independent(&inliers, value).sqrt();
        Some(Self { value, spread, standard_error, rows: inliers.len() })
    }
}

/// Returns the median of the finite values; reorders them.
pub(super) fn median(values: &mut Vec<f64>) -> Option<f64> {
    values.retain(|value| value.is_finite());
    let middle = values.len() / 2;
    if values.is_empty() {
        return None;
    }
    let even = values.len().is_multiple_of(2);
    let (below, at, _) = values.select_nth_unstable_by(middle, f64::total_cmp);
    let at = *at;
    if !even {
        return Some(at);
    }
    let below = below.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    Some(0.5 * (below + at))
}

/// Returns the value below which this fraction of them is.
pub(super) fn quantile(values: &mut Vec<f64>, part: f64) -> Option<f64> {
    values.retain(|value| value.is_finite());
    let last = values.len().checked_sub(1)?;
    let place = (part * last as f64).round() as usize;
    Some(*values.select_nth_unstable_by(place.min(last), f64::total_cmp).1)
}

/// Distance of values from their median, as the standard deviation of normal noise.
pub(super) fn spread(values: &[f64], middle: f64) -> f64 {
    let mut distances: Vec<f64> = values.iter().map(|value| (value - middle).abs()).collect();
    OF_MEDIAN_DISTANCE * median(&mut distances).unwrap_or(0.0)
}

/// Uncertainty of values written in steps: the standard deviation within a step.
fn rounding(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let steps = sorted.windows(2).map(|pair| pair[1] - pair[0]).filter(|step| *step > 0.0);
    let step = steps.fold(f64::INFINITY, f64::min);
    if step.is_finite() { step / 12f64.sqrt() } else { 0.0 }
}

/// Noise from row to row, independent of any trend.
pub(super) fn noise(values: &[f64]) -> f64 {
    let steps: Vec<f64> = values.windows(2).map(|pair| pair[1] - pair[0]).collect();
    spread(&steps, 0.0) / std::f64::consts::SQRT_2
}

/// Number of independent rows, by the correlation of neighbours (a first-order autoregression).
fn independent(values: &[f64], middle: f64) -> f64 {
    let rows = values.len() as f64;
    // Spikes are excluded from the correlation.
    let reach = 3.0 * spread(values, middle);
    let off = |value: &f64| (value - middle).clamp(-reach, reach);
    let squares: f64 = values.iter().map(|value| off(value).powi(2)).sum();
    if squares == 0.0 {
        return rows;
    }
    let products: f64 = values.windows(2).map(|pair| off(&pair[0]) * off(&pair[1])).sum();
    let correlation = (products / squares).clamp(0.0, 0.99);
    (rows * (1.0 - correlation) / (1.0 + correlation)).max(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_is_the_middle_whatever_the_order() {
        assert_eq!(median(&mut vec![3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median(&mut vec![4.0, 1.0, f64::NAN, 3.0, 2.0]), Some(2.5));
        assert_eq!(median(&mut vec![f64::NAN]), None);
        assert_eq!(quantile(&mut (0..=100).map(f64::from).collect(), 0.95), Some(95.0));
    }

    /// Sine about a mean with spikes: the mean of whole swings is that of the sine, because the
    /// spikes are excluded.
    #[test]
    fn the_mean_holds_whole_swings_and_no_spike() {
        let swing = |row: i32| 10.0 + 3.0 * (f64::from(row) * std::f64::consts::TAU / 20.0).sin();
        let mut values: Vec<f64> = (0..400).map(swing).collect();
        values[7] = 500.0;
        values[90] = -80.0;
        let found = Estimate::by_mean(&values).unwrap();
        // Two rows of 400 are missing in it, each at most 3 from the mean.
        assert!((found.value - 10.0).abs() <= 2.0 * 3.0 / 398.0, "{found:?}");
        assert!((found.spread - 3.0 / 2f64.sqrt()).abs() < 0.02, "{found:?}");
        assert_eq!(found.rows, 398);
    }

    /// A sensor with discrete steps has at least the error of a step.
    #[test]
    fn steps_of_a_sensor_are_in_the_error() {
        let values: Vec<f64> = (0..90).map(|row| if row % 9 == 0 { 20.0 } else { 10.0 }).collect();
        let found = Estimate::by_median(&values).unwrap();
        assert_eq!((found.value, found.spread), (10.0, 10.0 / 12f64.sqrt()));
        assert!(found.standard_error > 0.3, "{found:?}");
    }

    /// Rows that repeat their neighbours count as one.
    #[test]
    fn rows_that_repeat_count_less() {
        let wave = |row: u32| if row % 40 < 20 { 1.0 } else { -1.0 };
        let slow: Vec<f64> = (0..400).map(wave).collect();
        let fast: Vec<f64> = (0..400).map(|row| if row % 2 == 0 { 1.0 } else { -1.0 }).collect();
        assert!(independent(&slow, 0.0) < 30.0);
        assert_eq!(independent(&fast, 0.0), 400.0);
    }
}
