//! E08: the shipped cases of well B against the records of its rig.
//!
//! The friction of both cases was fitted on the record at 1714 m. The result at 2235 m is a
//! prediction, and reported unchanged.

use std::{fs, ops::Range, path::Path};

use serde_json::Value;
use wholestring::{dynamics::TimeSeries, prelude::*, string::DrillString};
use wholestring_case::{Case, Override, load};
use wholestring_verification::{Tolerance, verify};

/// Compared statistics of a window, torques in kN·m.
struct Swing {
    mean: f64,
    least: f64,
    peak: f64,
    period_s: f64,
    bit_least_rpm: f64,
    bit_most_rpm: f64,
}

fn root() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The record of a depth: the source's own statistics.
fn recorded(depth_m: u32) -> Swing {
    let file = root().join("verification/E08_aarsnes_field_data.json");
    let data: Value = serde_json::from_str(&fs::read_to_string(file).unwrap()).unwrap();
    let name = format!("E08_wellB_{depth_m}m_digitised.csv");
    let rows = data["derived_statistics"].as_array().unwrap();
    let row = rows.iter().find(|row| row["file"] == name.as_str()).unwrap();
    let torque = |key: &str| row["tq_recorded_kNm"][key].as_f64().unwrap();
    let bit = |i: usize| row["bit_rpm_recorded_min_max"][i].as_f64().unwrap();
    Swing {
        mean: torque("mean"),
        least: torque("min"),
        peak: torque("max"),
        period_s: torque("period_s"),
        bit_least_rpm: bit(0),
        bit_most_rpm: bit(1),
    }
}

/// Means over the record's bins of 0.1 s; samples are whole steps apart, and bins hold ten or
/// eleven.
fn binned(series: &TimeSeries, values: &[f64], settle_s: f64) -> Vec<f64> {
    let mut bins: Vec<(f64, f64)> = Vec::new();
    for (time_s, value) in series.time_s.iter().zip(values) {
        if *time_s >= settle_s {
            let bin = ((time_s - settle_s) / 0.1) as usize;
            bins.resize(bins.len().max(bin + 1), (0.0, 0.0));
            bins[bin].0 += value;
            bins[bin].1 += 1.0;
        }
    }
    // The last one is cut short.
    bins.pop();
    bins.iter().map(|(sum, samples)| sum / samples).collect()
}

/// The delay at which the torque best repeats itself, among these tenths of a second, s; the
/// record's 3.9 s is found in the same way.
fn period_s(torque: &[f64], delays: Range<usize>) -> f64 {
    let mean = torque.iter().sum::<f64>() / torque.len() as f64;
    let alike = |delay: usize| {
        let pairs = torque.iter().zip(&torque[delay..]);
        let sum: f64 = pairs.map(|(a, b)| (a - mean) * (b - mean)).sum();
        sum / (torque.len() - delay) as f64
    };
    let best = delays.max_by(|a, b| alike(*a).total_cmp(&alike(*b))).unwrap();
    0.1 * best as f64
}

/// The same string with the polar inertia and the torsional stiffness of its assembly multiplied.
///
/// The inertia is multiplied by way of the mass, with a density that keeps the weight in the mud:
/// the axial and lateral inertia of the assembly grow with it, which does not affect torsion.
fn multiplied(model: &Model, inertia: f64, stiffness: f64) -> DrillString {
    let last = model.string.components().len() - 1;
    let mud = model.mud.density_kg_per_m3;
    let components = model.string.components().iter().enumerate().map(|(i, c)| {
        let mut material = c.material;
        let mut mass = c.mass_per_length_kg_per_m;
        // Neither the bit nor the pipe.
        if i > 0 && i < last {
            let sinks = (1.0 - mud / material.density_kg_per_m3) / inertia;
            mass *= inertia;
            material.density_kg_per_m3 = mud / (1.0 - sinks);
            material.shear_modulus_Pa *= stiffness;
        }
        ComponentSpec {
            mass_per_length_kg_per_m: mass,
            ..ComponentSpec::uniform(
                c.name.clone(),
                c.od_m,
                c.id_m,
                if i == last {
                    ComponentLength::ToSurface
                } else {
                    ComponentLength::Metres(c.length_m)
                },
                material,
            )
        }
    });
    let components = components.collect();
    StringSpec { components }.assemble(model.string.length_m()).unwrap()
}

fn shipped(depth_m: u32, changes: &[Override]) -> Case {
    let file = root().join(format!("cases/well-b-{depth_m}.toml"));
    load(&file, changes).unwrap_or_else(|report| panic!("{report}"))
}

fn computed(case: &Case, delays: Range<usize>) -> Swing {
    let mut simulation = Simulation::new(&case.model, &case.operations[0], &case.dynamics).unwrap();
    simulation.advance(simulation.end_time_s()).unwrap();
    let outcome = simulation.outcome();
    assert!(outcome.numerics.energy_residual.abs() < 1e-4);
    let series = &outcome.series;
    let settle_s = case.dynamics.settle_s;
    let torque = binned(series, &series.surface_torque_N_m, settle_s);
    let bit = binned(series, &series.bit_rotary_speed_rad_per_s, settle_s);
    let least = |values: &[f64]| values.iter().copied().fold(f64::MAX, f64::min);
    let most = |values: &[f64]| values.iter().copied().fold(f64::MIN, f64::max);
    let rpm = 30.0 / std::f64::consts::PI;
    Swing {
        mean: torque.iter().sum::<f64>() / torque.len() as f64 / 1e3,
        least: least(&torque) / 1e3,
        peak: most(&torque) / 1e3,
        period_s: period_s(&torque, delays),
        bit_least_rpm: rpm * least(&bit),
        bit_most_rpm: rpm * most(&bit),
    }
}

