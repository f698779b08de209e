//! A string under load in a straight hole: straight below the load of Dawson and Paslay, buckled
//! above it.

use wholestring::{
    dynamics::{HoistControl, MeshSettings},
    prelude::*,
    rod::buckled_element::BuckledElement,
    well::Interpolation,
};

use crate::{
    common::{Row, operation, path, report_worst, verification, verify},
    wells::{Case, each, go, model},
};

/// The string of one of C01's cases.
struct Pushed {
    case: Case,
    /// Dawson and Paslay's `2 √(EI w sin i/r)`, N.
    critical_N: f64,
    /// Length of a whole wave at that load, m.
    wavelength_m: f64,
    /// Buoyed weight along the hole, N/m: decrease of the load per metre up the hole.
    along_N_per_m: f64,
}

/// The row of 5 in pipe in an 8-1/2 in hole at an inclination, frictionless, `waves` wavelengths
/// long.
fn row(inclination_deg: f64, waves: f64) -> Pushed {
    let file = verification("C01_straight_hole_critical_loads.json");
    let rows = file["cases"].as_array().expect("a list of cases");
    let row = rows
        .iter()
        .find(|row| row["inputs"]["inc_deg"] == inclination_deg)
        .expect("the inclination");
    let input = |key: &str| row["inputs"][key].as_f64().expect("a number");
    let expected = |key: &str| row["expected"][key].as_f64().expect("a number");
    let wavelength_m = expected("sin_wavelength_m");
    let length_m = (waves * wavelength_m).round();
    let stations = [[0.0, inclination_deg, 0.0], [length_m, inclination_deg, 0.0]];
    let pipe = ComponentSpec {
        mass_per_length_kg_per_m: input("mass_air_kg_m"),
        ..ComponentSpec::uniform(
            "pipe",
            input("OD_m"),
            input("ID_m"),
            ComponentLength::ToSurface,
            Material {
                density_kg_per_m3: input("rho_steel"),
                youngs_modulus_Pa: input("E_Pa"),
                shear_modulus_Pa: 79.3e9,
                ..Material::STEEL
            },
        )
    };
    let mut model = model(
        path(&stations, Interpolation::Spline),
        vec![HoleSection::open(0.0..(length_m + 10.0), input("hole_m"), 0.0)],
        vec![pipe],
        length_m,
    );
    model.mud = Mud { density_kg_per_m3: input("rho_mud"), ..model.mud };
    let slide = Operation {
        // A bit that hardly cuts, without torque.
        rate_of_penetration_m_per_s: 1e-9,
        ..operation(OperationKind::Slide, length_m)
    };
    Pushed {
        case: Case::new(model, slide),
        critical_N: expected("F_sin_DawsonPaslay_N"),
        wavelength_m,
        along_N_per_m: input("buoyed_w_N_m") * inclination_deg.to_radians().cos(),
    }
}

/// Shape of a string: the angle from the low side of its contacts.
#[derive(Debug)]
struct Shape {
    /// Largest and root mean square, rad, four wavelengths and more from the ends.
    largest_rad: f64,
    spread_rad: f64,
    /// Twice the mean distance between crossings of the low side, m.
    wavelength_m: f64,
    /// Weight on bit over the critical load.
    load: f64,
}

/// The shape under `load` times the critical load at the lower end, `seconds` after the start.
/// `ends` wavelengths at either end are left out.
fn shape(row: &Pushed, load: f64, seconds: f64, ends: f64) -> Shape {
    let mut case = row.case.clone();
    let length_m = case.operation.bit_depth_m;
    let pushed_N = load * row.critical_N;
    case.operation.weight_on_bit_N = pushed_N;
    // A constant force on the top leaves the load at the bit whatever the string does on the way.
    let lift_N = row.along_N_per_m * length_m - pushed_N;
    case.settings.hoist_control = Some(HoistControl::HookLoad(lift_N));
    case.lasts(seconds, 5.0);
    let mut simulation: Simulation = case.start();
    go(&mut simulation, seconds + 5.0);
    let outcome = simulation.outcome();
    let nodes = &outcome.nodes;
    let near = ends * row.wavelength_m;
    let inner = nodes
        .md_m
        .iter()
        .zip(&nodes.climb_rad)
        .filter(|(md, _)| **md > near && **md < length_m - near);
    let lying: Vec<(f64, f64)> =
        inner.clone().filter_map(|(md, climb)| climb.map(|climb| (*md, climb))).collect();
    // A node without contact has no angle, and would be taken as straight.
    assert_eq!(lying.len(), inner.count(), "it lies on the wall");
    let crossings: Vec<f64> =
        lying.windows(2).filter(|pair| pair[0].1 * pair[1].1 < 0.0).map(|pair| pair[0].0).collect();
    let wavelength_m = match crossings.as_slice() {
        [first, .., last] => 2.0 * (last - first) / (crossings.len() - 1) as f64,
        _ => f64::INFINITY,
    };
    let square = lying.iter().map(|(_, c)| c * c).sum::<f64>() / lying.len() as f64;
    Shape {
        largest_rad: lying.iter().fold(0.0, |most, (_, c)| c.abs().max(most)),
        spread_rad: square.sqrt(),
        wavelength_m,
        load: outcome.scalars.weight_on_bit_N / row.critical_N,
    }
}

