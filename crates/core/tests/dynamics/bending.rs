//! Bending of a string in a curved hole.

use wholestring::{
    dynamics::{ContactClass, MeshSettings},
    operation::OperationKind,
    outcome::Profile,
    string::{ComponentLength, ComponentSpec, StringSpec, ToolJoints},
};

use crate::{
    common::{CAPSTAN_ARC_M, assert_close, capstan_model, operation, pipe},
    wells::Case,
};

const TENSION_N: f64 = 2e5;
const RADIUS_M: f64 = 0.06;
const BUILD_DEG: f64 = 40.0;

/// A weightless pipe without joints under tension in an arc touches its inside all along and bends
/// as the hole does, less its own distance from the hole's axis, though its wall acts at nodes 3.2
/// m apart.
///
/// The rest, below 0.4 %, is due to its penetration into the wall, 0.05 mm. Left out are 30 m at
/// the ends of the arc, where the curvature jumps: `e^(−30 m √(T/EI))` is 6e-6.
#[test]
fn a_plain_pipe_in_an_arc_bends_as_the_hole_does() {
    let model = capstan_model([0.0, 0.0], [BUILD_DEG, 0.0], 0.0, RADIUS_M, TENSION_N);
    let depth_m = model.string.length_m();
    let mut case = Case::new(model, operation(OperationKind::RotateOffBottom, depth_m));
    // Elements of the automatic mesh carry the jump of the curvature further into the arc than 30
    // m.
    case.settings.mesh = MeshSettings::uniform(3.2);
    case.lasts(6.0, 2.0);
    let nodes = case.run().nodes;

    let body = pipe(300.0, RADIUS_M, ComponentLength::ToSurface);
    let (od, id) = (body.od_m, body.id_m);
    let area = std::f64::consts::FRAC_PI_4 * (od * od - id * id);
    let second_moment = std::f64::consts::PI / 64.0 * (od.powi(4) - id.powi(4));
    let stiffness = body.material.youngs_modulus_Pa * second_moment;
    // The pipe is 90 mm inside the hole's axis.
    let radius_m = CAPSTAN_ARC_M / BUILD_DEG.to_radians() - (0.15 - RADIUS_M);
    let moment = stiffness / radius_m;
    let bending_stress = moment * od / (2.0 * second_moment);
    let mut seen = 0;
    for (i, md_m) in nodes.md_m.iter().enumerate() {
        if !(30.0..CAPSTAN_ARC_M - 30.0).contains(md_m) {
            continue;
        }
        seen += 1;
        let close = |what: &str, found: f64, expected: f64| {
            assert_close(&format!("{what} at {md_m} m"), found, expected, 4e-3);
        };
        close("moment", nodes.bending_moment_N_m[i], moment);
        close("moment between the nodes", nodes.bending_moment_between_N_m[i], moment);
        assert_eq!(nodes.body_contact_fraction[i], 1.0, "at {md_m} m");
        close("median", nodes.bending_moment_p50_N_m[i], moment);
        close("bending stress", nodes.bending_stress_Pa[i], bending_stress);
        let stress = TENSION_N / area + bending_stress;
        close("stress", nodes.von_mises_stress_Pa[i], stress);
        // It includes the remaining oscillation of the start.
        assert!(nodes.von_mises_stress_max_Pa[i] >= nodes.von_mises_stress_Pa[i]);
        // As dense as the mud, the pipe hangs in it as if there were none: its metal feels the
        // pressure.
        let path = &case.model.well.path;
        let column = case.model.mud_column();
        let tvd_m = path.at(*md_m).position_m.z;
        let pressure = column.annulus.hydrostatic_pressure_Pa(*md_m, tvd_m);
        let pressed = TENSION_N - pressure * area;
        let error = (nodes.true_tension_N[i] - pressed).abs();
        assert!(error < 2e-3 * TENSION_N, "true tension {error} N off at {md_m} m");
        assert_eq!(ContactClass::of(nodes.contact_fraction[i]), ContactClass::Continuous);
        assert!(nodes.side_force_N_per_m[i] > 0.0, "on the high side");
        // Nothing but the tension in its curve presses it there, the signed force's median as its
        // mean.
        let [p05, p50, p95] = [
            nodes.side_force_p05_N_per_m[i],
            nodes.side_force_p50_N_per_m[i],
            nodes.side_force_p95_N_per_m[i],
        ];
        close("side force", nodes.side_force_N_per_m[i], TENSION_N / radius_m);
        close("its median", p50, TENSION_N / radius_m);
        assert!(p05 <= p50 && p50 <= p95);
        assert!(nodes.whirl_coherence[i] < 0.5, "it does not whirl");
    }
    assert!(seen > 100, "{seen} nodes");
}

