//! Direction of a node.

use nalgebra::{UnitVector3, Vector3};

/// A node's director and two directions across it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Heading {
    /// The director.
    pub(super) along: Vector3<f64>,
    /// Two directions across it, a right-handed frame with it.
    pub(super) across: [Vector3<f64>; 2],
}

impl Heading {
    /// A heading along a direction; the first direction across is as near as possible to `near`.
    pub(super) fn new(along: Vector3<f64>, near: Vector3<f64>) -> Self {
        let first = (near - along * along.dot(&near)).normalize();
        Self { along, across: [first, along.cross(&first)] }
    }

    /// Rotated so that the director moves by two components across it, rad.
    pub(super) fn turned(&self, by: [f64; 2]) -> Self {
        let toward = self.across[0] * by[0] + self.across[1] * by[1];
        let Some((toward, angle)) = UnitVector3::try_new_and_get(toward, 0.0) else {
            return *self;
        };
        let (sine, cosine) = libm::sincos(angle);
        let along = (self.along * cosine + toward.into_inner() * sine).normalize();
        // Transported by the smallest rotation, so that a bend keeps its tool face.
        let first = self.across[0];
        let share = first.dot(&along) / (1.0 + self.along.dot(&along));
        Self::new(along, first - (self.along + along) * share)
    }
}
