//! D09: beams and shafts between two pins.

use std::f64::consts::{PI, TAU};

use serde_json::Value;
use wholestring::{
    ends::BitEnd,
    prelude::*,
    statics::stiff::StiffSettings,
    string::{ComponentLength, ComponentSpec, Material},
};
use wholestring_vibration::modal::{SmallMotions, Whirl};

use crate::{
    common,
    common::{number, report_worst, verification, verify},
    motions, rigid,
};

/// A pipe so light that its weight does nothing: its frequencies are higher by the root of this.
const LIGHT: f64 = 1e-4;

/// A shaft of a metre so heavy that it is distinct from rounding at rest; its weight is 4e-4 of its
/// buckling load.
const HEAVY: f64 = 6.0;

/// A pipe in a wide vertical hole under a tension, N, its mass `light` times the actual one.
fn beam(
    inputs: &Value,
    shear_modulus_Pa: f64,
    light: f64,
    tension_N: f64,
    elements: f64,
) -> (SmallMotions, f64) {
    let input = |key: &str| number(&inputs[key]);
    let length_m = input("L");
    let (od_m, id_m) = match inputs["r"].as_f64() {
        Some(radius_m) => (2.0 * radius_m, 0.0),
        None => (input("OD"), input("ID")),
    };
    let steel = Material {
        density_kg_per_m3: input("rho") * light,
        youngs_modulus_Pa: input("E"),
        shear_modulus_Pa,
        ..Material::STEEL
    };
    let part = ComponentSpec::uniform("pipe", od_m, id_m, ComponentLength::ToSurface, steel);
    let path = common::arcs(&[[0.0, 0.0, 0.0], [length_m, 0.0, 0.0]]);
    let hole = common::open_hole(1.0, 0.0, length_m);
    let model = common::model(path, hole, vec![part], common::mud(0.0), length_m);
    let operation = Operation { weight_on_bit_N: -tension_N, ..Operation::slide(length_m) };
    // A shaft as short as these is nearly as stiff as a bit's hold.
    let settings =
        StiffSettings { bit_lateral_stiffness_N_per_m: 1e13, ..rigid(length_m / elements) };
    (motions(&model, &operation, &settings), length_m)
}

/// D09: five modes of a pinned pipe, free of axial force, under tension and at half its buckling
/// load, each twice: across two planes. 240 elements, whose lumped rotary inertia takes 6e-5 of the
/// fifth mode, four times as much with half of them; the section's own rotary inertia and the
/// remaining shear, which the file leaves out, take 4e-4.
#[test]
fn d09_pinned_pipe() {
    let data = verification("D09_linear_frequencies.json");
    let group = &data["pinned_pinned_DP"];
    for case in group["cases"].as_array().expect("cases") {
        let tension_N = number(&case["axial_N"]);
        // So stiff in shear that it does not count.
        let (motions, length_m) = beam(&group["inputs"], 1e14, LIGHT, tension_N, 240.0);
        let found = motions.assembly(length_m).lateral(0.0, 10, 0.0).expect("modes");
        let expected = case["freq_Hz"].as_array().expect("frequencies");
        let rows = found.iter().enumerate().map(|(number_of, mode)| {
            let expected = number(&expected[number_of / 2]);
            verify(
                "D09",
                format!(
                    "mode {} of a pinned pipe at rest under {tension_N:.0} N, Hz",
                    number_of / 2 + 1
                ),
            )
            .relative(1e-3, "the file's; rotary inertia and shear, which it leaves out, are 5e-4")
            .row(expected, mode.frequency_Hz * LIGHT.sqrt())
        });
        report_worst(rows);
    }
}

/// D09: a kilometre of pipe that hangs from a pin, its lower end free, each mode twice. Its bending
/// stiffness, which the file counts too, is 2 % of the fifth; elements of 2.5 m: of 5 m miss 1.0e-3
/// of the fifth, a quarter of that is left; its own stretch is 1e-4.
#[test]
fn d09_hanging_chain() {
    let data = verification("D09_linear_frequencies.json");
    let input = |key: &str| number(&data["pinned_pinned_DP"]["inputs"][key]);
    let length_m = 1000.0;
    let steel = Material {
        density_kg_per_m3: input("rho"),
        youngs_modulus_Pa: input("E"),
        ..common::steel()
    };
    let pipe =
        ComponentSpec::uniform("pipe", input("OD"), input("ID"), ComponentLength::ToSurface, steel);
    let path = common::arcs(&[[0.0, 0.0, 0.0], [length_m, 0.0, 0.0]]);
    let hole = common::open_hole(1.0, 0.0, length_m);
    let mut model = common::model(path, hole, vec![pipe], common::mud(0.0), length_m);
    model.ends.bit = BitEnd::Free;
    let motions = motions(&model, &Operation::slide(length_m), &rigid(2.5));
    let found = motions.assembly(length_m).lateral(0.0, 10, 0.0).expect("modes");
    let expected =
        &data["hanging_chain_1000m_Hz"]["with_EI_5in_DP_pinned_top_free_bottom_vacuum_Hz"];
    let rows = found.iter().enumerate().map(|(at, mode)| {
        let number_of = at / 2 + 1;
        verify("D09", format!("lateral mode {number_of} of a hanging pipe at rest, Hz"))
            .relative(1e-3, "the file's; its stretch is 1e-4")
            .row(number(&expected[at / 2]), mode.frequency_Hz)
    });
    report_worst(rows);
}

