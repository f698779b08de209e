//! Axial and torsional waves: natural frequencies, speed, impedance, reflection.

use wholestring_verification::verify;

use super::bench::{Bench, COLLAR_M, PIPE_M, STEEL, Support};
use crate::{
    common::verification,
    dynamics::kernel::chain::{element, node},
    simd::vector::Vector,
};

#[derive(Clone, Copy, PartialEq, Debug)]
enum Kind {
    Axial,
    Torsional,
}

/// Gives each node a speed along or about the axis.
fn set_speed(rod: &mut Bench, kind: Kind, speed: impl Fn(f64) -> f64) {
    for i in 0..rod.chain.nodes() {
        let v = speed(rod.z_m(i));
        match kind {
            Kind::Axial => rod.chain.set_velocity(i, Vector(0.0, 0.0, v)),
            Kind::Torsional => node!(rod.chain, i, spin = v),
        }
    }
}

fn speed(rod: &Bench, kind: Kind, i: usize) -> f64 {
    match kind {
        Kind::Axial => rod.chain.velocity(i).2,
        Kind::Torsional => node!(rod.chain, i, spin),
    }
}

/// D09: three modes of 1000 m, held at the top, free at the bottom. Mass in lumps and time in steps
/// near the limit err by opposite dispersion; the remaining error is `(kh)²/24 (1 − S²)`, `S` the
/// distance that a wave runs in a step over the element's length: 1e-5 and 1.7e-4 for the third
/// mode and 100 elements.
#[test]
fn a_hanging_pipe_rings_at_its_frequencies() {
    let data = verification("D09_linear_frequencies.json");
    for (kind, key) in [(Kind::Axial, "axial_Hz"), (Kind::Torsional, "torsional_Hz")] {
        for mode in 0..3 {
            let exact = data["fixed_free_1000m"][key][mode].as_f64().expect("a frequency");
            let mut rod = Bench::new(&[(PIPE_M, 1000.0)], 10.0, 0.0);
            rod.support(0, Support::CLAMPED);
            let k = (mode as f64 + 0.5) * std::f64::consts::PI / 1000.0;
            set_speed(&mut rod, kind, |z| 1e-3 * (k * z).sin());
            let found = rod.frequency_Hz(3, |rod| {
                (0..rod.chain.nodes()).map(|i| (k * rod.z_m(i)).sin() * speed(rod, kind, i)).sum()
            });
            let wave = if kind == Kind::Axial { 5133.13 } else { 3178.35 };
            let courant = wave * rod.input.dt / 10.0;
            let dispersion = (k * 10.0).powi(2) / 24.0 * (1.0 - courant * courant);
            let error = found / exact - 1.0;
            // A zero found on the chord of a sine between two steps is off by 0.016 (ω dt)² dt at
            // most, and there are two.
            let dt = rod.input.dt;
            let zeros = 0.032 * (std::f64::consts::TAU * exact * dt).powi(2) * dt * exact / 3.0;
            let within = 0.02 * dispersion + zeros;
            assert!((error + dispersion).abs() < within, "{key} {mode}: {found} for {exact}");
            verify("D09", format!("{kind:?} mode {} of a hanging pipe, Hz", mode + 1))
                .relative(
                    dispersion + within,
                    "dispersion of lumps and steps, and zeros found between two steps",
                )
                .report(exact, found);
        }
    }
}

/// Position and size of a pulse.
struct Pulse {
    sum: f64,
    middle_m: f64,
}

fn pulse(rod: &Bench, kind: Kind, from_m: f64, to_m: f64) -> Pulse {
    let (mut sum, mut first) = (0.0, 0.0);
    for i in 0..rod.chain.nodes() {
        let z = rod.z_m(i);
        if z > from_m && z < to_m {
            sum += speed(rod, kind, i);
            first += z * speed(rod, kind, i);
        }
    }
    Pulse { sum, middle_m: first / sum }
}

const PULSE_M: f64 = 60.0;

