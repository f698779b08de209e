//! Fewer points of long time histories, without losing a peak.

/// Times and columns in at most `most` rows.
///
/// Where there are more, each two rows stand for as many rows as it takes: they hold the smallest
/// and the largest value of each column among those, in the order in which they came, at the first
/// and the middle time. So every peak keeps its height, and is off its time by less than the
/// spacing of the rows that are left.
///
/// # Panics
/// If a column differs from the times in length.
pub fn thinned(time_s: &[f64], columns: &[&[f64]], most: usize) -> (Vec<f64>, Vec<Vec<f64>>) {
    let rows = time_s.len();
    if rows <= most {
        return (time_s.to_vec(), columns.iter().map(|column| column.to_vec()).collect());
    }
    let size = rows.div_ceil((most / 2).max(1));
    let times = time_s.chunks(size).flat_map(|chunk| [chunk[0], chunk[chunk.len() / 2]]).collect();
    let thin = |column: &&[f64]| {
        assert_eq!(column.len(), rows, "a column is as long as the times");
        column.chunks(size).flat_map(extremes).collect()
    };
    (times, columns.iter().map(thin).collect())
}

/// Smallest and largest value in the order in which they come; missing where all are.
fn extremes(values: &[f64]) -> [f64; 2] {
    let (mut low, mut high) = ((0, f64::INFINITY), (0, f64::NEG_INFINITY));
    for (place, value) in values.iter().enumerate().filter(|(_, value)| value.is_finite()) {
        if *value < low.1 {
            low = (place, *value);
        }
        if *value >= high.1 {
            high = (place, *value);
        }
    }
    match (low, high) {
        ((_, low), _) if low.is_infinite() => [f64::NAN; 2],
        ((i, low), (k, high)) if i <= k => [low, high],
        ((_, low), (_, high)) => [high, low],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn peaks_keep_their_height() {
        let time: Vec<f64> = (0..100_001).map(f64::from).collect();
        let mut wave: Vec<f64> = time.iter().map(|t| (t * 1e-3).sin()).collect();
        wave[54_321] = 7.0;
        wave[54_330] = -9.0;
        wave[12] = f64::NAN;
        let nothing = vec![f64::NAN; time.len()];
        let (times, columns) = thinned(&time, &[&wave, &nothing], 1000);
        assert!(times.len() <= 1000, "{}", times.len());
        assert!(times.windows(2).all(|pair| pair[0] < pair[1]));
        assert_eq!(columns[0].len(), times.len());
        let at = |value| columns[0].iter().position(|v| *v == value).unwrap();
        let spacing = time.len() as f64 / times.len() as f64;
        assert!((times[at(7.0)] - 54_321.0).abs() <= 2.0 * spacing);
        assert_eq!(at(-9.0), at(7.0) + 1, "in their order");
        assert!(columns[0].iter().all(|v| v.is_finite()));
        assert!(columns[1].iter().all(|v| v.is_nan()));
    }

    #[test]
    fn few_rows_stay_as_they_are() {
        let (times, columns) = thinned(&[0.0, 1.0], &[&[5.0, 6.0]], 2);
        assert_eq!((times, columns), (vec![0.0, 1.0], vec![vec![5.0, 6.0]]));
        assert_eq!(thinned(&[], &[&[]], 0).0, Vec::<f64>::new());
    }
}
