//! S1d: hook load and torque of a whole string, plain and tortuous, and the climb of a rotating
//! one.

use wholestring::{prelude::*, string::ComponentLength};

use crate::{
    common,
    common::{number, verification, verify},
    piece, settings, solve,
};

fn smooth_step(x: f64) -> f64 {
    x * x * (3.0 - 2.0 * x)
}

/// The file's well, its inclination every metre.
fn path(inputs: &serde_json::Value, amplitude_deg: f64, wavelength_m: f64) -> Path {
    let input = |key: &str| number(&inputs[key]);
    let (from_m, end_m, td_m) = (input("kop_m"), input("eob_m"), input("td_m"));
    let stations: Vec<[f64; 3]> = (0..=td_m as usize)
        .map(|md| {
            let md = md as f64;
            let planned = (input("build_deg_30m") * (md.min(end_m) - from_m).max(0.0) / 30.0)
                .min(input("inc_deg"));
            let taper = smooth_step(((md - from_m) / 60.0).clamp(0.0, 1.0))
                * smooth_step(((td_m - md) / 60.0).clamp(0.0, 1.0));
            let wave = std::f64::consts::TAU * (md - from_m) / wavelength_m;
            let inclination = planned + amplitude_deg * taper * wave.sin();
            // A negative inclination is one on the other side of the vertical.
            if inclination < 0.0 { [md, -inclination, 180.0] } else { [md, inclination, 0.0] }
        })
        .collect();
    common::arcs(&stations)
}

/// Sum of the contact force per newton of tension along the string, rad: the angle of the capstan,
/// less where the string lies on the outside of its curve. A pull at the bit `δT` comes up as `dδT/ds = ±μ (n·κ) δT`, `N = |T κ + w⊥|` and `n` its direction: up with the
/// plus, and down with the minus, for friction takes off the tension there.
fn pressed_rad(model: &Model, operation: &Operation) -> f64 {
    let soft = soft_string(model, operation).expect("a soft string");
    let rows = soft.md_m.windows(2).zip(&soft.contact_direction);
    rows.map(|(md_m, towards)| {
        let curvature_per_m = model.well.path.at(0.5 * (md_m[0] + md_m[1])).curvature_per_m;
        towards.dot(&curvature_per_m) * (md_m[1] - md_m[0])
    })
    .sum()
}

/// Hook load within 300 N or a tenth of the difference between stiff and soft, side force within
/// 1.5 %, the file's tolerances for elements of 1 m; for rotating strings torque and side force
/// within 0.2 %. The file includes friction of the bit, which here is held by its own hole: the
/// friction of its reaction is subtracted. It leaves out that a rotating string climbs: its torque
/// is `√(1 + μ²)` of ours.
#[test]
fn s1d_whole_strings() {
    let data = verification("S1d_long_string_stiff_vs_soft.json");
    let inputs = &data["inputs"];
    let cases = data["cases"].as_array().expect("cases");
    assert_eq!(cases.len(), 9);
    for case in cases {
        let (input, expected) = (|key: &str| number(&case["inputs"][key]), &case["expected"]);
        let td_m = number(&inputs["td_m"]);
        let mu = input("mu");
        let path = path(inputs, input("tortuosity_amplitude_deg"), input("wavelength_m"));
        let collars_m = input("collars_m");
        let mut parts = Vec::new();
        if collars_m > 0.0 {
            parts.push(piece(&inputs["collar"], ComponentLength::Metres(collars_m)));
        }
        parts.push(piece(&inputs["pipe"], ComponentLength::ToSurface));
        let hole = common::open_hole(number(&inputs["hole_m"]), mu, td_m);
        let model = common::model(path, hole, parts, common::mud(0.0), td_m);
        let kind = case["inputs"]["operation"].as_str().expect("a word");
        let mut operation = match kind {
            "pu" => Operation::trip_out(td_m),
            "so" => Operation::trip_in(td_m),
            _ => Operation::rotate_off_bottom(td_m),
        };
        operation.rotary_speed_rad_per_s = 10.0;
        operation.trip_speed_m_per_s = 0.1;
        let found = solve(&model, &operation, &settings(1.0));
        let result = |key: &str| number(&expected[key]);
        // The file's; one of its cases lacks it.
        let bit_N =
            expected["end_reactions_N"].get(1).map_or(found.bit_side_force_N[0], number).abs();
        let rubs_N = match kind {
            "pu" => mu * bit_N * (mu * pressed_rad(&model, &operation)).exp(),
            "so" => -mu * bit_N * (-mu * pressed_rad(&model, &operation)).exp(),
            _ => 0.0,
        };
        let expected_N = result("stiff_hook_N") - rubs_N;
        let hook_N = found.scalars.hook_load_N;
        let difference_N = (result("stiff_hook_N") - result("soft_hook_N")).abs();
        let side_N = found.scalars.side_force_total_N;
        let id = case["id"].as_str().expect("a name").replace('_', " ");
        verify("S1d", format!("hook load {id}, N"))
            .absolute(f64::max(300.0, 0.1 * difference_N), "the file's; the bit's friction apart")
            .report(expected_N, hook_N);
        if kind == "rot" {
            // The bit's reaction has friction there, too.
            let od_m = number(&inputs[if collars_m > 0.0 { "collar" } else { "pipe" }]["od"]);
            let expected_N_m = result("stiff_torque_Nm") - mu * bit_N * 0.5 * od_m;
            let climbs = f64::hypot(1.0, mu);
            let torque_N_m = found.scalars.surface_torque_N_m * climbs;
            let reason = "the file's mesh, 0.5 m; here 1 m";
            verify("S1d", format!("torque times √(1 + μ²) {id}, N·m"))
                .relative(2e-3, reason)
                .report(expected_N_m, torque_N_m);
            verify("S1d", format!("side force times √(1 + μ²) {id}, N"))
                .relative(2e-3, reason)
                .report(result("stiff_sum_side_N") - bit_N, side_N * climbs);
        } else {
            verify("S1d", format!("side force {id}, N"))
                .relative(1.5e-2, "the file's; the bit's friction presses the string, too")
                .report(result("stiff_sum_side_N") - bit_N, side_N);
        }
    }
}

/// E05: a string that turns in a straight hole climbs to `atan μ`, and its torque is
/// `μ r w sin θ/√(1 + μ²)` per metre: exactly, away from the ends.
#[test]
fn a_rotating_string_climbs() {
    const MU: f64 = 0.3;
    const LENGTH_M: f64 = 300.0;
    let model = common::straight_model(60.0, LENGTH_M, 200.0, 0.0635, MU);
    let operation =
        Operation { rotary_speed_rad_per_s: 10.0, ..Operation::rotate_off_bottom(LENGTH_M) };
    let found = solve(&model, &operation, &settings(2.0));
    let middle = crate::nearest(&found, 150.0);
    let climb = found.climb_rad[middle].expect("it touches");
    let reason = "rounding of the wall that gives way";
    verify("E05", "climb of the stiff string at friction 0.3, rad")
        .relative(1e-6, reason)
        .report(MU.atan(), climb.abs());
    let per_m = MU * 0.0635 * 200.0 * 60.0_f64.to_radians().sin() / f64::hypot(1.0, MU);
    verify("E05", "torque of the stiff string at friction 0.3, N·m/m")
        .relative(1e-6, reason)
        .report(per_m, found.friction_torque_N_m_per_m[middle]);
}
