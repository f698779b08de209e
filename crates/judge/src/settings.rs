//! Settings of the limits, in addition to the model.

pub use crate::kind::DesignFactors;

use crate::CheckKind;

/// Settings of the limits.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct LimitSettings {
    /// The required factors.
    pub factors: DesignFactors,
    /// Requested overpull, N. Default 445 kN, 100,000 lbf: 50,000 to 100,000 lbf are commonly
    /// planned.
    pub overpull_N: f64,
    /// Largest side force of the wall on one joint of pipe, N; not checked where it is `None`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub side_force_per_joint_N: Option<f64>,
}

impl Default for LimitSettings {
    fn default() -> Self {
        Self {
            factors: DesignFactors::default(),
            overpull_N: 444.822e3,
            side_force_per_joint_N: None,
        }
    }
}

// Required factors of the limits.

impl DesignFactors {
    /// The first kind whose factor is not a positive number, and that factor.
    pub fn bad_factor(&self) -> Option<(CheckKind, f64)> {
        let factors = CheckKind::LIMITS.iter().map(|kind| (*kind, self.required(*kind)));
        let good = |factor: f64| factor.is_finite() && factor > 0.0;
        factors.into_iter().find(|(_, factor)| !good(*factor))
    }
}
