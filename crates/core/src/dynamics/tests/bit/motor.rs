//! A mud motor between string and bit.

use wholestring_verification::verify;

use super::{
    regenerative::{LAW, pressed},
    *,
};
use crate::dynamics::boundary::bit::{
    BitLaw, Cutters, DetournayDefournyLaw, Motor, MudMotor, RateLaw, RegenerativeLaw,
};

const TAU: f64 = std::f64::consts::TAU;

/// 30 L/s through 12 L/rev are 150 rev/min; 8 MPa give 12.2 kN·m of it.
const MOTOR: MudMotor = MudMotor {
    displacement_m3: 12e-3,
    rated_flow_m3_per_s: 30e-3,
    max_pressure_Pa: 8e6,
    slip: 0.12,
    efficiency: 0.8,
    stall_torque_N_m: 18e3,
};

/// Cuts with 3.888 MN/m, rubs with 6.48 kN: 1 kN of weight takes 90 N·m of torque.
const BIT: DetournayDefournyLaw = DetournayDefournyLaw {
    cutters: Cutters { wear_flat_m: 1e-3, ..LAW.cutters },
    full_contact_depth_m: 0.0,
    cleaning_limit_m: None,
    rock_stiffness_N_per_m: 1e8,
    excitation: None,
};

fn with(law: BitLaw, weight_N: f64) -> Rig {
    let operation =
        Operation { kind: OperationKind::Slide, flow_rate_m3_per_s: 30e-3, ..pressed(weight_N) };
    let settings = BitSettings { law, motor: Motor::Displacement(MOTOR), ..BitSettings::default() };
    let operation = settings.drilling_steadily(operation);
    Rig::with(operation, settings)
}

/// A sliding string that nothing turns.
fn sliding(weight_N: f64) -> Rig {
    let mut rig = with(BitLaw::DetournayDefourny(BIT), weight_N);
    node!(rig.chain, 0, inv_polar = 0.0);
    rig.push = Vector(0.0, 0.0, weight_N);
    rig
}

fn settled(rig: &mut Rig, steps: usize) -> BitStep {
    (0..steps).map(|_| rig.step(5e-4)).last().expect("a step")
}

/// The curve's corners, worked out from its definition, and half of the flow: less leaks at the
/// stall of less.
#[test]
fn the_curve_goes_through_its_corners() {
    let rated = 0.8 * 12e-3 * 8e6 / TAU;
    let free = 30.0 / 12.0 * TAU;
    for (flow, torque, expected) in [
        (30e-3, 0.0, free),
        (30e-3, 0.5 * rated, 0.94 * free),
        (30e-3, rated, 0.88 * free),
        (30e-3, 0.5 * (rated + 18e3), 0.44 * free),
        (15e-3, 0.0, 0.5 * free),
        (15e-3, rated, 0.38 * free),
    ] {
        let found = MOTOR.speed_rad_per_s(flow, torque);
        assert!((found / expected - 1.0).abs() < 1e-12, "{flow} {torque}: {found}");
    }
    assert!(MOTOR.speed_rad_per_s(30e-3, 18e3).abs() < 1e-12);
    assert!((MOTOR.max_torque_N_m() / rated - 1.0).abs() < 1e-12);
    assert!((MOTOR.pressure_Pa(MOTOR.torque_N_m(5e6)) / 5e6 - 1.0).abs() < 1e-12);
}

/// Under the weight that requires a torque, the bit turns at the curve's speed and drills at the
/// law's rate for it.
#[test]
fn the_bit_turns_on_the_curve() {
    for weight in [40e3, 90e3, 150e3, 190e3] {
        let torque = BIT.torque_N_m(weight);
        let speed = MOTOR.speed_rad_per_s(30e-3, torque);
        assert!(speed > 0.0);
        let mut rig = sliding(weight);
        let step = settled(&mut rig, 40_000);
        let rate = BIT.depth_of_cut_m(weight) * speed / TAU;
        for (quantity, expected, computed) in [
            ("torque, N·m", torque, step.torque_N_m),
            ("speed, rad/s", speed, step.motor_speed_rad_per_s),
            ("rate of penetration, m/s", rate, step.rate_of_penetration_m_per_s),
        ] {
            verify("E07", format!("mud motor under {:.0} kN: {quantity}", weight * 1e-3))
                .relative(1e-6, "rounding of a depth of 2000 m over a step of 1 µm")
                .report(expected, computed);
        }
        let pressure = rig.bit.motor_pressure_Pa(step.torque_N_m).expect("known");
        assert!((pressure / (torque * TAU / (0.8 * 12e-3)) - 1.0).abs() < 1e-6);
    }
}

