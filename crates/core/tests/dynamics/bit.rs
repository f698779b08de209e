//! The bit's laws under a whole string.

use wholestring::{
    dynamics::{
        BitLaw, BitSettings, BitTable, Cutters, DetournayDefournyLaw, Excitation, Motor, RateLaw,
        RegenerativeLaw, TableLaw, TablePoint,
    },
    prelude::*,
    well::Interpolation,
};

use crate::{
    common::{DRAG_BIT, MOTOR, SMOOTH, operation, path, rpm, verify},
    wells::{Case, between, model, np13, rate_from, statistic, tool},
};

const DEPTH_M: f64 = 1000.0;

/// [`DRAG_BIT`] in a hole of 8-1/2 in, worn.
const LAW: RegenerativeLaw = RegenerativeLaw {
    cutters: Cutters { radius_m: 0.107_95, wear_flat_m: 5e-3, ..DRAG_BIT.cutters },
    ..DRAG_BIT
};

/// Collars and pipe in a vertical well, drilling with a drag bit at a rotary speed.
fn vertical(revolutions_per_minute: f64) -> Case {
    let vertical = model(
        path(&[[0.0, 0.0, 0.0], [DEPTH_M + 20.0, 0.0, 0.0]], Interpolation::Spline),
        vec![HoleSection::open(0.0..(DEPTH_M + 20.0), 0.2159, 0.2)],
        vec![
            tool("bit", ComponentLength::Metres(0.3), 0.2159, 0.0),
            tool("collars", ComponentLength::Metres(100.0), 0.1651, 0.0714),
            tool("pipe", ComponentLength::ToSurface, 0.127, 0.1086),
        ],
        DEPTH_M,
    );
    let bit = BitSettings { law: BitLaw::Regenerative(LAW), ..BitSettings::default() };
    let drill = operation(OperationKind::Drill, DEPTH_M)
        .rotary_speed_rad_per_s(rpm(revolutions_per_minute))
        .weight_on_bit_N(60e3);
    let mut case = Case::new(vertical, bit.drilling_steadily(drill));
    case.settings.bit = bit;
    case.lasts(60.0, 30.0);
    case
}

/// Turning fast enough, a drag bit under a whole string drills steadily: weight, torque and rate of
/// penetration are those of the cutting law's closed form. Expected is rounding and the remainder
/// of the start: 1e-4 within a minute.
#[test]
fn a_fast_drag_bit_drills_steadily() {
    let mut case = vertical(200.0);
    case.settings.settle_s = 60.0;
    let outcome = case.run();
    let cutting_N = 60e3 - 60e6 * 0.107_95 * 5e-3;
    let depth_of_cut_m = cutting_N / (0.6 * 0.107_95 * 60e6);
    let torque = 0.5 * 0.107_95 * (cutting_N / 0.6 + 0.6 * (60e3 - cutting_N));
    let series = &outcome.series;
    let rate = rate_from(series, 60.0);
    let spin = statistic(&outcome, "bit_rotary_speed_rad_per_s");
    let weight = statistic(&outcome, "weight_on_bit_N");
    for (quantity, expected, computed) in [
        ("weight on bit, N", 60e3, weight.mean),
        ("torque on bit, N·m", torque, statistic(&outcome, "bit_torque_N_m").mean),
        ("rate of penetration, m/s", depth_of_cut_m * rpm(200.0) / std::f64::consts::TAU, rate),
        ("depth of cut, m", depth_of_cut_m, *series.depth_of_cut_m.last().expect("a sample")),
    ] {
        verify("E07", format!("whole string at 200 rev/min: {quantity}"))
            .relative(5e-4, "remainder of the start after a minute")
            .report(expected, computed);
    }
    assert!(spin.std < 1e-3 * spin.mean, "{spin:?}");
    assert!(weight.std < 1e-3 * weight.mean, "{weight:?}");
}

