//! A uniform pipe with a bit that weakens, under a top that takes a part of each wave.

use std::f64::consts::{PI, TAU};

use nalgebra::{Complex, ComplexField};
use wholestring::dynamics::Gains;
use wholestring_verification::verify;
use wholestring_vibration::torsional_stability::{LinearDrive, LumpedChain, SteadyRotation};

use serde_json::Value;

use crate::{
    band,
    common::{number, verification},
    in_torsion, turning, worst,
};

/// Impedance of the pipe, N·m·s, and the time in which a wave runs through it, s.
const IMPEDANCE: f64 = 400.0;
const TRAVEL_S: f64 = 0.6;

fn pipe(elements: usize) -> LumpedChain {
    let f64 = elements as f64;
    let inertia = IMPEDANCE * TRAVEL_S / f64;
    let mut nodes = vec![inertia; elements + 1];
    nodes[0] *= 0.5;
    nodes[elements] *= 0.5;
    LumpedChain {
        inertia: nodes,
        stiffness: vec![IMPEDANCE * f64 / TRAVEL_S; elements],
        drag: vec![0.0; elements + 1],
        stiffness_damping_s: 0.0,
    }
}

fn driven(elements: usize, inertia_kg_m2: f64, proportional: f64, integral: f64) -> LinearDrive {
    LinearDrive::Tuned {
        inertia_kg_m2,
        half_kg_m2: pipe(elements).inertia[0],
        gains: Gains { proportional_N_m_s: proportional, integral_N_m: integral, shown: None },
    }
}

fn string(elements: usize, drive: LinearDrive, slope: f64) -> SteadyRotation {
    in_torsion(pipe(elements), drive, turning(slope))
}

/// `Z (1 + R e^{−2sT})/(1 − R e^{−2sT}) + T′ = 0` with a dashpot `C` at the top, `R = (C − Z)/(C +
/// Z)`: every mode grows by `ln(R (Z + d)/(Z − d))/2T` where the torque falls by `d` per speed, at
/// the odd quarter waves. A held top is `R = 1`; a dashpot of the pipe's own impedance reflects
/// nothing, and nothing grows however near `d` is to `Z`.
#[test]
fn a_uniform_pipe_grows_by_what_its_ends_send_back() {
    let elements = 800;
    // The first three modes.
    let few = band(0.3, 5.8 * PI / (2.0 * TRAVEL_S));
    for (dashpot, slope) in
        [(f64::INFINITY, -40.0), (4000.0, -50.0), (4000.0, -30.0), (1200.0, -150.0), (900.0, 20.0)]
    {
        let (drive, back) = if dashpot.is_finite() {
            let drive = driven(elements, 0.0, dashpot, 0.0);
            (drive, (dashpot - IMPEDANCE) / (dashpot + IMPEDANCE))
        } else {
            (LinearDrive::Constant, 1.0)
        };
        let growth = (back * (IMPEDANCE - slope) / (IMPEDANCE + slope)).ln() / (2.0 * TRAVEL_S);
        let found = string(elements, drive, slope).stability(few);
        let growing = if growth > 0.0 { 6 } else { 0 };
        assert_eq!(found.unstable_roots, growing, "{dashpot} {slope}");
        let root = worst(&found);
        verify(
            "torsional stability",
            format!("growth of a uniform pipe, top {dashpot} and bit {slope} N·m·s, 1/s"),
        )
        .relative(5e-4, "lumped inertia: 2e-4 at 800 elements, four times that at half as many")
        .report(growth, root.growth_per_s);
        let quarter = 4.0 * TRAVEL_S * root.frequency_Hz;
        let odd = 2.0 * ((quarter - 1.0) / 2.0).round() + 1.0;
        assert!((quarter / odd - 1.0).abs() < 1e-4, "{quarter}");
    }
    let matched = driven(elements, 0.0, IMPEDANCE, 0.0);
    for part in [0.5, 0.9, 0.95] {
        let found = string(elements, matched, -part * IMPEDANCE).stability(few);
        assert!(found.is_stable(), "{part}");
    }
}

