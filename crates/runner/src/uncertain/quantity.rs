//! A number that samples scatter.

/// A number that every sample has an answer for.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Quantity {
    /// What it is, as the tables have it.
    pub(crate) name: &'static str,
    /// Of which limit; empty of others.
    pub(crate) limit: &'static str,
    /// Of which operation; empty of all.
    pub(crate) operation: &'static str,
    /// Friction factor of all sections; none where they have their own.
    pub(crate) friction: Option<f64>,
    /// Measured depth of the bit, m; none of all depths.
    pub(crate) bit_depth_m: Option<f64>,
    /// SI unit.
    pub(crate) unit: &'static str,
    /// The case's own.
    pub(crate) expected: Option<f64>,
    /// Whether a sample that has none lacks an answer: not where nothing loads a limit.
    pub(crate) must_be: bool,
    /// Whether it is asked which inputs it is owed to.
    pub(crate) is_owed: bool,
    /// Of a depth, how deep is looked, m.
    pub(crate) to_m: Option<f64>,
}

impl Quantity {
    /// Of an operation, at a depth, in a unit.
    pub(crate) fn new(name: &'static str, operation: &'static str, unit: &'static str) -> Self {
        Self {
            name,
            limit: "",
            operation,
            friction: None,
            bit_depth_m: None,
            unit,
            expected: None,
            must_be: true,
            is_owed: true,
            to_m: None,
        }
    }
}
