//! The same work without Python's part: what `benchmarks/overhead.py` compares with.

use std::sync::Arc;

use pyo3::prelude::*;
use wholestring_runner::{CancellationToken, Silent, run};

use crate::{
    case::{Case, change},
    error,
    simulation::Simulation,
};

/// Advances a run, and nothing else.
///
/// # Errors
/// A run that diverged.
#[pyfunction]
pub(crate) fn advance_alone(py: Python<'_>, of: &Simulation, seconds: f64) -> PyResult<()> {
    let advanced =
        of.asked(py, |live| live.advance(seconds, &Silent, &CancellationToken::new()))?;
    advanced.map_err(|error| error::of_work(py, &error))
}

/// Solves an operation of a case with one model, and gives its hook load, N; the case is made anew
/// from its text, with these changes, where any are given.
///
/// # Errors
/// A case without such an operation or model, or without answer.
#[pyfunction]
pub(crate) fn solve_alone(
    py: Python<'_>,
    of: &Case,
    model: &str,
    operation: &str,
    changes: Vec<(String, String)>,
) -> PyResult<f64> {
    let mut all = of.changes.clone();
    all.extend(changes.iter().map(|(key, value)| change(key, Some(value))));
    all.push(change("model", Some(&format!("{model:?}"))));
    all.push(change("operation.kind", Some(&format!("{operation:?}"))));
    let case = match changes.is_empty() {
        true => of.with_models(py, Some(vec![model.to_owned()]), Some(operation.to_owned()))?,
        false => {
            let case = py.detach(|| of.template.case(&all));
            Arc::new(case.map_err(|report| error::of_report(py, &report))?)
        }
    };
    let solved = py.detach(|| run::answer(&case, None, &Silent, &CancellationToken::new()));
    let solved = solved.map_err(|error| error::of_work(py, &error))?;
    let first = solved.answers.summary().operations.first();
    Ok(first.map_or(f64::NAN, |of| of.scalars.hook_load_N))
}
