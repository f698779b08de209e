//! Tool joints of a component.

use wholestring::string::catalogue::CatalogueEntry;
use wholestring_tabular::{Column, Holds, TallyCell, TallyRow};
use wholestring_units::{Dimension, number_text, significant};

use super::{
    part::{Length, Part},
    quote::{origin, quantity, unit, written},
};
use crate::fragment::{Block, Note, Origin, Value};

/// Distances between tool joints that are usual, m: singles, and doubles of short ones.
const SPACINGS_M: [f64; 2] = [4.0, 16.0];

/// Distance between the joints of range 2 pipe (API Spec 5DP: 8.84 to 9.75 m), in the two unit
/// systems.
const RANGE_2_M: (f64, &str) = (9.6, "m");
const RANGE_2_FT: (f64, &str) = (31.5, "ft");

/// Adds tool joints; returns their diameter if the component has any.
pub(super) fn of(
    part: &Part,
    od_m: f64,
    joint_od: Option<&TallyCell>,
    has_blades: bool,
    entry: Option<&CatalogueEntry>,
    block: &mut Block,
    notes: &mut Vec<Note>,
) -> Option<f64> {
    let listed = entry.and_then(|entry| entry.joints.as_ref());
    let joint_od_m = joint_od.and_then(TallyCell::si);
    let mut left_out = |cell: &TallyCell, why: &str| {
        let text = format!("tool joints of {} ({}): {why}", written(cell), cell.place);
        notes.push(Note::LeftOut(text));
    };
    if let Some(cell) = joint_od {
        if has_blades {
            left_out(cell, "its blades touch the wall");
            return None;
        }
        if joint_od_m < Some(od_m) {
            left_out(cell, "they are thinner than the body");
            return listed.map(|joints| joints.od_m);
        }
        // A collar's connection is as thick as its body.
        if listed.is_none() && joint_od_m == Some(od_m) {
            return None;
        }
    }
    let own = joint_od.filter(|_| {
        let near = |od_m: f64| joint_od_m.is_some_and(|own_m| (own_m - od_m).abs() < 3e-4);
        !listed.is_some_and(|joints| near(joints.od_m))
    });
    if let Some(cell) = own {
        block.push("joint_od", quantity(cell), origin(cell));
    }
    if own.is_none() && listed.is_none() {
        return None;
    }
    if let Some((value, origin)) = spacing(part) {
        block.push("joint_spacing", value, origin);
    } else if listed.is_none() {
        let is_field = match (&part.length, joint_od.map(|cell| cell.holds)) {
            (Length::Of { unit, .. }, _) => unit.is_field(),
            (Length::ToSurface, Some(Holds::Quantity { unit, .. })) => unit.is_field(),
            (Length::ToSurface, _) => false,
        };
        let (number, symbol) = if is_field { RANGE_2_FT } else { RANGE_2_M };
        let because = "no number of joints or length of a joint; range 2".to_owned();
        block.push(
            "joint_spacing",
            Value::quantity(number, unit(Dimension::Length, symbol)),
            Origin::Assumed { because },
        );
        notes.push(Note::Assumed(format!(
            "'{}': a tool joint every {number} {symbol}, as in range 2",
            part.name
        )));
    }
    own.and(joint_od_m).or(listed.map(|joints| joints.od_m))
}

/// Distance between tool joints: the average length of a joint.
fn spacing(part: &Part) -> Option<(Value, Origin)> {
    let usual = |m: f64| (SPACINGS_M[0]..=SPACINGS_M[1]).contains(&m);
    if part.rows.len() == 1
        && let Some(cell) = part.row().get(Column::JointLength)
        && usual(cell.si()?)
    {
        return Some((quantity(cell), origin(cell)));
    }
    let Length::Of { number, unit, joints: Some(joints), .. } = &part.length else { return None };
    let each = significant(number / joints, 6);
    let from =
        format!("{} {} over {} joints", number_text(*number), unit.symbol, number_text(*joints));
    (*joints >= 2.0 && usual(unit.to_si(each)))
        .then(|| (Value::quantity(each, unit), Origin::Derived { from }))
}

// Joints that a tally lists one by one.

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
