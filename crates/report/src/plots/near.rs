//! Columns in a coarse view, in which joints represent the pipe between them.

use std::ops::Range;

/// Half of the distance between joints, and a little, m.
pub(crate) const JOINT_REACH_M: f64 = 6.0;

/// A function of the values within `reach` of each depth.
fn near(depths: &[f64], values: &[f64], reach: f64, reduce: fn(&[f64]) -> f64) -> Vec<f64> {
    let within = |range: Range<usize>| reduce(values.get(range).unwrap_or_default());
    intervals(depths, reach).map(within).collect()
}

/// The rows within `reach` of each depth. Depths that do not increase, as in a damaged file, give
/// arbitrary rows.
fn intervals(depths: &[f64], reach: f64) -> impl Iterator<Item = Range<usize>> {
    let mut from = 0;
    let mut to = 0;
    depths.iter().map(move |depth| {
        while from < depths.len() && depths[from] < depth - reach {
            from += 1;
        }
        while to < depths.len() && depths[to] <= depth + reach {
            to += 1;
        }
        from.min(to)..to
    })
}

/// Row of the largest value within `reach` of each depth: a joint, where joints cause the value.
pub(crate) fn row_of_largest(depths: &[f64], values: &[f64], reach: f64) -> Vec<usize> {
    let value = |row: usize| values.get(row).copied().unwrap_or(f64::NAN);
    let row = |rows: Range<usize>| rows.max_by(|a, b| value(*a).total_cmp(&value(*b))).unwrap_or(0);
    intervals(depths, reach).map(row).collect()
}

/// The largest value within `reach` of each depth.
pub(crate) fn largest(depths: &[f64], values: &[f64], reach: f64) -> Vec<f64> {
    near(depths, values, reach, |values| values.iter().copied().fold(f64::NAN, f64::max))
}

/// The smallest.
pub(crate) fn smallest(depths: &[f64], values: &[f64], reach: f64) -> Vec<f64> {
    near(depths, values, reach, |values| values.iter().copied().fold(f64::NAN, f64::min))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_joint_counts_as_far_as_it_reaches() {
        let depths: Vec<f64> = (0..10).map(f64::from).collect();
        let mut values = vec![1.0; 10];
        values[4] = 7.0;
        assert_eq!(
            largest(&depths, &values, 2.0),
            [1.0, 1.0, 7.0, 7.0, 7.0, 7.0, 7.0, 1.0, 1.0, 1.0]
        );
        assert_eq!(smallest(&depths, &values, 2.0), [1.0; 10]);
        assert_eq!(row_of_largest(&depths, &values, 2.0)[2..7], [4; 5]);
    }

    #[test]
    fn depths_of_a_damaged_file_give_a_row_each() {
        let depths = [5.0, f64::NAN, 1e300, -3.0, 2.0];
        for values in [&[1.0, 2.0, 3.0, 4.0, 5.0][..], &[1.0]] {
            assert_eq!(largest(&depths, values, 2.0).len(), 5);
            assert_eq!(row_of_largest(&depths, values, 2.0).len(), 5);
        }
    }
}
