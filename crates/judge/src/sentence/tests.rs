//! Sentences of every kind.

use std::collections::BTreeSet;

use super::*;
use crate::{Descent, LimitSettings, Severity};

/// The words of a check in these units.
struct InUnits<'a>(Words<'a>, UnitSet);

impl InUnits<'_> {
    fn sentence(&self, check: &Check) -> String {
        Wording::from(self.0.sentence(check)).in_units(self.1)
    }

    fn lock_up(&self, descent: &Descent, check: &Check) -> String {
        Wording::from(self.0.lock_up(descent, check)).in_units(self.1)
    }
}

fn words(model: ModelKind, rig: &Rig, units: UnitSet) -> InUnits<'_> {
    let words = Words {
        held_hook_load_N: None,
        rig,
        model,
        has_helix_friction: true,
        hook_load_N: -257.9e3,
        weight_on_bit_N: 49e3,
        indicators: None,
        bit_table: None,
        statistics: &[],
        bit_travel_m: 0.0,
        buckled_element: None,
    };
    InUnits(words, units)
}

fn reported(kind: CheckKind, severity: Severity, value: f64, limit: f64) -> Check {
    Check::reported(kind, severity).value(value).limit(limit)
}

#[test]
fn every_kind_has_a_sentence_of_its_own() {
    let rig = Rig::default();
    let words = words(ModelKind::Dynamic, &rig, UnitSet::Si);
    let sentence = |kind: &CheckKind| {
        let check = match kind.is_limit() {
            true => Check::load(*kind, 300e3, 1.0, 1.1).expect("a load"),
            false => reported(*kind, Severity::Warning, -300e3, 1.0),
        };
        words.sentence(&check)
    };
    let all: BTreeSet<String> = CheckKind::ALL.iter().map(sentence).collect();
    assert_eq!(all.len(), CheckKind::ALL.len(), "{all:#?}");
    for sentence in &all {
        assert!(sentence.starts_with(char::is_uppercase), "{sentence}");
        assert!(!sentence.contains("NaN") && !sentence.ends_with('.'), "{sentence}");
    }
}

#[test]
fn the_hook_load_is_given_with_and_without_the_block() {
    let sentence = |rig: &Rig, severity| {
        let check = reported(CheckKind::GoesDown, severity, -257.9e3, 0.0);
        words(ModelKind::Soft, rig, UnitSet::Si).sentence(&check)
    };
    assert_eq!(
        sentence(&Rig::default(), Severity::Error),
        "The string does not go down by its weight: hook load -257.9 kN"
    );
    let rig = Rig { block_weight_N: Some(300e3), ..Rig::default() };
    assert_eq!(
        sentence(&rig, Severity::Warning),
        "The string does not go down by its weight, the block pushes it: hook load \
         -257.9 kN, 42.1 kN with the block"
    );
    let heavy = Check::load(CheckKind::Hoist, 1200e3, 1000e3, 1.0 / 0.9).expect("a load");
    assert_eq!(
        words(ModelKind::Soft, &rig, UnitSet::Si).sentence(&heavy),
        "Hoist: load 1200 kN (hook load 900 kN and block 300 kN), capacity 1000 kN, factor 0.83, \
         required 1.11: exceeded"
    );
}

#[test]
fn a_torque_above_the_rating_at_times_is_within_the_peak() {
    let rig = Rig::default();
    let words = words(ModelKind::Soft, &rig, UnitSet::Si);
    let rated = Check::load(CheckKind::TopDrive, 55e3, 40e3, 1.0).expect("a load");
    assert_eq!(
        words.sentence(&rated.clone().at_most(Severity::Note)),
        "Top drive, continuous: load 55 kN.m, capacity 40 kN.m, factor 0.73, required 1.00: exceeded \
         at times, within the peak torque"
    );
    assert!(words.sentence(&rated).ends_with("required 1.00: exceeded"));
}

