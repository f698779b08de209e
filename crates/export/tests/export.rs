//! Written formats, and the equality of data that are read again.

use insta::assert_snapshot;
use wholestring::well::{Station, TieIn};
use wholestring_export::{
    Component, Curve, Log, Look, Version, logs, rows, survey_report, trajectory, tubular,
};
use wholestring_units::{Dimension, UnitSet};

fn look(units: UnitSet) -> Look {
    Look {
        name: "S-1 <ST1> & \"more\"".to_owned(),
        created: "2026-01-31T12:00:00Z".to_owned(),
        program: "wholestring 0.1.0".to_owned(),
        units,
    }
}

fn stations() -> Vec<Station> {
    let station = |md_m, inclination: f64, azimuth: f64| Station {
        md_m,
        inclination_rad: inclination.to_radians(),
        azimuth_rad: azimuth.to_radians(),
    };
    vec![
        station(0.0, 0.0, 0.0),
        station(1000.0, 0.0, 0.0),
        station(1030.0, 3.125, 359.5),
        station(1060.123456, 6.25, -10.5),
        station(4000.0, 91.0, 370.0),
    ]
}

const TIE_IN: TieIn = TieIn { north_m: 12.5, east_m: -3.25, tvd_m: 0.0 };

/// Lengths are written to a hundredth of a foot, angles to a thousandth of a degree: the rounding
/// error is at most half of that.
#[test]
fn a_report_is_read_again() {
    let rows = rows(&stations(), TIE_IN).unwrap();
    for (units, length_m) in [(UnitSet::Si, 0.01), (UnitSet::Field, 0.01 * 0.3048)] {
        let text = survey_report(&look(units), &rows);
        let read = wholestring_tabular::read(text.as_bytes(), "survey.txt").unwrap();
        assert_eq!(read.stations.len(), rows.len());
        for ((read, written), stated) in read.stations.iter().zip(&rows).zip(&read.stated) {
            let near = |a: f64, b: f64, unit: f64| (a - b).abs() <= 0.5001 * unit;
            assert!(near(read.md_m, written.md_m, length_m), "{read:?}");
            let degree = |rad: f64| rad.to_degrees();
            assert!(near(degree(read.inclination_rad), degree(written.inclination_rad), 1e-3));
            assert!(near(degree(read.azimuth_rad), degree(written.azimuth_rad), 1e-3));
            assert!(near(stated.tvd_m.unwrap(), written.tvd_m, length_m));
            assert!(near(stated.north_m.unwrap(), written.north_m, length_m));
            assert!(near(stated.east_m.unwrap(), written.east_m, length_m));
            assert!(stated.dogleg_severity_rad_per_m.is_some());
        }
        assert_eq!(read.preamble[0].value, look(units).name);
    }
}

#[test]
fn what_a_report_looks_like() {
    assert_snapshot!(survey_report(&look(UnitSet::Field), &rows(&stations(), TIE_IN).unwrap()));
}

#[test]
fn trajectories() {
    let rows = rows(&stations()[2..4], TieIn { tvd_m: 1029.97, ..TIE_IN }).unwrap();
    assert_snapshot!("v1411", trajectory(&look(UnitSet::Field), &rows, Version::V1411).unwrap());
    assert_snapshot!("v20", trajectory(&look(UnitSet::Si), &rows, Version::V20).unwrap());
    assert_snapshot!("v21", trajectory(&look(UnitSet::Si), &rows, Version::V21).unwrap());
}

fn components() -> Vec<Component> {
    let component = |name: &str, length_m, od_m, id_m| Component {
        name: name.to_owned(),
        length_m,
        od_m,
        id_m,
        mass_per_length_kg_per_m: 100.0,
        ..Component::default()
    };
    vec![
        component("8 1/2\" PDC bit", 0.3, 0.2159, 0.0),
        Component {
            blade_od_m: Some(0.2127),
            blade_length_m: Some(0.4),
            ..component("near-bit stabiliser", 1.5, 0.17145, 0.07)
        },
        component("heavy-weight drill pipe", 100.0, 0.127, 0.0762),
        Component {
            joint_od_m: Some(0.168),
            joint_spacing_m: Some(9.6),
            yield_strength_Pa: Some(9.308e8),
            ..component("5 in drill pipe", 2900.0, 0.127, 0.1086)
        },
        component("thing", 1.0, 0.127, 0.1),
    ]
}

#[test]
fn tubulars() {
    let field = tubular(&look(UnitSet::Field), &components(), Version::V1411).unwrap();
    assert_snapshot!("tubular_v1411", field);
    assert_snapshot!(
        "tubular_v20",
        tubular(&look(UnitSet::Metric), &components()[3..], Version::V20).unwrap()
    );
    let metric = tubular(&look(UnitSet::Metric), &components(), Version::V21).unwrap();
    assert_snapshot!("tubular_v21", metric);
}

#[test]
fn logs_against_depth() {
    let log = |name: &str| Log {
        name: name.to_owned(),
        bit_depths_m: vec![500.0, 1000.0, 1500.5],
        curves: vec![
            Curve {
                mnemonic: "HKLD",
                class: "hookload (average)",
                meaning: "Hook load",
                dimension: Dimension::Force,
                values: vec![Some(4.448_221_615_260_5e5), None, Some(1.0 / 3.0)],
            },
            Curve {
                mnemonic: "TORQUE",
                class: "torque (average)",
                meaning: "Torque",
                dimension: Dimension::Torque,
                values: vec![Some(0.0), Some(-0.0), Some(f64::NAN)],
            },
        ],
    };
    let both = [log("pick-up, soft string"), log("slack-off, soft string")];
    assert_snapshot!("log_v1411", logs(&look(UnitSet::Field), &both, Version::V1411).unwrap());
    assert_snapshot!("log_v20", logs(&look(UnitSet::Si), &both[..1], Version::V20).unwrap());
    assert_snapshot!("log_v21", logs(&look(UnitSet::Si), &both[..1], Version::V21).unwrap());
}

/// Symbols of WITSML are known to the unit parser.
#[test]
fn units_are_known() {
    for units in [UnitSet::Si, UnitSet::Field] {
        let text = tubular(&look(units), &components(), Version::V1411).unwrap();
        for part in text.split("<").filter_map(|part| part.split_once(" uom=\"")) {
            let symbol = part.1.split('"').next().unwrap();
            let dimension = match part.0 {
                "od" | "id" | "odMx" | "odBladeMx" => Dimension::Diameter,
                "wtPerLen" => Dimension::MassPerLength,
                "tensYield" => Dimension::Stress,
                _ => Dimension::Length,
            };
            assert!(dimension.find_unit(symbol).is_some(), "{symbol}");
        }
    }
}
