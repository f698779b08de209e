//! A mass and a wheel on a torsion spring with a drag bit: Richard, Germay and Detournay's string.

use std::f64::consts::TAU;

use nalgebra::{Complex, ComplexField};
use wholestring_verification::verify;
use wholestring_vibration::torsional_stability::{
    LinearBit, LinearDrive, LinearHoist, LinearRock, LumpedChain, SteadyRotation,
};

use crate::{band, hung, turning};

const BLADES: f64 = 4.0;

/// In their dimensionless form: time in `√(I/C)`, and `M = 1/ψ`.
fn drilling(psi: f64, damping: f64, pitch: f64, coupling: f64, speed: f64) -> SteadyRotation {
    SteadyRotation {
        torsion: LumpedChain {
            inertia: vec![0.0, 1.0],
            stiffness: vec![1.0],
            drag: vec![0.0, damping],
            stiffness_damping_s: 0.0,
        },
        axial: hung(1.0 / psi),
        drive: LinearDrive::Constant,
        hoist: LinearHoist::Force(0.0),
        bit: LinearBit {
            rock: LinearRock::Delay { stiffness_N_per_m: BLADES, delay_s: TAU / (BLADES * speed) },
            torque_per_weight_m: coupling,
            advance_per_angle_m: pitch,
            ..turning(0.0)
        },
    }
}

/// Speed above which no root in the band grows.
fn threshold(rotation: impl Fn(f64) -> SteadyRotation, mut low: f64, mut high: f64) -> f64 {
    let stable = |speed: f64| rotation(speed).stability(band(0.05, 30.0)).is_stable();
    assert!(!stable(low) && stable(high));
    for _ in 0..20 {
        let middle = 0.5 * (low + high);
        if stable(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    0.5 * (low + high)
}

/// Without torsion `s² + nψ (1 − e^{−sτ}) = 0` first grows at `s = iπ/τ`, where the delay is half a
/// period: `ω₀ = 2 √(2ψ/n)`.
#[test]
fn chatter_begins_where_the_delay_is_half_a_period() {
    let psi = 14.0;
    let exact = 2.0 * (2.0 * psi / BLADES).sqrt();
    let found = threshold(|speed| drilling(psi, 0.5, 0.0, 0.0, speed), 0.8 * exact, 1.2 * exact);
    verify("torsional stability", "speed above which a drag bit does not chatter")
        .relative(2e-6, "halved twenty times")
        .report(exact, found);
}

/// The characteristic equation of the coupled string, written out:
/// `(s² + nψE)(s² + κs + 1 − nrE) + n²ψrE² = 0`, `E = 1 − e^{−sτ}`; its leading root by Newton's
/// method from all over the plane.
fn leading(psi: f64, damping: f64, pitch: f64, speed: f64) -> Complex<f64> {
    let delay = TAU / (BLADES * speed);
    let equation = |s: Complex<f64>| {
        let cut = (Complex::new(1.0, 0.0) - (-s * delay).exp()) * BLADES;
        let torsion = s * s + s * damping + 1.0;
        ((s * s + cut * psi) * (torsion - cut * pitch) + cut * cut * (psi * pitch)) / s
    };
    let mut leading = Complex::new(f64::NEG_INFINITY, 0.0);
    for re in -12..=6 {
        for im in 0..100 {
            let mut s = Complex::new(0.25 * f64::from(re), 0.011 + 0.25 * f64::from(im));
            for _ in 0..60 {
                let h = 1e-6;
                s -= equation(s) * (2.0 * h) / (equation(s + h) - equation(s - h));
            }
            let held = equation(s).modulus() < 1e-9 * (1.0 + s.modulus().powi(3));
            if held && s.im > 0.05 && s.modulus() < 30.0 && s.re > leading.re {
                leading = s;
            }
        }
    }
    leading
}

#[test]
fn the_coupled_string_has_the_roots_of_its_equation() {
    let psi = 14.0;
    for (damping, pitch, speed) in
        [(0.3, 0.06, 6.5), (0.3, 0.06, 7.5), (0.05, 0.2, 9.0), (0.0, 0.4, 6.0)]
    {
        let root = leading(psi, damping, pitch, speed);
        let found = drilling(psi, damping, pitch, 1.0, speed).stability(band(0.05, 30.0));
        assert_eq!(found.is_stable(), root.re < 0.0, "{root} {found:?}");
        assert!(found.complete);
        let seen = found.worst.expect("a root");
        let what = format!("damping {damping} with pitch {pitch} and speed {speed}");
        for (name, expected, computed) in [
            ("growth", root.re, seen.growth_per_s),
            ("angular frequency", root.im, TAU * seen.frequency_Hz),
        ] {
            verify("torsional stability", format!("{name} of a drag bit with delay: {what}"))
                .absolute(1e-6, "rounding: both are followed to 1e-9")
                .report(expected, computed);
        }
    }
}
