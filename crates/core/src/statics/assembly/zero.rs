//! Zeros of a quantity.

/// Zeros of a quantity between points of growing abscissa, by linear interpolation: for example the
/// inclination at which an assembly neither builds nor drops.
pub fn zeros(points: &[(f64, f64)]) -> Vec<f64> {
    let pairs = points.windows(2).filter(|pair| pair[0].1 * pair[1].1 <= 0.0);
    let pairs = pairs.filter(|pair| pair[0].1 != pair[1].1 && pair[1].1 != 0.0);
    pairs
        .map(|pair| {
            let [(x0, y0), (x1, y1)] = [pair[0], pair[1]];
            x0 - y0 * (x1 - x0) / (y1 - y0)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::zeros;

    #[test]
    fn signs_change_where_lines_cross_zero() {
        assert_eq!(zeros(&[(0.0, 2.0), (1.0, -2.0), (3.0, -1.0), (4.0, 1.0)]), [0.5, 3.5]);
        assert_eq!(zeros(&[(0.0, 1.0), (1.0, 2.0)]), [0.0; 0]);
        assert_eq!(zeros(&[(0.0, -1.0), (1.0, 0.0), (2.0, 1.0)]), [1.0]);
    }
}
