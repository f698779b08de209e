//! Laminar flow against closed forms.

use super::*;
use crate::common::viscous_mud;

const PIPE_M: f64 = 0.0635;
const HOLE_M: f64 = 0.10795;
const GAP: Annulus = Annulus { pipe_m: PIPE_M, hole_m: HOLE_M };
/// So narrow that a slot's closed form is right to the square of gap over radius.
const SLOT: Annulus = Annulus { pipe_m: 0.0990, hole_m: 0.1000 };
const BINGHAM: Rheology = Rheology::Bingham { plastic_viscosity_Pa_s: 0.025, yield_point_Pa: 7.2 };
const POWER_LAW: Rheology = Rheology::PowerLaw { consistency_Pa_s_n: 0.9, flow_index: 0.55 };

/// A mud without weight never becomes turbulent.
fn weightless(rheology: Rheology) -> Mud {
    viscous_mud(0.0, rheology)
}

#[track_caller]
fn close(what: &str, found: f64, expected: f64, tolerance: f64) {
    let error = (found / expected - 1.0).abs();
    assert!(error <= tolerance, "{what}: {found} for {expected}, {error:.1e}");
}

fn moving(axial: f64, spin: f64, flow: f64) -> Motion {
    Motion { axial_m_per_s: axial, spin_rad_per_s: spin, flow_m3_per_s: flow }
}

/// Newtonian: the pressure of a concentric annulus (Lamb 1932, Bird, Stewart and Lightfoot), the
/// torque of Couette, and for a pipe that moves along, the pressure and the pull that its displaced
/// mud makes, each by its own closed form, to rounding.
#[test]
fn newtonian_mud_is_exact() {
    let viscosity = 0.03;
    let mud = weightless(Rheology::Newtonian { viscosity_Pa_s: viscosity });
    let (a2, r2) = (PIPE_M * PIPE_M, HOLE_M * HOLE_M);
    let log = (HOLE_M / PIPE_M).ln();
    let flow = 0.02;
    let pumped = GAP.drag(&mud, &moving(0.0, 0.0, flow));
    let shape = r2 * r2 - a2 * a2 - (r2 - a2).powi(2) / log;
    let gradient = 8.0 * viscosity * flow / (PI * shape);
    close("gradient", pumped.gradient_Pa_per_m, gradient, 1e-12);
    // Shear on the pipe (the profile's slope there) and pressure on its end.
    let shear = 0.25 * gradient * (2.0 * PIPE_M - (r2 - a2) / (PIPE_M * log));
    let pull = 2.0 * PI * PIPE_M * shear - PI * a2 * gradient;
    close("pull", pumped.pull_N_per_m, pull, 1e-12);

    let turned = GAP.drag(&mud, &moving(0.0, 7.0, flow));
    let torque = 4.0 * PI * viscosity * 7.0 * a2 * r2 / (r2 - a2);
    close("torque", -turned.torque_N(7.0), torque, 1e-12);

    // A pipe that is run in pumps its displaced volume and drags mud down: superposed, Couette's
    // flow along the pipe carries `v π ((R² − a²)/(2 log) − a²)` down, so that the pressure must
    // drive that up as well.
    let v = 0.5;
    let run = GAP.drag(&mud, &moving(v, 0.0, 0.0));
    let couette = v * PI * ((r2 - a2) / (2.0 * log) - a2);
    let up = v * PI * a2 + couette;
    let gradient = 8.0 * viscosity * up / (PI * shape);
    close("surge", run.gradient_Pa_per_m, gradient, 1e-12);
    let shear = 0.25 * gradient * (2.0 * PIPE_M - (r2 - a2) / (PIPE_M * log))
        - viscosity * v / (PIPE_M * log);
    let pull = 2.0 * PI * PIPE_M * shear - PI * a2 * gradient;
    close("drag", run.axial_N_per_m(v), pull, 1e-12);
}

/// The solver for any mud gives the Newtonian closed form for a power law of index 1: to the
/// quadrature's rounding.
#[test]
fn a_power_law_of_index_one_is_newtonian() {
    let newton = weightless(Rheology::Newtonian { viscosity_Pa_s: 0.03 });
    let power = weightless(Rheology::PowerLaw { consistency_Pa_s_n: 0.03, flow_index: 1.0 });
    for motion in [moving(0.3, 7.0, 0.03), moving(-1.0, 0.0, 0.0), moving(0.0, 12.0, 0.0)] {
        let (exact, found) = (GAP.drag(&newton, &motion), GAP.drag(&power, &motion));
        let v = motion.axial_m_per_s;
        let scale = exact.axial_N_per_m(v).abs().max(1e-6);
        assert!((exact.axial_N_per_m(v) - found.axial_N_per_m(v)).abs() < 1e-9 * scale);
        close("slope", found.drag_Pa_s, exact.drag_Pa_s, 1e-9);
        close("spin", found.spin_drag_N_s, exact.spin_drag_N_s, 1e-9);
    }
}

