//! Yield-power law through readings of a rotational rheometer.

use super::Rheology;

/// Shear stress per degree of the dial, Pa: bob B1 and spring F1, 1.067 lbf/100 ft² (API RP 13D).
pub const DIAL_PA: f64 = 0.5109;

/// Shear rate per rotary speed, 1/s per rev/min: rotor R1 and bob B1 (API RP 13D).
pub const DIAL_RATE_PER_S_RPM: f64 = 1.7034;

/// Flow behaviour indices between which the fit is looked for.
const INDICES: [f64; 2] = [0.1, 1.0];

/// Indices that are tried before the best is refined, and steps of the refinement: 1e-8 of the interval between two.
const TRIED: usize = 91;
const REFINED: usize = 40;

/// One reading: rotary speed, rev/min, and the dial, degrees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DialReading {
    /// Rotary speed of the rotor, rev/min.
    pub speed_rpm: f64,
    /// Deflection of the bob, degrees.
    pub dial_deg: f64,
}

/// Yield-power law fitted to readings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DialFit {
    /// The law.
    pub rheology: Rheology,
    /// Root mean square of the differences between the readings and the law, Pa.
    pub residual_Pa: f64,
    /// The largest difference, Pa, and the speed at which it is, rev/min.
    pub largest_Pa: f64,
    /// That speed, rev/min.
    pub largest_at_rpm: f64,
}

impl DialReading {
    fn rate_per_s(&self) -> f64 {
        self.speed_rpm * DIAL_RATE_PER_S_RPM
    }

    fn stress_Pa(&self) -> f64 {
        self.dial_deg * DIAL_PA
    }
}

/// The yield-power law of least squares of the stresses, `τ₀ ≥ 0` and `n` from 0.1 to 1. `None` of fewer than three speeds, or
/// of readings that are no stresses or do not grow with the speed at all.
pub fn fit_dial_readings(readings: &[DialReading]) -> Option<DialFit> {
    let valid = |reading: &DialReading| {
        reading.speed_rpm > 0.0
            && reading.speed_rpm.is_finite()
            && reading.dial_deg >= 0.0
            && reading.dial_deg.is_finite()
    };
    let mut speeds: Vec<f64> = readings.iter().map(|reading| reading.speed_rpm).collect();
    speeds.sort_by(f64::total_cmp);
    speeds.dedup();
    if speeds.len() < 3 || !readings.iter().all(valid) {
        return None;
    }
    let squares = |index: f64| linear(readings, index).map_or(f64::INFINITY, |fit| fit.2);
    let step = (INDICES[1] - INDICES[0]) / (TRIED - 1) as f64;
    let tried = (0..TRIED).map(|at| INDICES[0] + step * at as f64);
    let best = tried.min_by(|a, b| squares(*a).total_cmp(&squares(*b)))?;
    // Golden section between the neighbours of the best.
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let (mut low, mut high) = ((best - step).max(INDICES[0]), (best + step).min(INDICES[1]));
    for _ in 0..REFINED {
        let (a, b) = (high - golden * (high - low), low + golden * (high - low));
        if squares(a) <= squares(b) { high = b } else { low = a }
    }
    let middle = 0.5 * (low + high);
    let ends = [middle, low, high, best];
    let index = ends.into_iter().min_by(|a, b| squares(*a).total_cmp(&squares(*b)))?;
    let (yield_point_Pa, consistency_Pa_s_n, sum) = linear(readings, index)?;
    let rheology =
        Rheology::HerschelBulkley { yield_point_Pa, consistency_Pa_s_n, flow_index: index };
    let off = |reading: &DialReading| {
        let law = yield_point_Pa + consistency_Pa_s_n * libm::pow(reading.rate_per_s(), index);
        (law - reading.stress_Pa()).abs()
    };
    let largest = readings.iter().max_by(|a, b| off(a).total_cmp(&off(b)))?;
    Some(DialFit {
        rheology,
        residual_Pa: (sum / readings.len() as f64).sqrt(),
        largest_Pa: off(largest),
        largest_at_rpm: largest.speed_rpm,
    })
}

/// Yield point and consistency of least squares at an index, and the sum of the squares; `None` where the mud would not thicken.
fn linear(readings: &[DialReading], index: f64) -> Option<(f64, f64, f64)> {
    let count = readings.len() as f64;
    let points: Vec<(f64, f64)> = readings
        .iter()
        .map(|reading| (libm::pow(reading.rate_per_s(), index), reading.stress_Pa()))
        .collect();
    let sum = |term: fn(&(f64, f64)) -> f64| points.iter().map(term).sum::<f64>();
    let (x, y) = (sum(|point| point.0), sum(|point| point.1));
    let (xx, xy) = (sum(|point| point.0 * point.0), sum(|point| point.0 * point.1));
    let slope = (count * xy - x * y) / (count * xx - x * x);
    let (yields, consistency) = match (y - slope * x) / count {
        yields if yields >= 0.0 => (yields, slope),
        _ => (0.0, xy / xx),
    };
    let squares = points.iter().map(|(x, y)| (yields + consistency * x - y).powi(2)).sum();
    (consistency > 0.0).then_some((yields, consistency, squares))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn readings(pairs: &[(f64, f64)]) -> Vec<DialReading> {
        pairs.iter().map(|&(speed_rpm, dial_deg)| DialReading { speed_rpm, dial_deg }).collect()
    }

    const SPEEDS: [f64; 6] = [600.0, 300.0, 200.0, 100.0, 6.0, 3.0];

    /// Readings that a law makes give the law back: to 1e-6, where the sum of squares has its rounding.
    #[test]
    fn a_law_is_found_again() {
        for (yields, consistency, index) in [(4.0, 0.6, 0.7), (0.0, 1.2, 0.45), (7.0, 0.03, 1.0)] {
            let pairs: Vec<(f64, f64)> = SPEEDS
                .iter()
                .map(|speed| {
                    let rate: f64 = speed * DIAL_RATE_PER_S_RPM;
                    (*speed, (yields + consistency * rate.powf(index)) / DIAL_PA)
                })
                .collect();
            let fit = fit_dial_readings(&readings(&pairs)).expect("a fit");
            let Rheology::HerschelBulkley { yield_point_Pa, consistency_Pa_s_n, flow_index } =
                fit.rheology
            else {
                panic!("{fit:?}");
            };
            assert!((yield_point_Pa - yields).abs() < 1e-5, "{fit:?}");
            assert!((consistency_Pa_s_n / consistency - 1.0).abs() < 1e-5, "{fit:?}");
            assert!((flow_index - index).abs() < 1e-6, "{fit:?}");
            assert!(fit.residual_Pa < 1e-6, "{fit:?}");
        }
    }

    #[test]
    fn too_few_or_impossible_readings_have_no_law() {
        assert_eq!(fit_dial_readings(&readings(&[(600.0, 60.0), (300.0, 40.0)])), None);
        assert_eq!(fit_dial_readings(&readings(&[(600.0, 60.0), (300.0, 40.0), (0.0, 3.0)])), None);
        let falling = [(600.0, 3.0), (300.0, 20.0), (100.0, 60.0)];
        let fit = fit_dial_readings(&readings(&falling));
        assert!(fit.is_none_or(|fit| fit.residual_Pa > 1.0), "{fit:?}");
    }
}
