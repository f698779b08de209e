//! Common results of the trials of one bit on one rock.

use serde::{Deserialize, Serialize};

use super::TrialOutcome;
use crate::drilling::BitShape;

/// The numbers by which a bit on a rock is judged, from trials under several weights at several
/// speeds.
///
/// Detournay and Defourny (*International Journal of Rock Mechanics and Mining Sciences* 29, 1992)
/// have `T = ½ μ γ a W` for the weight on wear flats, `T = a W/2ζ` for the weight of cutting, and a
/// specific energy of the order of the rock's strength.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct DrillingResponse {
    /// Slope of the line `T = s W + t` with the least squares of the torque, m, `W` the weight that
    /// the rock bore; none where but one weight was put on the bit.
    pub torque_over_weight_m: Option<f64>,
    /// The same over the bit's radius.
    pub torque_over_weight_and_radius: Option<f64>,
    /// Torque of that line where there is no weight, N·m.
    pub torque_at_no_weight_N_m: Option<f64>,
    /// Weight over a blade's depth of cut `d/n`, by the least squares of the weight, N/m: the
    /// stiffness of the bottom against the surface left by the blade before. None for a bit without
    /// blades, or where no bit advanced.
    pub bottom_stiffness_N_per_m: Option<f64>,
    /// Work per volume broken, of all trials together, Pa; none where nothing was broken.
    pub specific_energy_Pa: Option<f64>,
    /// The same over the rock's unconfined strength.
    pub specific_energy_over_strength: Option<f64>,
}

