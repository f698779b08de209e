//! Distribution bands of results.

/// Distribution bands of results.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bands {
    /// The 5, 10, 50, 90 and 95 % quantiles of the results.
    pub quantiles: [f64; 5],
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub std: f64,
    /// Number of results.
    pub count: usize,
}

impl Bands {
    /// Parts of its quantiles.
    pub const PARTS: [f64; 5] = [0.05, 0.1, 0.5, 0.9, 0.95];

    /// Returns the bands of the finite results; `None` for fewer than two.
    pub fn of(answers: &[f64]) -> Option<Self> {
        let mut sorted: Vec<f64> =
            answers.iter().copied().filter(|answer| answer.is_finite()).collect();
        let count = sorted.len();
        if count < 2 {
            return None;
        }
        sorted.sort_by(f64::total_cmp);
        // Linear between the results, the first and the last being 0 and 100 %.
        let quantile = |part: f64| {
            let place = part * (count - 1) as f64;
            let below = (place as usize).min(count - 2);
            sorted[below] + (place - below as f64) * (sorted[below + 1] - sorted[below])
        };
        let mean = sorted.iter().sum::<f64>() / count as f64;
        let squares: f64 = sorted.iter().map(|answer| (answer - mean).powi(2)).sum();
        let std = (squares / (count - 1) as f64).sqrt();
        Some(Self { quantiles: Self::PARTS.map(quantile), mean, std, count })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bands_of_an_even_row() {
        let answers: Vec<f64> = (0..=100).rev().map(f64::from).chain([f64::NAN]).collect();
        let bands = Bands::of(&answers).expect("bands");
        for (found, part) in bands.quantiles.iter().zip(Bands::PARTS) {
            assert!((found - 100.0 * part).abs() < 1e-9);
        }
        assert_eq!((bands.mean, bands.count), (50.0, 101));
        assert!((bands.std - 858.5_f64.sqrt()).abs() < 1e-9);
        assert_eq!(Bands::of(&[1.0, f64::NAN]), None);
    }
}
