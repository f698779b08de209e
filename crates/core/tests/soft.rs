//! The soft string against closed forms beyond those of `verification/`, its symmetries, its order
//! of convergence and its errors.

mod common;

use common::*;
use nalgebra::{Rotation3, Vector3};
use wholestring::{
    GRAVITY_M_PER_S2,
    model::Model,
    operation::{Operation, OperationKind, OperationKind::*},
    outcome::ModelKind,
    statics::soft::{self, SoftError, SoftProfile, SoftSettings},
    string::{ComponentLength, ComponentSpec, Material, ToolJoints},
    well::{Friction, Hole, HoleSection, Interpolation},
};

fn solve_with(model: &Model, operation: &Operation, step_m: f64) -> SoftProfile {
    let solved = soft::solve(model, operation, &SoftSettings { step_m, ..SoftSettings::default() })
        .expect("a sound model");
    let columns = solved.unlike_declared(ModelKind::Soft);
    assert!(columns.is_empty(), "not as declared: {columns:?}");
    let wear = solved.wear.unlike_declared(ModelKind::Soft);
    assert!(wear.is_empty(), "not as declared: {wear:?}");
    solved
}

fn solve(model: &Model, operation: &Operation) -> SoftProfile {
    solve_with(model, operation, SoftSettings::default().step_m)
}

fn run(model: &Model, kind: OperationKind) -> SoftProfile {
    solve(model, &operation(kind, model.string.length_m()))
}

/// A horizontal turn with weight: `q² = (F/R)² + w²`, so `asinh(F/(wR))` grows by `μ` per radian of
/// turn when pulled and falls by it when pushed. Tolerance: the rounding of 500 steps; the method's
/// own error is 1e-13 here.
#[test]
fn horizontal_turn_has_a_hyperbolic_closed_form() {
    let (weight, radius_m, mu, turn_deg) = (300.0, 400.0, 0.3, 70.0_f64);
    let turn = turn_deg.to_radians();
    let length_m = radius_m * turn;
    let pipe_radius_m = 0.07;
    let stations = [[0.0, 90.0, 20.0], [length_m, 90.0, 20.0 + turn_deg]];
    let model = uniform_model(&stations, weight, pipe_radius_m, mu);
    let scale = weight * radius_m;
    let pulled = run(&model, TripOut);
    let expected = scale * (mu * turn).sinh();
    assert_close("pulled", pulled.scalars.hook_load_N, expected, 1e-11);

    let weight_on_bit_N = 80e3;
    let slide = pressing(Slide, length_m, weight_on_bit_N);
    let pushed = solve(&model, &slide);
    let expected = scale * ((-weight_on_bit_N / scale).asinh() - mu * turn).sinh();
    assert_close("pushed", pushed.scalars.hook_load_N, expected, 1e-11);

    let drill = pressing(Drill, length_m, weight_on_bit_N);
    let rotated = solve(&model, &drill);
    let side_force = weight.hypot(weight_on_bit_N / radius_m);
    let expected = mu * side_force * pipe_radius_m * length_m;
    assert_close("torque", rotated.scalars.surface_torque_N_m, expected, 1e-11);

    // It turns to the right. Tension presses the pipe to the inner (right) and low side,
    // compression to the outer (left) and low side.
    for (profile, side) in [(&pulled, 1.0), (&rotated, -1.0)] {
        let point = model.well.path.at(0.0);
        let (high, right) = (Vector3::new(0.0, 0.0, -1.0), point.right_side().expect("inclined"));
        let direction = profile.contact_direction[0];
        assert!((direction.norm() - 1.0).abs() < 1e-12);
        assert!(direction.dot(&point.tangent).abs() < 1e-12);
        let tension = profile.tension_N[0];
        assert!(direction.dot(&high) < 0.0);
        assert!(direction.dot(&right) * side > 0.1);
        let angle = (tension / radius_m).abs().atan2(weight);
        assert_close("lift", -direction.dot(&high), angle.cos(), 1e-10);
        assert!(profile.side_force_N_per_m[0] < 0.0);
    }
}

