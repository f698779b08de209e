//! The commands that leave a folder: each as the runner carries it out.

use std::{num::NonZeroUsize, path::PathBuf, time::Duration};

use pyo3::prelude::*;
use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_case::Override;
use wholestring_runner::{
    BatchOptions, BatchOutcome, CancellationToken, Error, Keep, Observer, Output, bha, bit_test,
    calibrate::{self, CheckDynamics, Fit, NamedCase, option},
    modes,
    plan::{self, Statics},
    reach, study,
};
use wholestring_units::UnitSet;

use crate::{
    attended::{Attended, attended, attended_or_left},
    case::{Case, change},
    error,
    existing::existing_of,
    table::Table,
};

/// What commands have in common.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Common {
    folder: PathBuf,
    existing: String,
    units: Option<String>,
    jobs: Option<NonZeroUsize>,
    checkpoint_s: Option<f64>,
    shard: Option<String>,
    csv: bool,
    png: bool,
}

/// Why an option's value cannot be.
fn bad(option: &str, reason: impl std::fmt::Display) -> Error {
    Error::BadInput(format!("`{option}`: {reason}"))
}

impl Common {
    fn output(&self) -> Output {
        Output { folder: Some(self.folder.clone()), existing: existing_of(&self.existing) }
    }

    fn units(&self) -> Result<Option<UnitSet>, Error> {
        let units = self.units.as_ref().map(|name| name.parse());
        units.transpose().map_err(|reason| bad("units", reason))
    }

    fn checkpoint(&self) -> Result<Option<Duration>, Error> {
        match self.checkpoint_s {
            Some(seconds) if !(0.01..=86_400.0).contains(&seconds) => {
                Err(bad("checkpoint", format!("{seconds} s: expected 0.01 s to 86400 s")))
            }
            seconds => Ok(seconds.map(Duration::from_secs_f64)),
        }
    }

    fn batch(&self) -> Result<BatchOptions, Error> {
        let shard = self.shard.as_ref().map(|text| text.parse()).transpose();
        Ok(BatchOptions {
            output: self.output(),
            jobs: self.jobs,
            shard: shard.map_err(|reason: String| bad("shard", reason))?.unwrap_or_default(),
            checkpoint_every: self.checkpoint()?,
            csv: self.csv,
        })
    }
}

fn operation(name: &str) -> Result<OperationKind, Error> {
    OperationKind::from_name(name).ok_or_else(|| {
        let names = OperationKind::ALL.map(OperationKind::name).join(", ");
        bad("operation", format!("`{name}` is no operation: expected one of {names}"))
    })
}

/// Where the results are, if there are any, and what was raised before the end.
type Ended = (Option<PathBuf>, Option<Py<PyAny>>);

/// Where the results are, and what ended the work early.
type Found = (PathBuf, Option<Error>);

/// Does the work beside Python.
fn carry_out(
    py: Python<'_>,
    listener: &Bound<'_, PyAny>,
    work: impl FnOnce(&dyn Observer, &CancellationToken) -> Result<Found, Error> + Send,
) -> PyResult<Ended> {
    let Attended { result, raised } = attended(py, listener, work)?;
    came(py, Some(result), raised)
}

/// The same of work that leaves nothing when it is interrupted.
fn carry_out_or_leave(
    py: Python<'_>,
    listener: &Bound<'_, PyAny>,
    work: impl FnOnce(&dyn Observer, &CancellationToken) -> Result<Found, Error> + Send + 'static,
) -> PyResult<Ended> {
    let Attended { result, raised } = attended_or_left(py, listener, work)?;
    came(py, result, raised)
}

/// What Python is given of what came of work.
fn came(
    py: Python<'_>,
    result: Option<Result<Found, Error>>,
    raised: Option<PyErr>,
) -> PyResult<Ended> {
    let value = |raised: PyErr| raised.into_value(py).into_any();
    match (result, raised) {
        (Some(Ok((folder, stopped))), raised) => {
            let stopped = || stopped.map(|stop| error::of_work(py, &stop));
            Ok((Some(folder), raised.or_else(stopped).map(value)))
        }
        (_, Some(raised)) => Ok((None, Some(value(raised)))),
        (Some(Err(stop)), None) => Err(error::of_work(py, &stop)),
        (None, None) => Err(error::of_panic(py)),
    }
}

