//! Buckling of a pipe in its hole against `verification/`: critical loads (C01, C03, S2a) and
//! lock-up (S2b).

mod common;

use common::*;
use serde_json::Value;
use wholestring::statics::buckling::{
    Criterion, Place, Pushed, Segment, Shape, Shape::*, push_through, weight_at_bit_N,
};

fn number(object: &Value, key: &str) -> f64 {
    object[key].as_f64().unwrap_or_else(|| panic!("{key}: {object}"))
}

fn numbers(list: &Value) -> Vec<f64> {
    let all = list.as_array().expect("a list");
    all.iter().map(|value| value.as_f64().expect("a number")).collect()
}

/// A pipe of stiffness, clearance and weight in a straight hole.
fn straight(stiffness: f64, clearance_m: f64, weight: f64, inclination_deg: f64) -> Place {
    Place {
        bending_stiffness_N_m2: stiffness,
        clearance_m,
        weight_N_per_m: weight,
        weight_across_N_per_m: weight * inclination_deg.to_radians().sin(),
        build_rad_per_m: 0.0,
        turn_rad_per_m: 0.0,
    }
}

const PER_30_M: f64 = std::f64::consts::PI / 180.0 / 30.0;

/// The loads of Dawson and Paslay, of Chen, Lin and Cheatham and of Wu and Juvkam-Wold.
#[test]
fn c01_straight_holes() {
    let data = verification("C01_straight_hole_critical_loads.json");
    for (shape, key, name) in [
        (Sinusoidal, "F_sin_DawsonPaslay_N", "sinusoid"),
        (Helical, "F_hel_sqrt2_ChenLinCheatham_N", "helix"),
        (FullHelical, "F_hel_2sqrt2minus1_Wu_N", "finished helix"),
    ] {
        let quantity = format!("critical load of the {name}, N");
        let rows = data["cases"].as_array().expect("cases").iter().map(|row| {
            let inputs = &row["inputs"];
            let place = straight(
                number(inputs, "E_Pa") * number(inputs, "I_m4"),
                number(inputs, "clearance_m"),
                number(inputs, "buoyed_w_N_m"),
                number(inputs, "inc_deg"),
            );
            let [load] = place.critical_loads_N(shape)[..] else {
                panic!("one load: {row}");
            };
            verify("C01", &quantity)
                .relative(1e-12, "rounding")
                .row(number(&row["expected"], key), load)
        });
        report_worst(rows.collect::<Vec<_>>());
    }
}

/// The curvature's contact force counts: builds, drops and turns.
#[test]
fn c03_curved_holes() {
    let data = verification("C03_curved_hole_he_kyllingstad.json");
    let rows = data["cases"].as_array().expect("cases").iter().map(|row| {
        let inputs = &row["inputs"];
        let inclination_deg = number(inputs, "inc_deg");
        let place = Place {
            build_rad_per_m: number(inputs, "build_deg_per_30m") * PER_30_M,
            turn_rad_per_m: number(inputs, "turn_deg_per_30m")
                * PER_30_M
                * inclination_deg.to_radians().sin(),
            ..straight(
                number(inputs, "EI"),
                number(inputs, "r_c"),
                number(inputs, "w"),
                inclination_deg,
            )
        };
        let shape = match inputs["mode"].as_str() {
            Some("sin") => Sinusoidal,
            _ => Helical,
        };
        verify("C03", "critical load of He and Kyllingstad in a curved hole, N")
            .relative(1e-6, "what its source requires")
            .row(number(&row["expected"], "F_crit_N"), place.critical_loads_N(shape)[0])
    });
    report_worst(rows.collect::<Vec<_>>());
}