/// Reiner and Riwlin's torque of a Bingham mud: `Ω = T/4πμ (1/a² − 1/r₀²) − τ₀/μ ln(r₀/a)`, where
/// the mud is yielded to `r₀ = √(T/2πτ₀)` or to the hole. The solid part is a stiff liquid here,
/// 1e-4 of it, and where it begins the integrand has a kink: 24 points hold it to 1e-3.
#[test]
fn bingham_torque_is_that_of_reiner_and_riwlin() {
    let (viscosity, yield_point) = (0.025, 7.2);
    for (torque, tolerance) in [(0.30, 2e-4), (0.45, 2e-4), (0.6, 2e-4), (1.5, 2e-4)] {
        let reach = f64::sqrt(torque / (2.0 * PI * yield_point));
        let outer = reach.min(HOLE_M);
        let spin = torque / (4.0 * PI * viscosity) * (PIPE_M.powi(-2) - outer.powi(-2))
            - yield_point / viscosity * (outer / PIPE_M).ln();
        let drag = GAP.drag(&weightless(BINGHAM), &moving(0.0, spin, 0.0));
        close("torque", -drag.torque_N(spin), torque, tolerance);
    }
}

/// A power-law mud between rotating cylinders: `Ω = n/2 (T/2πK)^(1/n) (a^(−2/n) − R^(−2/n))`.
#[test]
fn power_law_torque_is_that_of_couette() {
    let (consistency, n): (f64, f64) = (0.9, 0.55);
    for torque in [0.05f64, 0.2, 1.0] {
        let spin = 0.5
            * n
            * (torque / (2.0 * PI * consistency)).powf(1.0 / n)
            * (PIPE_M.powf(-2.0 / n) - HOLE_M.powf(-2.0 / n));
        let drag = GAP.drag(&weightless(POWER_LAW), &moving(0.0, spin, 0.0));
        close("torque", -drag.torque_N(spin), torque, 1e-9);
    }
}

/// Flow through a narrow slot: `Q = W h² n/(2(2n + 1)) (G h/2K)^(1/n)` for the power law,
/// `Q = W h² τ_w/6μ (1 − 3/2 y + y³/2)` with `y = τ₀/τ_w` for Bingham. A slot as narrow as a
/// hundredth of its radius differs from an annulus by the square of that; the stiff liquid in
/// Bingham's plug adds 3e-4.
#[test]
fn slots_meet_their_closed_forms() {
    let gap = SLOT.hole_m - SLOT.pipe_m;
    let width = PI * (SLOT.hole_m + SLOT.pipe_m);
    let (consistency, n): (f64, f64) = (0.9, 0.55);
    let wall = 40.0f64;
    let flow = width * gap * gap * n / (2.0 * (2.0 * n + 1.0)) * (wall / consistency).powf(1.0 / n);
    let drag = SLOT.drag(&weightless(POWER_LAW), &moving(0.0, 0.0, flow));
    close("power law", drag.gradient_Pa_per_m, 2.0 * wall / gap, 2e-4);
    for (wall, tolerance) in [(20.0, 5e-4), (40.0, 5e-4)] {
        let y = 7.2 / wall;
        let flow = width * gap * gap * wall / (6.0 * 0.025) * (1.0 - 1.5 * y + 0.5 * y * y * y);
        let drag = SLOT.drag(&weightless(BINGHAM), &moving(0.0, 0.0, flow));
        close("Bingham", drag.gradient_Pa_per_m, 2.0 * wall / gap, tolerance);
    }
}

/// Helical flow: with the stresses that were found, the velocities integrated across the gap in
/// 20000 steps meet the pipe's velocity, its spin and the flow rate. The error of the quadrature is
/// within 1e-4 of the largest.
#[test]
fn helical_flow_meets_its_three_conditions() {
    for rheology in [BINGHAM, POWER_LAW] {
        for motion in [
            moving(0.3, 7.0, 0.033),
            moving(-0.5, 2.0, 0.0),
            moving(0.0, 0.5, 0.01),
            moving(0.02, 20.0, 0.002),
        ] {
            let drag = GAP.laminar(&rheology, &motion);
            let g = drag.gradient_Pa_per_m;
            let b = drag.axial_N_per_m(motion.axial_m_per_s) / (2.0 * PI);
            let c = drag.torque_N(motion.spin_rad_per_s) / (2.0 * PI);
            let n = 20_000;
            let h = (HOLE_M - PIPE_M) / f64::from(n);
            let (mut flow, mut velocity, mut spin) = (0.0, 0.0, 0.0);
            for i in 0..n {
                let r = PIPE_M + (f64::from(i) + 0.5) * h;
                let (along, around) = (0.5 * g * r + b / r, c / (r * r));
                let fluidity = rheology.flow(along.hypot(around)).fluidity;
                flow += PI * r * r * fluidity * along * h;
                velocity -= fluidity * along * h;
                spin -= fluidity * around / r * h;
            }
            let area = PI * (HOLE_M * HOLE_M - PIPE_M * PIPE_M);
            let expected =
                [motion.flow_m3_per_s / area, motion.axial_m_per_s, motion.spin_rad_per_s * PIPE_M];
            let found = [flow / area, velocity, spin * PIPE_M];
            let largest = expected.iter().fold(0.0f64, |m, w| m.max(w.abs()));
            for (found, expected) in found.iter().zip(expected) {
                assert!(
                    (found - expected).abs() < 1e-4 * largest,
                    "{rheology:?} {motion:?}: {found} for {expected}"
                );
            }
        }
    }
}

