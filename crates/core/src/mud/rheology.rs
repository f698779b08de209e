//! Shear stress against shear rate.

use serde::{Deserialize, Serialize};

/// Ratio of the assumed viscosity of a Bingham mud below its yield point to its plastic viscosity:
/// a stiff liquid in place of a solid (O'Donovan and Tanner 1984), an error of 1e-4 of the stress.
const UNYIELDED: f64 = 1e4;

/// Rheology of a mud: a generalised Newtonian fluid.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Rheology {
    /// `τ = μ γ̇`.
    Newtonian {
        /// Viscosity `μ`, Pa·s.
        viscosity_Pa_s: f64,
    },
    /// `τ = τ₀ + μ γ̇`; rigid below `τ₀`.
    Bingham {
        /// Plastic viscosity `μ`, Pa·s.
        plastic_viscosity_Pa_s: f64,
        /// Yield point `τ₀`, Pa.
        yield_point_Pa: f64,
    },
    /// `τ = K γ̇ⁿ`.
    PowerLaw {
        /// Consistency index `K`, Pa·sⁿ.
        consistency_Pa_s_n: f64,
        /// Flow behaviour index `n`: below 1 the mud thins as it is sheared.
        flow_index: f64,
    },
    /// `τ = τ₀ + K γ̇ⁿ`, the yield-power law; rigid below `τ₀`.
    HerschelBulkley {
        /// Yield point `τ₀`, Pa.
        yield_point_Pa: f64,
        /// Consistency index `K`, Pa·sⁿ.
        consistency_Pa_s_n: f64,
        /// Flow behaviour index `n`: below 1 the mud thins as it is sheared.
        flow_index: f64,
    },
}

/// Shear rate at which the stiffness of a yield-power-law mud below its yield point is counted, 1/s.
const STIFF_AT_PER_S: f64 = 100.0;

/// Point at which the stiff line of a yield-power-law mud meets its law, 1/s and Pa: at the rate at
/// which a Bingham mud, with the viscosity that `K γ̇ⁿ` has at 100 1/s, would leave its own.
fn yields(yield_point_Pa: f64, consistency: f64, index: f64) -> (f64, f64) {
    let viscosity = consistency * libm::pow(STIFF_AT_PER_S, index - 1.0);
    let rate_per_s = yield_point_Pa / (UNYIELDED * viscosity);
    (rate_per_s, yield_point_Pa + consistency * libm::pow(rate_per_s, index))
}

/// Flow of a mud under a stress.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flow {
    /// Shear rate over shear stress, 1/(Pa·s).
    pub fluidity: f64,
    /// Derivative of the shear rate with respect to the stress, 1/(Pa·s).
    pub slope: f64,
}

impl Rheology {
    /// Shear stress at a shear rate, Pa; both positive.
    pub fn stress_Pa(&self, rate_per_s: f64) -> f64 {
        match *self {
            Self::Newtonian { viscosity_Pa_s } => viscosity_Pa_s * rate_per_s,
            Self::Bingham { plastic_viscosity_Pa_s: viscosity, yield_point_Pa } => {
                (viscosity * rate_per_s + yield_point_Pa).min(UNYIELDED * viscosity * rate_per_s)
            }
            Self::PowerLaw { consistency_Pa_s_n, flow_index } => {
                consistency_Pa_s_n * libm::pow(rate_per_s, flow_index)
            }
            Self::HerschelBulkley { yield_point_Pa, consistency_Pa_s_n, flow_index } => {
                let (knee_per_s, knee_Pa) = yields(yield_point_Pa, consistency_Pa_s_n, flow_index);
                if rate_per_s < knee_per_s {
                    return knee_Pa / knee_per_s * rate_per_s;
                }
                yield_point_Pa + consistency_Pa_s_n * libm::pow(rate_per_s, flow_index)
            }
        }
    }

