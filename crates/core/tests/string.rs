//! Strength, mass and assembly of the string.

mod common;

use common::{relative_error, report_worst, steel, verification, verify};
use wholestring::string::{
    AssemblyError, Component, ComponentLength, ComponentSpec, StringSpec, ToolJoints, catalogue,
};

const INCH_M: f64 = 0.0254;
const FOOT_M: f64 = 0.3048;
const POUND_KG: f64 = 0.45359237;
const POUND_FORCE_N: f64 = POUND_KG * 9.80665;
const FOOT_POUND_N_M: f64 = FOOT_M * POUND_FORCE_N;

/// A05: body strength from dimensions. The formula's tolerance, 1e-4, is the file's; it holds the
/// rounding of the constant 0.096167.
#[test]
fn a05_drill_pipe_strength() {
    let data = verification("A05_drill_pipe_strength.json");
    let rows = data["rows"].as_array().expect("rows");
    assert!(rows.len() >= 20);
    let mut strengths = Vec::new();
    for row in rows {
        let number = |key: &str| row[key].as_f64().expect(key);
        let size = row["pipe"].as_str().expect("pipe");
        let grade = row["grade"].as_str().expect("grade");
        let pipe = catalogue::find(&format!("{size} {grade}"))
            .expect("every pipe of the file is in the catalogue")
            .component("pipe", ComponentLength::Metres(1.0), steel());
        let string =
            StringSpec { components: vec![pipe] }.assemble(1.0).expect("one metre of pipe");
        let pipe = &string.components()[0];
        let square_inch = INCH_M.powi(2);
        for (what, obtained, expected, tolerance) in [
            ("od", pipe.od_m / INCH_M, number("OD_in"), 1e-12),
            ("id", pipe.id_m / INCH_M, number("ID_in"), 1e-12),
            ("area", pipe.area_m2() / square_inch, number("area_in2"), 1e-12),
            ("J", pipe.polar_moment_m4() / square_inch.powi(2), number("J_in4"), 1e-12),
            (
                "tensile yield",
                pipe.tensile_yield_N().expect("graded") / POUND_FORCE_N,
                number("tensile_yield_lbf"),
                1e-4,
            ),
            (
                "torsional yield",
                pipe.torsional_yield_N_m().expect("graded") / FOOT_POUND_N_M,
                number("torsional_yield_ftlbf"),
                1e-4,
            ),
        ] {
            assert!(
                relative_error(obtained, expected) < tolerance,
                "{size} {grade}: {what} {obtained} for {expected}"
            );
            if what.ends_with("yield") {
                let unit = if what.starts_with("tensile") { "lbf" } else { "ft·lbf" };
                let what = format!("{what} of {size} {grade}, {unit}");
                strengths.push((what, obtained, expected));
            }
        }
    }
    report_worst(strengths.iter().map(|(what, computed, expected)| {
        verify("A05", what)
            .relative(1e-4, "rounding of the constant 0.096167 of the standard")
            .row(*expected, *computed)
    }));
}

/// A05: the same against API RP 7G's printed table, 0.01 % (the file's tolerance).
#[test]
fn a05_published_strengths() {
    let data = verification("A05_drill_pipe_strength.json");
    let table = data["tabulated_from_memory_unverified"].as_object().expect("table");
    assert_eq!(table.len(), 4);
    let mut published = Vec::new();
    for (name, strengths) in table {
        let entry = catalogue::find(name).expect("in the catalogue");
        let mut pipe = Component::uniform("", entry.od_m, entry.id_m, 1.0, steel());
        pipe.yield_strength_Pa = Some(entry.yield_strength_Pa);
        let tensile = pipe.tensile_yield_N().expect("graded") / POUND_FORCE_N;
        let torsional = pipe.torsional_yield_N_m().expect("graded") / FOOT_POUND_N_M;
        published.push((format!("printed tensile yield of {name}, lbf"), tensile, &strengths[0]));
        let what = format!("printed torsional yield of {name}, ft·lbf");
        published.push((what, torsional, &strengths[1]));
    }
    report_worst(published.iter().map(|(what, computed, expected)| {
        verify("A05", what)
            .relative(1e-4, "the table's last digit")
            .row(expected.as_f64().expect("a number"), *computed)
    }));
}

