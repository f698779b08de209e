//! Duration of a sample of a plan on one core, and its parts: the operations at every depth, and
//! the weights to buckle. The string of NP13-X1042 in a hole like its own, 30 depths, 6 operations:
//! `cargo bench -p wholestring-plan --bench uncertain`.

#[path = "../../core/tests/common/np13.rs"]
#[allow(dead_code, unreachable_pub)]
mod np13;

use std::{hint::black_box, time::Instant};

use wholestring::{ends::Ends, prelude::*, statics::buckling::Criterion};
use wholestring_plan::{Broomstick, Frictions, Setup, Statics, bit_depths_m};

const DEPTH_M: f64 = 4305.0;
const REPEATS: usize = 11;

/// Vertical, a build to 65°, a tangent, surveyed every 30 m.
fn setup() -> Setup {
    let inclination_deg = |md_m: f64| 65.0 * ((md_m - 322.9) / (1075.0 - 322.9)).clamp(0.0, 1.0);
    let depths_m = (0..144).map(|k| 30.0 * f64::from(k)).chain([DEPTH_M]);
    let stations: Vec<Station> =
        depths_m.map(|md_m| Station::from_degrees(md_m, inclination_deg(md_m), 45.0)).collect();
    let hole = Hole::new(vec![
        HoleSection::casing(0.0..2986.53, 0.22296, 0.3),
        HoleSection::open(2986.53..DEPTH_M, 0.2159, 0.3),
    ]);
    let mut components = np13::components();
    // All components have limits.
    for component in &mut components {
        component.yield_strength_Pa = Some(931e6);
    }
    Setup {
        well: Well {
            path: Path::minimum_curvature(&stations).expect("a path"),
            hole: hole.expect("a hole"),
        },
        string: StringSpec { components },
        mud: Mud::of_density(1200.0),
        fluids: Default::default(),
        rig: Rig::default(),
        ends: Ends::default(),
        buckling: Criterion::default(),
    }
}

fn operations() -> Vec<Operation> {
    let (turns_rad_per_s, goes_m_per_s) = (7.3, 10.0 / 3600.0);
    let turning = |operation: Operation| operation.rotary_speed_rad_per_s(turns_rad_per_s);
    let advancing = |operation: Operation| operation.rate_of_penetration_m_per_s(goes_m_per_s);
    vec![
        Operation::trip_out(DEPTH_M),
        Operation::trip_in(DEPTH_M),
        turning(Operation::rotate_off_bottom(DEPTH_M)),
        turning(advancing(Operation::drill(DEPTH_M))).weight_on_bit_N(60e3).bit_torque_N_m(3e3),
        advancing(Operation::slide(DEPTH_M)).weight_on_bit_N(60e3),
        turning(advancing(Operation::new(OperationKind::BackReam, DEPTH_M))),
    ]
}

/// Shortest duration of a piece of work, s, because disturbances only add to a measurement.
fn least_s(mut work: impl FnMut()) -> f64 {
    let once = |_| {
        let begun = Instant::now();
        work();
        begun.elapsed().as_secs_f64()
    };
    (0..REPEATS).map(once).fold(f64::INFINITY, f64::min)
}

fn main() {
    let setup = setup();
    let depths_m = bit_depths_m(&setup, None, DEPTH_M, 30);
    let broomstick = Broomstick::new(
        &setup,
        &Frictions::default(),
        operations(),
        depths_m.clone(),
        vec![Statics::Soft],
    )
    .expect("a broomstick");
    let loads_s = least_s(|| {
        for bit_depth_m in &depths_m {
            let found = broomstick.expected_loads(Statics::Soft, *bit_depth_m, &operations());
            assert!(black_box(found).iter().all(Result::is_ok));
        }
    });
    let weights_s = least_s(|| {
        let found = broomstick.expected_weights_to_buckle(DEPTH_M);
        assert!(black_box(found).iter().all(|point| point.weights_N.is_ok()));
    });
    println!("{} depths of 6 operations: {:.1} ms", depths_m.len(), 1e3 * loads_s);
    println!("the weights to buckle at the deepest: {:.1} ms", 1e3 * weights_s);
    println!("a sample: {:.1} ms", 1e3 * (loads_s + weights_s));
}
