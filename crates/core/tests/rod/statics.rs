//! The rod at rest: cantilevers, elastica, beam-columns and Euler's column.

use crate::{
    common::{assert_close, number, relative_error, verification, verify},
    plane::{Plane, order, section},
};

const RIGID: f64 = 1e30;

fn cantilever(axial: f64, bending: f64, shear: f64, length: f64, parts: usize) -> Plane {
    let mut rod = Plane::new(&section(axial, bending, shear), length, parts);
    rod.fix(0, &[0, 1, 2]);
    rod
}

/// `w = PL³/3EI + PL/κGA`, exact at the nodes however coarse the mesh: the element's bending is
/// Timoshenko's solution. Loads of 1e-6 of `EI/L²` bend the rod by so little that its large
/// rotation shows in the twelfth digit.
#[test]
fn a_cantilever_deflects_as_timoshenko_says() {
    let (ei, l) = (1.2e6, 10.0);
    for shear in [RIGID, 1e7, 1e5, 1e4] {
        for parts in [1, 2, 7] {
            let load = 1e-6 * ei / (l * l);
            let mut rod = cantilever(7e8, ei, shear, l, parts);
            rod.load[3 * parts] = load;
            rod.balance(1);
            let expected = load * l.powi(3) / (3.0 * ei) + load * l / shear;
            assert_close("tip", rod.at(parts)[0], expected, 1e-9);
            assert_close("turn", rod.at(parts)[2], load * l * l / (2.0 * ei), 1e-9);
        }
    }
}

/// Errors at 16, 32 and 64 elements: they fall with the square of the element's turn, and their
/// extrapolation is the expected value.
fn converges(
    case: &str,
    what: &str,
    answers: [[f64; 2]; 3],
    exact: [f64; 2],
    size: f64,
    tolerance: f64,
) {
    let error = |a: [f64; 2]| (a[0] - exact[0]).hypot(a[1] - exact[1]) / size;
    let [_, middle, fine] = answers.map(error);
    let limit = [0, 1].map(|i| (4.0 * answers[2][i] - answers[1][i]) / 3.0);
    assert!((order(middle, fine) - 2.0).abs() < 0.05, "{what}: order {}", order(middle, fine));
    for (axis, i) in [("x", 0), ("y", 1)] {
        verify(case, format!("{axis} of the tip over the length at {what}"))
            .absolute(tolerance, "the source's, after extrapolation from 32 and 64 elements")
            .report(exact[i] / size, limit[i] / size);
    }
}

/// D01: a moment bends a cantilever to an arc; `λ = 2` closes the circle. The element takes the
/// sine of an angle for the angle, so the error falls with the square of the turn per element: 16
/// elements (22° each for the circle) miss the tip by 2 % of the length, 64 by 0.2 %. The error
/// after extrapolation is of fourth order, `(2π/32)⁴` of that: 1e-4, the tolerance of the source.
#[test]
fn an_end_moment_bends_a_cantilever_to_a_circle() {
    let data = verification("D01_cantilever_end_moment.json");
    let inputs = &data["inputs"];
    let [l, ei, ea] = ["L_in", "EI_lbf_in2", "EA_lbf"].map(|key| number(&inputs[key]));
    for row in data["expected"].as_array().expect("rows") {
        let moment = number(&row["M"]);
        let answer = |parts: usize| {
            let mut rod = cantilever(ea, ei, RIGID, l, parts);
            // From nearby: on its circle.
            let curvature = moment / ei;
            for node in 0..=parts {
                let s = l * node as f64 / parts as f64;
                rod.moved[3 * node] = (1.0 - (curvature * s).cos()) / curvature;
                rod.moved[3 * node + 1] = (curvature * s).sin() / curvature - s;
                rod.moved[3 * node + 2] = curvature * s;
            }
            rod.load[3 * parts + 2] = moment;
            rod.balance(1);
            let [across, along, _] = rod.at(parts);
            [l + along, across]
        };
        let exact = [number(&row["tip_x"]), number(&row["tip_y"])];
        converges("D01", &format!("λ {}", row["lam"]), [16, 32, 64].map(answer), exact, l, 1e-4);
    }
}

/// D05: Bisshopp and Drucker's cantilever under a tip force that keeps its direction. The tolerance
/// is the source's 1e-4, which takes 16 elements up to `PL²/EI = 1` and 64 at 10, or the
/// extrapolation.
#[test]
fn a_tip_force_bends_a_cantilever_as_the_elastica() {
    let data = verification("D05_elastica_tip_force.json");
    for row in data["table"].as_array().expect("rows") {
        let load = number(&row["PL2_over_EI"]);
        let answer = |parts: usize| {
            let mut rod = cantilever(1e7, 1.0, RIGID, 1.0, parts);
            rod.load[3 * parts] = load;
            rod.balance(20);
            let [across, along, _] = rod.at(parts);
            [1.0 + along, across]
        };
        let exact = [number(&row["x_over_L"]), number(&row["delta_over_L"])];
        converges("D05", &format!("PL²/EI {load}"), [16, 32, 64].map(answer), exact, 1.0, 1e-4);
    }
}

