//! Effect of a viscous mud on motion along the hole and about the axis.

use nalgebra::Vector3;

use super::bench::{Bench, PIPE_M};
use crate::{
    common::{operation, viscous_mud},
    dynamics::{
        boundary::{anchor::Anchor, mud::viscous::Viscous},
        kernel::chain::node,
    },
    mud::{Annulus, Motion, Mud, Rheology},
    operation::OperationKind,
    simd::vector::Vector,
};

const HOLE_M: f64 = 0.2159;
const LENGTH_M: f64 = 96.0;

/// A mud without weight, which stays laminar.
fn weightless(rheology: Rheology) -> Mud {
    viscous_mud(0.0, rheology)
}

const NEWTONIAN: Rheology = Rheology::Newtonian { viscosity_Pa_s: 1.0 };
const BINGHAM: Rheology = Rheology::Bingham { plastic_viscosity_Pa_s: 0.5, yield_point_Pa: 20.0 };

/// A free vertical rod in mud.
struct Wet {
    bench: Bench,
    viscous: Viscous,
    anchors: Vec<Anchor>,
    steps: u64,
}

impl Wet {
    /// `weight` more than nothing, N/m.
    fn new(mud: Mud, element_length_m: f64, velocity: f64, spin: f64, weight: f64) -> Self {
        let parts = [(PIPE_M, LENGTH_M)];
        let mut bench = Bench::in_mud(&parts, element_length_m, 0.0, mud, HOLE_M);
        let anchors: Vec<Anchor> = (0..bench.chain.nodes())
            .map(|i| Anchor {
                md_m: bench.z_m(i),
                position_m: Vector3::new(0.0, 0.0, bench.z_m(i)),
                high_side: Vector3::x(),
            })
            .collect();
        for i in 0..bench.chain.nodes() {
            bench.chain.set_velocity(i, Vector(0.0, 0.0, velocity));
            node!(bench.chain, i, spin = spin);
            let length = bench.mesh.tributary_length_m(i);
            bench.chain.set_weight(i, Vector(0.0, 0.0, length * weight));
        }
        let operation = operation(OperationKind::RotateOffBottom, LENGTH_M)
            .rotary_speed_rad_per_s(spin)
            .trip_speed_m_per_s(0.0);
        let viscous = Viscous::new(&bench.model, &bench.mesh, &operation, velocity, LENGTH_M);
        let mut viscous = viscous.expect("the mud has a rheology");
        viscous.attach(&mut bench.chain, &anchors, bench.input.dt);
        Self { bench, viscous, anchors, steps: 0 }
    }

    fn go(&mut self, seconds: f64) {
        let dt = self.bench.input.dt;
        for _ in 0..(seconds / dt).round() as u64 {
            self.bench.step();
            self.steps += 1;
            if self.steps.is_multiple_of(16) {
                let Bench { chain, model, .. } = &mut self.bench;
                self.viscous.update(chain, &self.anchors, model, dt, 16.0 * dt);
            }
        }
    }

    fn time_s(&self) -> f64 {
        self.steps as f64 * self.bench.input.dt
    }

    /// Angular momentum over moment of inertia, rad/s.
    fn mean_spin(&self) -> f64 {
        let chain = &self.bench.chain;
        let sum = |term: &dyn Fn(usize) -> f64| (0..chain.nodes()).map(term).sum::<f64>();
        sum(&|i| node!(chain, i, polar) * node!(chain, i, spin)) / sum(&|i| node!(chain, i, polar))
    }

    fn middle(&self) -> usize {
        self.bench.chain.nodes() / 2
    }
}

/// Torque of Couette's flow over spin, per metre, and moment of inertia per metre.
fn spin_drag_and_inertia(wet: &Wet) -> (f64, f64) {
    let (a2, r2) = (0.25 * PIPE_M[0] * PIPE_M[0], 0.25 * HOLE_M * HOLE_M);
    let section = &wet.bench.mesh.elements[0].section;
    let drag = 4.0 * std::f64::consts::PI * a2 * r2 / (r2 - a2);
    (drag, section.polar_inertia_kg_m)
}

