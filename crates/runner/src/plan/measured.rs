//! What was measured, held against what the plan would have read.

use serde::{Deserialize, Serialize};
use wholestring::operation::Operation;
use wholestring_case::Measured as Measurements;
use wholestring_plan::{
    Broomstick, BroomstickTask,
    calibration::{Assembly, Channel, Reading},
};
use wholestring_results::{PlanMeasured, PlanPoint};

use super::{request::Request, rows::points};
use crate::{
    error::Error,
    readings::{self, NamedCase, Readings},
};

/// Readings, and the strings that were in the hole with the frictions of the plan.
#[derive(Default)]
pub(super) struct Measured {
    readings: Readings,
    /// One for each string.
    broomsticks: Vec<Broomstick>,
}

/// What is solved for readings: an operation of one of the strings, with every friction.
#[derive(Debug, Clone, Copy)]
pub(super) struct MeasuredTask {
    string: usize,
    pub(super) task: BroomstickTask,
}

/// What came of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct MeasuredDone {
    string: usize,
    points: Vec<PlanPoint>,
}

/// What was done while it was read.
fn operation(assembly: &Assembly, of: &Reading) -> Operation {
    let operation = assembly.operations[of.channel.motion() as usize];
    Operation { bit_depth_m: of.bit_depth_m, ..operation }
}

impl Measured {
    /// What the plan's file has; nothing where it has none.
    pub(super) fn of(request: &Request<'_>) -> Result<Self, Error> {
        let case = request.case;
        let Some(measured) = &case.plan.measured else { return Ok(Self::default()) };
        let named = NamedCase {
            file: String::new(),
            template: request.template,
            overrides: request.overrides,
            case,
        };
        let Measurements { file, readings, half_digit_m, .. } = measured;
        let readings = readings::of_rows(file, readings, *half_digit_m, &[named])?;
        let of_string = |of: &Assembly| {
            let plan = &case.plan;
            let models = plan.models.clone();
            Broomstick::new(&of.setup, &plan.frictions, Vec::new(), Vec::new(), models)
                .map(|of| of.with_settings(case.soft, case.dynamics.stiff_string()))
        };
        let broomsticks = readings.assemblies.iter().map(of_string);
        let broomsticks = broomsticks.collect::<Result<_, _>>().map_err(Error::failed)?;
        Ok(Self { readings, broomsticks })
    }

    /// Every reading with its place in the file, and whether it is held out.
    fn all(&self) -> impl Iterator<Item = (&Reading, &String, bool)> {
        let of = &self.readings;
        let used = of.readings.iter().zip(&of.places).map(|(of, place)| (of, place, false));
        let held_out = of.held_out.iter().zip(&of.held_out_places);
        used.chain(held_out.map(|(of, place)| (of, place, true)))
    }

    /// What is to be solved: a weight and a torque of one operation once.
    pub(super) fn tasks(&self, request: &Request<'_>) -> Vec<MeasuredTask> {
        let mut tasks: Vec<MeasuredTask> = Vec::new();
        for &model in &request.case.plan.models {
            for (reading, ..) in self.all() {
                let string = reading.setup;
                let operation = operation(&self.readings.assemblies[string], reading);
                let task = BroomstickTask { model, operation };
                if !tasks.iter().any(|of| of.string == string && of.task == task) {
                    tasks.push(MeasuredTask { string, task });
                }
            }
        }
        tasks
    }

    /// The answers of one.
    pub(super) fn solve(&self, of: &MeasuredTask) -> MeasuredDone {
        let found = self.broomsticks[of.string].solve(&of.task);
        MeasuredDone { string: of.string, points: points(&found) }
    }

    /// Every reading beside what was found, channel after channel; those that the plan did not come to are left out.
    pub(super) fn rows(&self, request: &Request<'_>, done: &[MeasuredDone]) -> Vec<PlanMeasured> {
        let block_N = request.case.model.rig.block_weight_N.unwrap_or(0.0);
        let mut rows = Vec::new();
        let models = request.case.plan.models.iter();
        for (model, channel) in models.flat_map(|of| Channel::ALL.map(|channel| (of, channel))) {
            for (reading, place, held_out) in self.all().filter(|of| of.0.channel == channel) {
                let operation = operation(&self.readings.assemblies[reading.setup], reading);
                let is = |of: &PlanPoint| {
                    of.model == model.name()
                        && of.operation == operation.kind.name()
                        && of.bit_depth_m == reading.bit_depth_m
                };
                let of_string = done.iter().filter(|of| of.string == reading.setup);
                let Some(found) = of_string.map(|of| &of.points).find(|of| of.iter().any(is))
                else {
                    continue;
                };
                let is_torque = reading.channel.is_torque();
                let value = |level: &str| {
                    let scalars = found.iter().find(|of| of.friction == level)?.scalars?;
                    Some(match is_torque {
                        true => scalars.surface_torque_N_m,
                        false => scalars.hook_load_N + block_N,
                    })
                };
                rows.push(PlanMeasured {
                    model: model.name().to_owned(),
                    place: place.clone(),
                    operation: operation.kind.name().to_owned(),
                    reading: reading.channel.name().to_owned(),
                    is_torque,
                    held_out,
                    bit_depth_m: reading.bit_depth_m,
                    measured: reading.value,
                    block_N: if is_torque { 0.0 } else { block_N },
                    predicted: super::levels::LEVELS.map(value),
                    message: found.iter().find_map(|of| of.message.clone()),
                });
            }
        }
        rows
    }
}
