//! The record of a case with all defaults filled in: its keys are a contract.

use std::{collections::BTreeSet, path::Path};

use serde_json::{Value as Json, json};
use wholestring_case::{Override, load};

/// Changes of a vertical well, each of which writes other keys.
const VARIANTS: &[(&str, &[&str])] = &[
    (
        "linear_contact",
        &[
            "dynamics.contact_law=linear",
            "dynamics.start=centred",
            "dynamics.start_tension=cold",
            "dynamics.settle=auto",
        ],
    ),
    (
        "excited_rate",
        &[
            "bit.excitation.amplitude=1mm",
            "bit.excitation.frequency=4Hz",
            "top_drive.control=soft-torque",
        ],
    ),
    ("regenerative", &["bit.law=regenerative"]),
    (
        "detournay",
        &["bit.law=detournay-defourny", "bit.cleaning_limit=8mm", "top_drive.control=z-torque"],
    ),
    (
        "table",
        &[
            "bit.law=table",
            "bit.table.points=[[10000,60,10,2000,100],[300000,60,30,8000,200],\
             [10000,180,15,2000,100],[300000,180,45,8000,300]]",
            "top_drive.control=pi",
        ],
    ),
    (
        "rock",
        &[
            "bit.law=rock",
            "bit.kind=inserts",
            "rock.strength=60MPa",
            "bit_test.wob=10kN",
            "records.spectra=hook_load",
        ],
    ),
    (
        "motor_in_mud",
        &[
            "mud.rheology=power-law",
            "mud.flow_behaviour_index=0.7",
            "mud.consistency_index=0.5Pa.s^n",
            "operation.flow_rate=2000L/min",
            "bit.motor.displacement=0.02m3",
            "bit.motor.max_differential_pressure=60bar",
            "bit.motor.stall_torque=20kN.m",
            "bit.motor.rated_flow=3000L/min",
        ],
    ),
    (
        "hook_load_in_rough_hole",
        &["hoist.control=hook-load", "hoist.hook_load=900kN", "well.roughness.rms=2mm"],
    ),
    (
        "schedule",
        &[
            "operation.schedule=[{at=\"10 s\",rpm=100,ramp=\"2 s\",note=\"x\"},{at=\"20 s\",wob=\"20 kN\"}]",
        ],
    ),
];

fn settings(changes: &[&str]) -> Json {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/vertical.toml");
    let drilling = [
        "model=dynamic",
        "operation.kind=drill",
        "operation.rpm=120",
        "operation.wob=50kN",
        "operation.rop=10m/h",
    ];
    let changes: Vec<Override> =
        drilling.iter().chain(changes).map(|text| text.parse().expect("KEY=VALUE")).collect();
    let case = load(&file, &changes).unwrap_or_else(|report| panic!("{}", report.render(false)));
    case.settings
}

/// Every key and value of one case, and the differences of the others.
#[test]
fn are_on_record() {
    let plain = settings(&[]);
    insta::assert_snapshot!("plain", serde_json::to_string_pretty(&plain).expect("JSON"));
    for (name, changes) in VARIANTS {
        let changed = settings(changes);
        let tables = |record: &Json| record.as_object().expect("tables").clone();
        let (plain, changed) = (tables(&plain), tables(&changed));
        let different = changed.iter().filter(|(key, value)| plain.get(*key) != Some(value));
        let different: Json = different
            .map(|(key, value)| (key.clone(), value.clone()))
            .collect::<serde_json::Map<_, _>>()
            .into();
        insta::assert_snapshot!(*name, serde_json::to_string_pretty(&different).expect("JSON"));
    }
}

/// Parts that a component does not have are not keys.
#[test]
fn components_without_joints_or_bends_do_not_speak_of_them() {
    let keys = |component: &Json| -> BTreeSet<String> {
        component.as_object().expect("a table").keys().cloned().collect()
    };
    let plain = settings(&[]);
    let bent = settings(&["string.1.bend=1deg", "string.1.bend_at=1m"]);
    let more: Vec<String> =
        keys(&bent["string"][1]).difference(&keys(&plain["string"][1])).cloned().collect();
    assert_eq!(more, ["bend_at_m", "bend_rad", "bend_toolface_rad"]);
    assert_eq!(bent["string"][1]["bend_at_m"], json!(1.0));
    for component in plain["string"].as_array().expect("components") {
        assert!(!keys(component).contains("eccentricity_m"));
    }
}
