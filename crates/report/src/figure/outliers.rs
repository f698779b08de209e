//! Values so far from all others that an axis up to them would flatten the rest.

use serde::Serialize;

/// Rule for outliers: of figures, and of the tracks of a page, which applies the same rule.
#[derive(Debug, Clone, Copy, Serialize)]
pub(crate) struct Outliers {
    /// Part of the values at either end that may be outliers.
    pub(crate) tail: f64,
    /// Values are outliers where the axis would have to be this many times as long to reach them.
    pub(crate) times_as_long: f64,
    /// Fewer values than this have no outliers, because each of them is a hundredth or more.
    pub(crate) fewest: usize,
}

/// The rule of all axes.
pub(crate) const OUTLIERS: Outliers = Outliers { tail: 0.01, times_as_long: 3.0, fewest: 100 };

/// Returns the interval that an axis has to reach, without outliers: the whole one where there are
/// none.
///
/// The inner interval contains all but the lowest and the highest hundredth of the values, and zero
/// where `zero` requires it. A value is an outlier where its distance from the inner interval is
/// more than `times_as_long` less one lengths of the inner interval; the axis reaches the outermost
/// of all others.
pub(super) fn without(values: &[f64], zero: bool) -> Option<(f64, f64)> {
    let Outliers { tail, times_as_long, fewest } = OUTLIERS;
    let mut sorted: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
    let (count, last) = (sorted.len(), sorted.len().checked_sub(1)?);
    sorted.sort_by(f64::total_cmp);
    let whole = (sorted[0], sorted[last]);
    if count < fewest {
        return Some(whole);
    }
    let tail = (tail * count as f64).ceil() as usize;
    let (mut low, mut high) = (sorted[tail], sorted[last - tail]);
    if zero {
        (low, high) = (low.min(0.0), high.max(0.0));
    }
    let far = (times_as_long - 1.0) * (high - low);
    if far == 0.0 {
        return Some(whole);
    }
    // Values that are not far off are reached.
    let first = sorted.partition_point(|value| low - value > far);
    let end = sorted.partition_point(|value| value - high <= far);
    Some((sorted[first], sorted[end - 1]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line() -> Vec<f64> {
        (0..1000).map(|i| f64::from(i) / 999.0).collect()
    }

    #[test]
    fn one_value_far_off_is_left_out_and_an_even_spread_is_not() {
        assert_eq!(without(&line(), false), Some((0.0, 1.0)));
        let mut values = line();
        values[500] = 230.0;
        let (low, high) = without(&values, true).unwrap();
        assert_eq!(low, 0.0);
        assert!((0.98..=1.0).contains(&high), "{high}");
        values[400] = -230.0;
        let (low, high) = without(&values, true).unwrap();
        assert!((-0.01..=0.0).contains(&low) && high <= 1.0, "{low} {high}");
        // Values at the edge of the others are not outliers.
        assert_eq!(without(&values, false), Some((0.0, 1.0)));
        // A tenth of the values cannot be outliers.
        values[..100].fill(50.0);
        assert_eq!(without(&values, false).unwrap().1, 50.0);
    }

    #[test]
    fn few_values_and_equal_ones_have_none() {
        assert_eq!(without(&[0.0, 1.0, 900.0], false), Some((0.0, 900.0)));
        let mut values = vec![2.0; 200];
        values[7] = 5.0;
        assert_eq!(without(&values, false), Some((2.0, 5.0)));
        assert_eq!(without(&[], true), None);
        assert_eq!(without(&[f64::NAN], true), None);
    }
}
