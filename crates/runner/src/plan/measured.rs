//! Measurements compared with the readings predicted by the plan.

use serde::{Deserialize, Serialize};
use wholestring::{operation::Operation, well::FrictionLevel};
use wholestring_case::Measured as Measurements;
use wholestring_judge::Severity;
use wholestring_plan::{
    Broomstick, BroomstickTask,
    calibration::{Assembly, Channel, Reading},
};
use wholestring_results::{PlanMeasured, PlanPoint};

use super::{request::Request, rows::points};
use crate::{
    calibrate,
    cancellation::CancellationToken,
    error::Error,
    observer::Observer,
    readings::{self, NamedCase, Readings},
};

/// Readings, and the strings in the hole at their times with the friction of the plan.
#[derive(Default)]
pub(super) struct Measured {
    readings: Readings,
    /// One broomstick for each string.
    broomsticks: Vec<Broomstick>,
}

/// A task for the readings: an operation of one of the strings, with every friction level.
#[derive(Debug, Clone, Copy)]
pub(super) struct MeasuredTask {
    string: usize,
    pub(super) task: BroomstickTask,
}

/// Outcome of such a task.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct MeasuredDone {
    string: usize,
    pub(super) points: Vec<PlanPoint>,
}

/// Operation during a reading.
fn operation(assembly: &Assembly, reading: &Reading) -> Operation {
    let operation = assembly.operations[reading.channel.motion() as usize];
    Operation { bit_depth_m: reading.bit_depth_m, ..operation }
}

impl Measured {
    /// The measurements of the plan's file; empty if it has none. They are checked as a calibration
    /// checks its readings, and its warnings are passed to the observer.
    ///
    /// # Errors
    /// A row that belongs to no string, or a column in another unit than that of its heading.
    pub(super) fn of(
        request: &Request<'_>,
        observer: &dyn Observer,
        cancellation: &CancellationToken,
    ) -> Result<Self, Error> {
        let case = request.case;
        let Some(measured) = &case.plan.measured else { return Ok(Self::default()) };
        let named = NamedCase {
            file: String::new(),
            template: request.template,
            overrides: request.overrides,
            case,
        };
        let Measurements { file, readings, half_digit_m, units, .. } = measured;
        let readings = readings::of_rows(file, readings, *half_digit_m, &[named])?;
        let mut readings = Readings { units: *units, ..readings };
        let shown_in = request.units.unwrap_or(case.units);
        calibrate::of_comparison(file, &mut readings, case, shown_in, cancellation)?;
        for warning in calibrate::sentences(&readings.checks, Severity::Warning) {
            observer.warning(&format!("{file}: {warning}"));
        }
        let of_string = |assembly: &Assembly| {
            let plan = &case.plan;
            let models = plan.models.clone();
            Broomstick::new(&assembly.setup, &plan.frictions, Vec::new(), Vec::new(), models)
                .map(|broomstick| broomstick.with_settings(case.soft, case.dynamics.stiff_string()))
        };
        let broomsticks = readings.assemblies.iter().map(of_string);
        let broomsticks = broomsticks.collect::<Result<_, _>>().map_err(Error::failed)?;
        Ok(Self { readings, broomsticks })
    }

    /// Every reading with its place in the file, and whether it is held out.
    fn all(&self) -> impl Iterator<Item = (&Reading, &String, bool)> {
        let readings = &self.readings;
        let used = readings
            .readings
            .iter()
            .zip(&readings.places)
            .map(|(reading, place)| (reading, place, false));
        let held_out = readings.held_out.iter().zip(&readings.held_out_places);
        used.chain(held_out.map(|(held_out, place)| (held_out, place, true)))
    }

    /// Tasks to solve; a weight and a torque of one operation share a task.
    pub(super) fn tasks(&self, request: &Request<'_>) -> Vec<MeasuredTask> {
        let mut tasks: Vec<MeasuredTask> = Vec::new();
        for &model in &request.case.plan.models {
            for (reading, ..) in self.all() {
                let string = reading.setup;
                let operation = operation(&self.readings.assemblies[string], reading);
                let task = BroomstickTask { model, operation };
                if !tasks.iter().any(|known| known.string == string && known.task == task) {
                    tasks.push(MeasuredTask { string, task });
                }
            }
        }
        tasks
    }

    /// Solves a task.
    pub(super) fn solve(&self, task: &MeasuredTask) -> MeasuredDone {
        let found = self.broomsticks[task.string].solve(&task.task);
        MeasuredDone { string: task.string, points: points(&found) }
    }

    /// Every reading with its prediction, channel after channel; readings whose task was not solved
    /// are left out.
    pub(super) fn rows(&self, request: &Request<'_>, done: &[MeasuredDone]) -> Vec<PlanMeasured> {
        let block_N = request.case.model.rig.block_weight_N.unwrap_or(0.0);
        let mut rows = Vec::new();
        let models = request.case.plan.models.iter().map(|model| model.kind());
        for (model, channel) in
            models.flat_map(|model| Channel::ALL.map(|channel| (model, channel)))
        {
            for (reading, place, held_out) in self.all().filter(|row| row.0.channel == channel) {
                let operation = operation(&self.readings.assemblies[reading.setup], reading);
                let is = |point: &PlanPoint| {
                    point.model == model
                        && point.operation == operation.kind
                        && point.bit_depth_m == reading.bit_depth_m
                };
                let of_string = done.iter().filter(|done| done.string == reading.setup);
                let Some(found) =
                    of_string.map(|of_string| &of_string.points).find(|point| point.iter().any(is))
                else {
                    continue;
                };
                let is_torque = reading.channel.is_torque();
                let value = |level: FrictionLevel| {
                    let scalars = found.iter().find(|point| point.friction == level)?.scalars?;
                    Some(match is_torque {
                        true => scalars.surface_torque_N_m,
                        false => scalars.hook_load_N + block_N,
                    })
                };
                rows.push(PlanMeasured {
                    model,
                    place: place.clone(),
                    operation: operation.kind,
                    reading: reading.channel.name().to_owned(),
                    is_torque,
                    held_out,
                    bit_depth_m: reading.bit_depth_m,
                    measured: reading.value,
                    block_N: if is_torque { 0.0 } else { block_N },
                    predicted: FrictionLevel::ALL.map(value),
                    message: found.iter().find_map(|point| point.message.clone()),
                });
            }
        }
        rows
    }
}
