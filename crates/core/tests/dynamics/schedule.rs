//! Set points that change while the run continues.

use wholestring::{
    dynamics::{
        HoistSetPoint, Schedule, ScheduleFault, ScheduleStep, SpeedController, TopDriveSettings,
    },
    outcome::{TIME_SERIES, TimeSeries, Values},
    prelude::*,
};

use crate::{
    common::{assert_close, operation, rpm},
    wells::{Case, between, go, line, mean_between, straight},
};

const MU: f64 = 0.25;

fn at(at_s: f64, ramp_s: f64) -> ScheduleStep {
    ScheduleStep { at_s, ramp_s, ..ScheduleStep::default() }
}

fn turning(at_s: f64, ramp_s: f64, revolutions_per_minute: f64) -> ScheduleStep {
    ScheduleStep { rotary_speed_rad_per_s: Some(rpm(revolutions_per_minute)), ..at(at_s, ramp_s) }
}

fn moving(at_s: f64, ramp_s: f64, hoist: HoistSetPoint) -> ScheduleStep {
    ScheduleStep { hoist: Some(hoist), ..at(at_s, ramp_s) }
}

/// 300 m off bottom in a slant hole, at rest for two seconds, then brought to 60 rev/min in three
/// by a drive with inertia.
fn start_up() -> Case {
    let turn = operation(OperationKind::RotateOffBottom, 300.0);
    let mut case = Case::new(straight(300.0, MU), turn);
    case.operation.rotary_speed_rad_per_s = rpm(60.0);
    case.settings.top_drive = TopDriveSettings::Driven {
        inertia_kg_m2: 2900.0,
        controller: SpeedController::Pi { proportional_N_m_s: 38e3, integral_N_m: 100e3 },
        torque_limit_N_m: None,
    };
    case.settings.schedule.steps = vec![turning(0.0, 0.0, 0.0), turning(2.0, 3.0, 60.0)];
    case
}

/// Before the first line changes something the string is untwisted and at rest; in the end it
/// carries the torque of the same string that has turned all along, and its set point is the plan's
/// at every sample. The drive's inertia is in the energy balance.
///
/// The mean torque of the two windows agrees within 0.5 %, the remainder of the contact's slow
/// rolling after ten seconds.
#[test]
fn a_string_starts_to_turn_by_the_plan() {
    let case = start_up();
    let outcome = case.run();
    let series = &outcome.series;
    for (i, &time) in series.time_s.iter().enumerate() {
        let plan = rpm(60.0) * ((time - 2.0) / 3.0).clamp(0.0, 1.0);
        // A line begins with the first step after its time, so that the step in which the ramp
        // begins does not follow it.
        let begins = time - 2.0 < outcome.numerics.time_step_s;
        let late = if begins { rpm(60.0) / 3.0 * outcome.numerics.time_step_s } else { 1e-9 };
        assert!((series.rotary_speed_set_rad_per_s[i] - plan).abs() < late, "{time}");
        if time < 2.0 {
            assert!(series.surface_torque_N_m[i].abs() < 1.0, "{time}");
            assert!(series.bit_rotary_speed_rad_per_s[i].abs() < 1e-3, "{time}");
            assert_eq!(series.schedule_line[i], 1);
        }
    }
    let mut always = case;
    always.settings.schedule = Schedule::default();
    let steady = always.run().scalars;
    let torque = outcome.scalars.surface_torque_N_m;
    assert_close("torque when started", torque, steady.surface_torque_N_m, 5e-3);
    assert!(outcome.numerics.energy_residual.abs() < 1e-3);
}

/// Written to a checkpoint in the middle of a ramp, a run continues to the same bits.
#[test]
fn a_plan_is_taken_up_where_it_was_left() {
    let case = start_up();
    let mut whole = case.start();
    go(&mut whole, 3.0);
    let checkpoint = whole.checkpoint().into_owned();
    go(&mut whole, 2.0);
    let resumed = Simulation::resume(&case.model, &case.operation, &case.settings, checkpoint);
    let mut resumed = resumed.expect("the same run");
    go(&mut resumed, 2.0);
    assert_eq!(whole.outcome(), resumed.outcome());
}

/// The same to the last bit: the first column that is not is named.
fn assert_same(one: &TimeSeries, other: &TimeSeries) {
    for column in TIME_SERIES {
        let (Values::Numbers(one), Values::Numbers(other)) = ((column.of)(one), (column.of)(other))
        else {
            continue;
        };
        let bits = |values: &[f64]| values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
        let (one, other) = (bits(&one), bits(&other));
        let first = one.iter().zip(&other).position(|(a, b)| a != b);
        assert_eq!((first, one.len()), (None, other.len()), "{}", column.quantity.name);
    }
}

