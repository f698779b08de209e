//! Division of friction between the axis and the circumference.

use crate::operation::Operation;

/// The string's motion over the wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Sliding {
    /// Along the hole alone: 1 towards the bit, -1 towards the surface.
    Axial(f64),
    /// Rotating, with an axial velocity (positive towards the bit) or without.
    Rotating { rotation_rad_per_s: f64, axial_m_per_s: f64 },
}

impl Sliding {
    /// A string that does not rotate slides the way its operation goes, whatever its speed: Coulomb
    /// friction does not depend on it.
    pub(crate) fn of(operation: &Operation) -> Self {
        if operation.kind.rotates() {
            Self::Rotating {
                rotation_rad_per_s: operation.rotation_rad_per_s(),
                axial_m_per_s: operation.axial_velocity_m_per_s(),
            }
        } else {
            Self::Axial(operation.kind.axial_motion().direction())
        }
    }

    /// Parts of the sliding direction along the hole (positive towards the bit) and around it, for
    /// a surface at a radius, m. Their squares add up to one.
    pub(crate) fn direction(self, radius_m: f64) -> (f64, f64) {
        match self {
            Self::Axial(along) => (along, 0.0),
            Self::Rotating { rotation_rad_per_s, axial_m_per_s } => {
                let around = rotation_rad_per_s * radius_m;
                let speed = libm::hypot(axial_m_per_s, around);
                (axial_m_per_s / speed, around / speed)
            }
        }
    }
}
