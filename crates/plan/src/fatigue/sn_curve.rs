//! Cycles to failure of a pipe under an alternating stress.

/// An S-N curve of two slopes that meet at a knee, with an optional endurance limit: cycles `N` to
/// failure at an amplitude `S`,
///
#[doc = include_str!("../../equations/sn-curve.html")]
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct SnCurve {
    /// Cycles at the knee `N_k`.
    pub knee_cycles: f64,
    /// Amplitude of the stress at the knee `S_k`, Pa: half of its range.
    pub knee_amplitude_Pa: f64,
    /// Exponent above the knee `m₁`.
    pub exponent: f64,
    /// Exponent below the knee `m₂`.
    pub exponent_below: f64,
    /// Amplitude, Pa, below which there is no damage.
    pub endurance_limit_Pa: Option<f64>,
}

impl SnCurve {
    /// DNV-RP-C203, curve B1 in air (as commonly printed): `log N = 15.117 − 4 log Δσ` up to 10⁷
    /// cycles, `17.146 − 5 log Δσ` beyond, `Δσ` the range in MPa. A design curve, two standard
    /// deviations below the mean, of smooth rolled metal: neither of threads, nor of slip cuts, nor
    /// of corroded pipe.
    pub const B1_IN_AIR: Self = Self {
        knee_cycles: 1e7,
        knee_amplitude_Pa: 53.483_45e6,
        exponent: 4.0,
        exponent_below: 5.0,
        endurance_limit_Pa: None,
    };

    /// Returns a curve of one slope through this number of cycles at an amplitude, Pa.
    pub const fn of_one_slope(cycles: f64, amplitude_Pa: f64, exponent: f64) -> Self {
        Self {
            knee_cycles: cycles,
            knee_amplitude_Pa: amplitude_Pa,
            exponent,
            exponent_below: exponent,
            endurance_limit_Pa: None,
        }
    }

    /// Returns the cycles to failure at an amplitude, Pa; infinite without damage.
    pub fn cycles(&self, amplitude_Pa: f64) -> f64 {
        let endured = self.endurance_limit_Pa.is_some_and(|limit_Pa| amplitude_Pa < limit_Pa);
        if amplitude_Pa <= 0.0 || endured {
            return f64::INFINITY;
        }
        let over = self.knee_amplitude_Pa / amplitude_Pa;
        let exponent = if over <= 1.0 { self.exponent } else { self.exponent_below };
        self.knee_cycles * libm::pow(over, exponent)
    }
}

impl Default for SnCurve {
    fn default() -> Self {
        Self::B1_IN_AIR
    }
}
