//! The bit on the rock, which the step leaves to an implicit correction; here the plain rate law.

mod delay;
mod detournay;
mod excitation;
mod lumped;
mod motor;
mod regenerative;
mod rock;
mod roots;
mod side;
mod table;

use nalgebra::Vector3;

use crate::{
    common::operation,
    dynamics::{
        boundary::{
            anchor::Anchor,
            bit::{Bit, BitSettings, BitStep, StepStart},
            executor::RockExecutor,
        },
        kernel::chain::{Chain, node},
    },
    operation::{Operation, OperationKind},
    simd::vector::Vector,
};

const MASS_KG: f64 = 150.0;
const POLAR_KG_M2: f64 = 0.8;
const DEPTH_M: f64 = 2000.0;

const OPERATION: Operation = operation(OperationKind::Drill, DEPTH_M)
    .rotary_speed_rad_per_s(7.0)
    .weight_on_bit_N(60e3)
    .bit_torque_N_m(3e3)
    .rate_of_penetration_m_per_s(0.003);

/// A bit that forces push and turn.
struct Rig {
    chain: Chain,
    bit: Bit,
    push: Vector<f64>,
    turn: f64,
}

impl Rig {
    fn new(operation: Operation) -> Self {
        Self::with(operation, BitSettings::default())
    }

    fn with(operation: Operation, settings: BitSettings) -> Self {
        let mut chain = Chain::new(1);
        node!(chain, 0, mass_axial = MASS_KG);
        node!(chain, 0, inv_mass_axial = 1.0 / MASS_KG);
        node!(chain, 0, mass_lateral = 2.0 * MASS_KG);
        node!(chain, 0, inv_mass_lateral = 0.5 / MASS_KG);
        node!(chain, 0, polar = POLAR_KG_M2);
        node!(chain, 0, inv_polar = 1.0 / POLAR_KG_M2);
        Self {
            chain,
            bit: Bit::new(&settings, &operation, DEPTH_M, 1),
            push: Vector::zero(),
            turn: 0.0,
        }
    }

    fn spin(&self) -> f64 {
        node!(self.chain, 0, spin)
    }

    fn set_spin(&mut self, spin: f64) {
        node!(self.chain, 0, spin = spin);
    }

    fn step(&mut self, dt: f64) -> BitStep {
        let (before, spin) = (self.chain.velocity(0), self.spin());
        let mass = [0.5 / MASS_KG, 0.5 / MASS_KG, 1.0 / MASS_KG];
        let kick = Vector(self.push.0 * mass[0], self.push.1 * mass[1], self.push.2 * mass[2]);
        let v = before.plus(kick, dt);
        let u = self.chain.displacement(0).plus(v, dt);
        self.chain.set_velocity(0, v);
        self.chain.set_displacement(0, u);
        let turn = dt * self.turn * node!(self.chain, 0, inv_polar);
        self.set_spin(spin + turn);
        let anchor = Anchor {
            md_m: DEPTH_M,
            position_m: Vector3::new(0.0, 0.0, DEPTH_M),
            high_side: Vector3::x(),
        };
        let step_start = StepStart { velocity: before, spin };
        self.bit.act(&mut self.chain, &anchor, step_start, &RockExecutor::default(), dt)
    }
}

/// `W = W₀ (v/v₀)(Ω₀/Ω)`, at rest in time: pushed with any weight and turned at any speed, the bit
/// drills at the law's rate.
#[test]
fn the_bit_drills_at_the_laws_rate() {
    for (weight, speed) in [(1.0, 1.0), (0.5, 1.0), (2.0, 1.0), (1.0, 0.5), (0.3, 2.0)] {
        let mut rig = Rig::new(OPERATION);
        // The string turns it at a speed that the torque does not change.
        node!(rig.chain, 0, inv_polar = 0.0);
        rig.set_spin(7.0 * speed);
        rig.push = Vector(0.0, 0.0, 60e3 * weight);
        let mut step = BitStep::default();
        for _ in 0..40_000 {
            step = rig.step(5e-4);
        }
        let rate = 0.003 * weight * speed;
        assert!((step.weight_on_bit_N / (60e3 * weight) - 1.0).abs() < 1e-9, "{step:?}");
        assert!((step.torque_N_m / (3e3 * weight) - 1.0).abs() < 1e-9);
        assert!((rig.chain.velocity(0).2 / rate - 1.0).abs() < 1e-6, "{}", rig.chain.velocity(0).2);
    }
}

