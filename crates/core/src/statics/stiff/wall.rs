//! Compliance of the wall under a contact force.

use crate::{
    string::Component,
    wall::contact::{self, ContactLaw},
    well::HoleSection,
};

/// Penetration against contact force: the inverse of the contact law, which is steep at zero.
#[derive(Debug, Clone, Copy)]
pub(super) enum Compliance {
    /// `α = (N/K)^(2/3)`, `K` in N/m^1.5.
    Hertz(f64),
    /// `α = N/k`, `k` in N/m.
    Linear(f64),
}

impl Compliance {
    /// Compliance of a component's steel on the wall of a hole.
    pub(super) fn new(
        law: &ContactLaw,
        component: &Component,
        section: &HoleSection,
        hole_radius_m: f64,
        contact_radius_m: f64,
    ) -> Self {
        match *law {
            ContactLaw::Hertz { .. } => {
                let steel = &component.material;
                let modulus_Pa = contact::contact_modulus_Pa(
                    steel.youngs_modulus_Pa,
                    steel.poisson_ratio(),
                    section.youngs_modulus_Pa,
                    section.poisson_ratio,
                );
                Self::Hertz(contact::hertz_stiffness(modulus_Pa, hole_radius_m, contact_radius_m))
            }
            ContactLaw::Linear { stiffness_N_per_m, .. } => Self::Linear(stiffness_N_per_m),
        }
    }

    /// Penetration under a force, m, and its derivative, m/N.
    pub(super) fn penetration_m(self, force_N: f64) -> (f64, f64) {
        match self {
            Self::Hertz(stiffness) => {
                let depth_m = libm::pow(force_N.max(0.0) / stiffness, 2.0 / 3.0);
                (depth_m, 2.0 / 3.0 * depth_m / force_N.max(f64::MIN_POSITIVE))
            }
            Self::Linear(stiffness) => (force_N / stiffness, 1.0 / stiffness),
        }
    }

    /// Work that a force has done on the wall, J.
    pub(super) fn energy_J(self, force_N: f64) -> f64 {
        let (depth_m, _) = self.penetration_m(force_N);
        let part = match self {
            Self::Hertz(_) => 0.4,
            Self::Linear(_) => 0.5,
        };
        part * force_N.max(0.0) * depth_m
    }
}
