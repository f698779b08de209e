//! Fewer points of long time histories, without losing a peak.

/// Thins columns of a given number of rows to at most `most`, stretch after stretch.
///
/// Where there are more, each two rows represent a stretch of rows: they contain the smallest and
/// the largest value of each column in the stretch, in their original order, at its first and its
/// middle time. Every peak therefore keeps its height, and is off its time by less than the spacing
/// of the remaining rows.
#[derive(Debug, Clone)]
pub struct Thinned {
    /// Number of rows that become two; `None` where all are retained.
    size: Option<usize>,
    two: fn(&[f64]) -> [f64; 2],
    gathered: Vec<f64>,
    thin: Vec<f64>,
}

impl Thinned {
    /// Thins the times of the rows.
    pub fn times(rows: usize, most: usize) -> Self {
        Self::by(rows, most, |times| [times[0], times[times.len() / 2]])
    }

    /// Thins a column.
    pub fn column(rows: usize, most: usize) -> Self {
        Self::by(rows, most, extremes)
    }

    fn by(rows: usize, most: usize, two: fn(&[f64]) -> [f64; 2]) -> Self {
        let size = (rows > most).then(|| rows.div_ceil((most / 2).max(1)));
        Self { size, two, gathered: Vec::new(), thin: Vec::new() }
    }

    /// Takes the next value.
    pub fn push(&mut self, value: f64) {
        let Some(size) = self.size else {
            self.thin.push(value);
            return;
        };
        self.gathered.push(value);
        if self.gathered.len() == size {
            self.close();
        }
    }

    fn close(&mut self) {
        if !self.gathered.is_empty() {
            self.thin.extend((self.two)(&self.gathered));
            self.gathered.clear();
        }
    }

    /// Returns the remaining values.
    pub fn values(mut self) -> Vec<f64> {
        self.close();
        self.thin
    }
}

/// Returns times and columns in at most `most` rows, thinned as by [`Thinned`].
///
/// # Panics
/// If a column differs from the times in length.
pub fn thinned(time_s: &[f64], columns: &[&[f64]], most: usize) -> (Vec<f64>, Vec<Vec<f64>>) {
    let rows = time_s.len();
    let thin = |mut thinned: Thinned, values: &[f64]| {
        assert_eq!(values.len(), rows, "a column is as long as the times");
        values.iter().for_each(|value| thinned.push(*value));
        thinned.values()
    };
    let columns = columns.iter().map(|values| thin(Thinned::column(rows, most), values)).collect();
    (thin(Thinned::times(rows, most), time_s), columns)
}

/// Smallest and largest value in their order of occurrence; missing where all are.
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
