//! The hoist, which the step leaves to an implicit correction, against exact solutions.

use crate::{
    GRAVITY_M_PER_S2,
    dynamics::{
        boundary::hoist::{Hoist, HoistStep, Target},
        kernel::chain::{Chain, node},
        settings::{Autodriller, HoistControl, HoistLine},
    },
    simd::vector::Vector,
};

const MASS_KG: f64 = 5e3;
const LINE: HoistLine =
    HoistLine { stiffness_N_per_m: 1e7, damping_N_s_per_m: 1e5, block_mass_kg: 0.0 };

const TARGET: Target = Target { weight_N: 60e3, velocity_m_per_s: 0.003 };

/// A mass that hangs on the hoist.
struct Load {
    chain: Chain,
    hoist: Hoist,
    gravity: f64,
}

impl Load {
    fn new(line: HoistLine, control: HoistControl, gravity: f64) -> Self {
        Self::under(line, control, Autodriller::default(), gravity)
    }

    fn under(
        line: HoistLine,
        control: HoistControl,
        autodriller: Autodriller,
        gravity: f64,
    ) -> Self {
        let mut chain = Chain::new(1);
        node!(chain, 0, mass_axial = MASS_KG);
        node!(chain, 0, inv_mass_axial = 1.0 / MASS_KG);
        let weight = MASS_KG * gravity;
        let hoist = Hoist::new(line, control, autodriller, TARGET, 100.0, weight);
        Self { chain, hoist, gravity }
    }

    fn down(&self) -> f64 {
        self.chain.displacement(0).2
    }

    fn velocity(&self) -> f64 {
        self.chain.velocity(0).2
    }

    fn step(&mut self, weight_on_bit_N: f64, dt: f64) -> HoistStep {
        let before = self.velocity();
        let v = before + dt * self.gravity;
        self.chain.set_velocity(0, Vector(0.0, 0.0, v));
        self.chain.set_displacement(0, Vector(0.0, 0.0, self.down() + dt * v));
        self.hoist.act(&mut self.chain, 100.0, before, weight_on_bit_N, dt)
    }
}

/// Largest distance from the exact oscillation over three periods, part of the amplitude.
fn oscillation_error(line: HoistLine, steps_per_period: f64) -> f64 {
    let omega = (line.stiffness_N_per_m / MASS_KG).sqrt();
    let zeta = 0.5 * line.damping_N_s_per_m / (line.stiffness_N_per_m * MASS_KG).sqrt();
    let damped = omega * (1.0 - zeta * zeta).sqrt();
    let dt = std::f64::consts::TAU / omega / steps_per_period;
    let mut load = Load::new(line, HoistControl::BlockVelocity(0.0), GRAVITY_M_PER_S2);
    let amplitude = 2e-3;
    load.chain.set_displacement(0, Vector(0.0, 0.0, amplitude));
    let mut worst: f64 = 0.0;
    for i in 1..=(3.0 * steps_per_period) as usize {
        load.step(0.0, dt);
        let t = dt * i as f64;
        let exact = (-zeta * omega * t).exp()
            * ((damped * t).cos() + zeta * omega / damped * (damped * t).sin());
        worst = worst.max((load.down() / amplitude - exact).abs());
    }
    worst
}

/// Resolved, a mass on the line swings and settles as the damped oscillator, with the first order
/// of an implicit step: `ω dt` of the amplitude and less.
#[test]
fn a_mass_on_the_line_swings_and_settles() {
    for damping_N_s_per_m in [0.0, 3e4, 1e5, 3e5] {
        let line = HoistLine { damping_N_s_per_m, ..LINE };
        let [coarse, fine] = [2e4, 4e4].map(|steps| oscillation_error(line, steps));
        assert!(((coarse / fine).log2() - 1.0).abs() < 0.1, "{coarse:e} {fine:e}");
        assert!(fine < 4.0 * std::f64::consts::TAU / 4e4 * 3.0);
    }
}

/// However long the step, a mass at rest stays in place, and the hook load equals its weight.
#[test]
fn a_hanging_mass_weighs_what_it_weighs() {
    for dt in [1e-5, 5e-4, 0.1] {
        let mut load = Load::new(LINE, HoistControl::BlockVelocity(0.0), GRAVITY_M_PER_S2);
        for _ in 0..100 {
            let step = load.step(0.0, dt);
            assert!((step.hook_load_N / (MASS_KG * GRAVITY_M_PER_S2) - 1.0).abs() < 1e-9);
        }
        assert!(load.down().abs() < 1e-11);
    }
}

