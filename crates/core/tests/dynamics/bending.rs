//! What a string bears that a curved hole bends.

use wholestring::{
    dynamics::{ContactClass, MeshSettings},
    operation::OperationKind,
    string::ComponentLength,
};

use crate::{
    common::{CAPSTAN_ARC_M, assert_close, capstan_model, operation, pipe},
    wells::Case,
};

const TENSION_N: f64 = 2e5;
const RADIUS_M: f64 = 0.06;
const BUILD_DEG: f64 = 40.0;

/// A weightless pipe under tension in an arc lies against its inside at every node and bends more
/// there than the hole: by `x/tanh x`, `x = (l/2)√(T/EI)`, with `l` from one support to the next
/// (A. Lubinski, *Maximum Permissible Dog-Legs in Rotary Boreholes*, J. Petroleum Technology,
/// February 1961, for tool joints).
///
/// Here `x` is 0.64 and the factor 1.132. An element has it to the second order, `1 + x²/3`: 0.32 %
/// more, the tolerance is 0.4 %. Left out are 30 m at the ends of the arc, where the curvature
/// jumps: `e^(−30 m √(T/EI))` is 6e-6.
#[test]
fn a_pipe_in_an_arc_bends_most_where_it_is_held() {
    let model = capstan_model([0.0, 0.0], [BUILD_DEG, 0.0], 0.0, RADIUS_M, TENSION_N);
    let depth_m = model.string.length_m();
    let mut case = Case::new(model, operation(OperationKind::RotateOffBottom, depth_m));
    case.settings.mesh = MeshSettings::uniform(3.2);
    case.lasts(6.0, 2.0);
    let mesh_m = case.start().mesh().elements[20].length_m;
    let nodes = case.run().nodes;

    let body = pipe(300.0, RADIUS_M, ComponentLength::ToSurface);
    let (od, id) = (body.od_m, body.id_m);
    let area = std::f64::consts::FRAC_PI_4 * (od * od - id * id);
    let second_moment = std::f64::consts::PI / 64.0 * (od.powi(4) - id.powi(4));
    let stiffness = body.material.youngs_modulus_Pa * second_moment;
    // The pipe lies 90 mm inside the hole's axis.
    let radius_m = CAPSTAN_ARC_M / BUILD_DEG.to_radians() - (0.15 - RADIUS_M);
    let x = 0.5 * mesh_m * (TENSION_N / stiffness).sqrt();
    let moment = stiffness / radius_m * x / x.tanh();
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
        close("median", nodes.bending_moment_p50_N_m[i], moment);
        close("bending stress", nodes.bending_stress_Pa[i], bending_stress);
        let stress = TENSION_N / area + bending_stress;
        close("stress", nodes.von_mises_stress_Pa[i], stress);
        // What is left of the start's swinging is in it.
        assert!(nodes.von_mises_stress_max_Pa[i] >= nodes.von_mises_stress_Pa[i]);
        // As dense as the mud, the pipe hangs in it as if there were none: its metal feels the
        // pressure.
        let path = &case.model.well.path;
        let pressure = case.model.mud_column().pressure_Pa(path.at(*md_m).position_m.z);
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