/// Amplitude `A` of the snake `θ = A sin kz` under `load` times the critical load: the least of the
/// energy `EI r²/2 (θ″² + θ′⁴) − F r²/2 θ′² + w r (1 − cos θ)` per length over `A` and `k`, to the
/// fourth order in `A`: `load = √(1 − A²/8) (1 + 3A²/4)`. Derived here; at `A = 0` it is Dawson and
/// Paslay's load.
fn amplitude_rad(load: f64) -> f64 {
    let (mut low, mut high) = (0.0f64, 1.0f64);
    for _ in 0..60 {
        let a2 = (0.5 * (low + high)).powi(2);
        if (1.0 - a2 / 8.0).sqrt() * (1.0 + 0.75 * a2) < load {
            low = 0.5 * (low + high);
        } else {
            high = 0.5 * (low + high);
        }
    }
    0.5 * (low + high)
}

/// Waves of the string, and waves left out at either end: the ends are held to the hole's axis and
/// lift the string off the low side there, which fades within two waves.
const WAVES: f64 = 16.0;
const ENDS: f64 = 4.0;

/// Straight: the seeded disturbance of a micrometre turns the string by 2e-5 rad at the start, and
/// it must not have grown.
const STRAIGHT_RAD: f64 = 2e-5;

/// At 0.9 of Dawson and Paslay's load the string is straight on the low side, at 1.25 it snakes,
/// with waves as long as the critical one within 10 %: the wave that grows fastest is shorter by
/// `1/√1.25`, that of the least energy 1 % longer, and one wave more or less between the held ends
/// is 6 %.
///
/// The load is that at the bit. In a hole of 60 degrees it falls by 120 N per metre upwards, so
/// that the lower 316 m, 12 waves, are above the critical load when the bit is at 1.25 of it; at
/// 0.9 no part is.
#[test]
fn straight_below_the_critical_load_and_buckled_above() {
    let cases = [(90.0, 0.9), (90.0, 1.25), (60.0, 0.9), (60.0, 1.25)];
    let shapes = each(&cases, |(inclination, load)| {
        let row = row(*inclination, WAVES);
        (shape(&row, *load, 10.0, ENDS), row.wavelength_m)
    });
    for ((inclination, load), (shape, wavelength_m)) in cases.iter().zip(&shapes) {
        assert!((shape.load / load - 1.0).abs() < 1e-3, "{shape:?}");
        let at = format!("hole of {inclination}° at {load} of the load");
        if *load < 1.0 {
            straight(&format!("{at}: largest angle, rad"), shape).report();
        } else {
            verify("C01", format!("{at}: largest angle, rad"))
                .at_least("buckled: half of the 0.61 rad of an endless snake under that load")
                .report(0.3, shape.largest_rad);
            verify("C01", format!("{at}: length of a wave, m"))
                .relative(
                    0.1,
                    "the fastest-growing wave is shorter by 1/√1.25, and one wave more or less \
                     is 6 %",
                )
                .report(*wavelength_m, shape.wavelength_m);
        }
    }
}

/// The row of a string that has not buckled.
fn straight<'a>(quantity: &'a str, shape: &Shape) -> Row<'a> {
    verify("C01", quantity)
        .absolute(STRAIGHT_RAD, "the seeded disturbance of a micrometre, which must not have grown")
        .row(0.0, shape.largest_rad)
}

/// The row of a string that has.
fn snaking<'a>(quantity: &'a str, shape: &Shape) -> Row<'a> {
    verify("C01", quantity)
        .at_least("an endless snake has 0.17 rad at 1.02 of the load, and more above")
        .row(0.1, shape.largest_rad)
}

/// In the horizontal hole the string is still straight at 0.99 and 1.00 of the critical load and
/// snakes at 1.02, with the amplitude of [`amplitude_rad`]: 16 waves between held ends buckle
/// within 2 % of an endless string (C01's own tolerance for more than ten waves).
///
/// The amplitude is right to `A⁴` and at one wavelength out of those that fit: 2 % up to 1.1 of the
/// load. So little above it the snake grows for half a minute from a micrometre.
#[test]
fn the_onset_and_the_amplitude_of_snaking() {
    let loads = [0.99, 1.0, 1.02, 1.05, 1.1];
    let row = row(90.0, WAVES);
    for (load, shape) in loads.iter().zip(each(&loads, |load| shape(&row, *load, 40.0, ENDS))) {
        let at = format!("hole of 90° at {load} of the load");
        if *load <= 1.0 {
            straight(&format!("{at}: largest angle, rad"), &shape).report();
        } else {
            verify("C01", format!("{at}: amplitude of the snake, rad"))
                .relative(
                    0.02,
                    "the source's, for more than ten waves; right to the fourth power of the \
                     amplitude",
                )
                .report(amplitude_rad(*load), std::f64::consts::SQRT_2 * shape.spread_rad);
        }
    }
}

