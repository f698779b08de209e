//! Normal contact between string and wall, solved implicitly within a step.
//!
//! Penetration is geometry: `α = u + r − R`. Both laws take it at the end of the step, which makes
//! any stiffness stable and the mean forces independent of it. The price is restitution: a blow
//! shorter than a few steps loses most of its energy. Theory and measured rebounds:
//! `docs/src/theory/wall.md`.

use serde::Serialize;

/// Contact force of the wall against penetration.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub enum ContactLaw {
    /// `N = K_h α^1.5 (1 + d α')`, `K_h` from the elastic constants and radii of pipe and hole.
    Hertz {
        /// Hunt-Crossley dissipation `d`, s/m. Raising it makes impacts rebound less.
        dissipation_s_per_m: f64,
    },
    /// `N = k α + c α'`, never in tension.
    Linear {
        /// Stiffness `k` of one contact (a node), N/m.
        stiffness_N_per_m: f64,
        /// `c` as a fraction of the critical damping of the node on `k`.
        damping_ratio: f64,
    },
}

impl ContactLaw {
    /// Hunt-Crossley dissipation, s/m; the linear law has none.
    pub fn dissipation_s_per_m(&self) -> f64 {
        match self {
            Self::Hertz { dissipation_s_per_m } => *dissipation_s_per_m,
            Self::Linear { .. } => 0.0,
        }
    }
}

/// Smallest clearance `R − r` that the Hertz stiffness is computed with, m. A tool as large as its
/// hole would have an infinite one.
pub const SMALLEST_CLEARANCE_M: f64 = 1e-3;

/// Contact modulus `E*` of two materials, Pa: `1/E* = (1 − ν1²)/E1 + (1 − ν2²)/E2`.
pub fn contact_modulus_Pa(e1: f64, nu1: f64, e2: f64, nu2: f64) -> f64 {
    1.0 / ((1.0 - nu1 * nu1) / e1 + (1.0 - nu2 * nu2) / e2)
}

/// Hertz stiffness `K_h` of a pipe of radius `r` on a hole of radius `R`, N/m^1.5:
/// `K_h = (4/3) E* √(R r/(R − r))`, so that `N = K_h α^1.5` is the article's (5).
pub fn hertz_stiffness(modulus_Pa: f64, hole_radius_m: f64, pipe_radius_m: f64) -> f64 {
    let clearance = (hole_radius_m - pipe_radius_m).max(SMALLEST_CLEARANCE_M);
    4.0 / 3.0 * modulus_Pa * (hole_radius_m * pipe_radius_m / clearance).sqrt()
}
