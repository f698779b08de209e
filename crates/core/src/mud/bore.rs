//! Mud on its way down the string.

use std::f64::consts::PI;

use super::{Mud, Rheology, turbulence};

/// Friction pressure gradient in a bore, Pa/m, at a flow rate relative to the pipe; zero without a
/// rheology.
///
/// Laminar by Rabinowitsch's integral: Hagen and Poiseuille, Buckingham and Reiner, Metzner and
/// Reed. Turbulent, and between the two, by API RP 13D: from a Reynolds number of 2100 on for a
/// Newtonian mud. The pipe is smooth, without joints.
pub fn gradient_Pa_per_m(mud: &Mud, bore_m2: f64, flow_m3_per_s: f64) -> f64 {
    let (Some(rheology), true) = (mud.rheology, bore_m2 > 0.0 && flow_m3_per_s > 0.0) else {
        return 0.0;
    };
    let radius = (bore_m2 / PI).sqrt();
    let wall_Pa = laminar_wall_stress_Pa(&rheology, radius, flow_m3_per_s);
    let mean = flow_m3_per_s / bore_m2;
    // Metzner and Reed: the Reynolds number with which laminar friction is 16/Re.
    let reynolds = 8.0 * mud.density_kg_per_m3 * mean * mean / wall_Pa;
    let mixed = turbulence::through_flow(reynolds, rheology.flow_index(), 16.0);
    2.0 * wall_Pa / radius * mixed
}

fn laminar_wall_stress_Pa(rheology: &Rheology, radius_m: f64, flow_m3_per_s: f64) -> f64 {
    let rate = flow_m3_per_s / (PI * radius_m.powi(3));
    match *rheology {
        Rheology::Newtonian { viscosity_Pa_s } => 4.0 * viscosity_Pa_s * rate,
        Rheology::PowerLaw { consistency_Pa_s_n, flow_index: n } => {
            consistency_Pa_s_n * libm::pow((3.0 * n + 1.0) / n * rate, n)
        }
        Rheology::Bingham { plastic_viscosity_Pa_s, yield_point_Pa } => {
            // τ (1 − 4/3 y + y⁴/3) = 4 μ Q/(π r³), y = τ₀/τ: convex, and the start is above the
            // root.
            let newtonian = 4.0 * plastic_viscosity_Pa_s * rate;
            let mut wall = newtonian + 4.0 / 3.0 * yield_point_Pa;
            for _ in 0..60 {
                let y = yield_point_Pa / wall;
                let excess = wall * (1.0 - 4.0 / 3.0 * y + y.powi(4) / 3.0) - newtonian;
                let step = excess / (1.0 - y.powi(4)).max(1e-9);
                wall -= step;
                if step.abs() <= 1e-12 * wall {
                    break;
                }
            }
            wall
        }
        Rheology::HerschelBulkley { yield_point_Pa, consistency_Pa_s_n, flow_index: n } => {
            let through = |excess_Pa: f64| {
                yield_power_law_rate(yield_point_Pa, consistency_Pa_s_n, n, excess_Pa)
            };
            // A plug in the middle lets less through than the power law without it.
            let mut low = consistency_Pa_s_n * libm::pow((3.0 * n + 1.0) / n * rate, n);
            let mut high = low;
            while through(high) < rate && high.is_finite() {
                (low, high) = (high, 2.0 * high);
            }
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if through(middle) < rate {
                    low = middle
                } else {
                    high = middle
                }
                if high - low <= 1e-13 * high {
                    break;
                }
            }
            yield_point_Pa + 0.5 * (low + high)
        }
    }
}

