//! A pipe in a vertical hole under the weight on its bit: its critical load and its buckled shape.
//!
//! Lengths in units of `(EI/w)^(1/3)`, forces of `(EI w²)^(1/3)`, as of Lubinski (1950).

use std::f64::consts::{PI, SQRT_2, TAU};

use wholestring::{
    ends::{BitEnd, Ends, TopEnd},
    prelude::*,
    statics::stiff::{self, StiffProfile},
    string::ComponentSpec,
};

use crate::{
    common,
    common::{report_worst, verify},
    pressed, settings, solve,
};

const OD_M: f64 = 0.127;
const ID_M: f64 = 0.1086;
const HOLE_M: f64 = 0.2159;
const MUD_KG_PER_M3: f64 = 1200.0;

/// Elements, m: a seventh of the unit.
const ELEMENT_M: f64 = 3.0;

/// Of a thin pipe.
struct Units {
    length_m: f64,
    force_N: f64,
}

fn units() -> Units {
    let steel = common::steel();
    let stiffness_N_m2 = steel.youngs_modulus_Pa * PI / 64.0 * (OD_M.powi(4) - ID_M.powi(4));
    let density = steel.density_kg_per_m3 - MUD_KG_PER_M3;
    let area_m2 = PI / 4.0 * (OD_M * OD_M - ID_M * ID_M);
    let weight_N_per_m = area_m2 * density * wholestring::GRAVITY_M_PER_S2;
    let length_m = (stiffness_N_m2 / weight_N_per_m).cbrt();
    Units { length_m, force_N: weight_N_per_m * length_m }
}

/// 5 in pipe of a length in a vertical hole of 8-1/2 in, pinned at its bit.
fn hanging(length_m: f64, top: TopEnd, friction: f64) -> Model {
    let path = common::arcs(&[[0.0, 0.0, 0.0], [length_m, 0.0, 0.0]]);
    let pipe = ComponentSpec::uniform("pipe", OD_M, ID_M, ToSurface, common::steel());
    let hole = common::open_hole(HOLE_M, friction, length_m);
    let mud = common::mud(MUD_KG_PER_M3);
    let ends = Ends { top, bit: BitEnd::Pinned };
    Model { ends, ..common::model(path, hole, vec![pipe], mud, length_m) }
}

/// Largest offset of a node from the axis, as a part of the clearance.
fn far(profile: &StiffProfile) -> f64 {
    let most_m =
        profile.lateral_offset_m.iter().fold(0.0_f64, |most, offset| most.max(offset.abs()));
    most_m / (0.5 * (HOLE_M - OD_M))
}

/// The lateral equilibrium `u'' + (f − x) u = h` of the slope `u` from the pinned bit, `u'(0) = 0`,
/// to the top, integrated from `u(0)` by Runge and Kutta: `u`, `u'` and `∫u` there.
fn shoot(f: f64, length: f64, slope: f64, side: f64) -> [f64; 3] {
    const STEPS: usize = 2000;
    let step = length / STEPS as f64;
    let rate = |x: f64, [u, v, _]: [f64; 3]| [v, side - (f - x) * u, u];
    let add = |a: [f64; 3], b: [f64; 3], by: f64| [0, 1, 2].map(|k| a[k] + by * b[k]);
    let mut at = [slope, 0.0, 0.0];
    for index in 0..STEPS {
        let x = step * index as f64;
        let k1 = rate(x, at);
        let k2 = rate(x + 0.5 * step, add(at, k1, 0.5 * step));
        let k3 = rate(x + 0.5 * step, add(at, k2, 0.5 * step));
        let k4 = rate(x + step, add(at, k3, step));
        at = [0, 1, 2].map(|k| at[k] + step / 6.0 * (k1[k] + 2.0 * (k2[k] + k3[k]) + k4[k]));
    }
    at
}