/// All roots along a well with a build and a drop, and in drops so sharp that there are three.
#[test]
fn s2a_all_roots() {
    let data = verification("S2a_buckling_along_string.json");
    let pipe = &data["inputs"]["pipe"];
    let clearance_m = number(&data["inputs"], "clearance_m");
    let place = |inclination_deg: f64, curvature: f64| Place {
        build_rad_per_m: curvature,
        ..straight(number(pipe, "EI"), clearance_m, number(pipe, "w"), inclination_deg)
    };
    let mut rows = Vec::new();
    let mut hold = |place: Place, shape: Shape, expected: &Value| {
        let (found, expected) = (place.critical_loads_N(shape), numbers(expected));
        assert_eq!(found.len(), expected.len(), "{place:?}: {found:?}");
        for (computed, expected) in found.into_iter().zip(expected) {
            rows.push(
                verify("S2a", "critical load along a well with a build and a drop, N")
                    .relative(1e-6, "what its source requires")
                    .row(expected, computed),
            );
        }
    };
    for row in data["critical"].as_array().expect("depths") {
        let place = place(number(row, "inc_deg"), number(row, "curvature_rad_m"));
        hold(place, Sinusoidal, &row["F_sin_all_roots_N"]);
        let helical = &row["F_hel_HeKyllingstad_beta8_all_roots_N"];
        hold(place, Helical, helical);
    }
    for row in data["strong_drop_points"].as_array().expect("drops") {
        let inputs = &row["inputs"];
        let place = place(number(inputs, "inc_deg"), number(inputs, "build_deg_30m") * PER_30_M);
        hold(place, Sinusoidal, &row["expected"]["F_sin_all_roots_N"]);
        hold(place, Helical, &row["expected"]["F_hel_all_roots_N"]);
    }
    report_worst(rows);
    let vertical = place(0.0, 0.0);
    verify("S2a", "Lubinski's load of the first order in a vertical hole, N")
        .relative(1e-12, "rounding")
        .report(
            number(&data["vertical"], "Lubinski_sin_1p94_N"),
            vertical.threshold_N(Sinusoidal, 0.0),
        );
}

/// Each criterion means its own two loads, of which only He and Kyllingstad's see the curvature.
#[test]
fn s2a_criteria() {
    let data = verification("S2a_buckling_along_string.json");
    let pipe = &data["inputs"]["pipe"];
    let clearance_m = number(&data["inputs"], "clearance_m");
    let mut rows = Vec::new();
    for row in data["critical"].as_array().expect("depths") {
        let place = Place {
            build_rad_per_m: number(row, "curvature_rad_m"),
            ..straight(number(pipe, "EI"), clearance_m, number(pipe, "w"), number(row, "inc_deg"))
        };
        let first = |key: &str| numbers(&row[key]).first().copied().unwrap_or(0.0);
        let sinusoid_N = number(row, "F_sin_straight_formula_N");
        for (criterion, expected_N) in [
            (
                Criterion::HeKyllingstad,
                [first("F_sin_all_roots_N"), first("F_hel_HeKyllingstad_beta8_all_roots_N")],
            ),
            (
                Criterion::ChenLinCheatham,
                [sinusoid_N, number(row, "F_hel_ChenLinCheatham_straight_N")],
            ),
            (Criterion::WuJuvkamWold, [sinusoid_N, number(row, "F_hel_WuJuvkamWold_straight_N")]),
        ] {
            let loads_N = place.loads_N(criterion, 0.0).expect("there is clearance");
            let shapes = criterion.shapes().into_iter();
            for (shape, (load_N, expected_N)) in shapes.zip(loads_N.into_iter().zip(expected_N)) {
                // The support of a vertical hole acts in every hole.
                let least_N = place.vertical_load_N(shape);
                rows.push(
                    verify("S2a", "critical loads by each criterion, N")
                        .relative(1e-6, "what its source requires")
                        .row(expected_N.max(least_N), load_N),
                );
                assert!(!place.is_beyond(shape, 0.0));
            }
            for part in [0.999, 1.001] {
                let helix_N = loads_N[1];
                assert_eq!(place.is_helix(criterion, part * helix_N), part > 1.0, "{place:?}");
            }
        }
    }
    report_worst(rows);
    let snug = Place { clearance_m: 0.0, ..straight(1e6, 0.0, 300.0, 90.0) };
    assert_eq!(snug.loads_N(Criterion::default(), 1e9), None);
    assert!(!snug.is_helix(Criterion::default(), 1e9));
}

