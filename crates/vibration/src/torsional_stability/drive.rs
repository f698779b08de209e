//! Impedance of the string's top to a small torsional motion.

use nalgebra::Complex;

use super::chain::TopEnd;
use crate::complex;
use wholestring::dynamics::{Gains, SpeedController, TopDriveSettings, TorsionalString};

/// A top drive as small motions find it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LinearDrive {
    /// It follows its set point whatever that takes.
    Constant,
    /// Inertia under a controller.
    Tuned {
        /// Moment of inertia, kg·m².
        inertia_kg_m2: f64,
        /// Moment of inertia of the half element of pipe above the string's first torque, kg·m².
        half_kg_m2: f64,
        /// Gains of the controller.
        gains: Gains,
    },
}

impl LinearDrive {
    /// The drive of `settings` on a string; none of a controller of the caller's own.
    pub(super) fn new(
        settings: &TopDriveSettings,
        string: TorsionalString,
        half_kg_m2: f64,
    ) -> Option<Self> {
        match settings {
            TopDriveSettings::Constant => Some(Self::Constant),
            TopDriveSettings::Driven { inertia_kg_m2, controller, .. } => {
                Some(Self::of(*inertia_kg_m2, *controller, string, half_kg_m2))
            }
            TopDriveSettings::Custom(_) => None,
        }
    }

    fn of(
        inertia_kg_m2: f64,
        controller: SpeedController,
        string: TorsionalString,
        half_kg_m2: f64,
    ) -> Self {
        let gains = Gains::of(controller, inertia_kg_m2, string);
        Self::Tuned { inertia_kg_m2, half_kg_m2, gains }
    }

    /// The same inertia under another controller; itself where nothing gives way.
    pub(super) fn under(&self, controller: SpeedController, string: TorsionalString) -> Self {
        match *self {
            Self::Constant => Self::Constant,
            Self::Tuned { inertia_kg_m2, half_kg_m2, .. } => {
                Self::of(inertia_kg_m2, controller, string, half_kg_m2)
            }
        }
    }

    /// The same on a string whose top node has another inertia, kg·m².
    pub(super) fn with_half(self, half_kg_m2: f64) -> Self {
        match self {
            Self::Constant => Self::Constant,
            Self::Tuned { inertia_kg_m2, gains, .. } => {
                Self::Tuned { inertia_kg_m2, half_kg_m2, gains }
            }
        }
    }

    /// Impedance at the chain's top node: `s² J + s K_p + K_i`, and the contribution of a
    /// controller with feedback of the string's torque, `(K_p s + K_i)/((s + ω₁) Z)`.
    pub(super) fn top(&self, s: Complex<f64>) -> TopEnd {
        match *self {
            Self::Constant => TopEnd::Held,
            Self::Tuned { inertia_kg_m2, half_kg_m2, gains } => {
                let control = s * gains.proportional_N_m_s + gains.integral_N_m;
                let answered = gains.shown.map_or(Complex::new(0.0, 0.0), |shown| {
                    control / ((s + shown.corner_rad_per_s) * shown.impedance_N_m_s)
                });
                let own = s * s * (answered * half_kg_m2 + inertia_kg_m2) + control;
                TopEnd::Gives { own, answered }
            }
        }
    }

    /// Part of a torsional wave of a frequency that the drive sends back into a pipe, by its
    /// amplitude: `|(Z_d − Z)/(Z_d + Z)|`, `Z_d = (J s + C)/(1 + C H/Z_s)`.
    pub fn reflection(&self, pipe_N_m_s: f64, frequency_Hz: f64) -> f64 {
        let s = Complex::new(0.0, std::f64::consts::TAU * frequency_Hz);
        match *self {
            Self::Constant => 1.0,
            Self::Tuned { inertia_kg_m2, gains, .. } => {
                let TopEnd::Gives { answered, .. } = self.top(s) else {
                    return 1.0;
                };
                let control = gains.integral_N_m / s + gains.proportional_N_m_s;
                let impedance = (s * inertia_kg_m2 + control) / (answered + 1.0);
                complex::norm((impedance - pipe_N_m_s) / (impedance + pipe_N_m_s))
            }
        }
    }
}