/// Too much weight stalls the motor: the bit stops under its stall torque and cuts nothing. Lifted
/// to a lower weight it continues at once.
#[test]
fn the_motor_stalls_and_recovers() {
    let mut rig = sliding(150e3);
    let running = settled(&mut rig, 40_000);
    rig.push = Vector(0.0, 0.0, 230e3);
    assert!(BIT.torque_N_m(230e3) > 18e3);
    let stalled = settled(&mut rig, 40_000);
    assert_eq!(stalled.rate_of_penetration_m_per_s, 0.0);
    assert!(stalled.motor_speed_rad_per_s.abs() < 1e-9);
    assert!((stalled.torque_N_m / 18e3 - 1.0).abs() < 1e-12, "{stalled:?}");
    assert!((stalled.weight_on_bit_N / 230e3 - 1.0).abs() < 1e-6);
    rig.push = Vector(0.0, 0.0, 150e3);
    let again = settled(&mut rig, 40_000);
    for (a, b) in [
        (running.torque_N_m, again.torque_N_m),
        (running.motor_speed_rad_per_s, again.motor_speed_rad_per_s),
        (running.rate_of_penetration_m_per_s, again.rate_of_penetration_m_per_s),
    ] {
        assert!((a / b - 1.0).abs() < 1e-5, "{a} {b}");
    }
}

/// Without flow the motor gives no torque; a string that turns drags a held bit no harder than the
/// leakage allows.
#[test]
fn without_flow_there_is_no_torque() {
    let mut rig = sliding(150e3);
    rig.bit.set_flow(0.0);
    let step = settled(&mut rig, 100);
    assert_eq!((step.torque_N_m, step.rate_of_penetration_m_per_s), (0.0, 0.0));
    rig.set_spin(1.0);
    let step = settled(&mut rig, 100);
    // 12 L/rev at 1 rad/s are 1.91 L/s, 53 % of the leakage at 12.2 kN·m.
    let expected = MOTOR.max_torque_N_m() * (12.0 / TAU) / (0.12 * 30.0);
    assert!((step.torque_N_m / expected - 1.0).abs() < 1e-9, "{step:?}");
    assert_eq!(step.rate_of_penetration_m_per_s, 0.0);
}

/// A string that turns with its motor stalled continues to turn around the stationary bit.
#[test]
fn a_turning_string_slips_around_a_stalled_motor() {
    let mut rig = sliding(230e3);
    rig.set_spin(5.0);
    let step = settled(&mut rig, 40_000);
    assert!((step.torque_N_m / 18e3 - 1.0).abs() < 1e-12);
    assert_eq!(step.motor_speed_rad_per_s, -5.0);
    assert_eq!(step.rate_of_penetration_m_per_s, 0.0);
}

/// The rate law holds at the speed that the motor has under the operation's torque, and a motor
/// under less torque turns and drills faster by its curve.
#[test]
fn the_rate_law_takes_the_motors_speed() {
    let rate = BitLaw::Rate(RateLaw { rock_stiffness_N_per_m: 1e8, excitation: None });
    let mut rig = with(rate, 60e3);
    node!(rig.chain, 0, inv_polar = 0.0);
    for weight in [60e3, 30e3] {
        rig.push = Vector(0.0, 0.0, weight);
        let step = settled(&mut rig, 40_000);
        let part = weight / 60e3;
        let speed = |torque| MOTOR.speed_rad_per_s(30e-3, torque);
        let expected = 0.003 * part * speed(3e3 * part) / speed(3e3);
        let found = step.rate_of_penetration_m_per_s;
        assert!((found / expected - 1.0).abs() < 1e-6, "{found} {expected}");
    }
}

/// The regenerative law cuts with the motor's speed, too.
#[test]
fn the_regenerative_law_takes_the_motors_speed() {
    let law = RegenerativeLaw { cutters: BIT.cutters, blades: 4 };
    let mut rig = with(BitLaw::Regenerative(law), 80e3);
    node!(rig.chain, 0, inv_polar = 0.0);
    node!(rig.chain, 0, inv_mass_axial = 0.0);
    let torque = law.steady(80e3, 1.0).torque_N_m;
    let steady = law.steady(80e3, MOTOR.speed_rad_per_s(30e-3, torque));
    let rate = steady.rate_of_penetration_m_per_s;
    rig.chain.set_velocity(0, Vector(0.0, 0.0, rate));
    let step = settled(&mut rig, 8000);
    assert!((step.weight_on_bit_N / 80e3 - 1.0).abs() < 1e-6, "{step:?}");
    assert!((step.rate_of_penetration_m_per_s / rate - 1.0).abs() < 1e-6);
}

#[test]
fn work_is_the_change_of_kinetic_energy() {
    assert_work_is_the_change_of_energy(&mut with(BitLaw::DetournayDefourny(BIT), 150e3));
}
