//! A plan.

use std::path::PathBuf;

use pyo3::prelude::*;
use wholestring_runner::plan;

use super::{
    carry_out::{Ended, carry_out, ended},
    common::Common,
};
use crate::case::Case;

#[pyfunction]
pub(crate) fn plan_of(
    py: Python<'_>,
    case: &Case,
    common: Common,
    overlay: Option<PathBuf>,
    listener: &Bound<'_, PyAny>,
) -> PyResult<Ended> {
    carry_out(py, listener, |observer, cancellation| {
        let request = plan::Request {
            case: &case.case,
            template: &case.template,
            overrides: &case.changes,
            units: common.units()?,
            output: common.output(),
            jobs: common.jobs,
            checkpoint_every: common.checkpoint()?,
            overlay: overlay.as_deref().map(plan::Overlay::read).transpose()?,
            png: common.png,
        };
        Ok(ended(plan::run(&request, observer, cancellation)?.batch))
    })
}
