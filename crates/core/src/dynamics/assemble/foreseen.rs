//! The operations that the mesh of a run is chosen for: its own, and those that its schedule and its
//! hoist bring.

use crate::{
    GRAVITY_M_PER_S2,
    dynamics::settings::{
        DynamicsSettings, FrictionLaw, HoistControl,
        schedule::{HoistSetPoint, ScheduleStep},
    },
    model::Model,
    operation::{Operation, OperationKind},
    rod::{buckled_element::BuckledElement, mesh::Mesh},
    statics::soft::{self, SoftError, SoftSettings},
};

/// Weights that exceed the operation's by less than this part leave the mesh as it is: a lift that
/// is tuned for a weight brings no other one.
const SAME_WEIGHT: f64 = 0.1;

/// Halvings of the interval that holds a weight: a hundredth of it is left.
const HALVINGS: usize = 7;

/// Step of the soft string, m.
const STEP_M: f64 = 4.0;

/// The operation of a run; where a schedule may stop its rotation, the string that slides; and both
/// with the heaviest weight on bit, or going down, where schedule or hoist bring that.
///
/// # Errors
/// A soft string without solution.
pub fn operations(
    model: &Model,
    operation: &Operation,
    settings: &DynamicsSettings,
) -> Result<Vec<Operation>, SoftError> {
    let mut operations = vec![*operation];
    let mut add_with_sliding = |one: Operation, is_own: bool| {
        let slid = Operation { kind: one.kind.without_rotation(), ..one };
        if !is_own {
            operations.push(one);
        }
        if !settings.schedule.is_empty() && slid.kind != one.kind {
            operations.push(slid);
        }
    };
    add_with_sliding(*operation, true);
    if operation.kind.on_bottom() {
        let weight_N = heaviest_N(model, operation, settings)?;
        if weight_N > operation.weight_on_bit_N {
            add_with_sliding(Operation { weight_on_bit_N: weight_N, ..*operation }, false);
        }
    } else if lowers(settings)
        && let Some(kind) = going_down(operation.kind)
    {
        add_with_sliding(Operation { kind, ..*operation }, false);
    }
    Ok(operations)
}

/// Whether a line of the schedule moves the block down.
fn lowers(settings: &DynamicsSettings) -> bool {
    let mut lines = settings.schedule.steps.iter();
    lines.any(|line| matches!(line.hoist, Some(HoistSetPoint::BlockVelocity(v)) if v > 0.0))
}

/// The kind of operation in which a string off bottom goes down, where its own does not.
fn going_down(kind: OperationKind) -> Option<OperationKind> {
    match kind {
        OperationKind::TripOut => Some(OperationKind::TripIn),
        OperationKind::BackReam | OperationKind::RotateOffBottom => Some(OperationKind::Ream),
        _ => None,
    }
}

/// The heaviest weight on bit that the set points bring, N; the operation's own where that is it.
fn heaviest_N(
    model: &Model,
    operation: &Operation,
    settings: &DynamicsSettings,
) -> Result<f64, SoftError> {
    let own_N = operation.weight_on_bit_N;
    let mut heaviest_N = own_N;
    for line in &settings.schedule.steps {
        if let Some(HoistSetPoint::WeightOnBit(weight_N)) = line.hoist {
            heaviest_N = heaviest_N.max(weight_N);
        }
    }
    // Friction that opposes each motion by itself drags a string that turns as one that slides.
    let dragged = match settings.friction_law {
        FrictionLaw::Vector => *operation,
        FrictionLaw::Independent => {
            Operation { kind: operation.kind.without_rotation(), ..*operation }
        }
    };
    let beyond = |weight_N: f64| weight_N > (1.0 + SAME_WEIGHT) * own_N;
    match settings.hoist_control {
        Some(HoistControl::HookLoad(lift_N))
            if settings.schedule.hoist_at_time_zero().is_none() =>
        {
            let delivered_N = delivered_N(model, &dragged, lift_N)?;
            if beyond(delivered_N) {
                heaviest_N = heaviest_N.max(delivered_N);
            }
        }
        _ => {}
    }
    let pushed_N = pushed_N(model, operation, settings, heaviest_N);
    if pushed_N > heaviest_N && beyond(pushed_N) {
        let block_N = settings.hoist_line.block_mass_kg * GRAVITY_M_PER_S2;
        let slack_N = delivered_N(model, &dragged, -block_N - model.rig.push_N())?;
        heaviest_N = heaviest_N.max(pushed_N.min(slack_N));
    }
    Ok(heaviest_N)
}