/// A bit on rock that does not yield (a stopped bit) is a mass on a spring: resolved, its period
/// is `2π √(m/k)`, and its amplitude falls by the implicit step's `e^(−ω² dt t/2)`.
#[test]
fn a_stopped_bit_bounces_on_the_rock() {
    let mut rig = Rig::new(OPERATION);
    let omega = (1e8f64 / MASS_KG).sqrt();
    let dt = 1e-3 / omega;
    rig.push = Vector(0.0, 0.0, 60e3);
    let amplitude = 1e-4;
    rig.chain.set_displacement(0, Vector(0.0, 0.0, amplitude));
    for i in 1..20_000 {
        rig.step(dt);
        let t = f64::from(i) * dt;
        let exact = amplitude * (-0.5 * omega * omega * dt * t).exp() * (omega * t).cos();
        // Second order in ω dt = 1e-3 per radian, first in the phase of the start.
        let error = (rig.chain.displacement(0).2 - exact).abs() / amplitude;
        assert!(error < 2e-3, "{i}: {error:e}");
    }
}

/// Lifted, the bit leaves the rock and nothing holds it; lowered, it meets the front where it left
/// it.
#[test]
fn the_bit_leaves_the_rock_freely() {
    let mut rig = Rig::new(OPERATION);
    rig.chain.set_velocity(0, Vector(0.0, 0.0, -2.0));
    let mut free = 0;
    for _ in 0..100 {
        let step = rig.step(5e-4);
        assert!(step.weight_on_bit_N >= 0.0 && step.torque_N_m >= 0.0);
        if step.weight_on_bit_N == 0.0 {
            free += 1;
        }
    }
    assert!(free > 90);
    let lifted = rig.chain.displacement(0).2;
    let velocity = rig.chain.velocity(0).2;
    assert_eq!((rig.step(5e-4).work_J, rig.chain.velocity(0).2), (0.0, velocity));
    assert!(lifted < -0.09);
    // The front is 0.6 mm above the start, the compression of the rock under its 60 kN.
    rig.chain.set_velocity(0, Vector::zero());
    rig.chain.set_displacement(0, Vector(0.0, 0.0, -0.601e-3));
    assert_eq!(rig.step(1e-6).weight_on_bit_N, 0.0);
    rig.chain.set_displacement(0, Vector(0.0, 0.0, -0.599e-3));
    assert!(rig.step(1e-6).weight_on_bit_N > 0.0);
}

/// A string that turns with less than the bit's torque does not turn the bit; with more, the
/// difference accelerates it.
#[test]
fn the_rock_holds_a_stopped_bit() {
    let dt = 5e-4;
    let mut rig = Rig::new(OPERATION);
    rig.push = Vector(0.0, 0.0, 60e3);
    rig.turn = 2.9e3;
    for _ in 0..1000 {
        let step = rig.step(dt);
        assert_eq!(rig.spin(), 0.0);
        assert!((step.torque_N_m / 2.9e3 - 1.0).abs() < 1e-12);
    }
    rig.turn = 3.5e3;
    let step = rig.step(dt);
    let excess = 3.5e3 - step.torque_N_m;
    assert!((step.torque_N_m / (0.05 * step.weight_on_bit_N) - 1.0).abs() < 1e-12);
    assert!((rig.spin() / (dt * excess / POLAR_KG_M2) - 1.0).abs() < 1e-12);
    // Turned backwards, the rock does not drive it.
    let mut back = Rig::new(OPERATION);
    back.set_spin(-1.0);
    assert_eq!(back.step(dt).torque_N_m, 0.0);
}

