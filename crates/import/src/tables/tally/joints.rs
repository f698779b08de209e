//! Tool joints of a component.

use wholestring::string::catalogue::CatalogueEntry;
use wholestring_tabular::{Column, Holds, TallyCell};
use wholestring_units::{Dimension, number_text, significant};

use super::{
    length::Length,
    part::Part,
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
