//! Joints that a tally lists one by one.

use wholestring_tabular::{Column, TallyRow};
use wholestring_units::significant;

use super::{length::Length, part::Part};
use crate::fragment::{Note, Origin};

/// Number of identical consecutive rows from which they are joints of one component.
const FEWEST: usize = 5;

/// Combines joints that differ only in length into one component.
pub(crate) fn join<'a>(parts: Vec<Part<'a>>, notes: &mut Vec<Note>) -> Vec<Part<'a>> {
    let mut joined: Vec<Part> = Vec::new();
    for run in parts.chunk_by(is_alike) {
        let [first, .., last] = run else {
            joined.extend_from_slice(run);
            continue;
        };
        let lengths: Option<f64> = run.iter().map(|part| part.length.si_m()).sum();
        let (Some(length_m), Length::Of { unit, .. }) = (lengths, &first.length) else {
            joined.extend_from_slice(run);
            continue;
        };
        if run.len() < FEWEST {
            joined.extend_from_slice(run);
            continue;
        }
        let count = run.len();
        let from = format!("{count} joints, {} to {}", first.row().place, last.row().place);
        notes.push(Note::Read(format!("'{}': {from}, are one component", first.name)));
        // Twelve digits, without the rounding error of a sum.
        let number = significant(unit.from_si(length_m), 12);
        let length = Length::Of {
            number,
            unit,
            origin: Origin::Derived { from: format!("the sum of {from}") },
            joints: Some(count as f64),
        };
        let rows = run.iter().flat_map(|part| part.rows.iter().copied()).collect();
        joined.push(Part { rows, name: first.name.clone(), length });
    }
    joined
}

fn is_alike(one: &Part, other: &Part) -> bool {
    let is_joint = |part: &Part| {
        let joints = part.row().get(Column::Joints).and_then(|cell| cell.count());
        joints.is_none_or(|joints| joints == 1.0) && part.length.si_m().is_some()
    };
    let same = |column: Column| {
        let si = |row: &TallyRow| row.get(column).and_then(|cell| cell.si());
        si(one.row()) == si(other.row())
    };
    let same_words = |column: Column| {
        let words = |row: &TallyRow| row.get(column).map(|cell| cell.written.clone());
        words(one.row()) == words(other.row())
    };
    let plain = |name: &str| {
        name.trim_end_matches(|c: char| c.is_ascii_digit() || "# .-".contains(c)).to_lowercase()
    };
    is_joint(one)
        && is_joint(other)
        && plain(&one.name) == plain(&other.name)
        && [one, other].iter().all(|part| part.row().get(Column::Gauge).is_none())
        && [
            Column::OutsideDiameter,
            Column::InsideDiameter,
            Column::Mass,
            Column::NominalMass,
            Column::JointOutsideDiameter,
            Column::JointInsideDiameter,
            Column::YieldStrength,
            Column::BladeLength,
            Column::MetalDensity,
            Column::YoungsModulus,
            Column::ShearModulus,
        ]
        .into_iter()
        .all(same)
        && [Column::Connection, Column::Grade].into_iter().all(same_words)
}
