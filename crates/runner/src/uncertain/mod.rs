//! Samples of uncertain inputs, for plans and reaches.

mod summary;

pub use summary::scatter;
pub(crate) use summary::{samples_table, summary, write, write_picture_numbers};
pub use wholestring_report::uncertain_notes as notes;

use serde::{Deserialize, Serialize};
use wholestring::operation::OperationKind;
use wholestring_case::{Case, Override, Template, Uncertain};
use wholestring_judge::DepthLimit;

// Creation of the cases of samples.

/// The sampled case, as it was read.
#[derive(Debug, Clone)]
pub(crate) struct Sampler<'a> {
    template: &'a Template,
    overrides: &'a [Override],
    pub(crate) uncertain: &'a Uncertain,
    /// A row for each sample.
    pub(crate) points: Vec<Vec<f64>>,
}

impl<'a> Sampler<'a> {
    /// Creates the sampler of a case with uncertain inputs; `None` for any other case.
    pub(crate) fn of(
        case: &'a Case,
        template: &'a Template,
        overrides: &'a [Override],
    ) -> Option<Self> {
        let uncertain = case.plan.uncertain.as_ref()?;
        Some(Self { template, overrides, uncertain, points: uncertain.points() })
    }

    /// The case of a sample.
    ///
    /// # Errors
    /// The mistake in it, in a sentence.
    pub(crate) fn case(&self, sample: usize) -> Result<Case, String> {
        let found = self.template.sample(self.overrides, self.uncertain, &self.points[sample]);
        found.map_err(|report| {
            let first = report.diagnostics.first();
            first.map_or_else(|| "the case is invalid".to_owned(), |first| first.message.clone())
        })
    }
}

// Result of a sample.

/// Result of a sample: a value of each quantity, in order.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(crate) struct Sampled {
    /// `None` for a quantity without a value.
    pub(crate) answers: Vec<Option<f64>>,
    /// Number of points without a solution.
    pub(crate) lacking: usize,
    /// Reason of the first of them.
    pub(crate) message: Option<String>,
    /// For a reach, the operation and the limit that stop the well first, at each friction factor.
    pub(crate) stops: Vec<Option<(OperationKind, DepthLimit)>>,
}

impl Sampled {
    /// A sample whose case is invalid or without any solution; `points` of them are counted.
    pub(crate) fn none(answers: usize, points: usize, message: String) -> Self {
        Self {
            answers: vec![None; answers],
            lacking: points,
            message: Some(message),
            ..Self::default()
        }
    }

    /// Counts a point without a solution.
    pub(crate) fn lacks(&mut self, message: impl FnOnce() -> String) {
        self.lacking += 1;
        self.message.get_or_insert_with(message);
    }
}

// A quantity that varies between samples.

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