fn compare(depth_m: u32, period: Tolerance, peak: Tolerance, reason: &str) {
    let (found, record) = (computed(&shipped(depth_m, &[]), 20..70), recorded(depth_m));
    let reported = "reported as it comes";
    for (quantity, found, expected, tolerance, reason) in [
        ("period, s", found.period_s, record.period_s, period, reason),
        ("peak torque, kN·m", found.peak, record.peak, peak, reason),
        ("mean torque, kN·m", found.mean, record.mean, Tolerance::Any, reported),
        ("least torque, kN·m", found.least, record.least, Tolerance::Any, reported),
        (
            "least bit speed, rev/min",
            found.bit_least_rpm,
            record.bit_least_rpm,
            Tolerance::Any,
            reported,
        ),
        (
            "largest bit speed, rev/min",
            found.bit_most_rpm,
            record.bit_most_rpm,
            Tolerance::Any,
            reported,
        ),
    ] {
        println!("{depth_m} m, {quantity}: {found:.2} for {expected}");
        verify("E08", format!("at {depth_m} m: {quantity}"))
            .within(tolerance, reason)
            .report(expected, found);
    }
}

/// The fit: period within 10 %, peak within 15 %. The string sticks, slips and turns backwards, as
/// in the record.
#[test]
fn the_fit_at_1714_m_has_the_period_and_the_peak_of_the_record() {
    let reason = "the requirement for a fit of two coefficients";
    compare(1714, Tolerance::Relative(0.10), Tolerance::Relative(0.15), reason);
}

/// The prediction with the same friction.
#[test]
fn the_prediction_at_2235_m_is_reported() {
    let reason = "a prediction: reported as it comes";
    compare(2235, Tolerance::Any, Tolerance::Any, reason);
}

/// Kinetic and static friction of the shipped cases, and those of the fit with the authors' moment.
const SHIPPED: [f64; 2] = [0.24, 0.52];
const REFITTED: [f64; 2] = [0.25, 0.32];

/// A shipped case with another friction, and the assembly's moments multiplied.
fn varied(depth_m: u32, [kinetic, at_rest]: [f64; 2], inertia: f64, stiffness: f64) -> Swing {
    let friction = format!("friction={{ kinetic = {kinetic}, static = {at_rest} }}");
    let mut case = shipped(depth_m, &[friction.parse().unwrap()]);
    case.model.string = multiplied(&case.model, inertia, stiffness);
    let found = computed(&case, 20..if inertia > 1.0 { 100 } else { 70 });
    println!(
        "{depth_m} m, friction {kinetic}, {at_rest}, inertia {inertia:.2}, stiffness {stiffness:.2}: period {:.1} s, \
         peak {:.2}, mean {:.2}, least {:.2} kN·m, bit {:.0} to {:.0} rev/min",
        found.period_s,
        found.peak,
        found.mean,
        found.least,
        found.bit_least_rpm,
        found.bit_most_rpm
    );
    found
}

/// The authors' program multiplies the polar moment of the assembly by `π`, and thus its inertia
/// and its stiffness. Applied here, that does not explain the miss at 2235 m: whatever the
/// friction, and with the stiffness unchanged, the string swings at 6.3 s and more at 1714 m and at
/// 7.2 s and more at 2235 m, 1.6 times the record at least; with friction fitted again at 1714 m
/// the peak at 2235 m is missed by a quarter at least.
///
/// The bounds are half of the miss: the lowest natural period of the string, fixed at the top and
/// free at the bit, is 3.9 and 4.8 s without the `π` and 6.3 and 7.4 s with it, for records of 3.9
/// and 4.1 s.
#[test]
fn the_moment_of_the_authors_program_does_not_explain_the_miss() {
    use std::f64::consts::PI;
    for (friction, inertia, stiffness) in
        [(SHIPPED, PI, 1.0), (SHIPPED, PI, PI), (REFITTED, PI, PI)]
    {
        for depth_m in [1714, 2235] {
            let (found, record) =
                (varied(depth_m, friction, inertia, stiffness), recorded(depth_m));
            assert!(found.period_s > 1.4 * record.period_s, "{}", found.period_s);
            if depth_m == 2235 {
                assert!(found.peak > 1.2 * record.peak, "{}", found.peak);
            } else if friction == REFITTED {
                assert!((found.peak / record.peak - 1.0).abs() < 0.15);
                assert!((found.mean / record.mean - 1.0).abs() < 0.05);
            }
        }
    }
    // The effect of the fit's lower static friction alone.
    for depth_m in [1714, 2235] {
        varied(depth_m, REFITTED, 1.0, 1.0);
    }
}

/// A multiplied string of factors one is the string.
#[test]
fn a_string_multiplied_by_one_is_the_same() {
    let case = shipped(1714, &[]);
    let same = multiplied(&case.model, 1.0, 1.0);
    assert_eq!(same.length_m(), case.model.string.length_m());
    for (a, b) in same.components().iter().zip(case.model.string.components()) {
        assert!((a.material.density_kg_per_m3 / b.material.density_kg_per_m3 - 1.0).abs() < 1e-12);
        assert_eq!(a.mass_per_length_kg_per_m, b.mass_per_length_kg_per_m);
        assert_eq!((a.od_m, a.id_m, a.joints), (b.od_m, b.id_m, b.joints));
    }
}
