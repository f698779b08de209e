//! A turning pipe climbs the wall.

use wholestring::{dynamics::DynamicOutcome, dynamics::MeshSettings, operation::OperationKind};

use crate::{
    common::{operation, verification, verify},
    wells::{Case, STRAIGHT_DEG, each, line, mud, straight},
};

const LENGTH_M: f64 = 300.0;

/// Left out at either end, m. The top is clamped on the hole's axis and the bit held to it: between
/// axis and wall the pipe spans `(72 EI c/(w sin i))^¼` = 12 m (a clamped beam laid on a floor `c`
/// below, `c` the clearance), and the bending that it takes to the wall dies out over as much
/// again.
const END_M: f64 = 30.0;

/// Results of the run away from the ends: contact force per metre, slope of torque with depth, mean
/// angle of the contact.
fn middle(outcome: &DynamicOutcome) -> [f64; 3] {
    let nodes = &outcome.nodes;
    let inside: Vec<usize> = (0..nodes.md_m.len())
        .filter(|i| (END_M..LENGTH_M - END_M).contains(&nodes.md_m[*i]))
        .collect();
    let mean = |value: &dyn Fn(usize) -> f64| {
        inside.iter().map(|i| value(*i)).sum::<f64>() / inside.len() as f64
    };
    let spacing = nodes.md_m[inside[1]] - nodes.md_m[inside[0]];
    let force = mean(&|i| nodes.contact_force_N[i]) / spacing;
    let climb = mean(&|i| nodes.climb_rad[i].expect("the pipe lies on the wall"));
    let md: Vec<f64> = inside.iter().map(|i| nodes.md_m[*i]).collect();
    let torque: Vec<f64> = inside.iter().map(|i| nodes.torque_N_m[*i]).collect();
    [force, -line(&md, &torque).0, climb]
}

/// E05: a plain pipe that turns clockwise in a straight inclined hole climbs to `atan μ` on the
/// right of the low side; there it is pressed with `w sin i cos ψ` and rubs `r w sin i sin ψ` per
/// metre.
///
/// Expected values: the rows of the file, the balance of a rigid cylinder in a trough, exact
/// wherever the pipe is straight. The file requires 1 %; the tolerance here is 2e-4. Found: less
/// than 8e-5 for both element lengths, which is the remainder of the pipe's slow rolling after ten
/// seconds; the steady state itself depends on neither element length nor step.
#[test]
fn a_turning_pipe_climbs_to_the_angle_of_friction() {
    let data = verification("E05_rotating_pipe_climb_angle.json");
    let rows = data["rows"].as_array().expect("rows");
    assert_eq!(rows.len(), 4);
    let cases: Vec<_> =
        rows.iter().flat_map(|row| [3.2, 1.6].map(|length| (row, length))).collect();
    let found = each(&cases, |(row, element_length_m)| {
        let mu = row["mu"].as_f64().expect("mu");
        let model = straight(LENGTH_M, mu);
        let mut case = Case::new(model, operation(OperationKind::RotateOffBottom, LENGTH_M));
        case.settings.mesh = MeshSettings::uniform(*element_length_m);
        middle(&case.run())
    });
    let pipe = &straight(LENGTH_M, 0.0).string.components()[0].clone();
    let across = pipe.buoyed_weight_per_length_N_per_m(mud().density_kg_per_m3)
        * STRAIGHT_DEG.to_radians().sin();
    for ((row, element), [force, torque, climb]) in cases.iter().zip(found) {
        let number = |key: &str| row[key].as_f64().expect(key);
        let mu = number("mu");
        let expected = [
            number("N_over_w_sin_i") * across,
            number("torque_over_r_w_sin_i") * across * pipe.contact_radius_m(),
            number("offset_angle_deg").to_radians(),
        ];
        let what = [("side force", "N/m"), ("torque per metre", "N"), ("climb", "rad")];
        for (((what, unit), computed), expected) in
            what.iter().zip([force, torque, climb]).zip(expected)
        {
            verify("E05", format!("{what} at friction {mu} with elements of {element} m, {unit}"))
                .relative(2e-4, "remainder of the slow rolling after ten seconds")
                .report(expected, computed);
        }
    }
}
