//! Impedance of the hoist to a small axial motion of the top.

use nalgebra::Complex;

use super::chain::TopEnd;
use wholestring::dynamics::{Autodriller, DynamicsSettings, HoistControl};

/// A hoist as small motions find it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LinearHoist {
    /// A constant force carries a block of this mass, kg.
    Force(f64),
    /// A line to a drum.
    Line {
        /// Mass of the block, kg.
        block_kg: f64,
        /// Stiffness of the line, N/m.
        stiffness_N_per_m: f64,
        /// Damping of the line, N·s/m.
        damping_N_s_per_m: f64,
        /// Autodriller that moves the drum by the weight on bit; none where it turns at a constant
        /// speed.
        autodriller: Option<Autodriller>,
    },
}

impl LinearHoist {
    /// The hoist of `settings`, lowering the string at a speed, m/s.
    pub(super) fn new(control: HoistControl, settings: &DynamicsSettings, speed: f64) -> Self {
        let line = settings.hoist_line;
        let driller = settings.autodriller;
        let moves = driller.min_speed_m_per_s < speed && speed < driller.max_speed_m_per_s;
        match control {
            HoistControl::HookLoad(_) => Self::Force(line.block_mass_kg),
            _ => Self::Line {
                block_kg: line.block_mass_kg,
                stiffness_N_per_m: line.stiffness_N_per_m,
                damping_N_s_per_m: line.damping_N_s_per_m,
                autodriller: (control == HoistControl::Autodriller && moves).then_some(driller),
            },
        }
    }

    /// Impedance at the chain's top node.
    pub(super) fn top(&self, s: Complex<f64>) -> TopEnd {
        let zero = Complex::new(0.0, 0.0);
        let own = match *self {
            Self::Force(block_kg) => s * s * block_kg,
            Self::Line { block_kg, stiffness_N_per_m, damping_N_s_per_m, .. } => {
                s * s * block_kg + s * damping_N_s_per_m + stiffness_N_per_m
            }
        };
        TopEnd::Gives { own, answered: zero }
    }

    /// Force on the top node by which the autodriller answers a weight on bit:
    /// `−(k + cs) K (1 + 1/(T_i s))/(s (1 + T_f s))`.
    pub(super) fn answer(&self, s: Complex<f64>) -> Complex<f64> {
        let Self::Line { stiffness_N_per_m, damping_N_s_per_m, autodriller: Some(driller), .. } =
            *self
        else {
            return Complex::new(0.0, 0.0);
        };
        let line = s * damping_N_s_per_m + stiffness_N_per_m;
        let integral = (s * driller.integral_time_s).inv() + 1.0;
        let integral =
            if driller.integral_time_s.is_finite() { integral } else { Complex::new(1.0, 0.0) };
        let filter = s * driller.filter_s + 1.0;
        -line * integral * driller.gain_m_per_s_per_N / (s * filter)
    }
}