/// The slopes with the velocity along the hole are the difference quotients of force and pressure,
/// and the mud always takes energy.
#[test]
fn the_slope_is_the_forces_own() {
    let newtonian = Rheology::Newtonian { viscosity_Pa_s: 0.03 };
    for rheology in [newtonian, BINGHAM, POWER_LAW] {
        let mud = weightless(rheology);
        for motion in [moving(0.3, 7.0, 0.033), moving(-0.5, 2.0, 0.01)] {
            let drag = GAP.drag(&mud, &motion);
            let at = |v: f64| {
                let motion = Motion { axial_m_per_s: v, ..motion };
                let drag = GAP.drag(&mud, &motion);
                (drag.axial_N_per_m(v), drag.gradient_Pa_per_m)
            };
            let v = motion.axial_m_per_s;
            let (above, below) = (at(v + 1e-4), at(v - 1e-4));
            close("slope", (below.0 - above.0) / 2e-4, drag.drag_Pa_s, 1e-2);
            let surge = (above.1 - below.1) / 2e-4;
            close("surge", surge, drag.surge_Pa_s_per_m2, 1e-2);
            assert!(drag.spin_drag_N_s > 0.0 && drag.drag_Pa_s > 0.0);
        }
    }
}

/// A mud at rest answers with finite coefficients, also where it has a yield point, and pulls at
/// nothing.
#[test]
fn a_mud_at_rest_pulls_at_nothing() {
    for rheology in [BINGHAM, POWER_LAW] {
        let drag = GAP.drag(&weightless(rheology), &Motion::default());
        assert_eq!(drag.axial_N_per_m(0.0), drag.pull_N_per_m);
        assert!(drag.pull_N_per_m.abs() < 1e-9 && drag.gradient_Pa_per_m.abs() < 1e-9);
        assert!(drag.drag_Pa_s.is_finite() && drag.spin_drag_N_s.is_finite());
        assert!(drag.drag_Pa_s > 0.0 && drag.spin_drag_N_s > 0.0);
    }
    let filled = Annulus::new(0.2159, 0.2159);
    let drag = filled.drag(&weightless(BINGHAM), &moving(0.3, 7.0, 0.03));
    assert!(drag.axial_N_per_m(0.3).is_finite() && drag.axial_N_per_m(0.3) < 0.0);
}

/// Turbulent flow without motion of the pipe takes the gradient of the friction factor:
/// `2 f ρ U²/D_h`. The annulus's own laminar factor is 24/Re within 3 %, a slot's.
#[test]
fn turbulent_flow_takes_the_friction_factors_gradient() {
    let viscosity_Pa_s = 1e-3;
    let water = viscous_mud(1000.0, Rheology::Newtonian { viscosity_Pa_s });
    let area = PI * (HOLE_M * HOLE_M - PIPE_M * PIPE_M);
    let hydraulic = 2.0 * (HOLE_M - PIPE_M);
    let reynolds = 1000.0 * hydraulic / 1e-3;
    let friction = 0.0791 / reynolds.powf(0.25);
    let found = GAP.drag(&water, &moving(0.0, 0.0, area)).gradient_Pa_per_m;
    close("gradient", found, 2.0 * friction * 1000.0 / hydraulic, 0.04);
    // At rest and rotating, Wendt's torque.
    let spin = 7.0;
    let (eta, re) = (PIPE_M / HOLE_M, 1000.0 * spin * PIPE_M * (HOLE_M - PIPE_M) / 1e-3);
    let wendt = 0.23 * eta.powf(1.5) / (1.0 - eta).powf(1.75) * re.powf(1.7) * 1e-6 / 1000.0;
    let found = -GAP.drag(&water, &moving(0.0, spin, 0.0)).torque_N(spin);
    close("torque", found, wendt, 1e-9);
}