/// D04's small load: a short, deep beam in which shear counts. The deflection has the source's
/// 1e-6. The shortening is of second order, and there the rod is not Simo and Reissner's: its
/// stretch is that of the axis, with the tension along it, where theirs is taken along the normal
/// of the section. With the shear angle `γ = F/κGA` the two shorten differently by
/// `L(γ²/2 − γ F/EA)`, six ten-thousandths here.
#[test]
fn a_deep_cantilever_sags_by_bending_and_shear() {
    let data = verification("D04_shear_deformable_cantilever.json");
    let input = |key: &str| number(&data["inputs"][key]);
    let (l, h, b, e) = (input("L"), input("h"), input("b"), input("E"));
    let g = e / (2.0 * (1.0 + input("nu")));
    let (ea, ei, kga) = (e * b * h, e * b * h.powi(3) / 12.0, input("shear_corr") * g * b * h);
    let force = input("F_small");
    let parts = 32;
    let mut rod = cantilever(ea, ei, kga, l, parts);
    rod.load[3 * parts] = force;
    rod.balance(2);
    let [across, along, _] = rod.at(parts);
    let oracle = &data["expected"]["small"]["oracle"];
    verify("D04", "deflection under the small load, m")
        .relative(1e-6, "the source's")
        .report(number(&oracle[1]), across);
    let shear = force / kga;
    let own = l * (0.5 * shear * shear - shear * force / ea);
    verify("D04", "shortening under the small load with the rod's own shear, m")
        .relative(1e-6, "the source's")
        .report(number(&oracle[0]) + own, -along);
    assert!(own < 7e-4 * number(&oracle[0]));
}

/// Deflection of a pinned beam under a force in its middle and an axial force `T`, over that
/// without axial force: Timoshenko and Gere, *Theory of Elastic Stability* (1961), their (1-17) and
/// (1-43).
fn amplification(tension: f64, ei: f64, l: f64) -> f64 {
    let u = 0.5 * l * (tension.abs() / ei).sqrt();
    if tension > 0.0 { 3.0 * (u - u.tanh()) / u.powi(3) } else { 3.0 * (u.tan() - u) / u.powi(3) }
}

/// The middle of a pinned beam of two elements or more under axial load.
fn beam_column(tension: f64, shear: f64, parts: usize) -> f64 {
    let mut rod = Plane::new(&section(1e8, 1.0, shear), 1.0, parts);
    rod.fix(0, &[0, 1]);
    rod.fix(parts, &[0]);
    rod.load[3 * parts + 1] = tension;
    rod.balance(1);
    rod.load[3 * (parts / 2)] = 1e-6;
    rod.balance(1);
    rod.at(parts / 2)[0]
}

/// The stiffness by axial force is that of a cubic deflection: fourth order, until the bending
/// length `√(EI/T)` is longer than an element. Each tolerance is twice the error measured at 16
/// elements.
#[test]
fn axial_load_stiffens_and_softens_a_beam() {
    let euler = std::f64::consts::PI.powi(2);
    for (part, tolerance) in
        [(-0.8, 1.5e-5), (-0.5, 2.5e-6), (0.5, 6e-7), (5.0, 2e-5), (50.0, 5e-4)]
    {
        let tension = part * euler;
        let exact = 1e-6 / 48.0 * amplification(tension, 1.0, 1.0);
        let error = |parts| relative_error(beam_column(tension, RIGID, parts), exact);
        let [coarse, middle, fine] = [4, 8, 16].map(error);
        assert!(fine < tolerance, "{part}: {fine:e}");
        if part < 10.0 {
            assert!((order(coarse, middle) - 4.0).abs() < 0.4, "{}", order(coarse, middle));
        }
    }
}

/// Load at which a pinned column of `parts` elements loses its stiffness.
fn buckling_load(shear: f64, parts: usize) -> f64 {
    const AXIAL: f64 = 1e8;
    let (mut low, mut high) = (1.0, 20.0);
    for _ in 0..40 {
        let load = 0.5 * (low + high);
        let mut rod = Plane::new(&section(AXIAL, 1.0, shear), 1.0, parts);
        rod.fix(0, &[0, 1]);
        rod.fix(parts, &[0]);
        for node in 0..=parts {
            rod.moved[3 * node + 1] = -load / AXIAL * node as f64 / parts as f64;
        }
        if rod.min_stiffness() > 0.0 {
            low = load;
        } else {
            high = load;
        }
    }
    0.5 * (low + high)
}

/// Euler's load `π²EI/L²`, from above and with the fourth order of the cubic deflection. The column
/// is shortened by 1e-7 when it buckles, which bounds the comparison from below.
#[test]
fn a_column_buckles_at_eulers_load() {
    let euler = std::f64::consts::PI.powi(2);
    let error = |parts| buckling_load(RIGID, parts) / euler - 1.0;
    let [one, coarse, middle, fine] = [1, 2, 4, 8].map(error);
    assert!((order(coarse, middle) - 4.0).abs() < 0.2, "{}", order(coarse, middle));
    assert!(fine > 0.0 && fine < 5e-5);
    // One cubic over half a sine buckles at 12 EI/L².
    assert_close("one element", 1.0 + one, 12.0 / euler, 1e-6);
}

/// A column soft in shear buckles at Engesser's load `P_E/(1 + P_E/κGA)`: the tension pulls along
/// the axis, so its shear is that of the whole slope. (Haringx, with the tension along the
/// section's normal, is 0.8 % higher here.) Pipe has `P_E/κGA` below 1e-4, where the two agree.
#[test]
fn a_column_soft_in_shear_buckles_at_engessers_load() {
    let euler = std::f64::consts::PI.powi(2);
    let shear = 10.0 * euler;
    let engesser = euler / (1.0 + euler / shear);
    let [middle, fine] = [4, 8].map(|parts| buckling_load(shear, parts) / engesser - 1.0);
    // Second order: the element's share of the shear does not know of the tension. 3e-4 of fourth
    // order left.
    assert!((order(middle, fine) - 2.0).abs() < 0.15, "{}", order(middle, fine));
    assert!(((4.0 * fine - middle) / 3.0).abs() < 3e-4);
}
