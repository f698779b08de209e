//! Supports of the ends, pull at the bit, push at the top and lateral forces.

use std::f64::consts::{FRAC_PI_2, PI};

use wholestring::{
    ends::{BitEnd, Ends, TopEnd},
    prelude::*,
    statics::soft::soft_string,
};

use crate::{
    common,
    common::{
        assert_close,
        beam::{self, LENGTH_M, WEIGHT_N_PER_M, beam},
        number, report_worst, verification, verify,
    },
    nearest, pressed, settings, solve,
};

/// Elements of the beams, m: halved and halved again they change the bit's force by 1.1e-4 and
/// 3e-5.
const ELEMENT_M: f64 = 0.25;

/// Deflection under its own weight, the bit's share of it and the moment at the top of a beam whose
/// ends are held in every way. Elements of 0.25 m against thin beams: side forces and moments
/// within 1e-3 of the load, deflections within 1e-2; found 3e-4 and 7e-3, most of it shear,
/// `48 EI/(κGA L²)` of a clamped beam's deflection.
#[test]
fn beams_with_ends_of_every_kind() {
    let (stiffness, weight_N) = (beam::stiffness_N_m2(), WEIGHT_N_PER_M * LENGTH_M);
    for case in &beam::CASES {
        let model = beam(case.ends, None);
        let found = solve(&model, &pressed(LENGTH_M, 0.0), &settings(ELEMENT_M));
        let largest_m = found.lateral_offset_m.iter().fold(0.0_f64, |largest, y| largest.max(*y));
        let deflection = largest_m * stiffness / (weight_N * LENGTH_M.powi(3));
        let reason = "thin beams; shear and slopes, elements of 0.25 m";
        verify("ends", format!("largest deflection {} over wL⁴/EI", case.name))
            .relative(1e-2, reason)
            .report(case.deflection, deflection);
        verify("ends", format!("side force of the bit {} over the weight", case.name))
            .absolute(1e-3, reason)
            .report(-case.bit_share, found.bit_side_force_N[0] / weight_N);
        verify("ends", format!("moment at the top {} over wL²", case.name))
            .absolute(1e-3, reason)
            .report(case.moment_at_top, found.bending_moment_N_m[0] / (weight_N * LENGTH_M));
    }
}

/// A lateral force a third of the way up from a pinned bit presses the bit by
/// `F b² (3L − b)/(2 L³)`, `b` its distance from the clamped top, or by `F b/L` under a pinned one;
/// against its direction, at every tool face. The part of the weight is subtracted.
#[test]
fn a_lateral_force_presses_the_bit() {
    const FORCE_N: f64 = 300.0;
    const FROM_BIT_M: f64 = 4.0;
    let b = (LENGTH_M - FROM_BIT_M) / LENGTH_M;
    let mut rows = Vec::new();
    for (top, share) in [(TopEnd::Clamped, 0.5 * b * b * (3.0 - b)), (TopEnd::Pinned, b)] {
        let ends = Ends { top, bit: BitEnd::Pinned };
        let side_N = |force| {
            let model = beam(ends, force);
            solve(&model, &pressed(LENGTH_M, 0.0), &settings(ELEMENT_M)).bit_side_force_N
        };
        let own_N = side_N(None);
        for toolface_rad in [0.0, FRAC_PI_2, PI, -2.0] {
            let found_N = side_N(Some([FROM_BIT_M, FORCE_N, toolface_rad]));
            for (part, name) in [(0, "high side"), (1, "right")] {
                let towards = if part == 0 { toolface_rad.cos() } else { toolface_rad.sin() };
                let found = (found_N[part] - own_N[part]) / FORCE_N;
                let what = format!("to the {name} at {toolface_rad:.2} rad under a {top:?} top");
                rows.push(
                    verify("ends", format!("the bit's share of a lateral force {what}"))
                        .absolute(1e-3, "thin beams; shear and slopes")
                        .row(share * towards, found),
                );
            }
        }
    }
    report_worst(rows);
}