/// By Detournay and Defourny's law the same bit drills steadily at a speed at which the blades'
/// history would make it stick and slip: weight, torque and rate of penetration are the closed
/// form's, the rate is that of the bit's own depth, and the energy's books stay in balance.
#[test]
fn a_bit_without_history_drills_steadily() {
    let mut case = vertical(100.0);
    let law = DetournayDefournyLaw {
        cutters: LAW.cutters,
        full_contact_depth_m: 0.3e-3,
        cleaning_limit_m: None,
        rock_stiffness_N_per_m: 1e8,
        excitation: None,
    };
    case.settings.bit.law = BitLaw::DetournayDefourny(law);
    case.operation = case.settings.bit.drilling_steadily(case.operation);
    case.lasts(30.0, 15.0);
    let outcome = case.run();
    let cutting_N = 60e3 - 60e6 * 0.107_95 * 5e-3;
    let depth_of_cut_m = cutting_N / (0.6 * 0.107_95 * 60e6);
    let torque = 0.5 * 0.107_95 * (cutting_N / 0.6 + 0.6 * (60e3 - cutting_N));
    let rate = depth_of_cut_m * rpm(100.0) / std::f64::consts::TAU;
    let series = &outcome.series;
    let moved = rate_from(series, 30.0);
    let mean = |name| statistic(&outcome, name).mean;
    for (quantity, expected, computed) in [
        ("weight on bit, N", 60e3, mean("weight_on_bit_N")),
        ("torque on bit, N·m", torque, mean("bit_torque_N_m")),
        ("rate of penetration, m/s", rate, mean("rate_of_penetration_m_per_s")),
        ("speed of the bit along the hole, m/s", rate, moved),
    ] {
        verify("E07", format!("whole string at 100 rev/min, three regimes: {quantity}"))
            .relative(5e-4, "remainder of the start after half a minute")
            .report(expected, computed);
    }
    let residual = outcome.numerics.energy_residual;
    assert!(residual.abs() < 1e-5, "{residual:e}");
}

/// A string that slides with a mud motor, its bit by a table: steady at the speed that the motor
/// has under the table's torque.
#[test]
fn a_motor_turns_the_bit_of_a_sliding_string() {
    let mut case = vertical(0.0);
    let motor = MOTOR;
    let point = |weight: f64, turns: f64| TablePoint {
        weight_on_bit_N: weight,
        rotary_speed_rad_per_s: rpm(turns),
        rate_of_penetration_m_per_s: 5e-8 * weight * turns / 100.0,
        torque_N_m: 0.06 * weight - turns,
        torque_std_N_m: None,
        weight_on_bit_std_N: None,
    };
    let points = [point(30e3, 100.0), point(30e3, 200.0), point(90e3, 100.0), point(90e3, 200.0)];
    case.settings.bit.law = BitLaw::Table(TableLaw {
        table: BitTable::new(&points).expect("a table"),
        rock_stiffness_N_per_m: 1e8,
        excitation: None,
    });
    case.settings.bit.motor = Motor::Displacement(motor);
    case.operation.kind = OperationKind::Slide;
    case.operation.flow_rate_m3_per_s = 30e-3;
    case.operation = case.settings.bit.drilling_steadily(case.operation);
    case.lasts(30.0, 15.0);
    let outcome = case.run();
    // Torque and speed meet where 3600 N·m less 1 for each rev/min equals the torque of the motor's
    // speed.
    let free = 150.0;
    let fall = 0.1 * free / motor.max_torque_N_m();
    let turns = (free - fall * 3600.0) / (1.0 - fall);
    let series = &outcome.series;
    let from = series.time_s.partition_point(|t| *t < 30.0);
    let speeds: Vec<f64> = series.motor_speed_rad_per_s[from..].iter().flatten().copied().collect();
    let speed = speeds.iter().sum::<f64>() / speeds.len() as f64;
    let mean = |name| statistic(&outcome, name).mean;
    for (quantity, expected, computed) in [
        ("weight on bit, N", 60e3, mean("weight_on_bit_N")),
        ("torque on bit, N·m", 3600.0 - turns, mean("bit_torque_N_m")),
        ("speed of the motor, rad/s", rpm(turns), speed),
        ("rate of penetration, m/s", 3e-3 * turns / 100.0, mean("rate_of_penetration_m_per_s")),
    ] {
        verify("E07", format!("whole string sliding with a mud motor and a table: {quantity}"))
            .relative(1e-3, "remainder of the start after half a minute")
            .report(expected, computed);
    }
    let pressure = series.motor_pressure_Pa[from].expect("known");
    let expected = (3600.0 - turns) * std::f64::consts::TAU / (0.8 * 12e-3);
    assert!((pressure / expected - 1.0).abs() < 2e-3, "{pressure} {expected}");
    assert_eq!(outcome.bit_table.expect("a table").outside_fraction, 0.0);
}