/// In a sharp drop a pipe is straight, buckled, pressed straight to the high side, and buckled
/// again as it is pushed harder; its reference is the last load exceeded where it is buckled, and
/// the next load where it is not.
#[test]
fn a_drop_has_three_critical_loads() {
    let data = verification("S2a_buckling_along_string.json");
    let pipe = &data["inputs"]["pipe"];
    let place = Place {
        build_rad_per_m: -6.0 * PER_30_M,
        ..straight(number(pipe, "EI"), 0.04445, number(pipe, "w"), 60.0)
    };
    let [first, second, third] = place.critical_loads_N(Sinusoidal)[..] else {
        panic!("three loads");
    };
    for (load, beyond, held_against) in [
        (0.999 * first, false, first),
        (1.001 * first, true, first),
        (0.999 * second, true, first),
        (1.001 * second, false, third),
        (0.999 * third, false, third),
        (1.001 * third, true, third),
    ] {
        assert_eq!(place.is_beyond(Sinusoidal, load), beyond, "{load}");
        assert_eq!(place.critical_load_N(Sinusoidal, load), held_against);
    }
}

/// A helix that is pushed through a horizontal hole locks up within a length of its own.
#[test]
fn s2b_lock_up() {
    let data = verification("S2b_lockup_horizontal.json");
    let pipe = &data["inputs"]["pipe"];
    let (mut lengths, mut pushes) = (Vec::new(), Vec::new());
    for row in data["cases"].as_array().expect("cases") {
        let (inputs, expected) = (&row["inputs"], &row["expected"]);
        let helix = match inputs["F_hel_rule"].as_str() {
            Some("WuJuvkamWold") => Criterion::WuJuvkamWold,
            _ => Criterion::ChenLinCheatham,
        };
        let segment = Segment {
            length_m: 5.0,
            place: straight(
                number(pipe, "EI"),
                number(&data["inputs"], "clearance_m"),
                number(pipe, "w"),
                90.0,
            ),
            friction: number(inputs, "mu"),
            weight_along_N_per_m: 0.0,
        };
        let at_bit_N = number(inputs, "F_at_bit_N");
        let Pushed::LocksUp(length_m) = push_through(&[segment; 2000], at_bit_N, helix) else {
            panic!("it does not lock up: {row}");
        };
        let hold = |quantity, computed, expected| {
            verify("S2b", quantity)
                .relative(1e-6, "what its source requires")
                .row(expected, computed)
        };
        let closed_m = number(expected, "closed_form_m");
        lengths.push(hold("length that locks up, m", length_m, closed_m));
        // Nine tenths of that length are a whole number of stretches of their own.
        let part = Segment { length_m: 0.9 * closed_m / 1000.0, ..segment };
        let Pushed::Through(push_N) = push_through(&[part; 1000], at_bit_N, helix) else {
            panic!("it locks up too early: {row}");
        };
        let expected_N = number(expected, "F_at_0p9_L_N");
        pushes.push(hold("push at 0.9 of that length, N", push_N, expected_N));
        // The push down and its reversal.
        let arrives_N = weight_at_bit_N(&[part; 1000], push_N, helix);
        assert!((arrives_N - at_bit_N).abs() < 1.0, "{arrives_N}: {row}");
        // Beyond that length the greatest push does not bring the load to the bit, short of it the
        // load and more.
        let whole = |length_m: f64| [Segment { length_m: length_m / 1000.0, ..segment }; 1000];
        let max_N = |length_m| weight_at_bit_N(&whole(length_m), f64::INFINITY, helix);
        assert!(max_N(1.01 * closed_m) < at_bit_N, "{row}");
        assert!(max_N(0.99 * closed_m) > at_bit_N, "{row}");
    }
    report_worst(lengths);
    report_worst(pushes);
}