    /// Flow of the mud at a positive shear stress.
    pub fn flow(&self, stress_Pa: f64) -> Flow {
        match *self {
            Self::Newtonian { viscosity_Pa_s } => {
                Flow { fluidity: 1.0 / viscosity_Pa_s, slope: 1.0 / viscosity_Pa_s }
            }
            Self::Bingham { plastic_viscosity_Pa_s: viscosity, yield_point_Pa } => {
                let slope = 1.0 / viscosity;
                if stress_Pa <= self.knee_Pa() {
                    let stiff = slope / UNYIELDED;
                    return Flow { fluidity: stiff, slope: stiff };
                }
                Flow { fluidity: slope * (stress_Pa - yield_point_Pa) / stress_Pa, slope }
            }
            Self::PowerLaw { consistency_Pa_s_n, flow_index } => {
                let inverse = 1.0 / flow_index;
                let fluidity = libm::pow(stress_Pa / consistency_Pa_s_n, inverse) / stress_Pa;
                Flow { fluidity, slope: inverse * fluidity }
            }
            Self::HerschelBulkley { yield_point_Pa, consistency_Pa_s_n, flow_index } => {
                let (knee_per_s, knee_Pa) = yields(yield_point_Pa, consistency_Pa_s_n, flow_index);
                if stress_Pa <= knee_Pa && knee_per_s > 0.0 {
                    let stiff = knee_per_s / knee_Pa;
                    return Flow { fluidity: stiff, slope: stiff };
                }
                let (excess_Pa, inverse) = (stress_Pa - yield_point_Pa, 1.0 / flow_index);
                let rate_per_s = libm::pow(excess_Pa / consistency_Pa_s_n, inverse);
                Flow { fluidity: rate_per_s / stress_Pa, slope: inverse * rate_per_s / excess_Pa }
            }
        }
    }

    /// Stress at which the flow has a kink, Pa: where a Bingham mud's stiff line meets its plastic
    /// one; zero for the others.
    pub(super) fn knee_Pa(&self) -> f64 {
        match *self {
            Self::Bingham { yield_point_Pa, .. } => yield_point_Pa / (1.0 - 1.0 / UNYIELDED),
            Self::HerschelBulkley { yield_point_Pa: 0.0, .. } => 0.0,
            Self::HerschelBulkley { yield_point_Pa, consistency_Pa_s_n, flow_index } => {
                yields(yield_point_Pa, consistency_Pa_s_n, flow_index).1
            }
            Self::Newtonian { .. } | Self::PowerLaw { .. } => 0.0,
        }
    }

    /// The index `n` that turbulence correlations require: 1 but for a power law, with a yield point or without.
    pub fn flow_index(&self) -> f64 {
        match *self {
            Self::PowerLaw { flow_index, .. } | Self::HerschelBulkley { flow_index, .. } => {
                flow_index
            }
            Self::Newtonian { .. } | Self::Bingham { .. } => 1.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stress_and_flow_are_each_others_inverse() {
        for rheology in [
            Rheology::Newtonian { viscosity_Pa_s: 0.03 },
            Rheology::Bingham { plastic_viscosity_Pa_s: 0.025, yield_point_Pa: 7.0 },
            Rheology::PowerLaw { consistency_Pa_s_n: 0.8, flow_index: 0.6 },
            Rheology::HerschelBulkley {
                yield_point_Pa: 5.0,
                consistency_Pa_s_n: 0.8,
                flow_index: 0.6,
            },
            Rheology::HerschelBulkley {
                yield_point_Pa: 0.0,
                consistency_Pa_s_n: 0.8,
                flow_index: 0.6,
            },
        ] {
            for rate in [1e-3, 0.1, 1.0, 50.0, 1000.0] {
                let stress = rheology.stress_Pa(rate);
                let flow = rheology.flow(stress);
                assert!((flow.fluidity * stress / rate - 1.0).abs() < 1e-9, "{rate}");
                let step = 1e-6 * stress;
                let ahead = rheology.flow(stress + step);
                let slope = (ahead.fluidity * (stress + step) - rate) / step;
                assert!((slope / flow.slope - 1.0).abs() < 1e-4, "{rheology:?} {rate}");
            }
        }
    }
}