const SPACING_M: f64 = 9.6;

/// The same pipe with tool joints of 15 mm standoff. Its body hangs between them and bends more
/// than the hole at them, by `x/tanh x`, `x = (l/2)√(T/EI)`, and less half-way, by `x/sinh x` (A.
/// Lubinski, *Maximum Permissible Dog-Legs in Rotary Boreholes*, J. Petroleum Technology, February
/// 1961): twice and 0.58 of it here. Elements from joint to joint reproduce this as eight a joint
/// do, which have nodes half-way and a moment of their own there.
///
/// One element reproduces all of it to 5e-4, the error of the joints' penetration into the wall,
/// the joint's force too. Eight have it to 0.3 %, a moment half-way to 0.6 %: from the remaining
/// oscillation of the start. 1 % is held. Left out are the joints next to the ends of the arc.
#[test]
fn one_element_between_joints_bends_as_eight_do() {
    let light = pipe(300.0, RADIUS_M, ComponentLength::ToSurface);
    let mut model = capstan_model([0.0, 0.0], [BUILD_DEG, 0.0], 0.0, RADIUS_M, TENSION_N);
    let depth_m = model.string.length_m();
    let joints = ToolJoints { od_m: 2.0 * RADIUS_M + 0.03, spacing_m: SPACING_M };
    let tail = ComponentSpec {
        material: model.string.components()[0].material,
        mass_per_length_kg_per_m: model.string.components()[0].mass_per_length_kg_per_m,
        ..pipe(300.0, RADIUS_M, ComponentLength::Metres(depth_m - CAPSTAN_ARC_M))
    };
    let jointed = ComponentSpec { joints: Some(joints), ..light.clone() };
    let components = vec![tail, jointed];
    model.string = StringSpec { components }.assemble(depth_m).expect("a sound string");

    let stiffness = model.string.components()[1].bending_stiffness_N_m2();
    let hole_per_m = 1.0 / (CAPSTAN_ARC_M / BUILD_DEG.to_radians() - (0.15 - 0.5 * joints.od_m));
    let x = 0.5 * SPACING_M * (TENSION_N / stiffness).sqrt();
    let load_N_per_m = TENSION_N * hole_per_m;
    let at_joint_N_m = stiffness * hole_per_m * x / x.tanh();
    let half_way_N_m = stiffness * hole_per_m * x / x.sinh();
    let half_m = 0.5 * SPACING_M;
    let sag_m = load_N_per_m / TENSION_N * half_m * (0.5 * half_m - half_m / x * (0.5 * x).tanh());

    for elements in [1, 8] {
        let mut case = Case::new(model.clone(), operation(OperationKind::RotateOffBottom, depth_m));
        case.settings.mesh = MeshSettings::uniform(SPACING_M / f64::from(elements));
        case.lasts(6.0, 2.0);
        let nodes: Profile = case.run().nodes;
        // The nodes of the joints, selected by their contact force.
        let joints: Vec<usize> = (0..nodes.md_m.len())
            .filter(|i| (50.0..CAPSTAN_ARC_M - 60.0).contains(&nodes.md_m[*i]))
            .filter(|i| nodes.contact_fraction[*i] > 0.5)
            .collect();
        assert!(joints.len() > 38, "{} joints", joints.len());
        for joint in joints {
            let md_m = nodes.md_m[joint];
            let close = |what: &str, found: f64, expected: f64| {
                assert_close(&format!("{elements}: {what} at {md_m} m"), found, expected, 1e-2);
            };
            close("at the joint", nodes.bending_moment_N_m[joint], at_joint_N_m);
            close("force", nodes.contact_force_N[joint], load_N_per_m * SPACING_M);
            let half_way = if elements == 1 {
                close("sag", nodes.sag_m[joint], sag_m);
                assert_eq!(nodes.body_contact_fraction[joint], 0.0);
                nodes.bending_moment_between_N_m[joint]
            } else {
                nodes.bending_moment_N_m[joint + 4]
            };
            close("half-way", half_way, half_way_N_m);
        }
    }
}
