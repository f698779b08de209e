//! Inputs of the initial condition.

use crate::{
    dynamics::{
        boundary::{executor::SharedExecutor, hole::Borehole, mud::viscous::Viscous},
        kernel::{
            places::Border,
            step::{StepInput, Stepper},
        },
        settings::DynamicsSettings,
    },
    model::Model,
    operation::{Operation, OperationKind},
    rod::mesh::Mesh,
};

/// Inputs of the initial condition.
#[derive(Debug, Clone, Copy)]
pub struct Scene<'a> {
    /// Well, string and mud.
    pub model: &'a Model,
    /// Operation that matches the string's motion at time zero: [`motion`].
    pub operation: &'a Operation,
    /// Whether the string neither turns nor slides at time zero.
    pub at_rest: bool,
    /// Settings of the start.
    pub settings: &'a DynamicsSettings,
    /// The string cut into elements.
    pub mesh: &'a Mesh,
    /// The hole around it.
    pub borehole: &'a Borehole,
    /// The mud that drags on it, if any.
    pub viscous: Option<&'a Viscous>,
    /// Stepper used while the string settles.
    pub stepper: &'a Stepper,
    /// Border at which the chain is divided meanwhile.
    pub border: Option<Border>,
    /// The step of the whole, or of the upper region.
    pub input: &'a StepInput,
    /// Axial velocity of the whole string, m/s.
    pub velocity_m_per_s: f64,
    /// Executor that is polled for a stop request meanwhile.
    pub executor: &'a SharedExecutor,
}

/// Returns the kind of `operation` that matches the string's motion at time zero, and whether it is
/// at rest.
///
/// Without a schedule it is unchanged. A schedule may begin with another motion: a string that does
/// not rotate yet is run in or pulled out, or hangs still.
pub fn motion(
    operation: &Operation,
    axial_m_per_s: f64,
    settings: &DynamicsSettings,
) -> (Operation, bool) {
    if settings.schedule.is_empty() {
        return (*operation, false);
    }
    let pressed = operation.weight_on_bit_now_N() > 0.0;
    let turns = operation.rotation_rad_per_s() > 0.0;
    let kind = match (turns, pressed) {
        (_, true) if turns == operation.kind.rotates() => operation.kind,
        (_, true) => OperationKind::Slide,
        (true, false) if axial_m_per_s > 0.0 => OperationKind::Ream,
        (true, false) if axial_m_per_s < 0.0 => OperationKind::BackReam,
        (true, false) => OperationKind::RotateOffBottom,
        (false, false) if axial_m_per_s < 0.0 => OperationKind::TripOut,
        (false, false) => OperationKind::TripIn,
    };
    let operation = Operation { kind, trip_speed_m_per_s: axial_m_per_s.abs(), ..*operation };
    (operation, !turns && axial_m_per_s == 0.0)
}
