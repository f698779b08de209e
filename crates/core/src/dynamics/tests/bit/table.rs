//! A law that was measured.

use super::{regenerative::pressed, *};
use crate::{
    common::SMOOTH,
    dynamics::boundary::bit::{
        BitLaw, BitTable, Excitation, RateLaw, TableFault, TableLaw, TablePoint,
    },
};

fn point(weight: f64, speed: f64, rate: f64, torque: f64) -> TablePoint {
    TablePoint {
        weight_on_bit_N: weight,
        rotary_speed_rad_per_s: speed,
        rate_of_penetration_m_per_s: rate,
        torque_N_m: torque,
        torque_std_N_m: None,
        weight_on_bit_std_N: None,
    }
}

/// Rate and torque that are bilinear in weight and speed.
fn bilinear(weight: f64, speed: f64) -> TablePoint {
    let rate = 1e-3 + 4e-8 * weight + 2e-4 * speed + 3e-9 * weight * speed;
    point(weight, speed, rate, 200.0 + 0.05 * weight - 2.0 * speed)
}

fn points() -> Vec<TablePoint> {
    let weights = [20e3, 50e3, 110e3];
    let speeds = [4.0, 7.0, 13.0];
    let all = weights.iter().flat_map(|w| speeds.map(|s| bilinear(*w, s)));
    // In whatever order they come.
    all.rev().collect()
}

fn law(points: &[TablePoint], excitation: Option<Excitation>) -> BitLaw {
    BitLaw::Table(TableLaw {
        table: BitTable::new(points).expect("a table"),
        rock_stiffness_N_per_m: 1e8,
        excitation,
    })
}

fn rig(law: BitLaw, weight_N: f64) -> Rig {
    let settings = BitSettings { law, ..BitSettings::default() };
    Rig::with(pressed(weight_N), settings)
}

/// Between the points the table is the bilinear function that made it; at the edges it stays or
/// goes to zero.
#[test]
fn between_its_points_the_table_is_bilinear() {
    let table = BitTable::new(&points()).expect("a table");
    for (weight, speed) in [(20e3, 4.0), (33e3, 6.1), (50e3, 7.0), (80e3, 9.0), (110e3, 13.0)] {
        let (found, made) = (table.steady(weight, speed), bilinear(weight, speed));
        let rate = made.rate_of_penetration_m_per_s;
        assert!((found.rate_of_penetration_m_per_s / rate - 1.0).abs() < 1e-12);
        assert!((found.torque_N_m / made.torque_N_m - 1.0).abs() < 1e-12);
        assert!((found.depth_of_cut_m * speed / std::f64::consts::TAU / rate - 1.0).abs() < 1e-12);
        assert!(table.holds(weight, speed));
    }
    let edge = |weight, speed, at: (f64, f64), rate: f64, torque: f64| {
        let (found, at) = (table.steady(weight, speed), bilinear(at.0, at.1));
        assert!(!table.holds(weight, speed));
        let expected = rate * at.rate_of_penetration_m_per_s;
        assert!((found.rate_of_penetration_m_per_s - expected).abs() < 1e-15);
        assert!((found.torque_N_m - torque * at.torque_N_m).abs() < 1e-9);
    };
    edge(300e3, 20.0, (110e3, 13.0), 1.0, 1.0);
    edge(80e3, 20.0, (80e3, 13.0), 1.0, 1.0);
    edge(80e3, 1.0, (80e3, 4.0), 0.25, 1.0);
    edge(5e3, 7.0, (20e3, 7.0), 0.25, 0.25);
    edge(80e3, -1.0, (80e3, 4.0), 0.0, 1.0);
}

/// Pushed with a weight and turned at a speed, the bit drills at the table's rate, also outside it,
/// and reports the count and the extent of the excursions.
#[test]
fn the_bit_drills_as_the_table_says() {
    for (weight, speed, at) in
        [(80e3, 9.0, (80e3, 9.0)), (150e3, 9.0, (110e3, 9.0)), (80e3, 15.0, (80e3, 13.0))]
    {
        let mut rig = rig(law(&points(), None), 60e3);
        node!(rig.chain, 0, inv_polar = 0.0);
        rig.set_spin(speed);
        rig.push = Vector(0.0, 0.0, weight);
        let mut step = BitStep::default();
        for i in 0..40_000 {
            step = rig.step(5e-4);
            if i == 30_000 {
                rig.bit.open_window();
            }
        }
        let made = bilinear(at.0, at.1);
        let rate = made.rate_of_penetration_m_per_s;
        assert!((rig.chain.velocity(0).2 / rate - 1.0).abs() < 1e-6);
        assert!((step.torque_N_m / made.torque_N_m - 1.0).abs() < 1e-6);
        let used = rig.bit.table_use().expect("a table");
        let outside = if at == (weight, speed) { 0.0 } else { 1.0 };
        assert_eq!(used.outside_fraction, outside);
        assert!((used.weights_N[1] / weight - 1.0).abs() < 1e-6);
        assert_eq!(used.speeds_rad_per_s, [speed, speed]);
        assert_eq!(used.table_weights_N, [20e3, 110e3]);
    }
}

