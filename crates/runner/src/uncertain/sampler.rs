//! Creation of the cases of samples.

use wholestring_case::{Case, Override, Template, Uncertain};

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
