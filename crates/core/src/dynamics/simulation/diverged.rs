//! A run that cannot continue.

/// A run that left the range of numbers that mean anything.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error(
    "the run diverged {time_s:.3} s after its start, at {md_m:.1} m measured depth: {quantity} is \
     {value:e}"
)]
pub struct Diverged {
    /// When, s.
    pub time_s: f64,
    /// Measured depth of the worst node, m.
    pub md_m: f64,
    /// Which quantity.
    pub quantity: &'static str,
    /// Its value.
    pub value: f64,
}