/// C05: a heavy beam is lifted off its floor by `qL/2`, `L = (24 EI h/q)^(1/4)`: the bit on the
/// axis of a hole that leaves it `h`.
#[test]
fn c05_lifted_beam() {
    let data = verification("C05_stiff_string_contact.json");
    for row in data["lifted_heavy_beam"]["rows"].as_array().expect("rows") {
        let input = |key: &str| number(&row["inputs"][key]);
        let (od_m, id_m, length_m) = (0.127_f64, 0.1086_f64, 60.0);
        let second_moment = PI / 64.0 * (od_m.powi(4) - id_m.powi(4));
        let steel = Material {
            youngs_modulus_Pa: input("EI") / second_moment,
            shear_modulus_Pa: input("EI") / second_moment / 2.6,
            ..common::steel()
        };
        let pipe = ComponentSpec {
            mass_per_length_kg_per_m: input("q") / wholestring::GRAVITY_M_PER_S2,
            ..ComponentSpec::uniform("pipe", od_m, id_m, ComponentLength::ToSurface, steel)
        };
        let path = common::arcs(&[[0.0, 90.0, 0.0], [length_m, 90.0, 0.0]]);
        let lift_m = input("lift_h");
        let hole = common::open_hole(od_m + 2.0 * lift_m, 0.0, length_m);
        let mut model = common::model(path, hole, vec![pipe], common::mud(0.0), length_m);
        model.ends.bit = BitEnd::Pinned;
        let found = solve(&model, &Operation::trip_out(length_m), &settings(0.2));
        verify("C05", format!("force that lifts a beam by {lift_m} m, N"))
            .relative(2e-2, "the file's: small slopes, no shear")
            .report(-number(&row["expected"]["end_force_N"]), found.bit_side_force_N[0]);
    }
}

/// A free bit touches the wall like the pipe above it, with friction: a pipe on the low side of a
/// slant rests on it to its end.
#[test]
fn a_free_bit_lies_on_the_wall() {
    const DEPTH_M: f64 = 200.0;
    let weight_N_per_m = 200.0;
    let mut model = common::straight_model(60.0, DEPTH_M, weight_N_per_m, 0.0635, 0.3);
    model.ends.bit = BitEnd::Free;
    let found = solve(&model, &Operation::trip_out(DEPTH_M), &settings(2.0));
    let across_N_per_m = weight_N_per_m * 60.0_f64.to_radians().sin();
    // The lowest node has half an element.
    assert_close("the bit", -found.bit_side_force_N[0], across_N_per_m, 1e-4);
    let last = found.md_m.len() - 1;
    assert_close("the next", found.contact_force_N[last - 1], 2.0 * across_N_per_m, 1e-4);
    let from = nearest(&found, 150.0);
    let above: f64 = found.contact_force_N[from..].iter().sum();
    let length_m = DEPTH_M - found.md_m[from] + 1.0;
    assert_close("the rest", above, across_N_per_m * length_m, 1e-3);
}

