//! A run that starts on the hole's axis, untwisted.

use wholestring::{
    dynamics::{CentredStart, HoistControl, HoistLine, RodDamping, Start, StartTension},
    operation::OperationKind,
};

use crate::{
    common::{assert_close, operation},
    wells::{Case, STRAIGHT_DEG, between, go, line, mean_between, mud, straight},
};

/// At time zero the tension is that of a string without friction, `w cos i (L − s) − W`; nothing is
/// twisted.
///
/// One step after the start: 0.2 % of the largest tension, which is due to the impact of gravity
/// across the axis and the elements' finite length (half an element's weight is 0.1 % of it).
#[test]
fn it_starts_with_its_static_tension() {
    let (length, weight) = (1000.0, 20e3);
    let drill = operation(OperationKind::Drill, length)
        .weight_on_bit_N(weight)
        .rate_of_penetration_m_per_s(5.0 / 3600.0);
    let mut case = Case::new(straight(length, 0.3), drill);
    case.settings.start = Start::Centred;
    case.settings.settle_s = 0.0;
    case.settings.sample_interval_s = 1e-6;
    let mut simulation = case.start();
    let step_s = simulation.sample_interval_s();
    go(&mut simulation, step_s);
    let outcome = simulation.outcome();
    let pipe = &case.model.string.components()[0];
    let along = pipe.buoyed_weight_per_length_N_per_m(mud().density_kg_per_m3)
        * STRAIGHT_DEG.to_radians().cos();
    let largest = along * length - weight;
    let nodes = &outcome.nodes;
    let bit_md = nodes.md_m[nodes.md_m.len() - 1];
    for i in 1..nodes.md_m.len() - 1 {
        let expected = along * (bit_md - nodes.md_m[i]) - weight;
        let error = (nodes.tension_N[i] - expected).abs() / largest;
        assert!(error < 2e-3, "{error:e} at {} m", nodes.md_m[i]);
        assert!(nodes.torque_N_m[i].abs() < 1.0, "{} N·m", nodes.torque_N_m[i]);
    }
    assert!(outcome.scalars.twist_rad.abs() < 1e-3);
    assert_close("hook load", outcome.scalars.hook_load_N, largest, 2e-3);
}

/// Drilling from a centred start reaches its weight on bit: the block moves at the rate of
/// penetration from the first, and the autodriller makes up for the rest at its slower rate,
/// 0.15/s: after 40 s `e⁻⁶` of the deficit, 0.3 %, is left.
#[test]
fn a_centred_start_finds_its_weight_on_bit() {
    let (length, weight) = (1000.0, 20e3);
    let drill = operation(OperationKind::Drill, length)
        .weight_on_bit_N(weight)
        .rate_of_penetration_m_per_s(5.0 / 3600.0);
    let mut case = Case::new(straight(length, 0.0), drill);
    case.settings.start = Start::Centred;
    case.settings.settle_s = 0.0;
    let mut simulation = case.start();
    go(&mut simulation, 50.0);
    let series = simulation.outcome().series;
    let found = mean_between(&series.time_s, &series.weight_on_bit_N, 40.0, 50.0);
    assert_close("weight on bit", found, weight, 5e-3);
}

/// A front of slip runs down an untwisted string that rests on its wall and is turned at the top:
/// with `q` the friction torque per metre it reaches `z = √(2 GJ Ω t/q)`, where the twist `q z²/(2
/// GJ)` equals the rotation of the top, whose torque is `q z`. The square of the surface torque
/// grows by `2 GJ Ω q` each second.
///
/// `q = μ r w sin i/√(1 + μ²)`: the pipe climbs. Within 3 %: the climb takes its time, and the
/// inertia of the turning part adds `½ ρJ Ω dz/dt`, 0.1 % of the torque.
#[test]
fn a_front_of_slip_winds_the_string_up() {
    let (length, mu) = (2400.0, 0.3);
    let mut operation = operation(OperationKind::RotateOffBottom, length);
    operation.rotary_speed_rad_per_s = 1.0;
    let mut case = Case::new(straight(length, mu), operation);
    case.settings.start = Start::Centred;
    case.lasts(0.0, 8.0);
    let mut simulation = case.start();
    go(&mut simulation, 8.0);
    let series = simulation.outcome().series;
    let pipe = &case.model.string.components()[0];
    let across = pipe.buoyed_weight_per_length_N_per_m(mud().density_kg_per_m3)
        * STRAIGHT_DEG.to_radians().sin();
    let q = mu * pipe.contact_radius_m() * across / mu.hypot(1.0);
    let expected = 2.0 * pipe.torsional_stiffness_N_m2() * q * operation.rotary_speed_rad_per_s;
    let time = between(&series.time_s, &series.time_s, 3.0, 8.0);
    let square: Vec<f64> = between(&series.time_s, &series.surface_torque_N_m, 3.0, 8.0)
        .iter()
        .map(|t| t * t)
        .collect();
    let (found, at_zero) = line(&time, &square);
    assert_close("growth of the squared torque", found, expected, 0.03);
    let reach = expected.sqrt() * 8.0f64.sqrt() / q;
    assert!(reach < length, "the front reaches {reach} m");
    // The top reaches its speed within a second: it has turned as if it had started half a second
    // late.
    assert!((-at_zero / found - 0.5).abs() < 0.2);
}

