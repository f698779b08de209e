//! Required factors of the limits.

pub use crate::kind::DesignFactors;

use crate::CheckKind;

impl DesignFactors {
    /// The first kind whose factor is not a positive number, and that factor.
    pub fn bad_factor(&self) -> Option<(CheckKind, f64)> {
        let factors = CheckKind::LIMITS.iter().map(|kind| (*kind, self.required(*kind)));
        let good = |factor: f64| factor.is_finite() && factor > 0.0;
        factors.into_iter().find(|(_, factor)| !good(*factor))
    }
}
