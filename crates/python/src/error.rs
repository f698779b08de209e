//! Python exceptions: the classes of `wholestring.errors`.

use pyo3::{
    prelude::*,
    types::{PyDict, PyList},
};
use wholestring_case::{Diagnostic, Report, Severity};
use wholestring_runner::Error;

/// The exception of a class of `wholestring.errors`, made with these arguments.
fn exception<'py>(
    py: Python<'py>,
    class: &str,
    arguments: impl pyo3::call::PyCallArgs<'py>,
) -> PyErr {
    let made = py
        .import("wholestring.errors")
        .and_then(|errors| errors.getattr(class))
        .and_then(|class| class.call1(arguments));
    match made {
        Ok(exception) => PyErr::from_value(exception),
        Err(error) => error,
    }
}

/// The exception for an impossible request.
pub(crate) fn bad_input(message: impl Into<String>) -> PyErr {
    Python::attach(|py| exception(py, "InputError", (message.into(),)))
}

/// The exception for an unknown name.
pub(crate) fn not_found(message: impl Into<String>) -> PyErr {
    Python::attach(|py| exception(py, "NotFoundError", (message.into(),)))
}

/// The exception for work that failed.
pub(crate) fn of_work(py: Python<'_>, error: &Error) -> PyErr {
    let class = match error {
        Error::Unsound(unsound) => {
            return of_reports(py, &unsound.render(false), &unsound.reports);
        }
        Error::BadInput(_) => "InputError",
        Error::Folder(_) | Error::NotResumable { .. } => "FolderError",
        Error::Results(_) => "ResultsError",
        Error::Failed(_) => "NoAnswerError",
        Error::Interrupted => "Interrupted",
    };
    exception(py, class, (error.to_string(),))
}

/// The exception for results that cannot be read.
pub(crate) fn of_results(py: Python<'_>, error: &wholestring_results::ResultsError) -> PyErr {
    exception(py, "ResultsError", (error.to_string(),))
}

/// The exception for a thread that the system refuses.
pub(crate) fn of_refused_thread(py: Python<'_>, error: &std::io::Error) -> PyErr {
    let message = format!(
        "the system refuses a thread to work on: {error}; end other programs, or raise the limit \
         of processes (ulimit -u) or of memory"
    );
    exception(py, "Error", (message,))
}

/// The exception for a defect of the program.
pub(crate) fn of_panic(py: Python<'_>) -> PyErr {
    let message = "a defect of wholestring: the work panicked; its message is printed above";
    exception(py, "Error", (message,))
}

/// The exception for mistakes in a case.
pub(crate) fn of_report(py: Python<'_>, report: &Report) -> PyErr {
    of_reports(py, &report.render(false), std::slice::from_ref(report))
}

fn of_reports(py: Python<'_>, text: &str, reports: &[Report]) -> PyErr {
    match diagnostics(py, reports) {
        Ok(found) => exception(py, "CaseError", (text.trim_end(), found)),
        Err(error) => error,
    }
}

/// The diagnostics of reports, each as a dictionary.
pub(crate) fn diagnostics<'py>(
    py: Python<'py>,
    reports: &[Report],
) -> PyResult<Bound<'py, PyList>> {
    let all = PyList::empty(py);
    for report in reports {
        for diagnostic in &report.diagnostics {
            all.append(of_diagnostic(py, report, diagnostic)?)?;
        }
    }
    Ok(all)
}

fn of_diagnostic<'py>(
    py: Python<'py>,
    report: &Report,
    diagnostic: &Diagnostic,
) -> PyResult<Bound<'py, PyDict>> {
    let found = PyDict::new(py);
    let severity = match diagnostic.severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
    };
    found.set_item("severity", severity)?;
    found.set_item("message", &diagnostic.message)?;
    found.set_item("help", diagnostic.help.join("\n"))?;
    let label = diagnostic.labels.first();
    let source = label.and_then(|label| report.sources.get(label.place.source));
    let place = label.zip(source);
    let line = place.map(|(label, source)| {
        let before = source.text.get(..label.place.start).unwrap_or(&source.text);
        let line_start = before.rfind('\n').map_or(0, |end| end + 1);
        (before.matches('\n').count() + 1, before[line_start..].chars().count() + 1)
    });
    let file = source.or(report.sources.first()).map(|source| source.name.as_str());
    found.set_item("file", file)?;
    found.set_item("line", line.map(|(line, _)| line))?;
    found.set_item("column", line.map(|(_, column)| column))?;
    found.set_item("expected", label.map(|label| label.text.as_str()).unwrap_or_default())?;
    Ok(found)
}