/// A motor drills at its own pace, whatever the string does, and its reaction turns the string
/// back.
#[test]
fn a_motor_drills_and_turns_the_string_back() {
    let mut rig = Rig::new(Operation { kind: OperationKind::Slide, ..OPERATION });
    rig.push = Vector(0.0, 0.0, 60e3);
    let first = rig.step(5e-4);
    assert!((first.torque_N_m / (0.05 * first.weight_on_bit_N) - 1.0).abs() < 1e-12);
    assert!(rig.spin() < 0.0);
    for _ in 0..40_000 {
        rig.step(5e-4);
    }
    assert!((rig.chain.velocity(0).2 / 0.003 - 1.0).abs() < 1e-6);
}

#[test]
fn off_bottom_there_is_no_rock() {
    let mut rig = Rig::new(Operation { kind: OperationKind::RotateOffBottom, ..OPERATION });
    rig.chain.set_velocity(0, Vector(0.0, 0.0, 1.0));
    for _ in 0..100 {
        let step = rig.step(1e-3);
        assert_eq!((step.weight_on_bit_N, step.torque_N_m, step.work_J), (0.0, 0.0, 0.0));
    }
    assert_eq!(rig.chain.velocity(0).2, 1.0);
}

/// Off its axis, the bit swings with `√(k/m)`; the implicit step damps by `ω dt/2`.
#[test]
fn the_hole_holds_the_bit_to_its_axis() {
    let mut rig = Rig::new(Operation { kind: OperationKind::RotateOffBottom, ..OPERATION });
    let omega = (1e7 / (2.0 * MASS_KG)).sqrt();
    let dt = 1e-3 / omega;
    rig.chain.set_displacement(0, Vector(3e-3, -4e-3, 0.7));
    for i in 1..20_000 {
        rig.step(dt);
        let t = f64::from(i) * dt;
        let exact = (-0.5 * omega * omega * dt * t).exp() * (omega * t).cos();
        let u = rig.chain.displacement(0);
        assert!((u.0 / 3e-3 - exact).abs() < 2e-3 && (u.1 / -4e-3 - exact).abs() < 2e-3, "{i}");
        assert_eq!(u.2, 0.7);
    }
}

/// The work of the rock and the hole is the change of the bit's kinetic energy, to rounding,
/// however it moves; cutting takes energy.
#[test]
fn work_is_the_change_of_kinetic_energy() {
    let mut rig = Rig::new(OPERATION);
    assert_work_is_the_change_of_energy(&mut rig);
    assert_eq!(rig.spin(), 0.0);
}

#[track_caller]
fn assert_work_is_the_change_of_energy(rig: &mut Rig) {
    rig.chain.set_velocity(0, Vector(0.3, -0.2, 0.4));
    rig.chain.set_displacement(0, Vector(1e-3, 2e-3, 0.0));
    rig.set_spin(6.0);
    let energy = |rig: &mut Rig| {
        let v = rig.chain.velocity(0);
        let spin = rig.spin();
        0.5 * (2.0 * MASS_KG * (v.0 * v.0 + v.1 * v.1)
            + MASS_KG * v.2 * v.2
            + POLAR_KG_M2 * spin * spin)
    };
    for _ in 0..2000 {
        let before = energy(rig);
        let turning = rig.spin() > 1.0;
        let step = rig.step(5e-4);
        let change = energy(rig) - before;
        assert!(
            (change - step.work_J).abs() < 1e-10 * (before + change.abs()),
            "{change} {step:?}"
        );
        assert!(!turning || step.torque_N_m == 0.0 || step.weight_on_bit_N > 0.0);
    }
}
