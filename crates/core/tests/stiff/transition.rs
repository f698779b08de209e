//! S1c: from a build to a hold the pipe crosses its hole.

use wholestring::string::ComponentLength;

use crate::{
    common,
    common::{number, report_worst, verification, verify},
    nearest, piece, pressed, settings, solve,
};

/// Depths at which the pipe leaves the high side and touches the low side, and its offset in
/// between, by elements of 0.25 m against collocated solutions with free boundaries: within the
/// file's 0.15 m and an element, and 2e-4 m, half of which the line between two nodes makes.
#[test]
fn s1c_from_a_build_to_a_hold() {
    const ELEMENT_M: f64 = 0.25;
    let data = verification("S1c_build_hold_transition.json");
    for case in data["cases"].as_array().expect("cases") {
        let input = |key: &str| number(&case["inputs"][key]);
        let expected = &case["expected"];
        let (end_m, td_m) = (input("eob_m"), input("td_m"));
        let inclination = input("inc_deg");
        let path = common::arcs(&[
            [0.0, 0.0, 0.0],
            [input("kop_m"), 0.0, 0.0],
            [end_m, inclination, 0.0],
            [td_m, inclination, 0.0],
        ]);
        let pipe = serde_json::json!({
            "od": input("pipe_od_m"), "id": input("pipe_id_m"), "w": input("w_N_per_m"),
            "E": 210e9, "G": 210e9 / 2.6,
        });
        let model = common::model(
            path,
            common::open_hole(input("hole_m"), 0.0, td_m),
            vec![piece(&pipe, ComponentLength::ToSurface)],
            common::mud(0.0),
            td_m,
        );
        let found = solve(&model, &pressed(td_m, -input("T_at_td_N")), &settings(ELEMENT_M));
        let lifts_m = number(&expected["lift_off_high_side_md_m"]);
        let lands_m = number(&expected["touch_down_low_side_md_m"]);
        let touches = |index: &usize| found.contact_force_N[*index] > 0.0;
        let middle = nearest(&found, 0.5 * (lifts_m + lands_m));
        assert!(!touches(&middle));
        let above = (0..middle).rev().find(touches).expect("the high side");
        let below = (middle..found.md_m.len()).find(touches).expect("the low side");
        let id = case["id"].as_str().expect("a name").replace('_', " ");
        let mut rows = vec![
            (format!("where it leaves the high side {id}, m"), lifts_m, found.md_m[above]),
            (format!("where it lies down {id}, m"), lands_m, found.md_m[below]),
        ]
        .into_iter()
        .map(|(what, expected_m, found_m)| {
            verify("S1c", what)
                .absolute(ELEMENT_M + 0.15, "an element, and the file's own")
                .row(expected_m, found_m)
        })
        .collect::<Vec<_>>();
        for (md_m, offset_m) in expected["offset_y_m"].as_object().expect("offsets") {
            let md_m: f64 = md_m.parse().expect("a depth");
            let lower = found.md_m.partition_point(|at| *at < md_m);
            let part = (md_m - found.md_m[lower - 1]) / (found.md_m[lower] - found.md_m[lower - 1]);
            let at = |index: usize| found.lateral_offset_m[index];
            let y_m = at(lower - 1) + part * (at(lower) - at(lower - 1));
            let expected_m = number(offset_m).abs();
            // The distance from the axis is known without its sign, which changes between nodes.
            if expected_m > 5e-3 {
                rows.push(
                    verify("S1c", format!("offset at {md_m:.1} m {id}, m"))
                        .absolute(2e-4, "the file's: small slopes")
                        .row(expected_m, y_m),
                );
            }
        }
        report_worst(rows);
    }
}
