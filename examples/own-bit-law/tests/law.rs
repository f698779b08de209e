//! The law drills according to its formula, and causes stick-slip at the expected speed.

use std::path::Path;

use own_bit_law::{FallingTorque, case, drill};

const LAW: FallingTorque = FallingTorque {
    depth_of_cut_per_weight_m_per_N: 2e-8,
    torque_per_weight_m: 0.05,
    rise: 1.0,
    half_rad_per_s: 6.0,
};

fn drilled(rpm: u32) -> [f64; 3] {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slant.toml");
    let rpm = format!("rpm={rpm}");
    let changes = [
        "model=dynamic",
        "operation.kind=drill",
        "mesh.element_length=10 m",
        "dynamics.settle=20 s",
        "well.hole.0.friction=0.1",
        "well.hole.1.friction=0.1",
        &rpm,
    ];
    let changes = changes.map(|change| change.parse().expect("a change"));
    drill(&case(&file, LAW, &changes).expect("a valid case")).expect("an answer")
}

/// At 150 rev/min the bit turns steadily, and its mean torque is the law's at that speed, under the
/// 5 t that the autodriller holds, to within 1 %, the error of the weight that the autodriller
/// holds. At 60 rev/min the slope of the law exceeds the damping: the bit stops and reaches more
/// than twice the speed of the top.
#[test]
fn a_bit_whose_torque_falls_sticks_below_a_speed() {
    let [slowest, fastest, torque_N_m] = drilled(150);
    let speed = 150.0 * std::f64::consts::TAU / 60.0;
    assert!(slowest > 0.9 * speed && fastest < 1.1 * speed, "{slowest} to {fastest}");
    let expected = LAW.torque_N_m(5.0 * 9806.65, speed);
    assert!((torque_N_m / expected - 1.0).abs() < 0.01, "{torque_N_m} for {expected}");
    let [slowest, fastest, _] = drilled(60);
    let speed = 60.0 * std::f64::consts::TAU / 60.0;
    assert!(slowest < 0.1 && fastest > 2.0 * speed, "{slowest} to {fastest}");
}
