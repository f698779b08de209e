//! A calibration.

use std::path::PathBuf;

use pyo3::prelude::*;
use wholestring::outcome::ModelKind;
use wholestring_runner::{
    Error,
    calibrate::{self, CheckDynamics, Fit, NamedCase, option},
};

use super::{
    carry_out::{Ended, carry_out},
    common::Common,
    option::{bad, no_statics},
};
use crate::{case::Case, error};

/// Options of a calibration. Numbers are texts with their units, in the notation of the command
/// line.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct CalibrateOptions {
    data: PathBuf,
    content: Option<Vec<u8>>,
    one_factor: bool,
    by_section: bool,
    friction_around: bool,
    block_weight: bool,
    bit_torque: bool,
    hold: Vec<(String, String)>,
    weight_error: Option<String>,
    rotating_error: Option<String>,
    torque_error: Option<String>,
    outlier: String,
    without_outliers: bool,
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
        let error = |option: &str, text: &Option<String>, parse: Read<f64>| {
            text.as_ref().map(|text| read(option, text, parse)).transpose()
        };
        let hold = self.hold.iter().map(|(name, value)| {
            let held = option::held(&format!("{name}={value}"));
            held.map_err(|reason| bad("hold", format!("`{name}`: {reason}")))
        });
        let models = [ModelKind::Soft, ModelKind::Stiff];
        let model = models.into_iter().find(|model| model.name() == self.model);
        Ok(Fit {
            one_factor: self.one_factor,
            by_section: self.by_section,
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
            without_outliers: self.without_outliers,
            band_confidence: read("band", &self.band, option::confidence)?,
            model: model.ok_or_else(|| no_statics(&self.model))?,
        })
    }
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
        .map(|(file, case)| {
            (file.clone(), case.template.clone(), &case.changes[..], case.case.clone())
        })
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

/// Name of the dimension of a parameter that a calibration keeps fixed under this name; none for a
/// factor.
#[pyfunction]
pub(crate) fn held_dimension(py: Python<'_>, name: &str) -> PyResult<Option<&'static str>> {
    let dimension = option::dimension(name).map_err(|reason| bad("hold", reason));
    let dimension = dimension.map_err(|error| error::of_work(py, &error))?;
    Ok(dimension.map(wholestring_units::Dimension::name))
}

/// The keys of a case from a calibration in a folder, with their TOML values.
#[pyfunction]
pub(crate) fn calibrated(py: Python<'_>, folder: PathBuf) -> PyResult<Vec<(String, String)>> {
    calibrate::changes(&folder).map_err(|error| error::of_work(py, &error))
}
