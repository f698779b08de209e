//! Axial and torsional modes.

use std::time::Instant;

use wholestring::{
    dynamics::DynamicsSettings,
    modal::{Family, SmallMotions},
    prelude::*,
    sizing::ElementLength,
    statics::stiff::StiffSettings,
};

use crate::common::{self, np13};

/// Modes of NP13.
#[test]
fn np13_has_modes() {
    let path = common::arcs(&[
        [0.0, 0.0, 45.0],
        [300.0, 0.0, 45.0],
        [900.0, 60.0, 45.0],
        [4305.0, 60.0, 45.0],
    ]);
    let hole = common::open_hole(0.2159, 0.3, 4305.0);
    let model = common::model(path, hole, np13::components(), common::mud(1200.0), 4305.0);
    let operation = Operation::drill(4305.0)
        .rotary_speed_rad_per_s(12.0)
        .weight_on_bit_N(50e3)
        .bit_torque_N_m(3e3)
        .rate_of_penetration_m_per_s(5e-3);
    let settings =
        StiffSettings { element_length: ElementLength::Uniform(3.2), ..Default::default() };
    let start = Instant::now();
    let motions = SmallMotions::new(&model, &operation, &settings, &DynamicsSettings::default())
        .expect("rest");
    println!(
        "{} nodes, rest {:?}, stable {}",
        motions.nodes(),
        start.elapsed(),
        motions.is_stable()
    );
    let start = Instant::now();
    let below = motions.count_below(1.0);
    println!("{below} below 1 Hz, {:?}", start.elapsed());
    for from in [0.0, 1.0] {
        let start = Instant::now();
        let modes = motions.modes(from, 10).expect("modes");
        println!("{:?}", start.elapsed());
        for mode in modes {
            println!(
                "{:.6} {:?} {:?} {:?} {:?}",
                mode.frequency_Hz,
                mode.family,
                mode.energy,
                mode.whirl(),
                mode.most_bent
            );
        }
    }
    for family in [Family::Axial, Family::Torsional] {
        let start = Instant::now();
        let modes = motions.family(family, 10).expect("modes");
        println!("{:?}", start.elapsed());
        for mode in modes {
            println!(
                "{:.6} {:?} {:?} {:?}",
                mode.frequency_Hz, mode.family, mode.energy, mode.most_bent
            );
        }
    }
    let length_m = wholestring::modal::assembly_length_m(&model.string);
    let assembly = motions.assembly(length_m);
    println!("assembly {}", assembly.length_m());
    let start = Instant::now();
    let modes = assembly.lateral(0.0, 10, 12.0).expect("modes");
    println!("{:?}", start.elapsed());
    for mode in &modes {
        println!(
            "{:.6} {:?} {:?} {:?} {:?}",
            mode.frequency_Hz,
            mode.in_assembly,
            mode.energy,
            mode.whirl(),
            mode.most_bent
        );
    }
    let start = Instant::now();
    let speeds: Vec<f64> = (0..41).map(|k| 0.5 * f64::from(k)).collect();
    let campbell = assembly
        .campbell(10, &motions.family(Family::Torsional, 5).expect("t"), &speeds, &[1.0, 3.0])
        .expect("modes");
    println!("{:?}", start.elapsed());
    for critical in campbell.critical {
        println!("{critical:?}");
    }
    let start = Instant::now();
    let answers = assembly.respond(
        wholestring::modal::Forcing::Force {
            force_N: 1e3,
            from_bit_m: assembly.middle_of_longest_span_m(),
        },
        &speeds[1..],
    );
    println!("{:?}", start.elapsed());
    for answer in answers.iter().step_by(4) {
        println!("{answer:?}");
    }
}