/// The weight that arrives at the bit under a hook load, N, by the soft string; the operation's own
/// where less arrives.
fn delivered_N(model: &Model, operation: &Operation, hook_load_N: f64) -> Result<f64, SoftError> {
    let own_N = operation.weight_on_bit_N;
    let settings = SoftSettings { step_m: STEP_M, ..SoftSettings::default() };
    let spare_N = |weight_N: f64| -> Result<f64, SoftError> {
        let heavier = Operation { weight_on_bit_N: weight_N, ..*operation };
        let solved = soft::solve(model, &heavier, &settings)?;
        Ok(solved.scalars.hook_load_N - hook_load_N)
    };
    let spare_now_N = spare_N(own_N)?;
    if spare_now_N <= 0.0 {
        return Ok(own_N);
    }
    // Weight released at the hook reaches the bit, less the friction that it adds.
    let mut weights_N = [own_N, own_N + spare_now_N];
    if spare_N(weights_N[1]).is_ok_and(|spare_N| spare_N >= -1e-3 * spare_now_N) {
        return Ok(weights_N[1]);
    }
    for _ in 0..HALVINGS {
        let middle_N = 0.5 * (weights_N[0] + weights_N[1]);
        // A weight that no hook load brings to the bit is more than arrives.
        let arrives = spare_N(middle_N).is_ok_and(|spare_N| spare_N >= 0.0);
        weights_N[usize::from(!arrives)] = middle_N;
    }
    Ok(weights_N[1])
}

/// Weight on bit that a block of a given velocity causes, N: limited by the weight at which the bit
/// drills as fast, and by the compression of string and line over the block's travel.
fn pushed_N(model: &Model, operation: &Operation, settings: &DynamicsSettings, from_N: f64) -> f64 {
    let lines = &settings.schedule.steps;
    let start = match settings.hoist_control {
        Some(HoistControl::BlockVelocity(velocity)) => Some((0.0, velocity)),
        _ => None,
    };
    let moves = lines.iter().filter_map(|line| Some((line.at_s, velocity_m_per_s(line)?)));
    let moves: Vec<(f64, f64)> = start.into_iter().chain(moves).collect();
    let compliance_m_per_N = 1.0 / settings.hoist_line.stiffness_N_per_m
        + model
            .string
            .components()
            .iter()
            .map(|one| one.length_m / one.axial_stiffness_N())
            .sum::<f64>();
    let turning = lines.iter().filter_map(|line| line.rotary_speed_rad_per_s);
    let slowest = turning.fold(operation.rotation_rad_per_s(), f64::min).max(0.0);
    let (mut travel_m, mut heaviest_N) = (0.0_f64, 0.0_f64);
    for (index, (at_s, velocity)) in moves.iter().enumerate() {
        let end_s = moves.get(index + 1).map_or(settings.longest_s(), |(next_s, _)| *next_s);
        // A block that was raised before goes down as far without a push.
        travel_m += velocity * (end_s - at_s);
        if *velocity > 0.0 && travel_m > 0.0 {
            let taken_up_N = from_N + travel_m / compliance_m_per_N;
            let drills = |weight_N: f64| {
                let stands = operation.kind.rotates() && slowest == 0.0;
                let bit = &settings.bit;
                !stands && bit.axial_velocity_m_per_s(operation, weight_N, slowest) >= *velocity
            };
            heaviest_N = heaviest_N.max(least_N(taken_up_N, drills));
        }
    }
    heaviest_N
}

/// Velocity of the block that a line of the schedule sets, m/s, positive downwards; zero where the
/// autodriller takes over, none where the line does not name the hoist.
fn velocity_m_per_s(line: &ScheduleStep) -> Option<f64> {
    line.hoist.map(|hoist| match hoist {
        HoistSetPoint::BlockVelocity(velocity) => velocity,
        HoistSetPoint::WeightOnBit(_) => 0.0,
    })
}

/// The least weight, N, that serves, to a hundredth of the most; the most where none does.
fn least_N(most_N: f64, serves: impl Fn(f64) -> bool) -> f64 {
    if !serves(most_N) {
        return most_N;
    }
    let mut ends_N = [0.0, most_N];
    for _ in 0..HALVINGS {
        let middle_N = 0.5 * (ends_N[0] + ends_N[1]);
        ends_N[usize::from(serves(middle_N))] = middle_N;
    }
    ends_N[1]
}

/// The element of a mesh that an operation loads most beyond its own buckling load, by the soft
/// string; none where all are short enough, and where the soft string has no answer.
pub fn buckled_element(
    model: &Model,
    operation: &Operation,
    mesh: &Mesh,
) -> Option<BuckledElement> {
    let settings = SoftSettings { step_m: STEP_M, ..SoftSettings::default() };
    let soft = soft::solve(model, operation, &settings).ok()?;
    let md_m = |node: usize| operation.bit_depth_m - mesh.nodes[node].from_bit_m;
    BuckledElement::most(mesh, md_m, |index| {
        -soft.tension_at_N(0.5 * (md_m(index) + md_m(index + 1)))
    })
}
