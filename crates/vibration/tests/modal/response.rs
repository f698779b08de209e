//! The response to a rotating force.

use std::f64::consts::{PI, TAU};

use nalgebra::{Complex, ComplexField};
use wholestring::{
    dynamics::{DynamicsSettings, RodDamping},
    ends::TopEnd,
    prelude::*,
    string::{Cavity, ComponentLength, ComponentSpec, Eccentricity},
};
use wholestring_vibration::modal::{Forcing, SmallMotions};

use crate::{
    common,
    common::{number, report_worst, verification, verify},
    rigid,
};

/// D09, Jeffcott: a pinned pipe whose steel is eccentric, damped in proportion to its mass. Its
/// middle goes as far as the file's rotor times `4/π`, its first mode's part of a constant
/// eccentricity, and as far as the modes above the first add,
///
/// ```text
/// x/e = Σ (4/nπ) sin(nπ/2) rₙ²/(1 − rₙ² + 2iζₙrₙ),   rₙ = r/n²,  ζₙ = ζ/n²
/// ```
///
/// 120 elements take 1e-6 of the first mode's frequency, which resonance with 5 % of damping
/// hardly sees; shear and rotary inertia, which the series leaves out, are 2e-4 of the third mode.
#[test]
fn d09_eccentric_pipe() {
    const LENGTH_M: f64 = 30.0;
    const OFFSET_M: f64 = 1e-3;
    // So light that its weight does nothing.
    let steel = wholestring::string::Material { density_kg_per_m3: 0.785, ..common::steel() };
    let eccentricity = Eccentricity { offset_m: OFFSET_M, phase_rad: 0.7, cavity: Cavity::Sealed };
    let part = ComponentSpec {
        eccentricity: Some(eccentricity),
        ..ComponentSpec::uniform("pipe", 0.127, 0.1086, ComponentLength::ToSurface, steel)
    };
    let path = common::arcs(&[[0.0, 0.0, 0.0], [LENGTH_M, 0.0, 0.0]]);
    let hole = common::open_hole(1.0, 0.0, LENGTH_M);
    let mut model = common::model(path, hole, vec![part], common::mud(0.0), LENGTH_M);
    model.ends.top = TopEnd::Pinned;
    let operation = Operation::rotate_off_bottom(LENGTH_M).rotary_speed_rad_per_s(1.0);
    let damped = |mass_per_s: f64| {
        let damping = RodDamping { mass_per_s, stiffness_s: 0.0 };
        let dynamics = DynamicsSettings { damping, ..DynamicsSettings::default() };
        SmallMotions::new(&model, &operation, &rigid(0.25), &dynamics).expect("rest")
    };
    let free = damped(0.0);
    let first = TAU * free.assembly(LENGTH_M).lateral(0.0, 1, 0.0).expect("a mode")[0].frequency_Hz;
    let data = verification("D09_linear_frequencies.json");
    let mut rows = Vec::new();
    for case in data["jeffcott"]["cases"].as_array().expect("cases") {
        let (ratio, zeta) = (number(&case["r"]), number(&case["zeta"]));
        let motions = damped(2.0 * zeta * first);
        assert!(motions.is_eccentric());
        let found = motions.assembly(LENGTH_M).respond(Forcing::Imbalance, &[ratio * first]);
        let part = |n: f64| {
            let (r, zeta) = (ratio / (n * n), zeta / (n * n));
            let turned = Complex::new(1.0 - r * r, 2.0 * zeta * r);
            Complex::new(4.0 / (n * PI) * (0.5 * n * PI).sin() * r * r, 0.0) / turned
        };
        // The file's rotor is the first of them, but for its part.
        let rotor = number(&case["x_over_e"]) * 4.0 / PI;
        assert!((part(1.0).modulus() / rotor - 1.0).abs() < 1e-9);
        let sum: Complex<f64> = (0..20).map(|k| part(f64::from(2 * k + 1))).sum();
        // The widest place is the middle but where the third mode counts.
        let widest = found[0].amplitude_m / OFFSET_M;
        if ratio <= 2.0 {
            rows.push(
                verify(
                    "D09",
                    format!("middle of an eccentric pipe at {ratio} of resonance over its offset"),
                )
                .relative(3e-3, "the grid of nodes and shear")
                .row(sum.modulus(), widest),
            );
        }
    }
    report_worst(rows);
}