/// Worn pipe as API RP 7G prints it (from memory), 5 in 19.50 lb/ft: 560 764 lbf and 58 113 ft·lbf
/// for premium S-135, by hand from 80 % of the wall; class 2 by hand from 70 %. The last digit, and
/// the 1e-4 of the standard's constant. The strength of a joint is unchanged.
#[test]
fn worn_pipe_bears_less() {
    for (designation, pull_lbf, torque_ft_lbf, od_in) in [
        ("5 in 19.50 lb/ft S-135 premium", 560_764.0, 58_113.0, 4.8552),
        ("5 in 19.50 lb/ft E-75 class 2", 270_432.0, 27_976.0, 4.7828),
    ] {
        let entry = catalogue::find(designation).expect("in the catalogue");
        let worn = Component {
            yield_strength_Pa: Some(entry.yield_strength_Pa),
            ..Component::uniform("", entry.od_m, entry.id_m, 1.0, steel())
        };
        assert!(relative_error(entry.od_m / INCH_M, od_in) < 1e-9, "{designation}");
        let pull = worn.tensile_yield_N().expect("graded") / POUND_FORCE_N;
        let torque = worn.torsional_yield_N_m().expect("graded") / FOOT_POUND_N_M;
        assert!(relative_error(pull, pull_lbf) < 1e-4, "{designation}: {pull}");
        assert!(relative_error(torque, torque_ft_lbf) < 1e-4, "{designation}: {torque}");
        let (new, _) = designation
            .rsplit_once(if pull_lbf > 3e5 { " premium" } else { " class" })
            .expect("a class");
        let new = catalogue::find(new).expect("in the catalogue");
        assert_eq!(new.connection, entry.connection);
        assert!(new.mass_per_length_kg_per_m(7850.0) > entry.mass_per_length_kg_per_m(7850.0));
    }
}

/// Masses against the approximate weights of API RP 7G with tool joints, lb/ft, and against the
/// nominal weights of heavy-weight pipe, which are approximate weights too. 3 %: the upsets, which
/// the computed masses leave out, add 1 to 2 %, the standard's shorter spacing (31.1 ft) 0.3 %, and
/// the heavy-weight tables of two makers differ by 1.6 % (49.3 and 50.1 lb/ft).
#[test]
fn masses_are_near_the_published_ones() {
    for (designation, pounds_per_foot) in [
        ("5 in 19.50 lb/ft E-75", 20.89),
        ("5 in 19.50 lb/ft X-95", 21.44),
        ("5 in 19.50 lb/ft G-105", 21.93),
        ("5 in 19.50 lb/ft S-135", 22.61),
        ("5-1/2 in 21.90 lb/ft E-75", 23.81),
        ("5-1/2 in 21.90 lb/ft X-95", 24.43),
        ("5-1/2 in 21.90 lb/ft G-105", 25.28),
        ("5-1/2 in 21.90 lb/ft S-135", 26.40),
        ("HWDP 3-1/2 in 25.3 lb/ft", 25.3),
        ("HWDP 4 in 29.7 lb/ft", 29.7),
        ("HWDP 4-1/2 in 41.0 lb/ft", 41.0),
        ("HWDP 5 in 49.3 lb/ft", 49.3),
        ("HWDP 5-1/2 in 57.0 lb/ft", 57.0),
        ("HWDP 6-5/8 in 70.8 lb/ft", 70.8),
    ] {
        let entry = catalogue::find(designation).expect("in the catalogue");
        let obtained = entry.mass_per_length_kg_per_m(7850.0) / POUND_KG * FOOT_M;
        assert!(relative_error(obtained, pounds_per_foot) < 0.03, "{designation}: {obtained}");
    }
}

/// The plain-end weight is the nominal one within the addition of the joints and upsets (nominal
/// weights are those of threaded pipe of old): a misprinted wall would fall out.
#[test]
fn walls_fit_the_nominal_weights() {
    let entries = catalogue::entries();
    assert!(entries.len() > 90);
    for entry in entries {
        assert!(entry.id_m > 0.0 && entry.id_m < entry.od_m, "{}", entry.designation);
        let Some(joints) = &entry.joints else {
            continue;
        };
        assert!(joints.od_m > entry.od_m && joints.id_m < joints.od_m, "{}", entry.designation);
        if entry.kind == catalogue::TubularKind::DrillPipe {
            let plain = Component::uniform("", entry.od_m, entry.id_m, 1.0, steel())
                .mass_per_length_kg_per_m
                / POUND_KG
                * FOOT_M;
            let nominal: f64 = entry
                .designation
                .split(' ')
                .nth(2)
                .and_then(|weight| weight.parse().ok())
                .expect("a weight");
            let ratio = plain / nominal;
            assert!((0.87..1.0).contains(&ratio), "{}: {plain}", entry.designation);
        }
    }
}