/// A weightless string in an arc knows its dogleg and nothing of its orientation: `F e^{±μβ}`.
#[test]
fn capstan_in_any_plane() {
    let (mu, tension_N) = (0.25, 150e3);
    for (top, bottom) in
        [([30.0, 10.0], [75.0, 130.0]), ([85.0, 350.0], [40.0, 20.0]), ([0.0, 0.0], [60.0, 233.0])]
    {
        let model = capstan_model(top, bottom, mu, 0.07, tension_N);
        let stations = model.well.path.stations();
        let dogleg = stations[0].dogleg_rad(&stations[1]);
        let out = run(&model, TripOut).scalars.hook_load_N;
        assert_close("out", out, tension_N * (mu * dogleg).exp(), 1e-10);
        let lower = run(&model, TripIn).scalars.hook_load_N;
        assert_close("in", lower, tension_N * (-mu * dogleg).exp(), 1e-10);
    }
}

/// Rotation at the speed `Ωr` and pulling at `v` slide along a direction that does not change along
/// a string of one radius: a capstan of `μ v/V`, and torque and drag in the ratio `Ωr² : v`, the
/// torque in that of the coefficients around and along besides.
#[test]
fn reaming_in_a_capstan() {
    let (mu, radius_m, tension_N, dogleg) = (0.3, 0.07, 100e3, std::f64::consts::FRAC_PI_2);
    for (kind, sign, ratio) in
        [(BackReam, 1.0, 1.0), (Ream, -1.0, 1.0), (BackReam, 1.0, 0.6), (Ream, -1.0, 1.4)]
    {
        let mut model = capstan_model([90.0, 0.0], [0.0, 0.0], mu, radius_m, tension_N);
        let sections = model.well.hole.sections().iter().map(|section| {
            let friction = Friction { around: ratio, ..section.friction };
            HoleSection { friction, ..*section }
        });
        model.well.hole = Hole::new(sections.collect()).expect("a sound hole");
        let operation = operation(kind, model.string.length_m());
        let around = operation.rotary_speed_rad_per_s * radius_m;
        let along = operation.trip_speed_m_per_s / around.hypot(operation.trip_speed_m_per_s);
        let scalars = solve(&model, &operation).scalars;
        let expected = tension_N * (sign * mu * along * dogleg).exp();
        assert_close("hook load", scalars.hook_load_N, expected, 1e-10);
        assert_close("drag", scalars.axial_friction_N, expected - tension_N, 1e-9);
        let torque =
            scalars.axial_friction_N.abs() * around * radius_m / operation.trip_speed_m_per_s;
        assert_close("torque", scalars.friction_torque_N_m, ratio * torque, 1e-9);
    }
}

/// Kinetic friction of each hole section acts on the pipe in it, and the joints' radius makes the
/// torque: straight holes, sums of `μ w sin i L` by hand.
#[test]
fn hole_sections_and_components_act_where_they_lie() {
    let (inclination, depth_m) = (50.0_f64, 1500.0);
    let (sin, cos) = inclination.to_radians().sin_cos();
    let mut drill_pipe = pipe(250.0, 0.06, ComponentLength::ToSurface);
    drill_pipe.joints = Some(ToolJoints { od_m: 0.18, spacing_m: 9.6 });
    let collars = pipe(1200.0, 0.1, ComponentLength::Metres(200.0));
    let model = model(
        arcs(&[[0.0, inclination, 30.0], [depth_m, inclination, 30.0]]),
        hole_of(&[(0.2, 700.0), (0.35, depth_m)]),
        vec![collars, drill_pipe],
        mud(0.0),
        depth_m,
    );
    let weight = 250.0 * 1300.0 + 1200.0 * 200.0;
    // Casing: 700 m of pipe; open hole: 600 m of pipe and the collars.
    let pipe_drag = (0.2 * 700.0 + 0.35 * 600.0) * 250.0 * sin;
    let collar_drag = 0.35 * 1200.0 * 200.0 * sin;
    let out = run(&model, TripOut).scalars;
    let expected = weight * cos + pipe_drag + collar_drag;
    assert_close("pick-up", out.hook_load_N, expected, 1e-12);
    assert_close("drag", out.axial_friction_N, pipe_drag + collar_drag, 1e-12);
    assert_close("side force", out.side_force_total_N, weight * sin, 1e-12);
    let rotating = run(&model, RotateOffBottom).scalars;
    let expected = pipe_drag * 0.09 + collar_drag * 0.1;
    assert_close("torque", rotating.surface_torque_N_m, expected, 1e-12);
    assert_eq!(rotating.axial_friction_N, 0.0);
}