/// Angular frequencies of a pinned Timoshenko shaft that rotates, rad/s, forward and backward, of a
/// mode: with `w = W sin kx`, `θ = Θ cos kx`, both going round as `exp(iωt)`,
///
/// ```text
/// ρA ω² W = κGA (k² W − k Θ)
/// (ρI ω² − 2ρI Ω ω) Θ = EI k² Θ + κGA (Θ − k W)
/// ```
fn shaft_rad_per_s(inputs: &Value, shear_N: f64, mode: f64, speed: f64) -> [f64; 2] {
    let input = |key: &str| number(&inputs[key]);
    let (radius_m, rho, modulus) = (input("r"), input("rho"), input("E"));
    let (area, second) = (PI * radius_m.powi(2), 0.25 * PI * radius_m.powi(4));
    let k = mode * PI / input("L");
    let determinant = |omega: f64| {
        let a = rho * area * omega * omega - shear_N * k * k;
        let b = rho * second * (omega * omega - 2.0 * speed * omega)
            - modulus * second * k * k
            - shear_N;
        a * b - (shear_N * k).powi(2)
    };
    let guess = k * k * (modulus * second / (rho * area)).sqrt();
    [1.0, -1.0].map(|sign| {
        let (mut low, mut high) = (0.5 * guess * sign, 1.05 * guess * sign);
        assert!(determinant(low) * determinant(high) < 0.0);
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if determinant(middle) * determinant(low) > 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        low.abs()
    })
}

/// D09: a shaft that rotates, its modes forward and backward, against the roots of the Timoshenko
/// shaft; and one so stiff in shear that a third of the shear of steel's is left of it, against the
/// file's Rayleigh shaft.
#[test]
fn d09_spinning_shaft() {
    let data = verification("D09_linear_frequencies.json");
    let group = &data["spinning_rayleigh_shaft"];
    let mut rows = Vec::new();
    for (name, shear_modulus, is_files) in [("steel", 80e9, false), ("a stiff shaft", 1e14, true)] {
        let (motions, length_m) = beam(&group["inputs"], shear_modulus, HEAVY, 0.0, 30.0);
        let poisson = number(&group["inputs"]["E"]) / (2.0 * shear_modulus) - 1.0;
        let radius_m = number(&group["inputs"]["r"]);
        let kappa = wholestring::rod::element::shear_factor(poisson, 0.0);
        let shear_N = kappa * shear_modulus * PI * radius_m.powi(2);
        for case in group["cases"].as_array().expect("cases") {
            let [speed, mode] = ["Omega_rad_s", "mode"].map(|key| number(&case[key]));
            let assembly = motions.assembly(length_m);
            let found = assembly.lateral(0.0, 4, speed / HEAVY.sqrt()).expect("modes");
            let pair = &found[2 * mode as usize - 2..2 * mode as usize];
            if speed > 0.0 {
                assert_eq!(pair[0].whirl(), Some(Whirl::Backward));
                assert_eq!(pair[1].whirl(), Some(Whirl::Forward));
                assert!(pair.iter().all(|pair| pair.precession.abs() > 0.99));
            }
            let round = [1, 0].map(|way: usize| TAU * pair[way].frequency_Hz * HEAVY.sqrt());
            let roots = shaft_rad_per_s(&group["inputs"], shear_N, mode, speed);
            let what = format!("mode {mode:.0} of {name} at {speed:.0} rad/s");
            for (way, found, root) in
                [("forward", round[0], roots[0]), ("backward", round[1], roots[1])]
            {
                rows.push(
                    verify("D09", format!("{way} {what}, rad/s"))
                        .relative(1e-3, "thirty elements leave 6e-4, their weight 1e-4")
                        .row(root, found),
                );
            }
            if is_files {
                let [forward, backward] =
                    ["forward_rad_s", "backward_rad_s"].map(|key| number(&case[key]));
                let reason = "a third of steel's shear, which the file leaves out";
                rows.push(
                    verify("D09", format!("forward {what} without shear, rad/s"))
                        .relative(5e-3, reason)
                        .row(forward, round[0]),
                );
                if speed > 0.0 {
                    rows.push(
                        verify("D09", format!("forward less backward {what} without shear, rad/s"))
                            .relative(2e-2, reason)
                            .row(forward + backward, round[0] - round[1]),
                    );
                }
            }
        }
    }
    report_worst(rows);
}