#[test]
fn a_joint_of_another_size_changes_the_mass() {
    let mut entry = catalogue::find("5-1/2 in 21.90 lb/ft S-135").expect("in the catalogue");
    let before = entry.mass_per_length_kg_per_m(7850.0);
    let joints = entry.joints.as_mut().expect("drill pipe has joints");
    joints.od_m = 0.1778;
    joints.id_m = 0.1016;
    let after = entry.mass_per_length_kg_per_m(7850.0);
    // 18 in of ring between the two joints, the least that must go.
    let ring_m2 = std::f64::consts::FRAC_PI_4
        * ((0.1905_f64.powi(2) - 0.0762_f64.powi(2)) - (0.1778_f64.powi(2) - 0.1016_f64.powi(2)));
    assert!(before - after > 7850.0 * ring_m2 * 0.4572 / 9.6);
    assert_eq!(
        entry.component("pipe", ComponentLength::ToSurface, steel()).joints,
        Some(ToolJoints { od_m: 0.1778, spacing_m: 9.6 })
    );
}

/// Closed forms of a ring of 0.2 m by 0.1 m.
#[test]
fn sections_of_a_ring() {
    let pipe = Component::uniform("pipe", 0.2, 0.1, 10.0, steel());
    let pi = std::f64::consts::PI;
    assert!(relative_error(pipe.area_m2(), pi * 0.0075) < 1e-14);
    assert!(relative_error(pipe.inner_area_m2(), pi * 0.0025) < 1e-14);
    assert!(relative_error(pipe.second_moment_m4(), pi * 0.0015 / 64.0) < 1e-14);
    assert!(relative_error(pipe.axial_stiffness_N(), 210e9 * pi * 0.0075) < 1e-14);
    assert!(relative_error(pipe.bending_stiffness_N_m2(), 210e9 * pi * 0.0015 / 64.0) < 1e-14);
    assert!(relative_error(pipe.torsional_stiffness_N_m2(), 80e9 * pi * 0.0015 / 32.0) < 1e-14);
    // In mud a body weighs less by the mud that it displaces.
    let weight = pipe.buoyed_weight_per_length_N_per_m(1200.0);
    assert!(relative_error(weight, (7850.0 - 1200.0) * 9.80665 * pi * 0.0075) < 1e-14);
    assert_eq!(pipe.contact_radius_m(), 0.1);
    assert_eq!(pipe.tensile_yield_N(), None);
}

fn bar(length: ComponentLength) -> ComponentSpec {
    ComponentSpec::uniform("bar", 0.2, 0.1, length, steel())
}

#[test]
fn the_topmost_component_fills_up_to_the_surface() {
    let spec = StringSpec {
        components: vec![
            bar(ComponentLength::Metres(10.0)),
            bar(ComponentLength::Metres(20.0)),
            bar(ComponentLength::ToSurface),
        ],
    };
    for bit_depth_m in [30.1, 100.0, 4305.0] {
        let string = spec.assemble(bit_depth_m).expect("long enough");
        assert!((string.length_m() - bit_depth_m).abs() < 1e-9);
        assert_eq!(string.components().len(), 3);
    }
    // Nothing left: the component is not part of the string.
    let string = spec.assemble(30.0).expect("just long enough");
    assert_eq!(string.components().len(), 2);
    let string = spec.assemble(100.0).expect("long enough");
    for (distance_m, index) in
        [(-1.0, 0), (0.0, 0), (9.999, 0), (10.0, 1), (30.0, 2), (100.0, 2), (101.0, 2)]
    {
        assert_eq!(string.component_at(distance_m).0, index, "{distance_m}");
    }
    let ends: Vec<_> = string.spans().map(|span| (span.from_bit_m, span.to_bit_m)).collect();
    assert_eq!(ends, [(0.0, 10.0), (10.0, 30.0), (30.0, 100.0)]);
    let mass_per_length = bar(ComponentLength::ToSurface).mass_per_length_kg_per_m;
    assert!(relative_error(string.mass_kg(), 100.0 * mass_per_length) < 1e-14);
}

