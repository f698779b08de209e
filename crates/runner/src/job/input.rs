//! Cases of a job, read with its changes.

use std::{path::Path, sync::Arc};

use wholestring_case::{Case, Override, Report, Template};

use super::files::{CaseInput, JobFiles};
use crate::error::Error;

/// A case with the changes that made it.
pub(super) struct Input {
    pub(super) file: String,
    pub(super) template: Arc<Template>,
    pub(super) changes: Vec<Override>,
    pub(super) case: Arc<Case>,
}

/// Reads the inputs of a job.
pub(super) struct Reader<'a> {
    pub(super) files: &'a dyn JobFiles,
    pub(super) set: &'a [Override],
    pub(super) warnings: Vec<Report>,
}

impl Reader<'_> {
    /// A case with its own changes, those of the job and one more.
    pub(super) fn case(&mut self, name: &Path, more: Option<Override>) -> Result<Input, Error> {
        let CaseInput { file, template, mut changes, case } = self.files.case(name)?;
        let case = case.filter(|_| self.set.is_empty() && more.is_none());
        changes.extend(self.set.iter().cloned().chain(more));
        let case = match case {
            Some(case) => case,
            None => {
                let case = template.case(&changes)?;
                if !case.warnings.is_empty() {
                    self.warnings.push(case.warnings.clone());
                }
                Arc::new(case)
            }
        };
        Ok(Input { file, template, changes, case })
    }
}
