//! Strings whose results are judged.

use wholestring::{
    prelude::*,
    statics::{soft, soft::SoftSettings},
};
use wholestring_judge::{Check, CheckKind, Judge, Verdict};

use crate::common::*;

/// A horizontal well: vertical to 500 m, a quarter circle to 1400 m, then horizontal to `to_m`.
pub fn lateral(to_m: f64, mu: f64) -> Model {
    let stations = [[0.0, 0.0, 0.0], [500.0, 0.0, 0.0], [1400.0, 90.0, 0.0], [to_m, 90.0, 0.0]];
    five_inch(&stations, 0.2159, mu, 260.0)
}

/// Plain 5 in pipe of a weight per metre in air, in air, with the bit at the last station.
pub fn five_inch(stations: &[[f64; 3]], hole_m: f64, mu: f64, weight_N_per_m: f64) -> Model {
    let path = arcs(stations);
    let bit_depth_m = path.last_md_m();
    let hole = open_hole(hole_m, mu, bit_depth_m);
    let pipe = ComponentSpec {
        mass_per_length_kg_per_m: weight_N_per_m / wholestring::GRAVITY_M_PER_S2,
        ..ComponentSpec::uniform("pipe", 0.127, 0.1086, ComponentLength::ToSurface, steel())
    };
    model(path, hole, vec![pipe], mud(0.0), bit_depth_m)
}

/// The checks of a soft string that need attention.
pub fn soft_checks(model: &Model, operation: &Operation) -> Vec<Check> {
    let profile = soft::solve(model, operation, &SoftSettings::default()).expect("a sound model");
    open(Judge::default().soft(model, operation, &profile).checks)
}

/// The checks that need attention, marginal limits apart.
pub fn open(checks: Vec<Check>) -> Vec<Check> {
    let is_open = |check: &Check| !check.is_ok() && check.verdict != Verdict::Marginal;
    checks.into_iter().filter(is_open).collect()
}

/// The bit at the end of the string, with a weight on it.
pub fn at_full_depth(kind: OperationKind, model: &Model, weight_on_bit_N: f64) -> Operation {
    pressing(kind, model.string.length_m(), weight_on_bit_N)
}

pub fn only(found: &[Check], kind: CheckKind) -> Option<Check> {
    let mut all = found.iter().filter(|check| check.kind == kind);
    let first = all.next().cloned();
    assert!(all.next().is_none(), "{kind:?} twice: {found:?}");
    first
}

#[track_caller]
pub fn none(found: &[Check], kind: CheckKind) {
    assert_eq!(found.iter().find(|check| check.kind == kind), None);
}