/// Lines that are added as the run goes act as those of its plan do, a checkpoint holds them, and one
/// takes over from another in the middle of its ramp.
#[test]
fn a_line_that_is_added_acts_as_one_of_the_plan() {
    let mut planned = start_up();
    let mut live = planned.clone();
    planned.settings.schedule.steps.push(turning(5.0, 1.0, 20.0));
    live.settings.schedule.steps.truncate(1);
    let lines = [turning(2.0, 3.0, 60.0), turning(5.0, 1.0, 20.0)];
    let (mut planned, mut early, mut late) = (planned.start(), live.start(), live.start());
    for line in &lines {
        early.add_to_schedule(line.clone()).expect("a sound line");
    }
    go(&mut late, 1.0);
    // The second goes before the one that is there, in the order of their times.
    for line in lines.iter().rev() {
        late.add_to_schedule(line.clone()).expect("a sound line");
    }
    go(&mut late, 2.0);
    let checkpoint = late.checkpoint().into_owned();
    let resumed = Simulation::resume(&live.model, &live.operation, &live.settings, checkpoint);
    let mut resumed = resumed.expect("the same run");
    for (simulation, seconds) in
        [(&mut planned, 7.0), (&mut early, 7.0), (&mut late, 4.0), (&mut resumed, 4.0)]
    {
        go(simulation, seconds);
    }
    assert_same(early.series(), late.series());
    assert_same(early.series(), resumed.series());
    assert_eq!(early.series().schedule_line, planned.series().schedule_line);
    let set = |simulation: &Simulation| simulation.series().rotary_speed_set_rad_per_s.clone();
    assert_eq!(set(&early), set(&planned));

    // In the middle of the ramp, and late: from where it is.
    let mut simulation = live.start();
    simulation.add_to_schedule(turning(2.0, 3.0, 60.0)).expect("a sound line");
    go(&mut simulation, 3.5);
    simulation.add_to_schedule(turning(0.0, 0.0, 0.0)).expect("a sound line");
    go(&mut simulation, 0.5);
    let set = &simulation.series().rotary_speed_set_rad_per_s;
    assert_close("in the ramp", set[set.len() / 2 + set.len() / 4], rpm(60.0) / 3.0, 0.05);
    assert_eq!(set.last(), Some(&0.0));
    let endless = simulation.add_to_schedule(turning(f64::NAN, 0.0, 0.0));
    assert_eq!(endless, Err(ScheduleFault::Range));
}

/// The block stops by the plan while the bit drills, and the weight on bit decays at the
/// drill-off's rate `k v₀/W₀`, `k` that of pipe, line and rock in series; then the autodriller
/// brings it to another target by an integral, without which it would stay short of it.
///
/// Within 0.2 % for the rate, as where the block is stopped by hand; 0.5 % for the weight, of which
/// an integral of 10 s has left `e^(−50 s/12 s)` of the half that was missing.
#[test]
fn the_block_stops_and_the_autodriller_takes_over_by_the_plan() {
    let (length, weight, rate) = (1000.0, 20e3, 5.0 / 3600.0);
    let drill = operation(OperationKind::Drill, length)
        .weight_on_bit_N(weight)
        .rate_of_penetration_m_per_s(rate);
    let mut case = Case::new(straight(length, 0.0), drill);
    case.settings.damping.mass_per_s = 0.0;
    case.settings.autodriller.integral_time_s = 10.0;
    case.settings.schedule.steps = vec![
        moving(10.0, 0.0, HoistSetPoint::BlockVelocity(0.0)),
        moving(40.0, 10.0, HoistSetPoint::WeightOnBit(15e3)),
    ];
    let mut simulation = case.start();
    go(&mut simulation, 110.0);
    let series = simulation.outcome().series;
    let time = between(&series.time_s, &series.time_s, 12.0, 40.0);
    let logarithm: Vec<f64> = between(&series.time_s, &series.weight_on_bit_N, 12.0, 40.0)
        .iter()
        .map(|w| w.ln())
        .collect();
    let pipe = &case.model.string.components()[0];
    let line_N_per_m = case.settings.hoist_line.stiffness_N_per_m;
    let compliance = length / pipe.axial_stiffness_N() + 1.0 / line_N_per_m + 1.0 / 1e8;
    let expected = rate / weight / compliance;
    assert_close("rate of the drill-off", -line(&time, &logarithm).0, expected, 2e-3);
    let end = mean_between(&series.time_s, &series.weight_on_bit_N, 100.0, 110.0);
    assert_close("weight on bit in the end", end, 15e3, 5e-3);
    let row = |time_s: f64| series.time_s.iter().position(|t| *t >= time_s).expect("a row");
    assert_eq!(series.block_velocity_set_m_per_s[row(20.0)], Some(0.0));
    assert_eq!(series.weight_on_bit_set_N[row(20.0)], None);
    assert_eq!(series.weight_on_bit_set_N[row(60.0)], Some(15e3));
    let ramp = series.weight_on_bit_set_N[row(45.0)].expect("a target");
    assert!(ramp > 3e3 && ramp < 12e3, "{ramp}");
}

#[test]
fn plans_that_cannot_be_followed_are_refused() {
    let fault = |steps: Vec<ScheduleStep>| Schedule { steps }.fault();
    let stop = HoistSetPoint::BlockVelocity(0.0);
    assert_eq!(
        fault(vec![turning(5.0, 0.0, 10.0), turning(4.0, 0.0, 20.0)]),
        Some((1, ScheduleFault::Order))
    );
    assert_eq!(
        fault(vec![turning(5.0, 3.0, 10.0), turning(7.0, 0.0, 20.0)]),
        Some((1, ScheduleFault::Ramping("rpm")))
    );
    assert_eq!(
        fault(vec![moving(5.0, 0.0, stop), moving(5.0, 0.0, HoistSetPoint::WeightOnBit(1e4))]),
        Some((1, ScheduleFault::Ramping("the hoist")))
    );
    assert_eq!(fault(vec![turning(f64::NAN, 0.0, 10.0)]), Some((0, ScheduleFault::Range)));
    // Ramps of different set points may overlap, and one may follow the other at once.
    let valid = vec![turning(5.0, 3.0, 10.0), moving(6.0, 1.0, stop), turning(8.0, 0.0, 20.0)];
    assert_eq!(fault(valid), None);
}