/// A cold string that hangs from a fixed top takes all of its weight at once. The top feels
/// `ρAc g cos i t`, buoyed, until the wave from the lower end is back at `2L/c`; there it is twice
/// the weight, and back at nothing at `4L/c`.
///
/// 1 % of the peak: the elements round off its tip and ring by less than that about the straight
/// lines.
#[test]
fn a_cold_start_drops_the_string_into_its_weight() {
    let length = 1600.0;
    let mut hang = operation(OperationKind::RotateOffBottom, length);
    hang.rotary_speed_rad_per_s = 0.1;
    let mut case = Case::new(straight(length, 0.0), hang);
    case.settings.start = Start::Centred;
    case.settings.centred.tension = StartTension::Cold;
    case.settings.settle_s = 0.0;
    case.settings.hoist_control = Some(HoistControl::BlockVelocity(0.0));
    case.settings.hoist_line =
        HoistLine { stiffness_N_per_m: 1e11, damping_N_s_per_m: 0.0, block_mass_kg: 0.0 };
    case.settings.damping = RodDamping { mass_per_s: 0.0, stiffness_s: 1e-5 };
    let pipe = &case.model.string.components()[0];
    let weight = length
        * pipe.buoyed_weight_per_length_N_per_m(mud().density_kg_per_m3)
        * STRAIGHT_DEG.to_radians().cos();
    let material = pipe.material;
    let back_s = 2.0 * length / (material.youngs_modulus_Pa / material.density_kg_per_m3).sqrt();
    let mut simulation = case.start();
    go(&mut simulation, 2.2 * back_s);
    let series = simulation.outcome().series;
    for (time, load) in series.time_s.iter().zip(&series.hook_load_N) {
        // A sample is the mean over the interval that it ends.
        let part = (time - 0.5 * case.settings.sample_interval_s) / back_s;
        let expected = 2.0 * weight * (1.0 - (part - 1.0).abs()).abs();
        let error = (load - expected).abs() / (2.0 * weight);
        assert!(error < 0.01 || part > 1.9, "{load} N at {part} of the way, expected {expected} N");
    }
}

/// The ramp of the rotary speed is linear, and takes the time that is set; none is a blow.
#[test]
fn the_ramp_is_as_set() {
    for ramp_s in [0.0, 0.8] {
        let hang = operation(OperationKind::RotateOffBottom, 100.0);
        let mut case = Case::new(straight(100.0, 0.3), hang);
        case.settings.start = Start::Centred;
        case.settings.centred = CentredStart { ramp_s, ..CentredStart::default() };
        case.settings.settle_s = 0.0;
        let mut simulation = case.start();
        go(&mut simulation, 1.0);
        let outcome = simulation.outcome();
        let (series, step_s) = (outcome.series, outcome.numerics.time_step_s);
        for (time, speed) in series.time_s.iter().zip(&series.rotary_speed_rad_per_s) {
            let part = if ramp_s > 0.0 { (time / ramp_s).min(1.0) } else { 1.0 };
            // The step that ends at a time set its speed at its beginning.
            let late = if ramp_s > 0.0 { 1.0001 * step_s / ramp_s } else { 1e-3 };
            let expected = part * hang.rotary_speed_rad_per_s;
            assert!((speed - expected).abs() <= late * hang.rotary_speed_rad_per_s);
        }
    }
}