/// Under a drive with inertia and an integral gain: the roots of the same equation with
/// `C = J s + K_p + K_i/s`, by Newton's method on the continuous pipe. The error of the lumped pipe
/// falls by four from mesh to mesh.
#[test]
fn a_uniform_pipe_under_a_drive_has_the_roots_of_the_continuous_one() {
    let (inertia, proportional, integral, slope) = (1500.0, 2000.0, 900.0, -60.0);
    let one = Complex::new(1.0, 0.0);
    let equation = |s: Complex<f64>| {
        let drive = s * inertia + proportional + one * integral / s;
        let back = (drive - IMPEDANCE) / (drive + IMPEDANCE) * (-s * (2.0 * TRAVEL_S)).exp();
        (one + back) * IMPEDANCE + (one - back) * slope
    };
    let mut growing = Vec::new();
    for quarter in 0..40 {
        let mut s = Complex::new(0.05, 0.25 * f64::from(quarter) + 0.05);
        for _ in 0..50 {
            let h = 1e-6;
            s -= equation(s) * (2.0 * h) / (equation(s + h) - equation(s - h));
        }
        let new = growing.iter().all(|complex: &Complex<f64>| (complex - s).modulus() > 1e-6);
        if equation(s).modulus() < 1e-6 && new && s.im > 0.3 && s.modulus() < 10.0 {
            growing.push(s);
        }
    }
    let first = growing.iter().max_by(|a, b| a.re.total_cmp(&b.re)).expect("a root");
    let number = 2 * growing.iter().filter(|s| s.re > 0.0).count();
    assert!(number > 0);
    let errors = [100, 200, 400].map(|elements| {
        let drive = driven(elements, inertia, proportional, integral);
        let found = string(elements, drive, slope).stability(band(0.3, 10.0));
        assert_eq!(found.unstable_roots, number);
        let root = worst(&found);
        let s = Complex::new(root.growth_per_s, TAU * root.frequency_Hz);
        if elements == 400 {
            let reason = "a mesh of 400 elements: errors fall by four where they are halved";
            for (what, expected, computed) in
                [("growth", first.re, s.re), ("angular frequency", first.im, s.im)]
            {
                verify(
                    "torsional stability",
                    format!("{what} of a uniform pipe under a drive with inertia, 1/s"),
                )
                .relative(2e-4, reason)
                .report(expected, computed);
            }
        }
        (s - first).modulus()
    });
    for pair in errors.windows(2) {
        assert!((pair[0] / pair[1] / 4.0 - 1.0).abs() < 0.05, "{errors:?}");
    }
}

/// E02: 2500 m of pipe on a bottom-hole assembly, held at the top, barely damped: within 1 % of its
/// computed lowest frequency, which is the source's tolerance.
#[test]
fn a_string_of_pipe_and_assembly_swings_at_its_frequency() {
    let data = verification("E02_aarsnes_shor_synthetic_well.json");
    let case = &data["cases"][0];
    let part = |section: &Value, [polar, shear]: [&str; 2], length_m: f64| {
        let (polar, shear) = (number(&section[polar]), number(&section[shear]));
        (polar * number(&data["rho"]), shear * polar, length_m)
    };
    let low_m = number(&data["bha"]["Lc"]);
    let pipe = part(&data["pipe"], ["Jp", "Gp"], number(&case["inputs"]["MD"]) - low_m);
    let low = part(&data["bha"], ["Jc", "Gc"], low_m);
    let (mut inertia, mut stiffness) = (vec![0.0], Vec::new());
    for (inertia_kg_m, stiffness_N_m2, length_m) in [pipe, low] {
        let elements = 200;
        let of_one_m = length_m / f64::from(elements);
        for _ in 0..elements {
            let half = 0.5 * inertia_kg_m * of_one_m;
            *inertia.last_mut().expect("a node") += half;
            inertia.push(half);
            stiffness.push(stiffness_N_m2 / of_one_m);
        }
    }
    let drag = inertia.iter().map(|inertia| 1e-3 * inertia).collect();
    let chain = LumpedChain { inertia, stiffness, drag, stiffness_damping_s: 0.0 };
    let found = in_torsion(chain, LinearDrive::Constant, turning(0.0)).stability(band(0.3, 3.0));
    assert!(found.is_stable());
    let root = worst(&found);
    assert!((root.growth_per_s + 0.5e-3).abs() < 1e-8, "{root:?}");
    verify("E02", "lowest frequency by the roots of torsional stability, Hz")
        .relative(0.01, "the tolerance of the source; 1e-5 of lumped inertia")
        .report(number(&case["expected"]["f1_Hz"]), root.frequency_Hz);
}
