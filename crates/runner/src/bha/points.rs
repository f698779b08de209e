//! The assembly at other tool faces, weights and inclinations.

use std::{f64::consts::PI, sync::Mutex};

use wholestring::{
    model::Model,
    operation::Operation,
    statics::assembly::{self, AssemblySettings, in_straight_hole},
};
use wholestring_judge::{Judge, NoAnswer};
use wholestring_results::{BhaFound, BhaPoint, BhaVaried};
use wholestring_units::{Dimension, UnitSet};

use crate::{
    cancellation::CancellationToken,
    error::Error,
    parallel::{in_parallel, lock},
};

const DEGREE: f64 = PI / 180.0;

/// Largest weight on bit allowed, N: the limit of the case file.
const MAX_WEIGHT_N: f64 = 5e6;

/// Sharpest build rate of the holes in which the inclination is varied, rad/m: 180° in 30 m, a
/// radius of 9.5 m. Short-radius holes, the sharpest that are drilled with a rotating string, have
/// 12 m.
const MAX_BUILD_RAD_PER_M: f64 = 180.0 * DEGREE / 30.0;

/// Values to vary, one quantity after the other, SI; `None` selects the default.
#[derive(Debug, Clone, Default)]
pub struct Sweeps {
    /// Tool faces of the lowest bend, rad; by default a revolution in steps of 15° if the string
    /// has a bend.
    pub toolfaces_rad: Option<Vec<f64>>,
    /// Weights on bit, N; by default seven up to 1.5 times that of an operation with weight on bit.
    pub weights_N: Option<Vec<f64>>,
    /// Inclinations of a straight hole, rad; by default from 5° to 90° in steps of 5°.
    pub inclinations_rad: Option<Vec<f64>>,
    /// Build rate of those holes down to the bit, rad/m.
    pub build_rate_rad_per_m: f64,
}

/// A point to solve.
struct Target {
    varied: BhaVaried,
    value: f64,
}

/// Data common to all points.
pub(super) struct Base<'a> {
    pub(super) model: &'a Model,
    pub(super) operation: &'a Operation,
    pub(super) settings: &'a AssemblySettings,
    /// Length of the string that is solved, m.
    pub(super) solved_m: f64,
    /// Units in messages.
    pub(super) units: UnitSet,
    pub(super) judge: &'a Judge,
    pub(super) jobs: usize,
    pub(super) cancellation: &'a CancellationToken,
}