/// Below its one point a table is the rate law, step by step, whatever shakes the bit.
#[test]
fn a_table_of_one_point_is_the_rate_law_below_it() {
    let excitation = Some(Excitation {
        amplitude_m: 0.1e-3,
        roughness_m: 0.05e-3,
        torque_fluctuation: 0.1,
        ..SMOOTH
    });
    // The rate law's operation is 60 kN at 7 rad/s; the point is on its line, above all weights of
    // the run.
    let one = [point(300e3, 28.0, 0.003 * 20.0, 15e3)];
    let rate = BitLaw::Rate(RateLaw { rock_stiffness_N_per_m: 1e8, excitation });
    for turn in [0.0, 3.0e3] {
        let mut rigs = [rig(law(&one, excitation), 60e3), rig(rate.clone(), 60e3)];
        for rig in &mut rigs {
            rig.push = Vector(0.0, 0.0, 60e3);
            rig.turn = turn;
            rig.set_spin(7.0);
            if turn == 0.0 {
                // A speed that no torque changes.
                node!(rig.chain, 0, inv_polar = 0.0);
            }
        }
        for _ in 0..4000 {
            let [a, b] = [rigs[0].step(5e-4), rigs[1].step(5e-4)];
            assert!((a.weight_on_bit_N - b.weight_on_bit_N).abs() < 1e-4, "{a:?} {b:?}");
            assert!((a.torque_N_m - b.torque_N_m).abs() < 1e-5);
        }
        assert!((rigs[0].spin() - rigs[1].spin()).abs() < 1e-6);
    }
}

/// The torque has the table's standard deviation about the table's mean, and so has the weight of a
/// bit that is led down so slowly that its rock hardly yields.
#[test]
fn the_spread_is_the_tables() {
    let spread = |weight: f64, torque: f64, torque_std: f64, weight_std: f64| TablePoint {
        torque_std_N_m: Some(torque_std),
        weight_on_bit_std_N: Some(weight_std),
        ..point(weight, 7.0, 1.25e-11 * weight, torque)
    };
    let smooth = SMOOTH;
    let table = [spread(40e3, 2e3, 100.0, 8e3), spread(80e3, 4e3, 500.0, 8e3)];
    let mut rig = rig(law(&table, Some(smooth)), 60e3);
    node!(rig.chain, 0, inv_mass_axial = 0.0);
    node!(rig.chain, 0, inv_polar = 0.0);
    rig.chain.set_velocity(0, Vector(0.0, 0.0, 0.75e-6));
    rig.set_spin(7.0);
    let n = 1_000_000;
    let (mut w, mut ww, mut q, mut qq) = (0.0, 0.0, 0.0, 0.0);
    for _ in 0..n {
        let step = rig.step(2e-3);
        w += step.weight_on_bit_N;
        ww += step.weight_on_bit_N.powi(2);
        // The torque's mean goes with the weight, 50 N·m per kN.
        let beside = step.torque_N_m - 0.05 * step.weight_on_bit_N;
        q += beside;
        qq += beside * beside;
    }
    let n = f64::from(n);
    let rms = |sum: f64, squares: f64| (squares / n - (sum / n).powi(2)).sqrt();
    let weight = rms(w, ww);
    assert!((weight / 8e3 - 1.0).abs() < 0.02, "{weight}");
    // The torque's is 10 N·m for each kN above 30 kN: by the mean weight, which the bottom under
    // the bit at the start shifts, and by its spread.
    let torque = rms(q, qq);
    let expected = (0.01 * w / n - 300.0).hypot(0.01 * 8e3);
    assert!((torque / expected - 1.0).abs() < 0.02, "{torque} {expected}");
    assert!((q / n).abs() < 3.0, "{}", q / n);
}

#[test]
fn what_makes_no_table_is_refused() {
    let fault = |points: &[TablePoint]| BitTable::new(points).expect_err("no table");
    assert_eq!(fault(&[]), TableFault::Empty);
    let mut missing = points();
    missing.remove(4);
    assert_eq!(
        fault(&missing),
        TableFault::Missing { weight_on_bit_N: 50e3, rotary_speed_rad_per_s: 7.0 }
    );
    let mut twice = points();
    twice.push(twice[2]);
    assert_eq!(fault(&twice), TableFault::Twice { first: 3, second: 10 });
    let mut negative = points();
    negative[3].torque_N_m = -1.0;
    assert_eq!(fault(&negative), TableFault::Number { line: 4 });
    let mut spread = points();
    spread[1].torque_std_N_m = Some(10.0);
    assert_eq!(fault(&spread), TableFault::Spread { line: 2 });
}

#[test]
fn work_is_the_change_of_kinetic_energy() {
    assert_work_is_the_change_of_energy(&mut rig(law(&points(), None), 60e3));
}