const BUILD_AND_TURN: [[f64; 3]; 6] = [
    [0.0, 0.0, 0.0],
    [300.0, 0.0, 0.0],
    [700.0, 35.0, 40.0],
    [1000.0, 60.0, 75.0],
    [1400.0, 85.0, 120.0],
    [2500.0, 88.0, 130.0],
];

/// Turning the whole well about the vertical turns the contact directions with it and changes
/// nothing else; mirroring it changes the side of the turn.
#[test]
fn north_is_not_special() {
    let drill = operation(Drill, 2500.0)
        .weight_on_bit_N(60e3)
        .bit_torque_N_m(3e3)
        .rate_of_penetration_m_per_s(10.0 / 3600.0);
    for interpolation in [Interpolation::MinimumCurvature, Interpolation::Spline] {
        let solved = |turn_deg: f64, hand: f64| {
            let survey = BUILD_AND_TURN.map(|[md, inc, azi]| [md, inc, hand * azi + turn_deg]);
            let model = model(
                path(&survey, interpolation),
                hole(0.3, 2500.0),
                vec![pipe(300.0, 0.07, ComponentLength::ToSurface)],
                mud(1200.0),
                2500.0,
            );
            solve(&model, &drill)
        };
        let reference = solved(0.0, 1.0);
        let turned = solved(137.0, 1.0);
        let mirrored = solved(0.0, -1.0);
        let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), 137.0_f64.to_radians());
        for other in [&turned, &mirrored] {
            assert_eq!(reference.md_m.len(), other.md_m.len());
            for (a, b) in [
                (reference.scalars.hook_load_N, other.scalars.hook_load_N),
                (reference.scalars.surface_torque_N_m, other.scalars.surface_torque_N_m),
                (reference.scalars.stretch_m, other.scalars.stretch_m),
                (reference.scalars.twist_rad, other.scalars.twist_rad),
            ] {
                assert_close("scalar", b, a, 1e-11);
            }
        }
        for row in 0..reference.md_m.len() {
            // The direction is that of a load; where the load is near zero it has no digits.
            if reference.side_force_N_per_m[row].abs() < 1.0 {
                continue;
            }
            let expected = reference.contact_direction[row];
            assert!((turned.contact_direction[row] - turn * expected).norm() < 1e-9);
            let mirror = Vector3::new(expected.x, -expected.y, expected.z);
            assert!((mirrored.contact_direction[row] - mirror).norm() < 1e-9);
        }
    }
}

/// On a 3D arc under tension a step of 50 m has the hook load of one of 1 m to 1e-11: steps halve
/// themselves where the load turns. Of steps that do not, the one of 50 m was 1e-5 off.
#[test]
fn long_steps_halve_themselves() {
    let length_m = 600.0;
    let stations = [[0.0, 20.0, 0.0], [length_m, 80.0, 50.0]];
    let model = uniform_model(&stations, 300.0, 0.07, 0.4);
    let hook_load = |step_m: f64| {
        let pull = pressing(Slide, length_m, -300e3);
        solve_with(&model, &pull, step_m).scalars.hook_load_N
    };
    let exact = hook_load(1.0);
    for step_m in [50.0, 25.0, 12.5] {
        assert_close("hook load", hook_load(step_m), exact, 1e-11);
    }
}

/// At the default step every scalar of a 3D well with changes of side is converged to 1e-9: it
/// differs by less than that from a step eight times finer. Before steps ended at the kinks of the
/// path and of the load it was 1e-6.
#[test]
fn default_step_is_converged() {
    for interpolation in [Interpolation::MinimumCurvature, Interpolation::Spline] {
        let model = model(
            path(&BUILD_AND_TURN, interpolation),
            hole(0.3, 2500.0),
            vec![pipe(300.0, 0.07, ComponentLength::ToSurface)],
            mud(1200.0),
            2500.0,
        );
        for kind in OperationKind::ALL {
            let operation = operation(kind, 2500.0)
                .weight_on_bit_N(60e3)
                .bit_torque_N_m(3e3)
                .rate_of_penetration_m_per_s(10.0 / 3600.0);
            let coarse = solve(&model, &operation).scalars;
            let fine = solve_with(&model, &operation, 0.125).scalars;
            assert_close("hook load", coarse.hook_load_N, fine.hook_load_N, 1e-9);
            assert_close("side force", coarse.side_force_total_N, fine.side_force_total_N, 1e-9);
            assert_close("stretch", coarse.stretch_m, fine.stretch_m, 1e-9);
            if kind.rotates() || kind == Slide {
                let torque = fine.surface_torque_N_m;
                assert_close("torque", coarse.surface_torque_N_m, torque, 1e-9);
                assert_close("twist", coarse.twist_rad, fine.twist_rad, 1e-9);
            }
        }
    }
}