/// Where the flow up the hole turns turbulent, every mud's gradient is its laminar one times the
/// ratio of API RP 13D for a slot at Metzner and Reed's Reynolds number: laminar up to 3470 − 1370
/// n, turbulent from 4270 − 1370 n on, halfway the mean of the two frictions. Exact but for the
/// root that finds the laminar gradient.
#[test]
fn the_transition_is_that_of_api_rp_13d() {
    let newtonian = Rheology::Newtonian { viscosity_Pa_s: 0.03 };
    let unit = weightless(Rheology::Newtonian { viscosity_Pa_s: 1.0 });
    let area = PI * (HOLE_M * HOLE_M - PIPE_M * PIPE_M);
    let motion = moving(0.0, 0.0, area);
    for rheology in [newtonian, BINGHAM, POWER_LAW] {
        let laminar = GAP.drag(&weightless(rheology), &motion).gradient_Pa_per_m;
        // The viscosity of a Newtonian mud with this gradient.
        let viscosity = laminar / GAP.drag(&unit, &motion).gradient_Pa_per_m;
        let n: f64 = rheology.flow_index();
        let (a, b) = ((n.log10() + 3.93) / 50.0, (1.75 - n.log10()) / 7.0);
        let (first, last) = (3470.0 - 1370.0 * n, 4270.0 - 1370.0 * n);
        for reynolds in [1195.0, 2000.0, first + 400.0, 1.05 * last, 2e4] {
            let friction = if reynolds < first {
                24.0 / reynolds
            } else if reynolds < last {
                0.5 * (24.0 / first + a / last.powf(b))
            } else {
                a / reynolds.powf(b)
            };
            let density_kg_per_m3 = reynolds * viscosity / (2.0 * (HOLE_M - PIPE_M));
            let mud = viscous_mud(density_kg_per_m3, rheology);
            let found = GAP.drag(&mud, &motion).gradient_Pa_per_m / laminar;
            // Of the thinner muds the turbulent law may stay below the laminar one.
            let expected = (friction * reynolds / 24.0).max(1.0);
            close(&format!("{rheology:?} at {reynolds}"), found, expected, 1e-6);
        }
    }
}

/// A yield-power-law mud of index 1 is Bingham's, without a yield point a power law: to the quadrature's 1e-3 at the kink of the
/// plug, and to its rounding.
#[test]
fn a_yield_power_law_has_the_others_in_it() {
    let both = |yield_point_Pa, consistency_Pa_s_n, flow_index| {
        weightless(Rheology::HerschelBulkley { yield_point_Pa, consistency_Pa_s_n, flow_index })
    };
    for motion in [moving(0.3, 7.0, 0.03), moving(-1.0, 0.0, 0.0), moving(0.0, 12.0, 0.02)] {
        let v = motion.axial_m_per_s;
        let (exact, found) =
            (GAP.drag(&weightless(BINGHAM), &motion), GAP.drag(&both(7.2, 0.025, 1.0), &motion));
        close("gradient", found.gradient_Pa_per_m, exact.gradient_Pa_per_m, 1e-6);
        close("pull", found.axial_N_per_m(v), exact.axial_N_per_m(v), 1e-6);
        let (exact, found) =
            (GAP.drag(&weightless(POWER_LAW), &motion), GAP.drag(&both(0.0, 0.9, 0.55), &motion));
        close("gradient", found.gradient_Pa_per_m, exact.gradient_Pa_per_m, 1e-9);
        close("pull", found.axial_N_per_m(v), exact.axial_N_per_m(v), 1e-9);
    }
}

/// Torque of a yield-power-law mud between a rotating pipe and a hole at rest, all of it yielded: `Ω = ∫ γ̇(T/2πr²) dr/r` by
/// Simpson's rule.
#[test]
fn yield_power_law_torque_is_that_of_couette_flow() {
    let (yield_point, consistency, index) = (5.0, 0.6, 0.7);
    let torque = 1.5;
    let steps = 4000;
    let step = (HOLE_M - PIPE_M) / f64::from(steps);
    let rate = |r: f64| {
        let stress: f64 = torque / (2.0 * PI * r * r);
        assert!(stress > yield_point, "{stress}");
        ((stress - yield_point) / consistency).powf(1.0 / index) / r
    };
    let spin: f64 = (0..=steps)
        .map(|at| {
            let weight = if at == 0 || at == steps { 1.0 } else { f64::from(2 + 2 * (at % 2)) };
            weight * rate(PIPE_M + step * f64::from(at))
        })
        .sum::<f64>()
        * step
        / 3.0;
    let mud = weightless(Rheology::HerschelBulkley {
        yield_point_Pa: yield_point,
        consistency_Pa_s_n: consistency,
        flow_index: index,
    });
    let drag = GAP.drag(&mud, &moving(0.0, spin, 0.0));
    close("torque", -drag.torque_N(spin), torque, 1e-6);
}
