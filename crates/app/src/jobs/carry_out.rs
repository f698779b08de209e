//! Execution of a job by the runner.

use std::path::Path;

use wholestring_runner::{
    BatchOptions, CancellationToken, Error, Observer, Output, bha, bit_test, calibrate, modes,
    plan, reach, run, study, sweep,
};

use super::{
    ended::Ended,
    prepared::{Prepared, Task},
};

/// Runs a job, and returns its outcome.
pub(super) fn carry_out(
    prepared: &Prepared,
    output: Output,
    observer: &dyn Observer,
    token: &CancellationToken,
    root: &Path,
) -> Ended {
    done(prepared, output, observer, token).unwrap_or_else(|error| Ended::of_error(&error, root))
}

fn done(
    prepared: &Prepared,
    output: Output,
    observer: &dyn Observer,
    token: &CancellationToken,
) -> Result<Ended, Error> {
    let overrides = &prepared.overrides[..];
    let batch = |output| BatchOptions { output, ..BatchOptions::default() };
    match &prepared.task {
        Task::Run { case, csv } => {
            observer.diagnostics(&case.warnings);
            let request = run::Request { output, csv: *csv, ..run::Request::new(case) };
            let outcome = run::run(&request, observer, token)?;
            Ok(match outcome.stopped {
                None => Ended::finished(outcome.folder, None),
                Some(run::Stop::Interrupted) => Ended::stopped(outcome.folder),
                Some(stop) => Ended::failed(outcome.folder, stop.to_string()),
            })
        }
        Task::Plan { template, case, overlay } => {
            observer.diagnostics(&case.warnings);
            let request = plan::Request {
                case,
                template,
                overrides,
                units: None,
                output,
                jobs: None,
                checkpoint_every: None,
                overlay: overlay.clone(),
                png: false,
            };
            Ok(Ended::batch(&plan::run(&request, observer, token)?.batch, "tasks"))
        }
        Task::Reach { template, case, inputs } => {
            observer.diagnostics(&case.warnings);
            let request = reach::Request {
                from_m: inputs.from_m,
                to_m: inputs.to_m,
                frictions: inputs.frictions.clone(),
                operations: inputs.operations.clone(),
                helix_side_force: inputs.helix_side_force,
                output,
                ..reach::Request::new(case, template, overrides)
            };
            let outcome = reach::run(&request, observer, token)?;
            Ok(match (&outcome.samples, outcome.interrupted) {
                (_, true) => Ended::stopped(outcome.folder),
                (Some(samples), false) => Ended::batch(samples, "samples"),
                (None, false) => Ended::finished(outcome.folder, None),
            })
        }
        Task::Bha { case, operation, whole, sweeps } => {
            observer.diagnostics(&case.warnings);
            let request = bha::Request {
                operation: *operation,
                whole: *whole,
                sweeps: sweeps.clone(),
                output,
                ..bha::Request::new(case)
            };
            let outcome = bha::run(&request, observer, token)?;
            Ok(at_once(outcome.folder, outcome.interrupted))
        }
        Task::Modes { case, operation } => {
            observer.diagnostics(&case.warnings);
            let operation = operation.as_deref();
            let request =
                modes::Request { case, operation, units: None, jobs: None, output, png: false };
            let outcome = modes::run(&request, observer, token)?;
            Ok(at_once(outcome.folder, outcome.interrupted))
        }
        Task::Calibrate { template, case, inputs } => {
            observer.diagnostics(&case.warnings);
            let file = inputs.file.clone();
            let cases = [calibrate::NamedCase { file, template, overrides, case }];
            let request = calibrate::Request {
                cases: &cases,
                data: &inputs.data,
                content: Some(&inputs.content),
                fit: inputs.fit.clone(),
                check: inputs.check.clone(),
                units: None,
                output,
                png: false,
            };
            let outcome = calibrate::run(&request, observer, token)?;
            Ok(at_once(outcome.folder, outcome.interrupted))
        }
        Task::Sweep { template, variations, keep } => {
            let request = sweep::Request {
                template,
                overrides,
                variations,
                together: false,
                keep: *keep,
                batch: batch(output),
            };
            Ok(Ended::batch(&sweep::run(&request, observer, token)?, "cases"))
        }
        Task::Study { study, cases } => {
            observer.diagnostics(&study.warnings);
            let request = study::Request {
                study,
                cases: study::CaseFiles::Given(cases),
                overrides,
                keep: None,
                png: false,
                batch: batch(output),
            };
            Ok(Ended::batch(&study::run(&request, observer, token)?, "cases"))
        }
        Task::BitTest { case } => {
            observer.diagnostics(&case.warnings);
            let request = bit_test::Request { case, units: None, batch: batch(output) };
            Ok(Ended::batch(&bit_test::run(&request, observer, token)?.batch, "points"))
        }
    }
}

/// Outcome of work that writes its results in one step, or was interrupted.
fn at_once(folder: std::path::PathBuf, interrupted: bool) -> Ended {
    match interrupted {
        true => Ended::stopped(folder),
        false => Ended::finished(folder, None),
    }
}