impl Base<'_> {
    /// All points in the order of the varied quantities, and the number of points not solved
    /// because of a cancellation.
    pub(super) fn points(&self, sweeps: &Sweeps) -> Result<(Vec<BhaPoint>, usize), Error> {
        let targets = self.targets(sweeps)?;
        let order: Vec<usize> = (0..targets.len()).collect();
        let done: Vec<Mutex<Option<BhaPoint>>> = order.iter().map(|_| Mutex::default()).collect();
        in_parallel(self.jobs, &order, |index| {
            if !self.cancellation.is_cancelled() {
                let point = self.point(&targets[index], sweeps.build_rate_rad_per_m);
                *lock(&done[index]) = Some(point);
            }
        });
        let found: Vec<BhaPoint> = done.iter().filter_map(|point| lock(point).take()).collect();
        let missing = done.len() - found.len();
        Ok((found, missing))
    }

    fn targets(&self, sweeps: &Sweeps) -> Result<Vec<Target>, Error> {
        let has_bend = self.model.string.toolface_rad().is_some();
        let toolfaces = match &sweeps.toolfaces_rad {
            Some(_) if !has_bend => {
                return Err(Error::BadInput(
                    "no component of the string has a bend: there is no tool face to vary".into(),
                ));
            }
            Some(values) => values.clone(),
            None if has_bend => (0..=24).map(|step| f64::from(step) * 15.0 * DEGREE).collect(),
            None => Vec::new(),
        };
        let weight_N = self.operation.weight_on_bit_now_N();
        let on_bottom = self.operation.kind.on_bottom();
        let weights = match &sweeps.weights_N {
            Some(_) if !on_bottom => {
                let name = self.operation.kind.name();
                return Err(Error::BadInput(format!(
                    "{name} has no weight on the bit to vary: choose an operation that drills"
                )));
            }
            Some(values) => values.clone(),
            None if weight_N > 0.0 => {
                (0..=6).map(|step| f64::from(step) * 0.25 * weight_N).collect()
            }
            None => Vec::new(),
        };
        if let Some(wrong) =
            weights.iter().find(|weight_N| !(0.0..=MAX_WEIGHT_N).contains(*weight_N))
        {
            return Err(Error::BadInput(format!(
                "a weight on bit of {} is outside 0 to {}",
                Dimension::Force.format(*wrong, self.units),
                Dimension::Force.format(MAX_WEIGHT_N, self.units)
            )));
        }
        let inclinations = match &sweeps.inclinations_rad {
            Some(values) => values.clone(),
            None => (1..=18).map(|step| f64::from(step) * 5.0 * DEGREE).collect(),
        };
        if let Some(wrong) = inclinations.iter().find(|rad| !(0.0..=PI).contains(*rad)) {
            return Err(Error::BadInput(format!(
                "an inclination of {:.1} deg is outside 0 to 180 deg",
                wrong / DEGREE
            )));
        }
        check_build(sweeps.build_rate_rad_per_m, self.units)?;
        let all = [
            (BhaVaried::Toolface, toolfaces),
            (BhaVaried::Weight, weights),
            (BhaVaried::Inclination, inclinations),
        ];
        Ok(all
            .into_iter()
            .flat_map(|(varied, mut values)| {
                values.sort_by(f64::total_cmp);
                values.into_iter().map(move |value| Target { varied, value })
            })
            .collect())
    }

    fn point(&self, target: &Target, build_rate_rad_per_m: f64) -> BhaPoint {
        let bit_m = self.operation.bit_depth_m;
        let mut point = BhaPoint {
            varied: target.varied,
            toolface_rad: self.model.string.toolface_rad(),
            weight_on_bit_N: self.operation.weight_on_bit_now_N(),
            inclination_rad: self.model.well.path.at(bit_m).inclination_rad(),
            message: String::new(),
            found: None,
        };
        let mut operation = *self.operation;
        let model = match target.varied {
            BhaVaried::Toolface => {
                point.toolface_rad = Some(target.value);
                let string = self.model.string.at_toolface(target.value);
                Ok(Model { string, ..self.model.clone() })
            }
            BhaVaried::Weight => {
                point.weight_on_bit_N = target.value;
                operation = at_weight(&operation, target.value);
                Ok(self.model.clone())
            }
            BhaVaried::Inclination => {
                point.inclination_rad = target.value;
                let build = (build_rate_rad_per_m, self.solved_m);
                in_straight_hole(self.model, &operation, target.value, build)
            }
        };
        let found = model.map_err(|error| error.to_string()).and_then(|model| {
            let found = assembly::solve_once(&model, &operation, self.settings);
            found.map_err(|error| self.judge.reason(&NoAnswer::from(error)))
        });
        match found {
            Ok(found) => {
                let sag = found.sag.first();
                point.found = Some(BhaFound {
                    side_force_N: found.bit_side_force_N,
                    tilt_rad: found.bit_tilt_rad,
                    largest_bending_moment_N_m: found.largest_moment_N_m.value,
                    largest_von_mises_stress_Pa: found.largest_von_mises_Pa.value,
                    sag_inclination_rad: sag.map(|sag| sag.inclination_rad),
                    sag_azimuth_rad: sag.and_then(|sag| sag.azimuth_rad),
                });
            }
            Err(message) => point.message = message,
        }
        point
    }
}

/// Checks that a hole can be built at this rate, rad/m.
fn check_build(rate_rad_per_m: f64, units: UnitSet) -> Result<(), Error> {
    if rate_rad_per_m.abs() <= MAX_BUILD_RAD_PER_M {
        return Ok(());
    }
    let rate = |rad_per_m: f64| Dimension::DoglegSeverity.format(rad_per_m, units);
    Err(Error::BadInput(format!(
        "a build rate of {} is outside -{most} to {most}",
        rate(rate_rad_per_m),
        most = rate(MAX_BUILD_RAD_PER_M),
    )))
}

/// The operation at another weight, with the torque on bit in proportion.
fn at_weight(operation: &Operation, weight_N: f64) -> Operation {
    let part =
        if operation.weight_on_bit_N > 0.0 { weight_N / operation.weight_on_bit_N } else { 1.0 };
    Operation {
        weight_on_bit_N: weight_N,
        bit_torque_N_m: part * operation.bit_torque_N_m,
        ..*operation
    }
}