/// The least load under which a pipe of a length that is pinned at its bit has a bent shape: no
/// deflection at the top, and no slope or no moment.
fn critical(length: f64, top: TopEnd) -> f64 {
    let held = match top {
        TopEnd::Clamped => 0,
        TopEnd::Pinned => 1,
    };
    let determinant = |f: f64| {
        let [a, b] = [shoot(f, length, 1.0, 0.0), shoot(f, length, 0.0, 1.0)];
        a[held] * b[2] - b[held] * a[2]
    };
    let crossing = (0..200).map(|k| 0.05 * f64::from(k));
    let mut low = crossing
        .map(|f| (f, determinant(f) * determinant(f + 0.05)))
        .find_map(|(f, product)| (product < 0.0).then_some(f))
        .expect("a critical load");
    let mut high = low + 0.05;
    while high - low > 1e-6 {
        let middle = 0.5 * (low + high);
        if determinant(low) * determinant(middle) < 0.0 { high = middle } else { low = middle }
    }
    low
}

/// The pipe is straight below the critical load and on the wall beyond it: found by halving between
/// 1.5 and 2.5 to 1e-3. A stiffness below 1e-5 of the foundation `w/c` counts as neutral, which
/// here is 0.9 % of the load.
#[test]
fn a_hanging_pipe_buckles_where_a_beam_does() {
    let units = units();
    let mut rows = Vec::new();
    for (length, top) in [
        (8.0, TopEnd::Pinned),
        (8.0, TopEnd::Clamped),
        (12.0, TopEnd::Pinned),
        (12.0, TopEnd::Clamped),
    ] {
        let length_m = length * units.length_m;
        let model = hanging(length_m, top, 0.0);
        let bends = |f: f64| {
            let found = solve(&model, &pressed(length_m, f * units.force_N), &settings(ELEMENT_M));
            far(&found) > 0.5
        };
        let [mut straight, mut bent] = [1.5, 2.5];
        assert!(!bends(straight) && bends(bent), "{length} {top:?}");
        while bent - straight > 1e-3 {
            let middle = 0.5 * (straight + bent);
            if bends(middle) { bent = middle } else { straight = middle }
        }
        let (found, expected) = (0.5 * (straight + bent), critical(length, top));
        println!("{length} units, {top:?}: {found:.4} for {expected:.4}");
        let what = format!(
            "critical weight on bit of a hanging pipe of {length} units {top:?} at its top"
        );
        rows.push(
            verify("vertical", what)
                .relative(1.5e-2, "what costs 1e-5 of w/c counts as neutral, 0.9 %")
                .row(expected, found),
        );
        if (length, top) == (8.0, TopEnd::Pinned) {
            verify("vertical", "critical weight on bit of a hanging pipe over (EI w²)^(1/3)")
                .relative(1.5e-2, "what costs 1e-5 of w/c counts as neutral, 0.9 %")
                .report(1.94, found);
        }
    }
    report_worst(rows);
}

/// Range of the part below the neutral point around the hole, rad.
fn goes_rad(profile: &StiffProfile) -> f64 {
    let (mut at, mut last) = (0.0, None::<f64>);
    let [mut low, mut high] = [0.0_f64; 2];
    for (node, [up, right]) in profile.axis.offset_m.iter().enumerate() {
        let off_m = up.hypot(*right);
        if profile.tension_N[node] > 0.0 || off_m < 0.15 * (HOLE_M - OD_M) {
            continue;
        }
        let angle = right.atan2(*up);
        if let Some(last) = last {
            at += (angle - last + PI).rem_euclid(TAU) - PI;
        }
        last = Some(angle);
        (low, high) = (low.min(at), high.max(at));
    }
    high - low
}