/// The effect of length and mesh: strings of 12, 24 and 48 waves and elements of 1.6 and 3.2 m
/// buckle between 0.99 and 1.02 of the load. In a hole of 60 degrees two and a half waves are above
/// the critical load with 1.05 of it at the bit, which leaves the string straight, and five with
/// 1.10, which buckles it.
#[test]
#[ignore = "minutes: run by cargo xtask verify"]
fn the_onset_hardly_depends_on_length_and_mesh() {
    let mut cases = vec![];
    for waves in [12.0, 24.0, 48.0] {
        for element_m in [1.6, 3.2] {
            for load in [0.99, 1.02] {
                cases.push((waves, element_m, load));
            }
        }
    }
    let shapes = each(&cases, |(waves, element_m, load)| {
        let mut row = row(90.0, *waves);
        row.case.settings.mesh = MeshSettings::uniform(*element_m);
        shape(&row, *load, 30.0, ENDS)
    });
    let below = cases.iter().zip(&shapes).filter(|(case, _)| case.2 < 1.0);
    report_worst(below.map(|(_, shape)| {
        straight("12 to 48 waves at 0.99 of the load: largest angle, rad", shape)
    }));
    let above = cases.iter().zip(&shapes).filter(|(case, _)| case.2 > 1.0);
    report_worst(above.map(|(_, shape)| {
        snaking("12 to 48 waves at 1.02 of the load: largest angle, rad", shape)
    }));
    let row = row(60.0, 24.0);
    let loads = [1.02, 1.05, 1.1, 1.15, 1.25];
    for (load, shape) in loads.iter().zip(each(&loads, |load| shape(&row, *load, 30.0, 0.5))) {
        let quantity =
            format!("hole of 60° at {load} of the load with 24 waves: largest angle, rad");
        if *load <= 1.05 {
            straight(&quantity, &shape).report();
        } else {
            snaking(&quantity, &shape).report();
        }
    }
}

/// A pipe of 5 in on the floor of a level hole under 140 to 145 kN, in elements of 9.6 m, which 131
/// kN buckle between their nodes (`π² EI/L²`): the run names one, with the load that is its own. In
/// elements of 2.4 m, which are stable under sixteen times as much, none is named.
#[test]
fn elements_that_buckle_between_their_nodes_are_named() {
    let level = |length_m: f64| {
        let stations = [[0.0, 90.0, 0.0], [192.0, 90.0, 0.0]];
        let pipe = ComponentSpec::uniform(
            "pipe",
            0.127,
            0.1086,
            ComponentLength::ToSurface,
            crate::common::steel(),
        );
        let hole = vec![HoleSection::open(0.0..200.0, 0.2159, 0.1)];
        let model = model(path(&stations, Interpolation::Spline), hole, vec![pipe], 192.0);
        let slide = operation(OperationKind::Slide, 192.0)
            .weight_on_bit_N(140e3)
            .rate_of_penetration_m_per_s(1e-6);
        let mut case = Case::new(model, slide);
        case.settings.mesh = MeshSettings::uniform(length_m);
        case.settings.hoist_control = Some(HoistControl::HookLoad(-145e3));
        let ei = case.model.string.components()[0].bending_stiffness_N_m2();
        let mut simulation = case.start();
        go(&mut simulation, 8.0);
        // The answer has it where the string was on average over the window.
        let in_answer = simulation.outcome().numerics.buckled_element;
        let load_N = |element: BuckledElement| element.compression_N;
        assert_eq!(in_answer.map(load_N), simulation.buckled_element().map(load_N));
        (ei, simulation.buckled_element())
    };
    let (ei, found) = level(9.6);
    let found = found.expect("an element that buckles");
    assert!((found.length_m - 9.6).abs() < 1e-9, "{found:?}");
    let own_N = std::f64::consts::PI.powi(2) * ei / 9.6_f64.powi(2);
    assert!((found.own_load_N / own_N - 1.0).abs() < 1e-12, "{found:?}");
    assert!(found.compression_N > own_N && found.compression_N < 160e3, "{found:?}");
    assert!((0.0..192.0).contains(&found.md_m), "{found:?}");
    // Elements that are stable under four times the compression are half as long over its root.
    let bears_N = std::f64::consts::PI.powi(2) * ei / found.sufficient_length_m().powi(2);
    assert!((bears_N / found.compression_N - 4.0).abs() < 1e-9);
    assert_eq!(level(2.4).1, None);
}
