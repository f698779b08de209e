//! Sentences of every kind.

use std::collections::BTreeSet;

use wholestring::outcome::{ModelKind, Scalars};
use wholestring_results::{Friction, Status};

use super::*;

fn solved(model: ModelKind) -> OperationSummary {
    OperationSummary {
        model,
        operation: "slide".into(),
        status: Status::Complete,
        friction: Friction::Uniform(0.3),
        bit_depth_m: 4500.0,
        findings: Vec::new(),
        scalars: Scalars {
            hook_load_N: -257.9e3,
            surface_torque_N_m: 3e3,
            friction_torque_N_m: 0.0,
            axial_friction_N: 0.0,
            side_force_total_N: 0.0,
            weight_on_bit_N: 49e3,
            bit_torque_N_m: 3e3,
            twist_rad: 0.0,
            stretch_m: 0.0,
            neutral_point_m: None,
            cutoff_depth_m: None,
        },
        lift: None,
        hydraulics: None,
        at_rest: None,
        statistics: None,
        indicators: None,
        bit_table: None,
        numerics: None,
    }
}

fn found(kind: Kind, level: Level, value: f64, limit: f64) -> Finding {
    Finding { kind, level, from_md_m: None, to_md_m: None, value: Some(value), limit: Some(limit) }
}

fn around(rig: &Rig, units: UnitSet) -> Around<'_> {
    Around { rig, has_helix_friction: true, units }
}

#[test]
fn every_kind_has_a_sentence_of_its_own() {
    let of = solved(ModelKind::Dynamic);
    let said = |kind: &Kind| {
        let found = found(*kind, Level::Warning, -300e3, 1.0);
        sentence(&found, &of, &around(&Rig::default(), UnitSet::Si))
    };
    let all: BTreeSet<String> = Kind::ALL.iter().map(said).collect();
    assert_eq!(all.len(), Kind::ALL.len(), "{all:#?}");
    for text in &all {
        assert!(text.starts_with(char::is_uppercase), "{text}");
        assert!(!text.contains("NaN") && !text.ends_with('.'), "{text}");
    }
}

#[test]
fn the_hook_load_is_told_with_and_without_the_block() {
    let of = solved(ModelKind::Soft);
    let negative = found(Kind::HookLoadNegative, Level::Error, -257.9e3, 0.0);
    let said = |rig: &Rig, level| {
        let found = Finding { level, ..negative };
        sentence(&found, &of, &around(rig, UnitSet::Si))
    };
    assert_eq!(
        said(&Rig::default(), Level::Error),
        "The string does not go down by its weight: hook load -257.9 kN"
    );
    let rig = Rig { block_weight_N: Some(300e3), ..Rig::default() };
    assert_eq!(
        said(&rig, Level::Warning),
        "The string does not go down by its weight, the block pushes it: hook load \
         -257.9 kN, 42.1 kN with the block"
    );
    let heavy = found(Kind::HoistOverloaded, Level::Error, 1200e3, 1000e3);
    assert_eq!(
        sentence(&heavy, &of, &around(&rig, UnitSet::Si)),
        "Hook load with block of 1200 kN (900 kN without) exceeds the hoist's capacity of 1000 kN"
    );
}

#[test]
fn rated_and_peak_torque_are_told_apart() {
    let rig = Rig {
        top_drive_torque_N_m: Some(40e3),
        top_drive_peak_torque_N_m: Some(60e3),
        pump_pressure_limit_Pa: Some(30e6),
        ..Rig::default()
    };
    let said = |kind, level, value, limit| {
        let found = found(kind, level, value, limit);
        sentence(&found, &solved(ModelKind::Soft), &around(&rig, UnitSet::Si))
    };
    assert_eq!(
        said(Kind::TopDriveOverloaded, Level::Error, 65e3, 60e3),
        "Surface torque of 65 kN.m exceeds the top drive's peak torque of 60 kN.m"
    );
    assert_eq!(
        said(Kind::TopDriveOverloaded, Level::Note, 55e3, 40e3),
        "Surface torque of 55 kN.m exceeds the top drive's rated torque of 40 kN.m at times, \
         within its peak torque of 60 kN.m"
    );
    assert_eq!(
        said(Kind::PumpPressure, Level::Error, 32e6, 30e6),
        "Pump pressure of 32 MPa exceeds the limit of 30 MPa"
    );
}

#[test]
fn a_rig_that_pushes_is_told_of_its_push() {
    let rig = Rig { snubbing_force_N: Some(200e3), ..Rig::default() };
    let said = |value_N, level, rig: &Rig| {
        let found = found(Kind::HookLoadNegative, level, value_N, -200e3);
        sentence(&found, &solved(ModelKind::Soft), &around(rig, UnitSet::Si))
    };
    assert_eq!(
        said(-257.9e3, Level::Error, &rig),
        "The rig does not push the string down: hook load -257.9 kN, the rig pushes with 200 kN at \
         most"
    );
    assert_eq!(
        said(-280e3, Level::Warning, &rig),
        "The rig pushes with all of its 200 kN at times: hook load down to -280 kN"
    );
    let with_block = Rig { block_weight_N: Some(100e3), ..rig };
    assert_eq!(
        said(-257.9e3, Level::Warning, &with_block),
        "The rig pushes the string down with all of its 200 kN and the block: hook load -257.9 kN, \
         -157.9 kN with the block"
    );
}

#[test]
fn lock_up_tells_what_arrives() {
    let of = solved(ModelKind::Dynamic);
    let said = |asked_N, arrives_N| {
        let found = found(Kind::LockUp, Level::Error, asked_N, arrives_N);
        sentence(&found, &of, &around(&Rig::default(), UnitSet::Si))
    };
    assert_eq!(
        said(49e3, 24e3),
        "Lock-up: with all of its weight slacked off the string brings 24 kN of 49 kN to the bit"
    );
    assert_eq!(
        said(0.0, -30e3),
        "Lock-up: with all of its weight slacked off the string stands; at the \
         bit 30 kN are missing"
    );
    assert!(said(0.0, 0.0).ends_with("does not follow the block"));
}

#[test]
fn buckled_stretches_are_told_in_the_units_of_the_case() {
    let of = solved(ModelKind::Dynamic);
    let buckled = Finding {
        from_md_m: Some(457.2),
        to_md_m: Some(1021.08),
        ..found(Kind::HelicalBuckling, Level::Warning, 444_822.0, 222_411.0)
    };
    assert_eq!(
        sentence(&buckled, &of, &around(&Rig::default(), UnitSet::Field)),
        "Buckled to a helix from 1500 ft to 3350 ft: compression of 100 klbf \
         where 50 klbf is critical"
    );
}
