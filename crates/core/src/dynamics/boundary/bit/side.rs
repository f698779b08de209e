//! Lateral support of the bit by the rock, and side cutting.

use serde::{Deserialize, Serialize};

use crate::{ends::BitEnd, simd::vector::Vector};

/// The rock at the side of the bit.
///
/// The bit is held by `F = k (u − s)`, `u` its place across the hole and `s` that to which it has
/// cut the hole; `k` is infinite where it does not leave its hole's axis, and zero of a free end.
/// On bottom it cuts sideways with the force and the speed, `s' = c |Ω| F`.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Side {
    stiffness_N_per_m: f64,
    /// Side cut per force and angle `c`, m/N/rad.
    cut_m_per_N: f64,
    axis_m: Vector<f64>,
}

/// Reaction of the side rock on the bit in a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Held {
    pub(super) velocity: Vector<f64>,
    pub(super) displacement: Vector<f64>,
    /// Force on the bit, N.
    pub(super) force_N: Vector<f64>,
}

impl Side {
    pub(super) fn new(stiffness_N_per_m: f64, cut_m_per_N: f64) -> Self {
        Self { stiffness_N_per_m, cut_m_per_N, axis_m: Vector::zero() }
    }

    /// The same of a bit whose end of the string is held so.
    pub(super) fn ending(self, end: BitEnd) -> Self {
        Self { stiffness_N_per_m: end.stiffness_N_per_m(self.stiffness_N_per_m), ..self }
    }

    /// Lateral displacement of the cut hole from the axis at the bit, m.
    pub(super) fn cut_m(&self) -> Vector<f64> {
        self.axis_m
    }

    /// Position of the bit's node at the step's end, from its position without this rock.
    pub(super) fn hold(
        &mut self,
        velocity: Vector<f64>,
        displacement: Vector<f64>,
        tangent: Vector<f64>,
        mobility: f64,
        turning_rad_per_s: f64,
        dt: f64,
    ) -> Held {
        let across = displacement.minus(tangent, displacement.dot(tangent));
        let k = self.stiffness_N_per_m;
        let rate = self.cut_m_per_N * turning_rad_per_s.abs();
        // F = k (u − s) at the step's end: F slows the bit, and cuts the hole towards it.
        let hold = if k.is_finite() {
            k / (1.0 + k * (mobility + rate) * dt)
        } else {
            1.0 / ((mobility + rate) * dt)
        };
        let pressed = if rate > 0.0 {
            // The hole advances with the bit, so its cut is always across the hole's direction at
            // the bit.
            let axis = self.axis_m.minus(tangent, self.axis_m.dot(tangent));
            let pressed = across.minus(axis, 1.0);
            self.axis_m = axis.plus(pressed, dt * rate * hold);
            pressed
        } else {
            across.minus(self.axis_m, 1.0)
        };
        Held {
            velocity: velocity.minus(pressed, mobility * hold),
            displacement: displacement.minus(pressed, dt * mobility * hold),
            force_N: pressed.scaled(-hold),
        }
    }
}