/// A rod with 1000 m of pipe above, in which a pulse 400 m from its top runs down.
fn struck(kind: Kind, below: [f64; 2], wave_m_per_s: f64) -> Bench {
    let mut rod = Bench::new(&[(below, 1000.0), (PIPE_M, 1000.0)], 5.0, 0.0);
    let shape = |z: f64| 1e-3 * (-((z - 400.0) / PULSE_M).powi(2)).exp();
    set_speed(&mut rod, kind, shape);
    // In a wave that runs down, the strain is −v/c. Displacements live half a step later than
    // velocities, the twist, which the step first carries on, half a step earlier.
    let later = if kind == Kind::Axial { 0.5 } else { -0.5 } * rod.input.dt * wave_m_per_s;
    let mut moved = 0.0;
    for i in 0..rod.chain.elements() {
        let length = rod.mesh.elements[i].length_m;
        let strain = -shape(rod.z_m(i) + 0.5 * length - later) / wave_m_per_s;
        match kind {
            Kind::Axial => {
                moved += strain * length;
                rod.chain.set_displacement(i + 1, Vector(0.0, 0.0, moved));
            }
            Kind::Torsional => element!(rod.chain, i, twist = strain * length),
        }
    }
    rod
}

fn run(rod: &mut Bench, seconds: f64) -> f64 {
    let steps = (seconds / rod.input.dt).round();
    for _ in 0..steps as usize {
        rod.step();
    }
    steps * rod.input.dt
}

/// D10: speed, impedance, reflection and transmission at the joint of pipe and collar. Its
/// tolerance is 0.5 %. Sums over a pulse are not affected by dispersion, which changes its shape
/// alone: the bound of 1e-5 is the error of its tails (4e-7 was measured).
#[test]
fn pulses_run_and_are_thrown_back_as_their_impedances_say() {
    let expected = &verification("D10_axial_torsional_waves.json")["expected"];
    let number = |key: &str| expected[key].as_f64().expect("a number");
    for (kind, speed_key, impedance, back, on) in [
        (
            Kind::Axial,
            "c_axial",
            "axial_impedance_pipe_Ns_per_m",
            "velocity_reflection_pipe_to_collar_axial",
            "velocity_transmission_axial",
        ),
        (
            Kind::Torsional,
            "c_torsional",
            "torsional_impedance_pipe_Nms",
            "velocity_reflection_torsional",
            "velocity_transmission_torsional",
        ),
    ] {
        let c = number(speed_key);
        let mut rod = struck(kind, COLLAR_M, c);
        let start = pulse(&rod, kind, 0.0, 2000.0);
        let time = run(&mut rod, 200.0 / c);
        let there = pulse(&rod, kind, 0.0, 1000.0);
        let found = (there.middle_m - start.middle_m) / time;
        let holds = |what: &str, computed: f64, expected: f64, tolerance: f64| {
            verify("D10", format!("{kind:?} {what}"))
                .relative(tolerance, "the tails of the pulse")
                .report(expected, computed);
        };
        holds("speed, m/s", found, c, 1e-5);

        // The pulse is compressive: the part behind it is pulled by −Z v. In torsion the chain's
        // own sign.
        let load: f64 = (0..rod.chain.elements())
            .map(|i| match kind {
                Kind::Axial => -element!(rod.chain, i, tension),
                Kind::Torsional => -element!(rod.chain, i, torque),
            })
            .sum();
        let z = load / there.sum;
        holds("impedance in SI units", z, number(impedance), 1e-5);

        run(&mut rod, 800.0 / c);
        let returned = pulse(&rod, kind, 0.0, 1000.0).sum / start.sum;
        let passed = pulse(&rod, kind, 1000.0, 2000.0).sum / start.sum;
        holds("reflection from pipe to collar", returned, number(back), 1e-4);
        holds("transmission from pipe to collar", passed, number(on), 1e-4);
    }
}

/// A held end throws a pulse back with its speed reversed, a free end unchanged.
#[test]
fn ends_throw_pulses_back() {
    for kind in [Kind::Axial, Kind::Torsional] {
        for (held, sign) in [(true, -1.0), (false, 1.0)] {
            let c = if kind == Kind::Axial { 5133.13 } else { 3178.35 };
            let mut rod = struck(kind, PIPE_M, c);
            let last = rod.chain.nodes() - 1;
            if held {
                rod.support(last, Support::CLAMPED);
            }
            let start = pulse(&rod, kind, 0.0, 2000.0).sum;
            let time = run(&mut rod, 2200.0 / c);
            let back = pulse(&rod, kind, 0.0, 2001.0);
            let end = if held { "a held" } else { "a free" };
            verify("D10", format!("{kind:?} reflection from {end} end"))
                .relative(1e-3, "the tails of the pulse")
                .report(sign, back.sum / start);
            // 1600 m to the end, and back.
            let expected = 3600.0 - c * time;
            assert!((back.middle_m - expected).abs() < 0.1, "{} {expected}", back.middle_m);
        }
    }
}

