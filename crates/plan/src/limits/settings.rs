//! What limits are compared with beside the model.

use super::DesignFactors;

/// What limits are compared with.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct LimitSettings {
    /// The factors that are required.
    pub factors: DesignFactors,
    /// Overpull that is asked for, N. Default 445 kN, 100,000 lbf: 50,000 to 100,000 lbf are commonly
    /// planned.
    pub overpull_N: f64,
}

impl Default for LimitSettings {
    fn default() -> Self {
        Self { factors: DesignFactors::default(), overpull_N: 444.822e3 }
    }
}