/// The folder of a batch, and why it is not whole.
fn ended(batch: BatchOutcome) -> Found {
    let folder = batch.folder.clone();
    (folder, batch.finished().err())
}

#[pyfunction]
pub(crate) fn plan_of(
    py: Python<'_>,
    case: &Case,
    common: Common,
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
            png: common.png,
        };
        Ok(ended(plan::run(&request, observer, cancellation)?.batch))
    })
}

/// What is asked of a reach.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct ReachOptions {
    from_m: Option<f64>,
    to_m: Option<f64>,
    frictions: Vec<f64>,
    operations: Vec<String>,
    no_helix_friction: bool,
}

#[pyfunction]
pub(crate) fn reach_of(
    py: Python<'_>,
    case: &Case,
    options: ReachOptions,
    common: Common,
    listener: &Bound<'_, PyAny>,
) -> PyResult<Ended> {
    carry_out(py, listener, |observer, cancellation| {
        let operations = options.operations.iter().map(|name| operation(name));
        let request = reach::Request {
            from_m: options.from_m,
            to_m: options.to_m,
            frictions: options.frictions,
            operations: operations.collect::<Result<_, _>>()?,
            helix_side_force: !options.no_helix_friction,
            units: common.units()?,
            output: common.output(),
            png: common.png,
            jobs: common.jobs,
            ..reach::Request::new(&case.case, &case.template, &case.changes)
        };
        let found = reach::run(&request, observer, cancellation)?;
        let stopped = found.samples.and_then(|batch| batch.finished().err());
        Ok((found.folder, stopped))
    })
}

/// What is asked of a calibration. Numbers come as texts with their units, as they are written to
/// the command line.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct CalibrateOptions {
    data: PathBuf,
    content: Option<Vec<u8>>,
    one_factor: bool,
    friction_around: bool,
    block_weight: bool,
    bit_torque: bool,
    hold: Vec<(String, String)>,
    weight_error: Option<String>,
    rotating_error: Option<String>,
    torque_error: Option<String>,
    outlier: String,
    band: String,
    model: String,
    check_dynamics: Option<Vec<f64>>,
}

impl CalibrateOptions {
    fn fit(&self) -> Result<Fit, Error> {
        type Read<T> = fn(&str) -> Result<T, String>;
        fn read<T>(option: &str, text: &str, read: Read<T>) -> Result<T, Error> {
            read(text).map_err(|reason| bad(option, format!("`{text}`: {reason}")))
        }
        let error = |option: &str, text: &Option<String>, of: Read<f64>| {
            text.as_ref().map(|text| read(option, text, of)).transpose()
        };
        let hold = self.hold.iter().map(|(name, value)| {
            let held = option::held(&format!("{name}={value}"));
            held.map_err(|reason| bad("hold", format!("`{name}`: {reason}")))
        });
        let models = [ModelKind::Soft, ModelKind::Stiff];
        let model = models.into_iter().find(|of| of.name() == self.model);
        Ok(Fit {
            one_factor: self.one_factor,
            friction_around: self.friction_around,
            block_weight: self.block_weight,
            bit_torque: self.bit_torque,
            hold: hold.collect::<Result<_, _>>()?,
            errors: [
                error("weight_error", &self.weight_error, option::force)?,
                error("rotating_error", &self.rotating_error, option::force)?,
                error("torque_error", &self.torque_error, option::torque)?,
            ],
            outlier_beyond: read("outlier", &self.outlier, option::beyond)?,
            band_confidence: read("band", &self.band, option::confidence)?,
            model: model.ok_or_else(|| no_statics(&self.model))?,
        })
    }
}

fn no_statics(name: &str) -> Error {
    bad("model", format!("`{name}` is none of soft, stiff"))
}

