//! Where the cases of samples come from.

use wholestring_case::{Case, Override, Template, Uncertain};

/// The case that is sampled, as it was read.
#[derive(Debug, Clone)]
pub(crate) struct Sampler<'a> {
    template: &'a Template,
    overrides: &'a [Override],
    pub(crate) uncertain: &'a Uncertain,
    /// A row for each sample.
    pub(crate) points: Vec<Vec<f64>>,
}

impl<'a> Sampler<'a> {
    /// Of a case in which something is uncertain; none of another one.
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
    /// What is wrong with it, in a sentence.
    pub(crate) fn case(&self, sample: usize) -> Result<Case, String> {
        let found = self.template.sample(self.overrides, self.uncertain, &self.points[sample]);
        found.map_err(|report| {
            let first = report.diagnostics.first();
            first.map_or_else(|| "it is no case".to_owned(), |first| first.message.clone())
        })
    }
}