/// D09: a pipe that hangs in air and in mud, open-ended. The file prints all digits.
#[test]
fn d09_hanging_stretch() {
    let data = verification("D09_linear_frequencies.json");
    let data = &data["hanging_stretch"];
    let input = |key: &str| data["inputs"][key].as_f64().expect(key);
    let (length_m, modulus) = (input("L"), input("E"));
    let material = Material {
        density_kg_per_m3: input("rho_s"),
        youngs_modulus_Pa: modulus,
        shear_modulus_Pa: modulus / (2.0 * (1.0 + input("nu"))),
        ..Material::STEEL
    };
    let pipe = ComponentSpec::uniform("pipe", 0.14, 0.12, ComponentLength::ToSurface, material);
    for (key, density) in [("vacuum_m", 0.0), ("in_mud_open_ended_m", input("rho_m"))] {
        let model =
            along(&[[0.0, 0.0, 0.0], [length_m, 0.0, 0.0]], 0.3, vec![pipe.clone()], mud(density));
        let expected = data[key].as_f64().expect(key);
        verify("D09", format!("stretch of a hanging pipe in mud of {density} kg/m3, m"))
            .relative(1e-12, "rounding; the file prints all digits")
            .report(expected, run(&model, TripOut).scalars.stretch_m);
    }
}

/// A slanted string with weight on the bit: tension is linear, so stretch and twist are quadratic:
/// `(½ w_a L² − WOB L)/EA − (1−2ν) ρ_m g cos i L²/2E` and `(M_b L + ½ m L²)/GJ`, `m = μ w sin i r`.
#[test]
fn stretch_and_twist_of_a_slanted_string() {
    let (length_m, inclination, mu, radius_m, density) = (1800.0, 40.0_f64, 0.25, 0.07, 1300.0);
    let (sin, cos) = inclination.to_radians().sin_cos();
    let model = along(
        &[[0.0, inclination, 0.0], [length_m, inclination, 0.0]],
        mu,
        vec![pipe(300.0, radius_m, ComponentLength::ToSurface)],
        mud(density),
    );
    let pipe = &model.string.components()[0];
    let weight = pipe.buoyed_weight_per_length_N_per_m(density);
    let (weight_on_bit_N, bit_torque_N_m) = (50e3, 4e3);
    let drill =
        operation(Drill, length_m).weight_on_bit_N(weight_on_bit_N).bit_torque_N_m(bit_torque_N_m);
    let profile = solve(&model, &drill);
    let poisson = 210.0 / 160.0 - 1.0;
    let stretch = |up_m: f64| {
        let pressure_m2 = length_m * up_m - up_m * up_m / 2.0;
        (weight * cos * up_m * up_m / 2.0 - weight_on_bit_N * up_m) / pipe.axial_stiffness_N()
            - (1.0 - 2.0 * poisson) * density * GRAVITY_M_PER_S2 * cos * pressure_m2 / 210e9
    };
    let per_metre = mu * weight * sin * radius_m;
    let twist = |up_m: f64| {
        (bit_torque_N_m * up_m + per_metre * up_m * up_m / 2.0) / pipe.torsional_stiffness_N_m2()
    };
    for row in [0, 100, 700] {
        let up_m = length_m - profile.md_m[row];
        assert_close("stretch", profile.stretch_m[row], stretch(up_m), 1e-11);
        assert_close("twist", profile.twist_rad[row], twist(up_m), 1e-12);
    }
    assert_eq!(profile.scalars.stretch_m, profile.stretch_m[0]);
    assert_eq!(profile.scalars.twist_rad, profile.twist_rad[0]);
    let torque = bit_torque_N_m + per_metre * length_m;
    assert_close("torque", profile.scalars.surface_torque_N_m, torque, 1e-12);
    let friction = profile.scalars.friction_torque_N_m;
    assert_close("friction torque", friction, per_metre * length_m, 1e-11);
}