#[test]
fn lengths_that_do_not_fit_are_refused() {
    use ComponentLength::{Metres, ToSurface};
    let assemble = |lengths: &[ComponentLength], bit_depth_m: f64| {
        StringSpec { components: lengths.iter().map(|&length| bar(length)).collect() }
            .assemble(bit_depth_m)
            .map_err(|error| error.to_string())
    };
    assert!(assemble(&[Metres(40.0), Metres(60.0)], 100.0).is_ok());
    assert!(assemble(&[Metres(40.0), Metres(60.0004)], 100.0).is_ok());
    for (lengths, bit_depth_m, expected) in [
        (vec![], 100.0, "a string needs at least one component"),
        (
            vec![Metres(40.0), Metres(70.0)],
            100.0,
            "the string is 110.000 m long, longer than the bit depth of 100.000 m: adjust a length or \
             let the topmost component run \"to surface\"",
        ),
        (
            vec![Metres(40.0)],
            100.0,
            "the string is 40.000 m long, shorter than the bit depth of 100.000 m: adjust a length or \
             let the topmost component run \"to surface\"",
        ),
        (
            vec![Metres(40.0), ToSurface, ToSurface],
            100.0,
            "components 1 and 2 both run to the surface: only the topmost one can",
        ),
        (
            vec![ToSurface, Metres(40.0)],
            100.0,
            "component 0 (`bar`) runs to the surface, but has 1 above it: it must be the last",
        ),
        (
            vec![Metres(140.0), ToSurface],
            100.0,
            "the components below `bar` are 140.000 m long, but the bit is only 100.000 m deep",
        ),
    ] {
        assert_eq!(assemble(&lengths, bit_depth_m), Err(expected.to_owned()));
    }
    for bit_depth_m in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let result = StringSpec { components: vec![bar(ToSurface)] }.assemble(bit_depth_m);
        assert!(matches!(result, Err(AssemblyError::BitDepth(_))), "{bit_depth_m}");
    }
}

#[test]
fn bad_dimensions_name_component_field_and_value() {
    let refused = |change: &dyn Fn(&mut ComponentSpec)| {
        let mut components =
            vec![bar(ComponentLength::Metres(10.0)), bar(ComponentLength::ToSurface)];
        change(&mut components[1]);
        match (StringSpec { components }).assemble(100.0) {
            Err(AssemblyError::Dimension { index: 1, field, value, .. }) => (field, value),
            other => panic!("{other:?}"),
        }
    };
    let joints = |od_m, spacing_m| Some(ToolJoints { od_m, spacing_m });
    assert_eq!(refused(&|c| c.od_m = 0.1), ("id", 0.1));
    assert_eq!(refused(&|c| c.id_m = -0.1), ("id", -0.1));
    assert_eq!(refused(&|c| c.od_m = 0.0), ("od", 0.0));
    assert_eq!(refused(&|c| c.od_m = f64::INFINITY), ("od", f64::INFINITY));
    assert!(refused(&|c| c.id_m = f64::NAN).1.is_nan());
    assert_eq!(refused(&|c| c.mass_per_length_kg_per_m = 0.0), ("mass_per_length", 0.0));
    assert_eq!(refused(&|c| c.material.density_kg_per_m3 = -1.0), ("density", -1.0));
    assert_eq!(refused(&|c| c.material.youngs_modulus_Pa = 0.0), ("youngs_modulus", 0.0));
    assert_eq!(refused(&|c| c.material.shear_modulus_Pa = 0.0), ("shear_modulus", 0.0));
    assert_eq!(refused(&|c| c.joints = joints(0.19, 9.6)), ("joint_od", 0.19));
    assert_eq!(refused(&|c| c.joints = joints(0.25, 0.0)), ("joint_spacing", 0.0));
    assert_eq!(refused(&|c| c.yield_strength_Pa = Some(0.0)), ("yield_strength", 0.0));
    assert_eq!(refused(&|c| c.length = ComponentLength::Metres(-2.0)), ("length", -2.0));
    let error = StringSpec {
        components: vec![ComponentSpec { id_m: 0.3, ..bar(ComponentLength::ToSurface) }],
    }
    .assemble(100.0)
    .expect_err("the bore is wider than the bar");
    assert_eq!(
        error.to_string(),
        "component 0 (`bar`): `id` must be zero or more, and less than od, got 0.3"
    );
}