#[test]
fn a_rig_that_pushes_is_named_with_its_push() {
    let rig = Rig { snubbing_force_N: Some(200e3), ..Rig::default() };
    let sentence = |value_N, severity, rig: &Rig| {
        let check = reported(CheckKind::GoesDown, severity, value_N, -200e3);
        words(ModelKind::Soft, rig, UnitSet::Si).sentence(&check)
    };
    assert_eq!(
        sentence(-257.9e3, Severity::Error, &rig),
        "The rig does not push the string down: hook load -257.9 kN, largest push 200 kN"
    );
    assert_eq!(
        sentence(-280e3, Severity::Warning, &rig),
        "The rig pushes with all of its 200 kN at times: hook load down to -280 kN"
    );
    // A hook load within the push: what holds the string is its helix.
    assert_eq!(
        sentence(14.5e3, Severity::Error, &rig),
        "The rig does not push the string down, for its helix absorbs the push: hook load 14.5 kN, \
         largest push 200 kN"
    );
    let with_block = Rig { block_weight_N: Some(100e3), ..rig };
    assert_eq!(
        sentence(-257.9e3, Severity::Warning, &with_block),
        "The rig pushes the string down with all of its 200 kN and the block: hook load -257.9 kN, \
         -157.9 kN with the block"
    );
}

#[test]
fn lock_up_names_what_arrives() {
    let rig = Rig::default();
    let sentence = |requested_N, arrives_N, absorbed_above_md_m| {
        let descent = Descent {
            hook_load_N: -10e3,
            block_N: None,
            injector_N: None,
            drag_N: 100e3,
            requested_N,
            arrives_N,
            absorbed_above_md_m,
            locks_up: true,
            by_its_weight: false,
            is_unaided: false,
            in_time: true,
        };
        let check =
            Check::load(CheckKind::LockUp, 1.0, 0.5, LimitSettings::default().factors.lock_up);
        words(ModelKind::Dynamic, &rig, UnitSet::Si).lock_up(&descent, &check.expect("a load"))
    };
    assert_eq!(
        sentence(49e3, 24e3, None),
        "Lock-up: with all of its weight slacked off, only 24 kN of 49 kN of the requested weight \
         reaches the bit"
    );
    assert_eq!(
        sentence(49e3, -30e3, Some(357.0)),
        "Lock-up: with all of its weight slacked off, the string stops; 79 kN short of the requested \
         weight on bit; any further push from above 357 m is absorbed by the helix"
    );
    assert_eq!(
        sentence(0.0, -30e3, None),
        "Lock-up: with all of its weight slacked off, the string stops; 30 kN more force is \
         needed to move it"
    );
    assert!(sentence(0.0, 0.0, None).ends_with("does not follow the block"));
}

#[test]
fn buckled_stretches_are_given_in_the_units_of_the_case() {
    let check = Check::load(CheckKind::HelicalBuckling, 444_822.0, 222_411.0, 1.0).expect("a load");
    let rig = Rig::default();
    assert_eq!(
        words(ModelKind::Dynamic, &rig, UnitSet::Field)
            .sentence(&check.clone().over([457.2, 1021.08])),
        "Buckled to a helix from 1500 ft to 3350 ft: compression 100 klbf, critical 50 klbf"
    );
    // A stretch that is shorter than the unit of a depth is a place.
    assert_eq!(
        words(ModelKind::Dynamic, &rig, UnitSet::Field).sentence(&check.over([457.2, 457.3])),
        "Buckled to a helix at 1500 ft: compression 100 klbf, critical 50 klbf"
    );
}

/// The weight on bit of a hoist that holds a hook load follows from that load.
#[test]
fn a_held_hook_load_explains_the_weight_on_bit() {
    let rig = Rig::default();
    let InUnits(free, units) = words(ModelKind::Dynamic, &rig, UnitSet::Si);
    let check = reported(CheckKind::WeightOnBitExceeded, Severity::Error, 211.8e3, 30e3);
    let sentence = |words| InUnits(words, units).sentence(&check);
    let plain = "The weight on bit of 30 kN is exceeded: 211.8 kN on average";
    assert_eq!(
        sentence(Words { held_hook_load_N: Some(80e3), ..free }),
        format!("{plain}, which follows from the hook load of 80 kN that the hoist holds")
    );
    let InUnits(free, _) = words(ModelKind::Dynamic, &rig, UnitSet::Si);
    assert_eq!(sentence(free), plain);
}
