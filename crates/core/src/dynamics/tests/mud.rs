//! Effect of mud on lateral motion: drag and added mass.

use super::{
    beams::swing,
    bench::{Bench, PIPE_M, Support},
};
use crate::{
    dynamics::{assemble::chain, kernel::chain::node},
    mud::Mud,
    simd::vector::Vector,
};

const HOLE_M: f64 = 0.2159;
const LENGTH_M: f64 = 30.0;

/// Mud of 1.2 sg.
const STILL: Mud = crate::common::mud(1200.0);

fn rod(mud: Mud) -> Bench {
    Bench::in_mud(&[(PIPE_M, LENGTH_M)], 1.0, 0.0, mud, HOLE_M)
}

/// Steel, mud inside, and mud that moves along outside, kg/m: a cylinder of radius `r` accelerated
/// across an annulus that it shares the axis with carries `ρ π r² (R² + r²)/(R² − r²)` (Stokes
/// 1843; Blevins 1979).
fn masses_kg_per_m(bench: &Bench, density_kg_per_m3: f64) -> (f64, f64) {
    let steel = bench.mesh.elements[0].section.steel_kg_per_m;
    let quarter = std::f64::consts::FRAC_PI_4;
    let (d2, hole2) = (PIPE_M[0].powi(2), HOLE_M.powi(2));
    let inside = quarter * PIPE_M[1].powi(2);
    let outside = quarter * d2 * (hole2 + d2) / (hole2 - d2);
    (steel, steel + density_kg_per_m3 * (inside + outside))
}

/// Gives the free rod the velocity `v0` across, and the part of it that is left after `time_s`.
fn left_of(mud: Mud, v0: Vector<f64>, time_s: f64, steps: f64) -> Vector<f64> {
    let mut bench = rod(mud);
    bench.input.dt = time_s / steps;
    for i in 0..bench.chain.nodes() {
        bench.chain.set_velocity(i, v0);
    }
    for _ in 0..steps as usize {
        bench.step();
    }
    let middle = bench.chain.nodes() / 2;
    bench.chain.velocity(middle)
}

/// A rod that moves sideways as a whole loses its velocity as `m v' = −c v − ½ ρ C D v²` has it:
/// `v = v₀ e/(1 + (k v₀/λ)(1 − e))` with `e = exp(−λt)`, `λ = c/m` and `k = ½ ρ C D/m`; `exp(−λt)`
/// without the quadratic part, `1/(1 + k v₀ t)` without the linear one. Along the hole it loses
/// nothing.
///
/// The step takes the drag at its beginning: first order, with an error of `λ² t dt/2` for the
/// linear part and `k v₀ dt ln(1 + k v₀ t)/(1 + k v₀ t)` for the quadratic one. Both are below 4e-4
/// here; the sum of both is the tolerance. Halving the step halves it.
#[test]
fn mud_drags_on_lateral_motion() {
    let (speed, time) = (2.0f64, 2.0);
    for (linear, coefficient) in [(60.0, 0.0), (0.0, 1.0), (60.0, 1.0)] {
        let mud = Mud { linear_drag_Pa_s: linear, drag_coefficient: coefficient, ..STILL };
        let (_, mass) = masses_kg_per_m(&rod(STILL), STILL.density_kg_per_m3);
        let lambda = linear / mass;
        let k = 0.5 * STILL.density_kg_per_m3 * coefficient * PIPE_M[0] / mass;
        let decay = (-lambda * time).exp();
        let rest = if lambda > 0.0 { (1.0 - decay) / lambda } else { time };
        let expected = speed * decay / (1.0 + k * speed * rest);
        let steps = 8000.0;
        let error = |steps| {
            let left = left_of(mud, Vector(0.6 * speed, 0.8 * speed, 0.7), time, steps);
            assert!((left.2 - 0.7).abs() < 1e-12, "{} along the hole", left.2);
            assert!((left.1 / left.0 - 0.8 / 0.6).abs() < 1e-9);
            left.0.hypot(left.1) / expected - 1.0
        };
        let (coarse, fine) = (error(steps), error(2.0 * steps));
        assert!(coarse.abs() < 8e-4, "{coarse:e}");
        assert!((coarse / fine - 2.0).abs() < 0.05, "{coarse:e} {fine:e}");
    }
}