impl DrillingResponse {
    /// From the outcomes of trials of a bit; the rock's unconfined strength in Pa.
    pub fn of(outcomes: &[TrialOutcome], bit: &BitShape, strength_Pa: f64) -> Self {
        let radius_m = 0.5 * bit.diameter_m();
        let count = outcomes.len() as f64;
        let mean = |outcome: &dyn Fn(&TrialOutcome) -> f64| {
            outcomes.iter().map(outcome).sum::<f64>() / count
        };
        let [weight, torque] = [mean(&|one| one.weight_borne_N), mean(&|one| one.torque_N_m)];
        let spread = mean(&|one| (one.weight_borne_N - weight).powi(2));
        let together = mean(&|one| (one.weight_borne_N - weight) * (one.torque_N_m - torque));
        // The weights carried by the rock scatter about one value, and a line through them has no
        // meaning.
        let weights_N = outcomes.iter().map(|one| one.weight_on_bit_N);
        let [least, most] = [
            weights_N.clone().fold(f64::INFINITY, f64::min),
            weights_N.fold(f64::NEG_INFINITY, f64::max),
        ];
        let slope = (most - least > 1e-6 * most).then(|| together / spread);
        // Every element is as large as the others, so that their number is as good as their volume.
        let broken: f64 = outcomes.iter().map(|one| one.bricks_broken as f64).sum();
        let work: f64 = outcomes
            .iter()
            .filter_map(|one| Some(one.specific_energy_Pa? * one.bricks_broken as f64))
            .sum();
        let blade_cut = |one: &TrialOutcome| {
            let cut_m = one.depth_of_cut_m / bit.blades().map_or(f64::NAN, |n| n as f64);
            [one.weight_borne_N * cut_m, cut_m * cut_m]
        };
        let cuts = outcomes.iter().filter(|one| one.depth_of_cut_m > 0.0);
        let [pressed, squares] =
            cuts.map(blade_cut).fold([0.0; 2], |[a, b], [c, d]| [a + c, b + d]);
        let specific_energy_Pa = (broken > 0.0).then(|| work / broken);
        Self {
            torque_over_weight_m: slope,
            torque_over_weight_and_radius: slope.map(|slope| slope / radius_m),
            torque_at_no_weight_N_m: slope.map(|slope| torque - slope * weight),
            bottom_stiffness_N_per_m: (squares > 0.0).then(|| pressed / squares),
            specific_energy_Pa,
            specific_energy_over_strength: specific_energy_Pa.map(|energy| energy / strength_Pa),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bit_face::{InsertBit, PdcBit};

    fn outcome(weight_borne_N: f64, torque_N_m: f64, energy: Option<(f64, u64)>) -> TrialOutcome {
        TrialOutcome {
            weight_on_bit_N: 0.9 * weight_borne_N,
            torque_N_m,
            specific_energy_Pa: energy.map(|(energy, _)| energy),
            bricks_broken: energy.map_or(0, |(_, elements)| elements),
            rotary_speed_rad_per_s: 10.0,
            rate_of_penetration_m_per_s: 1e-3,
            rate_of_penetration_error_m_per_s: None,
            depth_of_cut_m: 1e-3,
            torque_error_N_m: None,
            torque_std_N_m: 1.0,
            weight_borne_N,
            weight_on_bit_std_N: 1.0,
            mechanical_specific_energy_Pa: None,
            kinetic_fraction: 0.0,
            revolutions: 4.0,
            time_s: 1.0,
            averaging_time_s: 1e-3,
        }
    }

    #[test]
    fn a_line_is_found_again() {
        let line = |weight| 0.08 * weight + 40.0;
        // Off the line by as much on either side at one weight: the line stays.
        let outcomes = [
            outcome(1e4, line(1e4), Some((20e6, 100))),
            outcome(2e4, line(2e4) + 7.0, Some((35e6, 300))),
            outcome(2e4, line(2e4) - 7.0, None),
            outcome(3e4, line(3e4), Some((20e6, 100))),
        ];
        let bit = PdcBit::for_diameter(0.2);
        let response = DrillingResponse::of(&outcomes, &BitShape::Pdc(bit), 50e6);
        let near = |value: Option<f64>, expected: f64| {
            let value = value.expect("a value");
            assert!((value / expected - 1.0).abs() < 1e-12, "{value} for {expected}");
        };
        near(response.torque_over_weight_m, 0.08);
        near(response.torque_over_weight_and_radius, 0.8);
        near(response.torque_at_no_weight_N_m, 40.0);
        // All of them cut 1 mm: the mean of the weights over a blade's.
        near(response.bottom_stiffness_N_per_m, 2e4 / (1e-3 / bit.blades as f64));
        near(response.specific_energy_Pa, 29e6);
        near(response.specific_energy_over_strength, 0.58);
    }

    #[test]
    fn one_weight_has_no_slope_and_nothing_broken_no_energy() {
        let bit = BitShape::Insert(InsertBit::for_diameter(0.2));
        let response =
            DrillingResponse::of(&[outcome(1e4, 9.0, None), outcome(1e4, 8.0, None)], &bit, 50e6);
        assert_eq!(
            response,
            DrillingResponse {
                torque_over_weight_m: None,
                torque_over_weight_and_radius: None,
                torque_at_no_weight_N_m: None,
                bottom_stiffness_N_per_m: None,
                specific_energy_Pa: None,
                specific_energy_over_strength: None,
            }
        );
        assert_eq!(DrillingResponse::of(&[], &bit, 50e6), response);
    }

    /// Under one weight at three speeds the rock carries it to within some newtons: a line through
    /// these had a slope of hundreds of radii.
    #[test]
    fn what_scatters_about_one_weight_is_no_second_weight() {
        let trial = |weight_borne_N: f64, torque_N_m: f64| TrialOutcome {
            weight_on_bit_N: 6e4,
            ..outcome(weight_borne_N, torque_N_m, None)
        };
        let outcomes = [trial(59_990.0, 3100.0), trial(60_004.0, 2900.0), trial(59_998.0, 3050.0)];
        let bit = BitShape::Pdc(PdcBit::for_diameter(0.2));
        let response = DrillingResponse::of(&outcomes, &bit, 50e6);
        assert_eq!(response.torque_over_weight_m, None);
        assert_eq!(response.torque_at_no_weight_N_m, None);
        assert_eq!(response.torque_over_weight_and_radius, None);
    }
}