/// `Q/(π r³)` of a yield-power-law mud whose stress at the wall exceeds its yield point by `x`, Rabinowitsch's integral:
/// `(x/K)^(1/n) n x [x²/(3n + 1) + 2 τ₀ x/(2n + 1) + τ₀²/(n + 1)]/τ³`.
fn yield_power_law_rate(yield_point_Pa: f64, consistency: f64, n: f64, x: f64) -> f64 {
    let wall = yield_point_Pa + x;
    let sum = x * x / (3.0 * n + 1.0)
        + 2.0 * yield_point_Pa * x / (2.0 * n + 1.0)
        + yield_point_Pa * yield_point_Pa / (n + 1.0);
    libm::pow(x / consistency, 1.0 / n) * n * x * sum / wall.powi(3)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mud(rheology: Rheology) -> Mud {
        crate::common::viscous_mud(1000.0, rheology)
    }

    /// Rabinowitsch's integral by Simpson's rule gives back the flow rate that the closed forms
    /// took.
    #[test]
    fn laminar_gradients_invert_rabinowitschs_integral() {
        let radius = 0.05;
        for (rheology, flow) in [
            (Rheology::Newtonian { viscosity_Pa_s: 0.5 }, 2e-3),
            (Rheology::Bingham { plastic_viscosity_Pa_s: 0.5, yield_point_Pa: 8.0 }, 2e-3),
            (Rheology::PowerLaw { consistency_Pa_s_n: 2.0, flow_index: 0.55 }, 2e-3),
            (
                Rheology::HerschelBulkley {
                    yield_point_Pa: 8.0,
                    consistency_Pa_s_n: 2.0,
                    flow_index: 0.55,
                },
                2e-3,
            ),
        ] {
            let gradient = gradient_Pa_per_m(&mud(rheology), PI * radius * radius, flow);
            let wall = 0.5 * gradient * radius;
            let n = 20_000;
            let h = wall / f64::from(n);
            let sum: f64 = (0..=n)
                .map(|i| {
                    let stress = h * f64::from(i);
                    let weight = match i {
                        0 => 1.0,
                        i if i == n => 1.0,
                        i if i % 2 == 1 => 4.0,
                        _ => 2.0,
                    };
                    weight * stress.powi(3) * rheology.flow(stress.max(1e-12)).fluidity
                })
                .sum();
            let found = PI * (radius / wall).powi(3) * sum * h / 3.0;
            // The stiff liquid below the yield point lets 1e-4 more through than a solid.
            assert!((found / flow - 1.0).abs() < 3e-4, "{rheology:?}: {found}");
        }
    }

    /// Water in a smooth pipe of 100 mm at 2 m/s: Blasius' 0.0791/Re^0.25 within 1 %.
    #[test]
    fn turbulent_water_follows_blasius() {
        let water = mud(Rheology::Newtonian { viscosity_Pa_s: 1e-3 });
        let area = PI * 0.05f64.powi(2);
        let found = gradient_Pa_per_m(&water, area, 2.0 * area);
        let friction = 0.0791 / 2e5f64.powf(0.25);
        let expected = friction * 0.5 * 1000.0 * 4.0 * 4.0 / 0.1;
        assert!((found / expected - 1.0).abs() < 0.01, "{found} {expected}");
    }

    /// Where flow turns turbulent the gradient is API RP 13D's, whatever the mud: `2 f ρ v²/d` with
    /// its friction at Metzner and Reed's Reynolds number, which the speed sets for all the muds.
    #[test]
    fn the_transition_is_that_of_api_rp_13d() {
        let (radius, area) = (0.05, PI * 0.05f64.powi(2));
        for rheology in [
            Rheology::Newtonian { viscosity_Pa_s: 0.01 },
            Rheology::Bingham { plastic_viscosity_Pa_s: 0.01, yield_point_Pa: 2.0 },
            Rheology::PowerLaw { consistency_Pa_s_n: 0.2, flow_index: 0.6 },
        ] {
            let n: f64 = rheology.flow_index();
            let (a, b) = ((n.log10() + 3.93) / 50.0, (1.75 - n.log10()) / 7.0);
            let (first, last) = (3470.0 - 1370.0 * n, 4270.0 - 1370.0 * n);
            for reynolds in [0.5 * first, 0.95 * first, first + 400.0, 1.1 * last, 3.0 * last] {
                // The speed that has this Reynolds number.
                let (mut low, mut high) = (1e-3, 100.0);
                for _ in 0..100 {
                    let middle = 0.5 * (low + high);
                    let wall = laminar_wall_stress_Pa(&rheology, radius, middle * area);
                    if 8.0 * 1000.0 * middle * middle / wall < reynolds {
                        low = middle;
                    } else {
                        high = middle;
                    }
                }
                let friction = if reynolds < first {
                    16.0 / reynolds
                } else if reynolds < last {
                    0.5 * (16.0 / first + a / last.powf(b))
                } else {
                    a / reynolds.powf(b)
                };
                let expected = 2.0 * friction * 1000.0 * low * low / (2.0 * radius);
                let found = gradient_Pa_per_m(&mud(rheology), area, low * area);
                assert!(
                    (found / expected - 1.0).abs() < 1e-9,
                    "{rheology:?} {reynolds}: {found} {expected}"
                );
            }
        }
    }

    /// With an index of 1 the yield-power law is Bingham's, and without a yield point a power law: to 1e-9.
    #[test]
    fn the_yield_power_law_has_the_others_in_it() {
        let (bore, flow) = (PI * 0.05 * 0.05, 8e-3);
        let gradient_Pa_per_m = |rheology| gradient_Pa_per_m(&mud(rheology), bore, flow);
        let bingham = gradient_Pa_per_m(Rheology::Bingham {
            plastic_viscosity_Pa_s: 0.3,
            yield_point_Pa: 8.0,
        });
        let power =
            gradient_Pa_per_m(Rheology::PowerLaw { consistency_Pa_s_n: 2.0, flow_index: 0.55 });
        let both = |yield_point_Pa, consistency_Pa_s_n, flow_index| {
            gradient_Pa_per_m(Rheology::HerschelBulkley {
                yield_point_Pa,
                consistency_Pa_s_n,
                flow_index,
            })
        };
        assert!((both(8.0, 0.3, 1.0) / bingham - 1.0).abs() < 1e-9);
        assert!((both(0.0, 2.0, 0.55) / power - 1.0).abs() < 1e-9);
    }
}
