//! A place in the string.

/// A place in the string.
#[derive(Debug, Clone, PartialEq)]
pub struct Place {
    /// Measured depth, m.
    pub md_m: f64,
    /// Distance from the bit, m.
    pub from_bit_m: f64,
    /// The component there.
    pub component: String,
}
