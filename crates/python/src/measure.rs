//! The same work without Python's part: what `benchmarks/overhead.py` compares with.

use pyo3::prelude::*;
use wholestring_runner::{CancellationToken, Silent, run};

use crate::{case::Case, error, simulation::Simulation};

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

/// Solves an operation of a case with one model, and drops the answers.
///
/// # Errors
/// A case without such an operation or model, or without answer.
#[pyfunction]
pub(crate) fn solve_alone(
    py: Python<'_>,
    of: &Case,
    model: String,
    operation: String,
) -> PyResult<()> {
    let case = of.with_models(py, Some(vec![model]), Some(operation))?;
    let solved = py.detach(|| {
        run::answer(&case, None, &Silent, &CancellationToken::new()).map(|solved| drop(solved))
    });
    solved.map_err(|error| error::of_work(py, &error))
}