/// The neutral point of a vertical string is where the weight below it is the weight on bit; a
/// string off bottom has none; a horizontal one that is pushed has none either: all is compressed.
#[test]
fn neutral_point() {
    let model = along(
        &[[0.0, 0.0, 0.0], [2000.0, 0.0, 0.0]],
        0.3,
        vec![
            pipe(1000.0, 0.1, ComponentLength::Metres(100.0)),
            pipe(250.0, 0.07, ComponentLength::ToSurface),
        ],
        mud(0.0),
    );
    let drill = pressing(Drill, 2000.0, 120e3);
    let found = solve(&model, &drill).scalars.neutral_point_m.expect("it passes zero");
    // 100 kN of collars and 80 m of pipe; tension is linear there, so only rounding is left.
    assert!((found - 1820.0).abs() < 1e-6, "{found}");
    assert_eq!(run(&model, RotateOffBottom).scalars.neutral_point_m, None);
    let horizontal = straight_model(90.0, 1000.0, 300.0, 0.07, 0.3);
    let slide = pressing(Slide, 1000.0, 20e3);
    assert_eq!(solve(&horizontal, &slide).scalars.neutral_point_m, None);
}

/// The weighted arc of A01 below a vertical part, surveyed every 10 m, then a frictionless tangent:
/// the cut-off is where the file's pipe changes sides. Its mean over 30 m and half a row move it by
/// less than 0.1 m + 0.5 m.
#[test]
fn cutoff_of_a_surveyed_build() {
    let data = verification("A01_soft_string_closed_forms.json");
    let rows = data["cases"].as_array().expect("cases");
    for (id, kind) in
        [("build_arc_side_switch_pull", TripOut), ("build_arc_side_switch_lower", TripIn)]
    {
        let row = rows.iter().find(|row| row["id"] == id).expect(id);
        let input = |key: &str| row["inputs"][key].as_f64().expect(key);
        let (radius_m, weight, bottom) =
            (input("R_m"), input("w_N_per_m"), input("inc_bottom_deg"));
        let kick_off_m = 300.0;
        let build_m = radius_m * bottom.to_radians();
        let build_end_m = kick_off_m + build_m;
        let tail_m = input("F_bottom_N") / (weight * bottom.to_radians().cos());
        let depth_m = build_end_m + tail_m;
        let mut survey = vec![[0.0, 0.0, 0.0], [kick_off_m, 0.0, 0.0]];
        let count = (build_m / 10.0).floor();
        for index in 1..=count as usize {
            let part = index as f64 / count;
            survey.push([kick_off_m + part * build_m, part * bottom, 0.0]);
        }
        survey.push([depth_m, bottom, 0.0]);
        let model = model(
            arcs(&survey),
            hole_of(&[(input("mu"), build_end_m), (0.0, depth_m)]),
            vec![pipe(weight, 0.07, ComponentLength::ToSurface)],
            mud(0.0),
            depth_m,
        );
        let switch = row["expected"]["switch_inclination_deg"].as_f64().expect("switch");
        let expected = kick_off_m + radius_m * switch.to_radians();
        let found = run(&model, kind).scalars.cutoff_depth_m.expect("the pipe changes sides");
        assert!((found - expected).abs() < 0.6, "{id}: {found} for {expected}");
    }
    // A straight hole has no build, so no cut-off.
    let slant = straight_model(30.0, 1000.0, 300.0, 0.07, 0.3);
    assert_eq!(run(&slant, TripOut).scalars.cutoff_depth_m, None);
}

