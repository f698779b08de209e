//! S1a: a string of twelve joints in a build.

use wholestring::{
    ends::TopEnd,
    string::{ComponentLength, ComponentSpec, ToolJoints},
};

use crate::{
    common,
    common::{number, report_worst, verification, verify},
    force_N, nearest, piece, pressed, settings, solve,
};

/// Forces and curvatures at the joints, with tension and nearly without. Elements of 0.6 m against an
/// exact solution of every span: within 0.5 % of the largest force and 0.5 % of the largest curvature,
/// where the file allows 1 %; shear, which it leaves out, is most of that.
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
