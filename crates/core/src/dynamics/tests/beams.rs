//! Lateral frequencies of pinned and clamped beams, with and without axial force.

use wholestring_verification::verify;

use super::bench::{Bench, PIPE_M, STEEL, Support};
use crate::{
    common::verification,
    dynamics::kernel::chain::node,
    rod::{element::Stiffness, section::Section},
    simd::vector::Vector,
};

/// A beam that does not shear, as the closed forms have it.
pub fn beam(length_m: f64, parts: usize) -> Bench {
    let mut rod = Bench::new(&[(PIPE_M, length_m)], length_m / parts as f64, 0.0);
    assert_eq!(rod.chain.elements(), parts);
    for i in 0..parts {
        let section = Section { shear_stiffness_N: 1e30, ..rod.mesh.elements[i].section };
        rod.chain.set_stiffness(i, &Stiffness::new(&section, rod.mesh.elements[i].length_m));
    }
    // The step was planned for a beam that shears and is the softer for it.
    rod.input.dt *= 0.5;
    rod
}

/// Swings `rod` in the shape `mode` (deflection and slope, by z) and gives the frequency over so
/// many periods.
pub fn swing(rod: &mut Bench, periods: usize, mode: impl Fn(f64) -> (f64, f64)) -> f64 {
    // Small: 1e-6 m/s, so that the deflection does not stretch the rod.
    for i in 0..rod.chain.nodes() {
        let (shape, slope) = mode(rod.z_m(i));
        let free = |inverse: f64| if inverse > 0.0 { 1e-6 } else { 0.0 };
        let v = free(node!(rod.chain, i, inv_mass_lateral)) * shape;
        let w = free(node!(rod.chain, i, inv_rotary)) * slope;
        rod.chain.set_velocity(i, Vector(v, 0.0, 0.0));
        rod.chain.set_turning(i, Vector(0.0, w, 0.0));
    }
    let weights: Vec<f64> = (0..rod.chain.nodes())
        .map(|i| node!(rod.chain, i, mass_lateral) * mode(rod.z_m(i)).0)
        .collect();
    rod.frequency_Hz(periods, |rod| {
        let each = weights.iter().enumerate();
        each.map(|(i, weight)| weight * rod.chain.displacement(i).0).sum()
    })
}

fn pinned(axial_N: f64, mode: usize, parts: usize) -> f64 {
    let length = 30.0;
    let mut rod = beam(length, parts);
    rod.support(0, Support::PINNED);
    rod.support(parts, Support::ROLLER);
    rod.chain.set_weight(parts, Vector(0.0, 0.0, axial_N));
    let strain = axial_N / rod.mesh.elements[0].section.axial_stiffness_N;
    for i in 0..=parts {
        rod.chain.set_displacement(i, Vector(0.0, 0.0, strain * rod.z_m(i)));
    }
    let k = mode as f64 * std::f64::consts::PI / length;
    swing(&mut rod, 2, |z| ((k * z).sin(), k * (k * z).cos()))
}

/// D09: five modes of a pinned pipe, free of axial force, under tension and at half its buckling
/// load. Its tolerance is 0.1 % with 60 elements. Its closed form has no rotary inertia, the rod
/// has: a factor `1/√(1 + I k²/A)`. Nor does it include the stretch `ε` of the pipe by tension,
/// 1.4e-4, which divides the bending part of `f²` by `(1 + ε)²` and the tension part by `1 + ε`.
/// The mesh's error is that of its rotary inertia, `−(kh)²/78`.
#[test]
fn a_pinned_pipe_has_its_frequencies() {
    let data = verification("D09_linear_frequencies.json");
    let gyration2 = (PIPE_M[0].powi(2) + PIPE_M[1].powi(2)) / 16.0;
    let area = std::f64::consts::FRAC_PI_4 * (PIPE_M[0].powi(2) - PIPE_M[1].powi(2));
    let cases = data["pinned_pinned_DP"]["cases"].as_array().expect("cases");
    for case in cases {
        let axial = case["axial_N"].as_f64().expect("a force");
        for (i, exact) in case["freq_Hz"].as_array().expect("modes").iter().enumerate() {
            let exact = exact.as_f64().expect("a frequency");
            let k = (i + 1) as f64 * std::f64::consts::PI / 30.0;
            let bending = cases[0]["freq_Hz"][i].as_f64().expect("a frequency").powi(2);
            let stretched = 1.0 + axial / (STEEL.youngs_modulus_Pa * area);
            let square = bending / stretched.powi(2) + (exact * exact - bending) / stretched;
            let exact = (square / (1.0 + gyration2 * k * k)).sqrt();
            let error = |parts| pinned(axial, i + 1, parts) / exact - 1.0;
            let fine = error(60);
            verify("D09", format!("mode {} of a pinned pipe under {axial:.0} N, Hz", i + 1))
                .relative(
                    1e-3,
                    "the source's, with the stretch and the rotary inertia that its closed \
                     form leaves out, 2e-4 of mode 5; second order with 60 elements",
                )
                .report(exact, exact * (1.0 + fine));
            let added = (0.5 * k).powi(2) / 78.0;
            assert!((fine + added).abs() < 0.1 * added, "{fine:e} {added:e}");
            if i == 4 && axial == 0.0 {
                let order = (error(15) / error(30)).abs().log2();
                assert!((order - 2.0).abs() < 0.2, "{order}");
            }
        }
    }
}

/// A clamped and free beam: `cos βL cosh βL = −1`, the first three roots (Blevins 1979, table 8-1).
/// Second order again, the larger for the free end's half mass; the extrapolated values are within
/// a tenth of D09's 0.1 %.
#[test]
fn a_clamped_pipe_has_its_frequencies() {
    let length = 60.0;
    for (root, name) in [(1.87510407f64, "first"), (4.69409113, "second"), (7.85475744, "third")] {
        let frequency = |parts: usize| {
            let mut rod = beam(length, parts);
            rod.support(0, Support::CLAMPED);
            let sigma = (root.cosh() + root.cos()) / (root.sinh() + root.sin());
            let k = root / length;
            let section = &rod.mesh.elements[0].section;
            let wave = (section.bending_stiffness_N_m2 / section.steel_kg_per_m).sqrt();
            let exact = k * k * wave / std::f64::consts::TAU;
            let found = swing(&mut rod, 2, |z| {
                let x = k * z;
                let shape = x.cosh() - x.cos() - sigma * (x.sinh() - x.sin());
                let slope = x.sinh() + x.sin() - sigma * (x.cosh() - x.cos());
                (shape, k * slope)
            });
            found / exact - 1.0
        };
        let [coarse, middle, fine] = [15, 30, 60].map(frequency);
        assert!(((4.0 * fine - middle) / 3.0).abs() < 1e-4, "{name}");
        assert!(((coarse / middle).abs().log2() - 2.0).abs() < 0.2, "{name}");
    }
}