/// A pull on the bit reaches the hook through an arc by the capstan's factor, as in the soft
/// string: `T e^(μα)` of a string without weight. The stiff string differs by its bending at both
/// ends of the arc: found 7e-4.
#[test]
fn a_pull_on_the_bit_comes_up_through_an_arc() {
    const PULL_N: f64 = 2e5;
    let (mu, turn_deg, length_m) = (0.3, 40.0_f64, 500.0);
    let pipe = common::pipe(1.0, 0.0635, ComponentLength::ToSurface);
    let [top_deg, bit_deg] = [20.0, 20.0 + turn_deg];
    let path = common::arcs(&[
        [0.0, top_deg, 0.0],
        [100.0, top_deg, 0.0],
        [400.0, bit_deg, 0.0],
        [length_m, bit_deg, 0.0],
    ]);
    let hole = common::open_hole(0.2159, mu, length_m);
    let model = common::model(path, hole, vec![pipe], common::mud(0.0), length_m);
    let pulled = Operation::trip_out(length_m).bit_pull_N(PULL_N);
    let weight_N = soft_string(&model, &Operation::trip_out(length_m)).expect("a soft string");
    let soft = soft_string(&model, &pulled).expect("a soft string");
    let stiff = solve(&model, &pulled, &settings(2.0));
    let expected = PULL_N * (mu * turn_deg.to_radians()).exp();
    let own_N = weight_N.scalars.hook_load_N;
    verify("ends", "hook load of the soft string under a pull on the bit, N")
        .relative(1e-3, "the weight that is left, in the arc")
        .report(expected, soft.scalars.hook_load_N - own_N);
    verify("ends", "hook load of the stiff string under a pull on the bit, N")
        .relative(2e-3, "how it bends into its arc")
        .report(expected, stiff.scalars.hook_load_N - own_N);
    for tension_N in [soft.tension_N.last(), stiff.tension_N.last()] {
        assert_eq!(tension_N, Some(&PULL_N));
    }
}

/// A stuck string that hangs straight is stretched by `F L/EA` more, from which its free length
/// follows.
#[test]
fn a_stuck_string_stretches_by_its_free_length() {
    const DEPTH_M: f64 = 1000.0;
    const PULL_N: f64 = 1.5e5;
    let model = common::straight_model(0.0, DEPTH_M, 250.0, 0.0635, 0.0);
    let steel_N = model.string.components()[0].axial_stiffness_N();
    let [free, stuck] = [0.0, PULL_N].map(|pull_N| {
        let operation = Operation::trip_out(DEPTH_M).bit_pull_N(pull_N);
        let soft = soft_string(&model, &operation).expect("a soft string").scalars;
        [soft, solve(&model, &operation, &settings(5.0)).scalars]
    });
    for (method, name) in ["soft", "stiff"].iter().enumerate() {
        verify("ends", format!("stretch of the {name} string under a pull on the bit, m"))
            .relative(1e-9, "exact, rounding")
            .report(PULL_N * DEPTH_M / steel_N, stuck[method].stretch_m - free[method].stretch_m);
        let pulls_N = stuck[method].hook_load_N - free[method].hook_load_N;
        assert_close("hook load", pulls_N, PULL_N, 1e-9);
    }
}

/// Weight on the bit of a level hole is pushed at the top, with the friction in addition:
/// `−(W + μ w L)`. In the stiff string, below the load of the sinusoid, all of its weight has
/// friction but the part that its clamped top carries, 8 m of 1000; contact forces and push balance
/// to rounding.
#[test]
fn a_level_hole_requires_a_push() {
    const LENGTH_M: f64 = 1000.0;
    let (mu, weight_N_per_m, wob_N) = (0.25, 250.0, 15e3);
    let mut model = common::straight_model(90.0, LENGTH_M, weight_N_per_m, 0.0635, mu);
    model.ends.bit = BitEnd::Free;
    let operation = pressed(LENGTH_M, wob_N);
    let expected_N = -(wob_N + mu * weight_N_per_m * LENGTH_M);
    let soft_N = soft_string(&model, &operation).expect("a soft string").scalars.hook_load_N;
    let stiff = solve(&model, &operation, &settings(2.0)).scalars;
    verify("ends", "force at the top of a level hole on the soft string, N")
        .relative(1e-9, "exact, rounding")
        .report(expected_N, soft_N);
    verify("ends", "force at the top of a level hole on the stiff string, N")
        .relative(8e-3, "what the clamped top carries off the wall rubs nowhere")
        .report(expected_N, stiff.hook_load_N);
    let balance_N = -(wob_N + mu * stiff.side_force_total_N);
    assert_close("balance", stiff.hook_load_N, balance_N, 1e-6);
}