/// Turning slowly, the same bit sticks and slips by itself, and drills on in the mean as fast as a
/// steady one would. It sticks at 100 rev/min and below, swings without stopping from 105 to 180,
/// and is quiet from 190 up (in steps of 5 and 10). The energy balance holds: the bit causes a
/// different vibration for every seed, and of 24 starts (six seeds, settled for 1 to 3 s across the
/// hole) none left more than 3e-4, half of them less than 1e-4, of either sign.
#[test]
fn a_slow_drag_bit_sticks_and_slips() {
    let case = vertical(40.0);
    let outcome = case.run();
    let series = &outcome.series;
    let spins = between(&series.time_s, &series.bit_rotary_speed_rad_per_s, 30.0, 60.0);
    let stuck = spins.iter().filter(|s| s.abs() < 1e-6).count() as f64 / spins.len() as f64;
    let spin = statistic(&outcome, "bit_rotary_speed_rad_per_s");
    assert!(stuck > 0.02, "{stuck}");
    assert!(spin.max > 2.0 * rpm(40.0), "{spin:?}");
    assert!((spin.mean / rpm(40.0) - 1.0).abs() < 0.05, "{spin:?}");
    let rate = rate_from(series, 30.0);
    let steady = case.operation.rate_of_penetration_m_per_s;
    assert!((rate / steady - 1.0).abs() < 0.1, "{rate} {steady}");
    let residual = outcome.numerics.energy_residual;
    assert!(residual.abs() < 1e-3, "{residual:e}");
}

/// An hour's drilling with a tricone bit on a rough bottom, a minute of it: the weight on bit
/// swings with three lobes and noise and keeps its mean, the torque with it and its own
/// fluctuation, and the energy's books stay in balance.
#[test]
fn a_rough_bottom_shakes_the_string() {
    let mut case = np13(0.3);
    case.settings.duration_s = 60.0;
    case.settings.bit.law = BitLaw::Rate(RateLaw {
        rock_stiffness_N_per_m: 1e8,
        excitation: Some(Excitation {
            amplitude_m: 0.8e-3,
            roughness_m: 0.2e-3,
            torque_fluctuation: 0.1,
            ..SMOOTH
        }),
    });
    let outcome = case.run();
    let [weight, torque, hook, spin] =
        ["weight_on_bit_N", "bit_torque_N_m", "hook_load_N", "bit_rotary_speed_rad_per_s"]
            .map(|name| statistic(&outcome, name));
    assert!((weight.mean / 58_839.9 - 1.0).abs() < 0.01, "{weight:?}");
    assert!((torque.mean / 3100.0 - 1.0).abs() < 0.01, "{torque:?}");
    assert!((spin.mean / rpm(70.0) - 1.0).abs() < 0.01, "{spin:?}");
    // A front that moves at v meets the collar's impedance √(EA m) = 7.7e5 N·s/m: 0.8 mm of three
    // lobes at 70 rev/min are 10 kN rms, 0.2 mm at some 30 rad/s of roughness 5 kN; the short
    // pieces above the bit reflect waves that add to that or reduce it.
    assert!((5e3..20e3).contains(&weight.std), "{weight:?}");
    // Independent factors: 1 + var = (1 + var of the weight)(1 + var of the fluctuation).
    let share = (weight.std / weight.mean).powi(2);
    let expected = (share + 0.01 * (1.0 + share)).sqrt() * torque.mean;
    assert!((torque.std / expected - 1.0).abs() < 0.05, "{torque:?} {expected}");
    // Wall friction and 4 km of string take most of it before the surface.
    assert!(hook.std < 0.2 * weight.std, "{hook:?}");
    let residual = outcome.numerics.energy_residual;
    assert!(residual.abs() < 1e-5, "{residual:e}");

    // The lobes exceed the noise at three times the rotary speed.
    let series = &outcome.series;
    let line = |hertz: f64| {
        let from = series.time_s.partition_point(|t| *t < 10.0);
        let (mut re, mut im) = (0.0, 0.0);
        for (t, w) in series.time_s[from..].iter().zip(&series.weight_on_bit_N[from..]) {
            let angle = std::f64::consts::TAU * hertz * t;
            re += (w - weight.mean) * angle.cos();
            im += (w - weight.mean) * angle.sin();
        }
        re.hypot(im)
    };
    // The spin swings, so that the line is wide: power of a band, against another one.
    let power = |from: f64, to: f64| {
        let lines = ((to - from) * 60.0) as usize;
        let sum: f64 = (0..lines).map(|i| line(from + i as f64 / 60.0).powi(2)).sum();
        sum / lines as f64
    };
    let (lobes, beside) = (power(3.0, 4.0), power(5.0, 7.0));
    assert!(lobes > 4.0 * beside, "{lobes} {beside}");
}
