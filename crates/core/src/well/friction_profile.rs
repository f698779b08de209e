//! Friction that varies along the hole.

use super::{Friction, Hole, HoleError, HoleSection};

impl Hole {
    /// The same hole with a friction that is a function of measured depth, m: every section becomes
    /// pieces of equal length, no longer than `max_length_m`, each with the friction at its middle.
    ///
    /// These are coefficients along the hole, sliding and at rest, for every solver. How the
    /// coefficient falls with the sliding speed is
    /// [`DynamicsSettings::stribeck_speed_m_per_s`](crate::dynamics::DynamicsSettings); in the
    /// dynamics a coefficient may be any function of speed, force and depth, by a
    /// [`FrictionCoefficient`](crate::dynamics::FrictionCoefficient). How friction is shared
    /// between the two directions is [`FrictionLaw`](crate::dynamics::FrictionLaw).
    ///
    /// # Errors
    /// A coefficient that is negative, not finite, or less at rest than sliding; a length that is
    /// not positive.
    pub fn with_friction_profile(
        &self,
        max_length_m: f64,
        friction: impl Fn(f64) -> Friction,
    ) -> Result<Self, HoleError> {
        let mut pieces = Vec::new();
        for (index, section) in self.sections().iter().enumerate() {
            if !(max_length_m.is_finite() && max_length_m > 0.0) {
                return Err(HoleError::OutOfRange {
                    index,
                    quantity: "longest piece of one friction",
                    value: max_length_m,
                    expected: "more than zero",
                });
            }
            let (from, length_m) = (section.from_md_m, section.to_md_m - section.from_md_m);
            let count = (length_m / max_length_m).ceil().max(1.0);
            let end = |piece: usize| from + length_m * piece as f64 / count;
            pieces.extend((0..count as usize).map(|piece| {
                let (from_md_m, to_md_m) = (end(piece), end(piece + 1));
                HoleSection {
                    from_md_m,
                    to_md_m,
                    friction: friction(0.5 * (from_md_m + to_md_m)),
                    ..*section
                }
            }));
        }
        Self::new(pieces)?.with_roughness(self.roughness().copied())
    }
}