#[test]
fn profile_runs_from_surface_to_bit_and_adds_up() {
    let model = model(
        path(&BUILD_AND_TURN, Interpolation::Spline),
        hole_of(&[(0.2, 1200.0), (0.3, 2500.0)]),
        vec![pipe(300.0, 0.07, ComponentLength::ToSurface)],
        mud(1200.0),
        2500.0,
    );
    let profile = run(&model, BackReam);
    let scalars = profile.scalars;
    assert_eq!(profile.md_m[0], 0.0);
    assert_eq!(profile.md_m[profile.md_m.len() - 1], 2500.0);
    assert!(profile.md_m.windows(2).all(|pair| pair[0] < pair[1]));
    assert_eq!(profile.tension_at_N(-5.0), scalars.hook_load_N);
    assert_eq!(profile.torque_N_m[0], scalars.surface_torque_N_m);
    assert_eq!(profile.tension_at_N(2500.0), 0.0);
    assert_eq!(profile.tension_at_N(3000.0), 0.0);
    let middle = 0.5 * (profile.md_m[10] + profile.md_m[11]);
    let mean = 0.5 * (profile.tension_N[10] + profile.tension_N[11]);
    assert_close("tension", profile.tension_at_N(middle), mean, 1e-12);
    assert_eq!(profile.contact_direction_at(middle + 0.1), profile.contact_direction[11]);
    assert_eq!(profile.contact_direction_at(middle - 0.1), profile.contact_direction[10]);
    // Sums of the rows are the scalars within the trapezoidal rule's error at a step of 1 m, and
    // half a metre of the jump of friction at the shoe.
    let integral = |value: &dyn Fn(usize) -> f64| -> f64 {
        (1..profile.md_m.len())
            .map(|i| 0.5 * (value(i) + value(i - 1)) * (profile.md_m[i] - profile.md_m[i - 1]))
            .sum()
    };
    let drag = integral(&|i| profile.axial_friction_N_per_m[i]);
    assert_close("drag", drag, scalars.axial_friction_N, 1e-3);
    let torque = integral(&|i| profile.friction_torque_N_m_per_m[i]);
    assert_close("torque", torque, scalars.friction_torque_N_m, 1e-3);
    let side = integral(&|i| profile.side_force_N_per_m[i].abs());
    assert_close("side force", side, scalars.side_force_total_N, 1e-4);
    // Weight along the hole is the buoyed weight times the vertical depth.
    let weight = model.string.components()[0].buoyed_weight_per_length_N_per_m(1200.0);
    let hanging = weight * model.well.path.at(2500.0).position_m.z;
    let expected = hanging + scalars.axial_friction_N;
    assert_close("hook load", scalars.hook_load_N, expected, 1e-9);
}

#[test]
fn bad_input_is_refused() {
    let model = straight_model(30.0, 1000.0, 300.0, 0.07, 0.3);
    let good = operation(Drill, 1000.0);
    type Change = fn(&mut Operation);
    let refused = |change: Change| {
        let mut operation = good;
        change(&mut operation);
        soft::solve(&model, &operation, &SoftSettings::default())
            .map(|profile| profile.scalars)
            .expect_err("a bad set point")
            .to_string()
    };
    let cases: [(Change, &str); 6] = [
        (
            |operation| operation.bit_depth_m = 990.0,
            "the string is 1000.000 m long, but the bit is 990.000 m deep",
        ),
        (
            |operation| operation.bit_depth_m = f64::NAN,
            "the bit depth must be a positive number of metres up to 100 km, got NaN m",
        ),
        (
            |operation| operation.rotary_speed_rad_per_s = 0.0,
            "the rotary speed must be positive (rad/s) where the string rotates, got 0",
        ),
        (
            |operation| operation.weight_on_bit_N = f64::INFINITY,
            "the weight on bit must be a finite number (N), got inf",
        ),
        (
            |operation| operation.bit_torque_N_m = f64::NAN,
            "the bit torque must be a finite number (N·m), got NaN",
        ),
        (
            |operation| operation.rate_of_penetration_m_per_s = f64::NAN,
            "the axial speed must be a finite number (m/s), got NaN",
        ),
    ];
    for (change, expected) in cases {
        assert_eq!(refused(change), expected);
    }
    let curved = uniform_model(&BUILD_AND_TURN, 300.0, 0.07, 0.3);
    let overload = pressing(Drill, 2500.0, 1e300);
    let result = soft::solve(&curved, &overload, &SoftSettings::default());
    assert!(matches!(result, Err(SoftError::NotFinite { .. })));
    for step_m in [0.0, -1.0, f64::NAN, 1e-9, 1e9] {
        let result =
            soft::solve(&model, &good, &SoftSettings { step_m, ..SoftSettings::default() });
        assert!(matches!(result, Err(SoftError::Step(_))), "{step_m}");
    }
}