/// Lowered at a constant speed, it follows the block.
#[test]
fn a_mass_follows_the_block() {
    let mut load = Load::new(LINE, HoistControl::BlockVelocity(0.3), GRAVITY_M_PER_S2);
    let mut step = HoistStep::default();
    for _ in 0..20_000 {
        step = load.step(0.0, 1e-3);
    }
    assert!((load.velocity() - 0.3).abs() < 1e-9);
    assert!((load.down() - 0.3 * 20.0).abs() < 1e-6);
    assert!((step.hook_load_N / (MASS_KG * GRAVITY_M_PER_S2) - 1.0).abs() < 1e-9);
    assert_eq!(load.hoist.velocity_m_per_s(), 0.3);
}

/// Its work is the change of kinetic energy, to rounding, and the energy removed by damping is
/// booked as lost: upward force on a falling mass is negative work.
#[test]
fn work_is_the_change_of_kinetic_energy() {
    for control in [HoistControl::BlockVelocity(0.2), HoistControl::HookLoad(7e4)] {
        let mut load = Load::new(LINE, control, 0.0);
        load.chain.set_velocity(0, Vector(0.0, 0.0, 0.5));
        let energy = |load: &Load| 0.5 * MASS_KG * load.velocity().powi(2);
        let (start, mut work) = (energy(&load), 0.0);
        let first = load.step(0.0, 5e-4);
        work += first.work_J;
        assert!(first.hook_load_N > 0.0 && first.work_J < 0.0);
        for _ in 0..500 {
            work += load.step(0.0, 5e-4).work_J;
        }
        assert!((energy(&load) - start - work).abs() < 1e-9 * start.max(work.abs()));
    }
}

#[test]
fn a_line_does_not_push() {
    let mut load = Load::new(LINE, HoistControl::BlockVelocity(0.0), 0.0);
    load.chain.set_velocity(0, Vector(0.0, 0.0, -1.0));
    for _ in 0..100 {
        let step = load.step(0.0, 1e-3);
        assert_eq!((step.hook_load_N, step.work_J), (0.0, 0.0));
    }
    assert_eq!(load.velocity(), -1.0);
    assert!((load.down() + 0.1).abs() < 1e-12);
}

/// A constant hook load: `v = (g − F/m) t` exactly. The block moves with the mass, so that a line
/// which takes over has the same load to carry.
#[test]
fn a_hook_load_lifts_as_newton_says() {
    let force = 6e4;
    let mut load = Load::new(LINE, HoistControl::HookLoad(force), GRAVITY_M_PER_S2);
    for _ in 0..1000 {
        assert_eq!(load.step(0.0, 1e-3).hook_load_N, force);
    }
    let expected = GRAVITY_M_PER_S2 - force / MASS_KG;
    assert!((load.velocity() - expected).abs() < 1e-11);
    assert!((load.hoist.velocity_m_per_s() - load.velocity()).abs() < 1e-12);
    let velocity = load.velocity();
    load.hoist.set_control(HoistControl::BlockVelocity(velocity));
    let step = load.step(0.0, 1e-3);
    assert!((step.hook_load_N / force - 1.0).abs() < 0.05, "{}", step.hook_load_N);
}

/// The block's speed answers the weight that is missing through a filter of first order:
/// `v = v₀ + K (W₀ − W)(1 − e^(−t/τ))`; it never lifts.
#[test]
fn an_autodriller_follows_its_filter() {
    let (target, nominal, weight) = (TARGET.weight_N, TARGET.velocity_m_per_s, 40e3);
    let mut load = Load::new(LINE, HoistControl::Autodriller, GRAVITY_M_PER_S2);
    let dt = 1e-4;
    for i in 1..=30_000 {
        load.step(weight, dt);
        let t = f64::from(i) * dt;
        let exact = nominal + 1e-7 * (target - weight) * (1.0 - (-t).exp());
        // The filter's step is implicit: dt/(2τ) of the change.
        assert!((load.hoist.velocity_m_per_s() - exact).abs() < 2e-3 * dt);
    }
    for _ in 0..30_000 {
        load.step(500e3, 1e-3);
    }
    assert_eq!(load.hoist.velocity_m_per_s(), 0.0);
}

