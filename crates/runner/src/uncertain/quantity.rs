//! A quantity that varies between samples.

use wholestring::operation::OperationKind;

/// A quantity that is computed for every sample.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Quantity {
    /// Name of the quantity in the tables.
    pub(crate) name: &'static str,
    /// Name of the limit; empty for other quantities.
    pub(crate) limit: &'static str,
    /// The operation; `None` for all.
    pub(crate) operation: Option<OperationKind>,
    /// Friction factor of all sections; `None` for their own.
    pub(crate) friction: Option<f64>,
    /// Measured depth of the bit, m; `None` for all depths.
    pub(crate) bit_depth_m: Option<f64>,
    /// SI unit.
    pub(crate) unit: &'static str,
    /// Value of the case itself.
    pub(crate) expected: Option<f64>,
    /// Whether a sample without a value lacks an answer; false for limits, which may not be loaded.
    pub(crate) must_be: bool,
    /// Whether sensitivities to the inputs are computed.
    pub(crate) is_owed: bool,
    /// Deepest depth evaluated, m, for a depth.
    pub(crate) to_m: Option<f64>,
}

impl Quantity {
    /// Creates a quantity of an operation, without depth, with this unit.
    pub(crate) fn new(
        name: &'static str,
        operation: Option<OperationKind>,
        unit: &'static str,
    ) -> Self {
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