/// A free string that spins in a Newtonian mud slows down as `exp(−kt/J)`, `k = 4πμ a²R²/(R² − a²)`
/// and `J` per metre, whatever its elements.
///
/// The step evaluates the drag at its beginning, an error of `(k/J)² t dt/2`, up to 8e-4. The
/// neighbours of the two ends carry the ends' share, so the ends are ahead of the mean by 1e-4, a
/// fifth of which remains in it. Meshes of 1.6, 3.2 and 4.8 m agree within their steps' errors, far
/// within 1 %.
#[test]
fn spin_down_follows_the_closed_form_on_every_mesh() {
    let mut left = vec![];
    for length in [1.6, 3.2, 4.8] {
        let mut wet = Wet::new(weightless(NEWTONIAN), length, 0.0, 10.0, 0.0);
        let (drag, inertia) = spin_drag_and_inertia(&wet);
        let rate = drag / inertia;
        wet.go(2.0 / rate);
        let dt = wet.bench.input.dt;
        let spin = wet.mean_spin();
        let expected = 10.0 * (-rate * wet.time_s()).exp();
        let first_order = 0.5 * rate * rate * wet.time_s() * dt;
        let error = spin / expected - 1.0;
        assert!(
            (error + first_order).abs() < 2e-5,
            "{length} m: {spin} for {expected}, {error:e}, {first_order:e}"
        );
        left.push(spin);
    }
    let (low, high) = left.iter().fold((f64::MAX, 0.0f64), |(l, h), s| (l.min(*s), h.max(*s)));
    assert!(high / low - 1.0 < 0.01, "{left:?}");
}

/// In a Bingham mud it slows down by `J s' = −T(s)`, with Reiner and Riwlin's torque, integrated by
/// Runge and Kutta's rule.
///
/// The drag is found anew every 16 steps (10 ms) where the motion has changed by 1 %. Torque over
/// spin lags behind a spin that falls from 10 rad/s in less than a second, so that the spin is up
/// to 0.1 rad/s late: 2 % of 10 rad/s are held.
#[test]
fn a_yield_point_brings_a_string_to_rest() {
    let mut wet = Wet::new(weightless(BINGHAM), 3.2, 0.0, 10.0, 0.0);
    let (_, inertia) = spin_drag_and_inertia(&wet);
    let annulus = Annulus::new(PIPE_M[0], HOLE_M);
    let mud = weightless(BINGHAM);
    let slowing = |spin: f64| {
        let motion = Motion { spin_rad_per_s: spin, ..Motion::default() };
        annulus.drag(&mud, &motion).torque_N(spin) / inertia
    };
    let (mut spin, mut time) = (10.0, 0.0);
    let h = 1e-3;
    for wanted in [0.2, 0.5, 0.8] {
        while time < wanted - 0.5 * h {
            let k1 = slowing(spin);
            let k2 = slowing(spin + 0.5 * h * k1);
            let k3 = slowing(spin + 0.5 * h * k2);
            let k4 = slowing(spin + h * k3);
            spin += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
            time += h;
        }
        wet.go(wanted - wet.time_s());
        let found = node!(wet.bench.chain, wet.middle(), spin);
        assert!((found - spin).abs() < 0.02 * 10.0, "{wanted} s: {found} for {spin} rad/s");
    }
    // It is held by the yield point, not braked for ever: at rest within the time that the yield
    // torque alone takes.
    wet.go(3.0);
    let found = node!(wet.bench.chain, wet.middle(), spin);
    assert!(found.abs() < 0.05, "{found} rad/s is left");
}

/// A heavy string that falls in a Newtonian mud reaches `v = w/c`, `c = 2πμ(R² + a²)/((R² + a²)
/// ln(R/a) − R² + a²)`, as `v (1 − exp(−ct/m))`: the drag of a pipe that displaces its own volume
/// of mud. At first order in the step.
#[test]
fn a_falling_string_reaches_its_terminal_velocity() {
    let weight = 100.0;
    let mut wet = Wet::new(weightless(NEWTONIAN), 3.2, 0.0, 0.0, weight);
    let (a2, r2) = (0.25 * PIPE_M[0] * PIPE_M[0], 0.25 * HOLE_M * HOLE_M);
    let sum = r2 + a2;
    let drag = 2.0 * std::f64::consts::PI * sum / (0.5 * sum * (r2 / a2).ln() - r2 + a2);
    let mass = wet.bench.mesh.elements[0].section.steel_kg_per_m;
    let rate = drag / mass;
    let first_order = rate * wet.bench.input.dt;
    for part in [0.5, 2.0] {
        wet.go(part / rate - wet.time_s());
        let found = wet.bench.chain.velocity(wet.middle()).2;
        // Velocities are those half a step later.
        let expected = weight / drag * (1.0 - (-rate * wet.time_s()).exp());
        assert!(
            (found / expected - 1.0).abs() < first_order,
            "{found} for {expected} m/s, {first_order:e}"
        );
    }
    wet.go(20.0 / rate);
    let found = wet.bench.chain.velocity(wet.middle()).2;
    let expected = weight / drag;
    assert!((found / expected - 1.0).abs() < 1e-8, "{found} for {expected} m/s");
}