/// D10: a rod on a wall with dry friction `f` per length, its end pulled at `v₀` (pushed, it would
/// buckle). The front runs at the speed of sound `c` and the force on the end grows by `f c/2` a
/// second; behind the front the rod moves at `v₀ − f x/2Z`, `Z = ρAc`. Gives the mean error of the
/// force between 0.4 and 0.5 s, and that of the speed between 200 and 1000 m over `v₀`, at an
/// element length.
fn slip_front(element_length_m: f64) -> (f64, f64) {
    let data = verification("D10_axial_torsional_waves.json");
    let data = &data["friction_front"];
    let number = |key: &str| data["inputs"][key].as_f64().expect("a number");
    let (f, v0, c) = (number("f"), number("v0"), 5133.132);
    let z = STEEL.density_kg_per_m3 * number("A") * c;
    let exact = |t: f64| z * v0 + 0.5 * f * c * t;
    let at_half = data["expected"]["F_at_0p5s"].as_f64().expect("a number");
    assert!((exact(0.5) / at_half - 1.0).abs() < 1e-6);

    // Pressed on the wall by a weight across, with a coefficient of one half.
    let (k, clearance) = (3e10, 0.05);
    let mut rod = Bench::new(&[(PIPE_M, 3000.0)], element_length_m, 0.0);
    let last = rod.chain.nodes() - 1;
    for i in 0..=last {
        let load = 2.0 * f * rod.mesh.tributary_length_m(i);
        rod.chain.set_weight(i, Vector(load, 0.0, 0.0));
        node!(rod.chain, i, clearance = clearance);
        node!(rod.chain, i, friction = 0.5);
        node!(rod.chain, i, stiffness = k);
        // Position at which the wall carries it.
        let off = clearance + (load / k).powf(2.0 / 3.0);
        rod.chain.set_displacement(i, Vector(off, 0.0, 0.0));
        let axial = i > 0;
        rod.support(i, Support { axial, spin: false, ..Support::FREE });
    }
    rod.chain.set_velocity(0, Vector(0.0, 0.0, -v0));
    let (mut force, mut speed, mut samples, mut time) = (0.0, 0.0, 0.0, 0.0);
    while time < 0.5 {
        rod.step();
        time += rod.input.dt;
        if time > 0.4 {
            // The end rubs over half an element itself.
            let own = 0.5 * element_length_m * f;
            force += (element!(rod.chain, 0, tension) + own) / exact(time) - 1.0;
            let behind = (0..=last).filter(|i| (200.0..1000.0).contains(&rod.z_m(*i)));
            let (mut sum, mut nodes) = (0.0, 0.0);
            for i in behind {
                sum += (-rod.chain.velocity(i).2 - (v0 - 0.5 * f * rod.z_m(i) / z)) / v0;
                nodes += 1.0;
            }
            speed += sum / nodes;
            samples += 1.0;
        }
    }
    // Ahead of the front friction holds everything, to the last digit.
    for i in (0..=last).filter(|i| rod.z_m(*i) > c * time + 300.0) {
        assert!(rod.chain.velocity(i).2.abs() < 1e-12, "{}", rod.z_m(i));
    }
    (force / samples, speed / samples)
}

/// The ringing of the chain behind so sharp a front turns some friction round for a moment, the
/// less the finer it is: the force errs in proportion to the element's length, both are within the
/// source's 0.5 % from 5 m on.
#[test]
fn a_front_of_slip_runs_into_a_rod_that_lies_on_the_wall() {
    let [coarse, fine] = [10.0, 5.0].map(slip_front);
    for (what, error) in [("force on the end", fine.0), ("speed behind it", fine.1)] {
        verify("D10", format!("front of slip: {what} over the closed form"))
            .absolute(0.005, "the source's; elements of 5 m and first order in their length")
            .report(1.0, 1.0 + error);
    }
    assert!((coarse.0 / fine.0 - 2.0).abs() < 0.5, "{}", coarse.0 / fine.0);
    assert!(coarse.1.abs() > fine.1.abs());
}