/// A pinned pipe that swings in viscous mud decays as `exp(−ct/2m)`.
///
/// Over ten periods, by the peaks. That rate is an oscillator's own, whatever its damping; the
/// step's error is of the order of `c dt/m`, 1e-5, and a parabola finds a peak, of thousands of
/// steps, to rounding. 0.2 % leaves room for the rounding of deflections of a micrometre.
#[test]
fn a_swinging_pipe_decays_at_half_the_rate_of_drag() {
    let mud = Mud { linear_drag_Pa_s: 5.0, ..STILL };
    let mut bench = rod(mud);
    let last = bench.chain.nodes() - 1;
    bench.support(0, Support::PINNED);
    bench.support(last, Support::ROLLER);
    let k = std::f64::consts::PI / LENGTH_M;
    for i in 0..=last {
        let z = bench.z_m(i);
        if node!(bench.chain, i, inv_mass_lateral) > 0.0 {
            bench.chain.set_velocity(i, Vector(1e-6 * (k * z).sin(), 0.0, 0.0));
        }
        bench.chain.set_turning(i, Vector(0.0, 1e-6 * k * (k * z).cos(), 0.0));
    }
    // Swings by their largest deflection, a parabola through the highest three.
    let (mut u, mut peaks) = ([0.0f64; 3], Vec::new());
    let mut step = 0u32;
    while peaks.len() < 21 {
        bench.step();
        step += 1;
        assert!(step < 1_000_000, "it does not swing");
        u = [u[1], u[2], bench.chain.displacement(last / 2).0];
        if u[1].abs() > u[0].abs() && u[1].abs() >= u[2].abs() {
            let curve = u[0] - 2.0 * u[1] + u[2];
            let shift = 0.5 * (u[0] - u[2]) / curve;
            let peak = u[1] - 0.25 * (u[0] - u[2]) * shift;
            peaks.push(((f64::from(step) - 1.0 + shift) * bench.input.dt, peak.abs().ln()));
        }
    }
    let rate = (peaks[0].1 - peaks[20].1) / (peaks[20].0 - peaks[0].0);
    let (_, mass) = masses_kg_per_m(&bench, STILL.density_kg_per_m3);
    let expected = 0.5 * mud.linear_drag_Pa_s / mass;
    assert!((rate / expected - 1.0).abs() < 2e-3, "{rate} for {expected} 1/s");
}

/// Mud inside and around slows a swinging pipe by `√(m/(m + m_in + m_out))`, and leaves its axial
/// vibration alone.
///
/// The beam's shear and the mesh act on both alike, but for the rotary inertia that is given to the
/// mesh: at most `(kh)²/78` = 1.4e-4 of the frequency. The axial frequency is `c/2L`, the mesh's
/// `(2/πk) sin` of it: both rods have the same to rounding.
#[test]
fn mud_takes_part_in_lateral_motion_only() {
    let k = std::f64::consts::PI / LENGTH_M;
    let lateral = |mud| {
        let mut bench = rod(mud);
        let last = bench.chain.nodes() - 1;
        bench.support(0, Support::PINNED);
        bench.support(last, Support::ROLLER);
        swing(&mut bench, 2, |z| ((k * z).sin(), k * (k * z).cos()))
    };
    let axial = |mud| {
        let mut bench = rod(mud);
        for i in 0..bench.chain.nodes() {
            let shape = (k * bench.z_m(i)).cos();
            bench.chain.set_velocity(i, Vector(0.0, 0.0, 1e-6 * shape));
        }
        bench.frequency_Hz(2, |bench| bench.chain.displacement(0).2)
    };
    let air = crate::common::mud(0.0);
    for density_kg_per_m3 in [1000.0, 2000.0] {
        let mud = crate::common::mud(density_kg_per_m3);
        let (steel, mass) = masses_kg_per_m(&rod(mud), density_kg_per_m3);
        let expected = (steel / mass).sqrt();
        let found = lateral(mud) / lateral(air);
        assert!((found / expected - 1.0).abs() < 1.5e-4, "{found} for {expected}");
        let (wet, dry) = (axial(mud), axial(air));
        assert!((wet / dry - 1.0).abs() < 1e-4, "{wet} for {dry} Hz");
    }
}

/// The mud carried along outside is the concentric annulus's up to a pipe that fills 82 % of its
/// hole, and five times the pipe's displaced mass in any tighter one.
#[test]
fn added_mass_is_confined_up_to_a_cap() {
    let outside_kg_per_m = |od: f64| {
        let parts = [([od, 0.05], 10.0)];
        let bench = Bench::in_mud(&parts, 1.0, 0.0, STILL, HOLE_M);
        let section = &bench.mesh.elements[0].section;
        let mass = chain::lateral_mass_kg_per_m(&bench.model, &bench.mesh, 10.0)[0];
        mass - section.steel_kg_per_m - STILL.density_kg_per_m3 * section.bore_m2
    };
    for (od, expected) in [
        (0.08, (0.2159f64.powi(2) + 0.0064) / (0.2159f64.powi(2) - 0.0064)),
        (0.80 * HOLE_M, 1.64 / 0.36),
        (0.83 * HOLE_M, 5.0),
        (HOLE_M, 5.0),
    ] {
        let displaced = STILL.density_kg_per_m3 * std::f64::consts::FRAC_PI_4 * od * od;
        let found = outside_kg_per_m(od) / displaced;
        assert!((found / expected - 1.0).abs() < 1e-9, "{od}: {found} for {expected}");
    }
}
