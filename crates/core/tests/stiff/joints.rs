//! S1a and C05: strings of joints in a build.

use wholestring::{ends::TopEnd, prelude::*, string::ToolJoints};

use crate::{
    common,
    common::{number, report_worst, verification, verify},
    force_N, nearest, piece, pressed, settings, solve,
};

/// Forces and curvatures at the joints, with tension and nearly without. Elements of 0.6 m against
/// an exact solution of every span: within 0.5 % of the largest force and 0.5 % of the largest
/// curvature, where the file allows 1 %; shear, which it leaves out, is most of that.
#[test]
fn s1a_twelve_joints_in_a_build() {
    let data = verification("S1a_tool_joints_in_build.json");
    let inputs = &data["inputs"];
    let pieces = data["finite"].as_array().expect("rows");
    assert_eq!(pieces.len(), 2);
    for row in pieces {
        let (input, expected) = (|key: &str| number(&row["inputs"][key]), &row["expected"]);
        let length_m = input("length_m");
        let (rate, top_deg) = (input("dls_deg_30m") / 30.0, input("inc_top_deg"));
        let path = common::arcs(&[[0.0, top_deg, 0.0], [length_m, top_deg + rate * length_m, 0.0]]);
        let hole = common::open_hole(number(&inputs["hole_m"]), 0.0, length_m);
        let joints = ToolJoints {
            od_m: number(&inputs["tool_joint_od_m"]),
            spacing_m: input("joint_spacing_m"),
        };
        let first_m = input("first_joint_at_m");
        let parts = vec![
            piece(&inputs["pipe"], ComponentLength::Metres(first_m)),
            ComponentSpec {
                joints: Some(joints),
                ..piece(&inputs["pipe"], ComponentLength::ToSurface)
            },
        ];
        let mut model = common::model(path, hole, parts, common::mud(0.0), length_m);
        model.ends.top = TopEnd::Pinned;
        // Without friction the tension grows upwards by the weight along the hole.
        let free = solve(&model, &pressed(length_m, 0.0), &settings(0.6));
        let pull_N = input("T_top_N") - free.scalars.hook_load_N;
        let found = solve(&model, &pressed(length_m, -pull_N), &settings(0.6));
        let joints = expected["tool_joints"].as_array().expect("joints");
        let largest =
            |key: &str| joints.iter().map(|joint| number(&joint[key]).abs()).fold(0.0, f64::max);
        let largest_N = largest("force_on_wall_N_pos_high");
        let largest_per_m = largest("curvature_rad_m");
        let mut rows = Vec::new();
        let tension_kN = input("T_top_N") / 1e3;
        for joint in joints {
            let at_m = number(&joint["s_m"]);
            let node = nearest(&found, at_m);
            let row = |what: &str, key: &str, found: f64, largest: f64| {
                verify(
                    "S1a",
                    format!("{what} of the stiff joint at {at_m:.1} m and {tension_kN} kN"),
                )
                .absolute(5e-3, "elements of 0.6 m, and shear, which the file leaves out")
                .row(number(&joint[key]) / largest, found / largest)
            };
            let per_m = found.bending_moment_N_m[node] / number(&inputs["pipe"]["EI"]);
            rows.push(row(
                "force over the largest",
                "force_on_wall_N_pos_high",
                force_N(&found, node),
                largest_N,
            ));
            rows.push(row("curvature over the largest", "curvature_rad_m", per_m, largest_per_m));
        }
        report_worst(rows);
    }
}

/// C05: a weightless pipe that a pull on its bit draws into an arc bends at its joints by
/// `Kl/tanh Kl` of the arc, `K² = T/EI`, between them by `Kl/sinh Kl`, and presses the wall with
/// each by `2 T tan(κl)` or so. In the middle of fourteen joints, eight elements between two,
/// against no shear: 1 %, the file's.
#[test]
fn c05_joints_under_a_pull() {
    const JOINTS: f64 = 14.0;
    let data = verification("C05_stiff_string_contact.json");
    for row in data["tool_joint_curved_hole"]["rows"].as_array().expect("rows") {
        let (input, expected) = (|key: &str| number(&row["inputs"][key]), &row["expected"]);
        let spacing_m = 2.0 * input("half_joint_m");
        let length_m = JOINTS * spacing_m;
        let (pull_N, rate) = (input("T_N"), input("dls_deg_30m") / 30.0);
        let (od_m, id_m) = (0.127_f64, 0.1086_f64);
        let second_moment = std::f64::consts::PI / 64.0 * (od_m.powi(4) - id_m.powi(4));
        let steel = Material {
            youngs_modulus_Pa: input("EI") / second_moment,
            // Shear is negligible.
            shear_modulus_Pa: input("EI") / second_moment,
            ..common::steel()
        };
        let pipe = ComponentSpec {
            mass_per_length_kg_per_m: 1e-4,
            joints: Some(ToolJoints { od_m: 0.3, spacing_m }),
            ..ComponentSpec::uniform("pipe", od_m, id_m, ComponentLength::ToSurface, steel)
        };
        let path = common::arcs(&[[0.0, 5.0, 0.0], [length_m, 5.0 + rate * length_m, 0.0]]);
        let hole = common::open_hole(0.35, 0.0, length_m);
        let model = common::model(path, hole, vec![pipe], common::mud(0.0), length_m);
        let operation = Operation::trip_out(length_m).bit_pull_N(pull_N);
        let found = solve(&model, &operation, &settings(spacing_m / 8.0));
        let joint = nearest(&found, 0.5 * JOINTS * spacing_m);
        assert!(found.contact_force_N[joint] > 0.0);
        let (rate, tension_kN) = (input("dls_deg_30m"), pull_N / 1e3);
        let row = |what: &str, unit: &str, key: &str, found: f64| {
            verify("C05", format!("{what} at {rate} deg/30 m and {tension_kN} kN, {unit}"))
                .relative(1e-2, "the file's")
                .row(number(&expected[key]), found)
        };
        let per_m = found.bending_moment_N_m[joint] / input("EI");
        let middle_per_m = found.bending_moment_N_m[joint + 4] / input("EI");
        report_worst([
            row("curvature at a joint", "1/m", "curvature_TJ_rad_m", per_m),
            row("curvature between joints", "1/m", "mid_curvature_rad_m", middle_per_m),
            row("force of a joint", "N", "TJ_side_force_N", found.contact_force_N[joint]),
        ]);
    }
}
