//! Mud that has gelled at rest: pressure and tension that break the gel.
//!
//! A plug of gel slides when the stress at its walls is the gel strength `τ_g`. In a bore of diameter
//! `d` that takes a gradient of `4 τ_g/d`, in the annulus between `d_1` and `d_2` one of
//! `4 τ_g/(d_2 − d_1)` (Bourgoyne, Millheim, Chenevert and Young, *Applied Drilling Engineering*, SPE 1986,
//! section 4.13, as commonly printed: `τ_g/(300 d)` in psi/ft, lbf/100 ft² and inches).

use std::f64::consts::PI;

use super::Annulus;

/// Effect of gelled mud in an annulus on a metre of pipe when it begins to flow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AnnulusGel {
    /// Gradient of the pressure that it takes, Pa/m.
    pub gradient_Pa_per_m: f64,
    /// Reduction of the effective tension, N/m: the stress at the pipe's wall and the pressure of
    /// the gradient around it, `π d_1 d_2 τ_g/(d_2 − d_1)`.
    pub lift_N_per_m: f64,
}

impl Annulus {
    /// Returns the load at which a gel of this strength, Pa, begins to flow.
    pub fn gel(&self, gel_strength_Pa: f64) -> AnnulusGel {
        let [pipe_m, hole_m] = self.diameters_m();
        let gradient_Pa_per_m = 4.0 * gel_strength_Pa / (hole_m - pipe_m);
        AnnulusGel {
            gradient_Pa_per_m,
            lift_N_per_m: 0.25 * PI * pipe_m * hole_m * gradient_Pa_per_m,
        }
    }
}

/// Gradient that makes a gel of this strength, Pa, flow in a bore, Pa/m; zero of none.
pub fn bore_gradient_Pa_per_m(gel_strength_Pa: f64, bore_m2: f64) -> f64 {
    if bore_m2 > 0.0 { 2.0 * gel_strength_Pa / (bore_m2 / PI).sqrt() } else { 0.0 }
}
