//! Power spectral densities.

use std::f64::consts::TAU;

use wholestring::{operation::OperationKind, outcome::Samples};

use crate::{fourier::Fourier, row::rows};

rows! {
    /// Density of a signal at a frequency.
    #[derive(Debug, Clone, PartialEq)]
    pub struct SpectrumRow {
        operation: OperationKind => Words, "`trip_out`, `drill`, ...";
        signal: String => Words,
            "Column of `time.parquet` or, of a node, of `frames.parquet` without its unit: \
             `surface_torque`, ...";
        md_m: Option<f64> => Depth, "Measured depth of the node; `null` for a scalar",
            null_where "it is a scalar's";
        unit: String => Words, "Unit of the signal";
        frequency_Hz: f64 => Frequency, "Frequency";
        density: f64 => Ratio, "One-sided power spectral density, square of the signal's unit per \
                                Hz";
    }

    /// Columns of `spectra.parquet`: power spectral densities over the window, a row per frequency.
    pub const SPECTRA;
}

/// One-sided power spectral density of a signal.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    /// Frequencies at even spacing from zero to half the sampling rate, Hz.
    pub frequency_Hz: Vec<f64>,
    /// Density at each of them, square of the signal's unit per Hz. Its sum times the spacing is
    /// the variance of the signal.
    pub density: Vec<f64>,
}

