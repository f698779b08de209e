//! Predictions of the readings.

use wholestring::{
    operation::{Operation, OperationKind},
    statics::soft::{self, SoftSettings},
    well::HoleKind,
};

use super::{CalibrationError, Factors, HolePart, Motion};
use crate::Setup;

/// A request to a model: the loads at surface of a string with its bit at a depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Asked {
    /// Index of the setup in the hole.
    pub setup: usize,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// The motion of the string.
    pub motion: Motion,
    /// Friction of the walls.
    pub factors: Factors,
}

/// Loads at surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Loads {
    /// Hook load, N, without the block.
    pub hook_load_N: f64,
    /// Torque, N·m, without the bit's.
    pub torque_N_m: f64,
}

/// A model that predicts readings: the soft string, the stiff one, or another.
pub trait Predict {
    /// Whether a string with its bit at a depth, m, touches this part of the hole.
    fn reaches(&self, setup: usize, bit_depth_m: f64, part: HolePart) -> bool;

    /// Returns the loads of each, in their order; they may be computed in parallel.
    ///
    /// # Errors
    /// A string for which the model has no solution.
    fn loads(&self, requests: &[Asked]) -> Result<Vec<Loads>, CalibrationError>;
}

/// A string in its hole, and its operations during the readings.
#[derive(Debug, Clone)]
pub struct Assembly {
    /// The string, at any depth.
    pub setup: Setup,
    /// The operations, by [`Motion`]; the depth of the bit is that of the reading.
    pub operations: [Operation; Motion::ALL.len()],
}

/// Default rotary speed, rad/s: 60 rev/min. Off bottom the soft string's torque does not depend on
/// it.
const ROTARY_SPEED_RAD_PER_S: f64 = std::f64::consts::TAU;

impl Assembly {
    /// Returns an assembly with the operations of a case, and usual ones in place of those that it
    /// lacks.
    pub fn new(setup: Setup, operations: &[Operation]) -> Self {
        let operations = Motion::ALL.map(|motion| {
            let kind = match motion {
                Motion::PickUp => OperationKind::TripOut,
                Motion::SlackOff => OperationKind::TripIn,
                Motion::Rotating => OperationKind::RotateOffBottom,
                Motion::Drilling => OperationKind::Drill,
            };
            let named = operations.iter().find(|operation| operation.kind == kind).copied();
            let turning =
                operations.iter().find(|operation| operation.rotary_speed_rad_per_s > 0.0);
            let mut operation = named.or(turning.copied()).unwrap_or(
                Operation::new(kind, 1.0).rotary_speed_rad_per_s(ROTARY_SPEED_RAD_PER_S),
            );
            operation.kind = kind;
            operation
        });
        Self { setup, operations }
    }

    /// Returns the operation with the bit at a depth, m, without the bit's torque.
    pub fn operation(&self, motion: Motion, bit_depth_m: f64) -> Operation {
        let operation = self.operations[motion as usize];
        Operation { bit_depth_m, bit_torque_N_m: 0.0, ..operation }
    }

    /// Whether the string touches this part of the hole.
    pub fn reaches(&self, bit_depth_m: f64, part: HolePart) -> bool {
        let sections = self.setup.well.hole.sections().iter().enumerate();
        let is_of = |place: usize, kind: HoleKind| match part {
            HolePart::Kind(part_kind) => kind == part_kind,
            HolePart::Section(index) => place == index,
        };
        let mut of_part = sections.filter(|(place, section)| is_of(*place, section.kind));
        of_part.any(|(_, section)| section.from_md_m < bit_depth_m)
    }
}

/// Predictions by the soft string.
#[derive(Debug, Clone, Copy)]
pub struct SoftPredictions<'a> {
    /// Strings in their holes.
    pub assemblies: &'a [Assembly],
    /// Settings of the soft string.
    pub settings: SoftSettings,
}

/// Longest step of the soft string, m, for hundreds of strings: it is halved at the kinks of the
/// side force.
const STEP_M: f64 = 5.0;

impl<'a> SoftPredictions<'a> {
    /// Returns predictions by the soft string, with steps suited to the resolution of hook loads.
    pub fn new(assemblies: &'a [Assembly]) -> Self {
        let settings = SoftSettings { step_m: STEP_M, ..SoftSettings::default() };
        Self { assemblies, settings }
    }

    /// Returns one prediction.
    ///
    /// # Errors
    /// A string without a solution.
    pub fn one(&self, request: &Asked) -> Result<Loads, CalibrationError> {
        let assembly = &self.assemblies[request.setup];
        let no_answer = |reason: String| request.no_answer("soft", reason);
        let setup = request.factors.applied_to(&assembly.setup);
        let setup = setup.map_err(|error| no_answer(error.to_string()))?;
        let model = setup.at(request.bit_depth_m).map_err(|error| no_answer(error.to_string()))?;
        let operation = assembly.operation(request.motion, request.bit_depth_m);
        let answer = soft::solve(&model, &operation, &self.settings);
        let scalars = answer.map_err(|error| no_answer(error.to_string()))?.scalars;
        Ok(Loads { hook_load_N: scalars.hook_load_N, torque_N_m: scalars.surface_torque_N_m })
    }
}

impl Asked {
    /// Returns the error of a model without a solution.
    pub fn no_answer(&self, model: &'static str, reason: String) -> CalibrationError {
        CalibrationError::NoAnswer {
            model,
            bit_depth_m: self.bit_depth_m,
            motion: match self.motion {
                Motion::PickUp => "picked up",
                Motion::SlackOff => "slacked off",
                Motion::Rotating => "turned off bottom",
                Motion::Drilling => "drilling",
            },
            along: self.factors.open,
            around: self.factors.open_around,
            reason,
        }
    }
}

impl Predict for SoftPredictions<'_> {
    fn reaches(&self, setup: usize, bit_depth_m: f64, part: HolePart) -> bool {
        self.assemblies[setup].reaches(bit_depth_m, part)
    }

    fn loads(&self, requests: &[Asked]) -> Result<Vec<Loads>, CalibrationError> {
        requests.iter().map(|request| self.one(request)).collect()
    }
}