/// Beyond the critical load a pipe is in a plane against one wall, then against two, and winds up
/// from 4 units on. A helix of Lubinski, Althouse and Logan winds by `√(F/2EI)` a metre, `0.4714
/// f^1.5` rad up to the neutral point; a quarter of a turn of it is missing at the ends. A torque
/// of the bit winds it somewhat more.
#[test]
fn beyond_it_it_winds_up() {
    const LENGTH: f64 = 30.0;
    let units = units();
    let length_m = LENGTH * units.length_m;
    for (friction, torque_N_m) in [(0.0, 0.0), (0.3, 0.0), (0.3, 2500.0)] {
        let model = hanging(length_m, TopEnd::Clamped, friction);
        let helix = |f: f64| 2.0 / 3.0 * f.powf(1.5) / SQRT_2;
        let mut goes = Vec::new();
        for f in [1.7, 2.0, 2.5, 3.0, 3.5, 3.75, 4.0, 4.2, 4.5, 5.0, 5.55, 6.5, 8.0, 12.0] {
            let pushed = pressed(length_m, f * units.force_N);
            let operation = Operation { bit_torque_N_m: torque_N_m, ..pushed };
            let begin = std::time::Instant::now();
            let found =
                stiff::solve(&model, &operation, &settings(ELEMENT_M)).expect("an equilibrium");
            let ms = 1e3 * begin.elapsed().as_secs_f64();
            let convergence = found.convergence;
            let touching = found.contact_force_N.iter().filter(|force| **force > 0.0).count();
            let goes_deg = goes_rad(&found).to_degrees();
            println!(
                "{friction} {torque_N_m} {f:5}: {} steps, stable {}, far {:.3}, goes {goes_deg:.0} deg, helix {:.0}, touches {touching}, {ms:.0} ms",
                convergence.iterations,
                convergence.stable,
                far(&found),
                helix(f).to_degrees()
            );
            assert!(convergence.stable && far(&found) > 0.99, "{f}: {convergence:?}");
            goes.push((f, goes_rad(&found)));
        }
        let at = |f: f64| goes.iter().find(|(load, _)| *load == f).expect("a row").1;
        let flat = |(f, goes): &(f64, f64)| *f > 3.8 || *goes < 0.01;
        assert!(torque_N_m > 0.0 || goes.iter().all(flat), "{goes:?}");
        if torque_N_m == 0.0 {
            let what = format!("turn between 8 and 12 units of load at friction {friction}, rad");
            verify("vertical", what)
                .relative(2e-2, "what the ends take changes with the load")
                .report(helix(12.0) - helix(8.0), at(12.0) - at(8.0));
        }
    }
}

/// A pipe that rotates with friction in a vertical hole has no static equilibrium with contact:
/// weight and ends have no moment about the hole's axis, so that nothing balances that of the
/// friction, `Σ μ N |u|` in addition to the torque that twists the pipe. Beyond its critical load
/// it has no stable equilibrium. The straight one is returned as unstable, with the depth at which
/// the released pipe rolls; the dynamics confirm this. Below that load, or without friction, it has
/// one.
#[test]
fn a_turning_pipe_has_no_buckled_state_of_rest() {
    const LENGTH: f64 = 12.0;
    let units = units();
    let length_m = LENGTH * units.length_m;
    let turning = |friction: f64, f: f64| {
        let model = hanging(length_m, TopEnd::Clamped, friction);
        let drill = common::pressing(OperationKind::Drill, length_m, f * units.force_N);
        let found = stiff::solve(&model, &drill, &settings(ELEMENT_M)).expect("an equilibrium");
        (found, model, drill)
    };
    let touches = |profile: &StiffProfile| {
        profile.contact_force_N.iter().fold(0.0_f64, |most, on| most.max(*on))
    };
    let (below, ..) = turning(0.3, 1.5);
    assert!(below.convergence.stable && below.convergence.rolls_at_md_m.is_none());
    // A pipe with a small contact force rolls slowly because of the damping: minimum turns in 20 s.
    for (f, least_turns) in [(3.0, 0.2), (5.0, 0.4), (8.0, 2.0)] {
        let (slippery, ..) = turning(0.0, f);
        println!("{f}: {:?}, {} N", slippery.convergence, touches(&slippery));
        assert!(slippery.convergence.stable && touches(&slippery) > 0.0);
        let (straight, model, drill) = turning(0.3, f);
        let convergence = straight.convergence;
        let rolls_m = convergence.rolls_at_md_m.expect("rolls");
        println!("{f}: {convergence:?}, of {length_m:.0} m, {} N", touches(&straight));
        assert!(!convergence.stable && touches(&straight) == 0.0, "{convergence:?}");
        assert!(far(&straight) < 1e-6, "{convergence:?}");
        // In the part that is compressed, or not far above it.
        assert!((0.0..1.5 * f * units.length_m).contains(&(length_m - rolls_m)), "{rolls_m}");
        let turns = common::whirl::turns(&model, &drill, [60.0, 20.0]).expect("a simulation");
        println!("{f}: {turns:.1} turns");
        assert!(turns > least_turns, "{f}: {turns}");
    }
}