/// With an integral, `v = v₀ + K e (1 − e^(−t/τ) + (t − τ(1 − e^(−t/τ)))/T_i)` for a weight that
/// stays `e` too small. Against a limit the integral waits: once the weight is right again the
/// speed is back at once, except for the filter's state.
#[test]
fn an_autodriller_integrates_and_keeps_to_its_limits() {
    let autodriller = Autodriller {
        integral_time_s: 20.0,
        min_speed_m_per_s: -0.001,
        max_speed_m_per_s: 0.006,
        ..Autodriller::default()
    };
    let control = HoistControl::Autodriller;
    let mut load = Load::under(LINE, control, autodriller, GRAVITY_M_PER_S2);
    let (nominal, missing, dt) = (TARGET.velocity_m_per_s, 10e3, 1e-4);
    for i in 1..=50_000 {
        load.step(TARGET.weight_N - missing, dt);
        let t = f64::from(i) * dt;
        let seen = 1.0 - (-t).exp();
        let exact = nominal + 1e-7 * missing * (seen + (t - seen) / 20.0);
        assert!((load.hoist.velocity_m_per_s() - exact).abs() < 2e-3 * dt);
    }
    let before = load.hoist.velocity_m_per_s();
    for (weight, limit) in [(0.0, 0.006), (500e3, -0.001)] {
        for _ in 0..60_000 {
            load.step(weight, 1e-3);
        }
        assert_eq!(load.hoist.velocity_m_per_s(), limit);
    }
    for _ in 0..30_000 {
        load.step(TARGET.weight_N, 1e-3);
    }
    // The minute at each limit would have moved an integral without a limit by 0.02 m/s; the
    // approach and the return move it by less than a filter's time at each side.
    let after = load.hoist.velocity_m_per_s();
    assert!((after - before).abs() < 1e-7 * 300e3 / 20.0, "{before} {after}");
}

/// A block of its own mass swings with the load on the line: `ω² = k/(m + M)`, and the hook feels
/// the load's part of it, `m/(m + M)` of the line's force. Within `π` steps per period, by the
/// first order of the implicit step.
#[test]
fn a_block_swings_with_its_load() {
    let block = 20e3;
    let line = HoistLine { damping_N_s_per_m: 0.0, block_mass_kg: block, ..LINE };
    let mut load = Load::new(line, HoistControl::BlockVelocity(0.0), GRAVITY_M_PER_S2);
    let omega = (line.stiffness_N_per_m / (MASS_KG + block)).sqrt();
    let steps = 40_000;
    let dt = std::f64::consts::TAU / omega / f64::from(steps);
    let amplitude = 2e-3;
    load.chain.set_displacement(0, Vector(0.0, 0.0, amplitude));
    let weight = MASS_KG * GRAVITY_M_PER_S2;
    let swing = MASS_KG / (MASS_KG + block) * line.stiffness_N_per_m * amplitude;
    for i in 1..=steps {
        let step = load.step(0.0, dt);
        let exact = (omega * dt * f64::from(i)).cos();
        let (place, pull) = (load.down() / amplitude, (step.hook_load_N - weight) / swing);
        let tolerance = std::f64::consts::TAU * std::f64::consts::PI / f64::from(steps);
        assert!((place - exact).abs() < tolerance, "{place} {exact}");
        assert!((pull - exact).abs() < tolerance, "{pull} {exact}");
    }
}

/// With a block or without, work is the change of the load's kinetic energy.
#[test]
fn work_does_not_count_the_block() {
    let line = HoistLine { block_mass_kg: 20e3, ..LINE };
    for control in [HoistControl::BlockVelocity(0.2), HoistControl::HookLoad(7e4)] {
        let mut load = Load::new(line, control, 0.0);
        load.chain.set_velocity(0, Vector(0.0, 0.0, 0.5));
        let energy = |load: &Load| 0.5 * MASS_KG * load.velocity().powi(2);
        let (start, mut work) = (energy(&load), 0.0);
        for _ in 0..500 {
            work += load.step(0.0, 5e-4).work_J;
        }
        assert!((energy(&load) - start - work).abs() < 1e-9 * start.max(work.abs()));
    }
}