#[pyfunction]
pub(crate) fn calibrate_by(
    py: Python<'_>,
    cases: Vec<(String, PyRef<'_, Case>)>,
    options: CalibrateOptions,
    common: Common,
    listener: &Bound<'_, PyAny>,
) -> PyResult<Ended> {
    let parts: Vec<_> = cases
        .iter()
        .map(|(file, of)| (file.clone(), of.template.clone(), &of.changes[..], of.case.clone()))
        .collect();
    carry_out(py, listener, |observer, cancellation| {
        let named = parts.iter().map(|(file, template, overrides, case)| NamedCase {
            file: file.clone(),
            template,
            overrides,
            case,
        });
        let named: Vec<NamedCase<'_>> = named.collect();
        let depths = options.check_dynamics.clone();
        let request = calibrate::Request {
            cases: &named,
            data: &options.data,
            content: options.content.as_deref(),
            fit: options.fit()?,
            check: depths.map(|bit_depths_m| CheckDynamics { bit_depths_m, jobs: common.jobs }),
            units: common.units()?,
            output: common.output(),
            png: common.png,
        };
        let found = calibrate::run(&request, observer, cancellation)?;
        Ok((found.folder, found.interrupted.then_some(Error::Interrupted)))
    })
}

/// Name of what a number measures that a calibration holds by this name; nothing of a factor.
#[pyfunction]
pub(crate) fn held_dimension(py: Python<'_>, name: &str) -> PyResult<Option<&'static str>> {
    let dimension = option::dimension(name).map_err(|reason| bad("hold", reason));
    let dimension = dimension.map_err(|error| error::of_work(py, &error))?;
    Ok(dimension.map(wholestring_units::Dimension::name))
}

/// The keys of a case that a calibration in a folder gives, with their TOML values.
#[pyfunction]
pub(crate) fn calibrated(py: Python<'_>, folder: PathBuf) -> PyResult<Vec<(String, String)>> {
    calibrate::changes(&folder).map_err(|error| error::of_work(py, &error))
}

#[pyfunction]
pub(crate) fn modes_of(
    py: Python<'_>,
    case: &Case,
    operation: Option<String>,
    common: Common,
    listener: &Bound<'_, PyAny>,
) -> PyResult<Ended> {
    let case = case.case.clone();
    carry_out_or_leave(py, listener, move |observer, cancellation| {
        let request = modes::Request {
            case: &case,
            operation: operation.as_deref(),
            units: common.units()?,
            output: common.output(),
            png: common.png,
        };
        Ok((modes::run(&request, observer, cancellation)?.folder, None))
    })
}

/// What is asked of an assembly at rest.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct BhaOptions {
    operation: Option<String>,
    toolfaces_rad: Option<Vec<f64>>,
    weights_N: Option<Vec<f64>>,
    inclinations_rad: Option<Vec<f64>>,
    build_rate_rad_per_m: f64,
    whole: bool,
}

#[pyfunction]
pub(crate) fn bha_of(
    py: Python<'_>,
    case: &Case,
    options: BhaOptions,
    common: Common,
    listener: &Bound<'_, PyAny>,
) -> PyResult<Ended> {
    let case = case.case.clone();
    carry_out_or_leave(py, listener, move |observer, cancellation| {
        let request = bha::Request {
            operation: options.operation.as_deref().map(operation).transpose()?,
            whole: options.whole,
            sweeps: bha::Sweeps {
                toolfaces_rad: options.toolfaces_rad,
                weights_N: options.weights_N,
                inclinations_rad: options.inclinations_rad,
                build_rate_rad_per_m: options.build_rate_rad_per_m,
            },
            units: common.units()?,
            output: common.output(),
            csv: common.csv,
            jobs: common.jobs,
            ..bha::Request::new(&case)
        };
        Ok((bha::run(&request, observer, cancellation)?.folder, None))
    })
}

#[pyfunction]
pub(crate) fn bit_test_of(
    py: Python<'_>,
    case: &Case,
    common: Common,
    listener: &Bound<'_, PyAny>,
) -> PyResult<Ended> {
    carry_out(py, listener, |observer, cancellation| {
        let (units, batch) = (common.units()?, common.batch()?);
        let request = bit_test::Request { case: &case.case, units, batch };
        Ok(ended(bit_test::run(&request, observer, cancellation)?.batch))
    })
}

/// The folder of a study, what was raised before its end, and a sentence for each case in whose
/// answers errors were found.
#[pyfunction]
pub(crate) fn study_of(
    py: Python<'_>,
    path: PathBuf,
    changes: Vec<(String, String)>,
    keep: Option<&str>,
    common: Common,
    listener: &Bound<'_, PyAny>,
) -> PyResult<(Ended, Vec<String>)> {
    let study = py.detach(|| study::load(&path));
    let study = study.map_err(|report| error::of_report(py, &report))?;
    let overrides: Vec<Override> = changes.iter().map(|(key, value)| change(key, value)).collect();
    let mut with_errors = Vec::new();
    let ended = carry_out(py, listener, |observer, cancellation| {
        if !study.warnings.is_empty() {
            observer.diagnostics(&study.warnings);
        }
        let keep = match keep {
            None => None,
            Some("summary") => Some(Keep::Summary),
            Some("tables") => Some(Keep::Tables),
            Some("all") => Some(Keep::All),
            Some(other) => {
                let reason = format!("`{other}` is none of summary, tables, all");
                return Err(bad("keep", reason));
            }
        };
        if common.csv && keep == Some(Keep::Summary) {
            return Err(bad("csv", "it writes tables, and keep=\"summary\" keeps none"));
        }
        let request = study::Request {
            study: &study,
            cases: path.parent().unwrap_or(std::path::Path::new("")),
            overrides: &overrides,
            keep,
            png: common.png,
            batch: common.batch()?,
        };
        let batch = study::run(&request, observer, cancellation)?;
        let wrong = batch.with_errors.iter();
        with_errors =
            wrong.map(|of| format!("{}: {}", of.name, of.operations.join(", "))).collect();
        Ok(self::ended(batch))
    })?;
    Ok((ended, with_errors))
}

/// What is asked of a broomstick.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct BroomstickOptions {
    models: Vec<String>,
    frictions: Vec<f64>,
    bit_depths_m: Vec<f64>,
    operations: Vec<String>,
    jobs: Option<NonZeroUsize>,
}