impl Spectrum {
    /// Computes Welch's estimate (*The Use of Fast Fourier Transform for the Estimation of Power
    /// Spectra*, IEEE Trans. Audio Electroacoust. 15, 1967): the mean of the periodograms of
    /// segments of `segment` samples that overlap by half, each less its mean and under Hann's
    /// window. A longer segment separates closer frequencies, more segments give a smoother
    /// estimate. `None` for less than two samples or a segment that does not fit.
    pub fn welch(
        samples: &(impl Samples + ?Sized),
        interval_s: f64,
        segment: usize,
    ) -> Option<Self> {
        let count = samples.count();
        if segment < 2 || segment > count {
            return None;
        }
        let window: Vec<f64> =
            (0..segment).map(|i| 0.5 - 0.5 * libm::cos(TAU * i as f64 / segment as f64)).collect();
        let power: f64 = window.iter().map(|w| w * w).sum();
        let transform = Fourier::of(segment);
        let mut density = vec![0.0; segment / 2 + 1];
        let step = (segment / 2).max(1);
        let segments = (count - segment) / step + 1;
        let windowed = |part: &[f64]| -> Vec<f64> {
            let mean = part.iter().sum::<f64>() / segment as f64;
            part.iter().zip(&window).map(|(value, window)| (value - mean) * window).collect()
        };
        // Two real segments are one complex signal: for `Z = X + iY`, `|X|² + |Y|²` is the mean of
        // `|Z|²` at a frequency and at its opposite.
        let mut add = |mut re: Vec<f64>, mut im: Vec<f64>| {
            transform.transform(&mut re, &mut im);
            let square = |k: usize| re[k] * re[k] + im[k] * im[k];
            for (k, sum) in density.iter_mut().enumerate() {
                *sum += 0.5 * (square(k) + square((segment - k) % segment));
            }
        };
        let mut gathered: Vec<f64> = Vec::with_capacity(segment);
        let mut single: Option<Vec<f64>> = None;
        samples.each(&mut |values| {
            for value in values {
                gathered.push(*value);
                if gathered.len() == segment {
                    let part = windowed(&gathered);
                    match single.take() {
                        Some(first) => add(first, part),
                        None => single = Some(part),
                    }
                    gathered.drain(..step);
                }
            }
        });
        if let Some(last) = single {
            add(last, vec![0.0; segment]);
        }
        let scale = interval_s / (power * segments as f64);
        let last = density.len() - 1;
        for (index, value) in density.iter_mut().enumerate() {
            // Every frequency but the first, and the last of an even number, represents two.
            let alone = index == 0 || (index == last && segment.is_multiple_of(2));
            *value *= if alone { scale } else { 2.0 * scale };
        }
        let spacing = 1.0 / (segment as f64 * interval_s);
        Some(Self {
            frequency_Hz: (0..density.len()).map(|i| i as f64 * spacing).collect(),
            density,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const INTERVAL_S: f64 = 0.01;

    /// Even noise between −½ and ½, of variance 1/12.
    fn noise(samples: usize) -> Vec<f64> {
        let mut state = 1u64;
        (0..samples)
            .map(|_| {
                state = state
                    .wrapping_mul(6_364_136_223_846_793_005)
                    .wrapping_add(1_442_695_040_888_963_407);
                (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
            })
            .collect()
    }

    fn spacing(spectrum: &Spectrum) -> f64 {
        spectrum.frequency_Hz[1]
    }

    /// White noise of variance `σ²` sampled at the rate `f` has the density `2σ²/f` everywhere. The
    /// mean over 250 frequencies of 1000 samples' periodograms, of 200 samples' worth of
    /// independent segments each, is known to `1/√(250·100)` = 0.6 %; three of these are allowed.
    /// Their sum is the variance (Parseval), known to `1/√100 000`.
    #[test]
    fn white_noise_is_flat_and_holds_its_variance() {
        let samples = noise(100_000);
        for segment in [1000, 1001] {
            let found = Spectrum::welch(&samples, INTERVAL_S, segment).unwrap();
            let variance: f64 = found.density.iter().sum::<f64>() * spacing(&found);
            assert!((12.0 * variance - 1.0).abs() < 0.01, "{variance}");
            let flat = 2.0 / 12.0 * INTERVAL_S;
            for band in found.density[2..498].chunks(248) {
                let mean = band.iter().sum::<f64>() / band.len() as f64;
                assert!((mean / flat - 1.0).abs() < 0.018, "{mean} for {flat}");
            }
        }
    }

    /// A line of 3.7 Hz and amplitude 2 in that noise: it appears at its frequency to half the
    /// spacing of 0.1 Hz, and the area under it is `A²/2` = 2 to within the noise under it and its
    /// leaks, 0.5 %.
    #[test]
    fn a_line_stands_at_its_frequency_with_its_power() {
        let samples: Vec<f64> = noise(60_000)
            .iter()
            .enumerate()
            .map(|(i, noise)| 7.0 + noise + 2.0 * (TAU * 3.73 * i as f64 * INTERVAL_S + 0.4).sin())
            .collect();
        let found = Spectrum::welch(&samples, INTERVAL_S, 1000).unwrap();
        assert!((spacing(&found) - 0.1).abs() < 1e-12);
        assert_eq!(found.frequency_Hz.last(), Some(&50.0));
        let peak = (0..found.density.len())
            .max_by(|a, b| found.density[*a].total_cmp(&found.density[*b]))
            .unwrap();
        assert!((found.frequency_Hz[peak] - 3.73).abs() <= 0.05);
        let area: f64 = found.density[peak - 4..=peak + 4].iter().sum::<f64>() * spacing(&found);
        assert!((area / 2.0 - 1.0).abs() < 5e-3, "{area}");
        // All of it, without the mean: a line and the noise.
        let all: f64 = found.density.iter().sum::<f64>() * spacing(&found);
        assert!((all / (2.0 + 1.0 / 12.0) - 1.0).abs() < 5e-3, "{all}");
    }

    #[test]
    fn too_little_has_no_spectrum() {
        assert_eq!(Spectrum::welch(&[1.0; 9], INTERVAL_S, 10), None);
        assert_eq!(Spectrum::welch(&[1.0; 9], INTERVAL_S, 1), None);
        let still = Spectrum::welch(&[1.0; 9], INTERVAL_S, 9).unwrap();
        assert!(still.density.iter().all(|density| *density < 1e-25));
    }
}
