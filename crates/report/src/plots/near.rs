//! Columns as they are seen from afar: what joints do counts for the pipe between them.

/// Half of the distance between joints, and a little, m.
pub(crate) const JOINT_REACH_M: f64 = 6.0;

/// Something of the values within `reach` of each depth.
fn near(depths: &[f64], values: &[f64], reach: f64, of: fn(&[f64]) -> f64) -> Vec<f64> {
    let mut from = 0;
    let mut to = 0;
    depths
        .iter()
        .map(|depth| {
            while depths[from] < depth - reach {
                from += 1;
            }
            while to < depths.len() && depths[to] <= depth + reach {
                to += 1;
            }
            of(&values[from..to])
        })
        .collect()
}

/// The largest value within `reach` of each depth.
pub(crate) fn largest(depths: &[f64], values: &[f64], reach: f64) -> Vec<f64> {
    near(depths, values, reach, |values| {
        values.iter().copied().fold(f64::NAN, f64::max)
    })
}

/// The smallest.
pub(crate) fn smallest(depths: &[f64], values: &[f64], reach: f64) -> Vec<f64> {
    near(depths, values, reach, |values| {
        values.iter().copied().fold(f64::NAN, f64::min)
    })
}

/// The mean.
pub(crate) fn mean(depths: &[f64], values: &[f64], reach: f64) -> Vec<f64> {
    near(depths, values, reach, |values| {
        values.iter().sum::<f64>() / values.len() as f64
    })
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
        assert!((mean(&depths, &values, 2.0)[4] - 2.2).abs() < 1e-12);
    }
}