#[pyfunction]
pub(crate) fn broomstick_of(
    py: Python<'_>,
    case: &Case,
    options: BroomstickOptions,
    listener: &Bound<'_, PyAny>,
) -> PyResult<Table> {
    let case = case.case.clone();
    let work = attended_or_left(py, listener, move |_, cancellation| {
        let model = |name: &String| {
            let found = Statics::ALL.into_iter().find(|of| of.name() == name);
            found.ok_or_else(|| no_statics(name))
        };
        let operations = options.operations.iter().map(|name| operation(name));
        let request = plan::BroomstickRequest {
            case: &case,
            models: options.models.iter().map(model).collect::<Result<_, _>>()?,
            frictions: options.frictions,
            bit_depths_m: options.bit_depths_m,
            operations: operations.collect::<Result<_, _>>()?,
            jobs: options.jobs,
        };
        plan::broomstick(&request, cancellation)
    })?;
    match (work.raised, work.result) {
        (Some(raised), _) => Err(raised),
        (None, Some(Ok(table))) => Table::of(&table),
        (None, Some(Err(error))) => Err(error::of_work(py, &error)),
        (None, None) => Err(error::of_panic(py)),
    }
}

/// The values of an option: a list or a range of quantities of a dimension, SI.
#[pyfunction]
pub(crate) fn values(
    py: Python<'_>,
    option: &str,
    text: &str,
    dimension: &str,
) -> PyResult<Vec<f64>> {
    let found = wholestring_units::Dimension::ALL.iter().find(|of| of.name() == dimension);
    let found = found.ok_or_else(|| error::of_panic(py))?;
    let values = wholestring_case::read_values(option, text, *found);
    values.map_err(|report| error::of_report(py, &report))
}
