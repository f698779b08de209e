//! Lengths of the components of a tally.

use wholestring_tabular::{Column, Holds, TallyCell, TallyRow};
use wholestring_units::{Dimension, number_text, significant};

use super::{
    part::{Length, Refusal},
    quote::origin,
    sums,
};
use crate::{
    choices::Choices,
    error::ImportErrorKind,
    fragment::{Note, Origin},
};

/// Length of a joint of pipe or collar, m: range 1 begins at 5.5 m (18 ft), range 3 ends at 14.6 m
/// (48 ft) (API Spec 5DP), and pup joints and casing slightly exceed this range.
const JOINT_M: [f64; 2] = [5.0, 16.0];

/// Number of joints from which their mean length is judged, and that of the shortest, m.
const FEWEST_JOINTS: f64 = 4.0;
const SHORT_M: f64 = 3.0;

/// Lengths of a component that a case accepts, m.
const LENGTHS_M: [f64; 2] = [0.01, 20_000.0];

/// Meaning of the column of lengths for rows of several joints.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Meaning {
    Total,
    Each,
}

/// Returns the lengths of all rows.
pub(crate) fn of(
    rows: &[TallyRow],
    names: &[String],
    choices: &Choices,
    notes: &mut Vec<Note>,
) -> Result<Vec<Length>, Refusal> {
    let several = rows.iter().any(|row| counted(row).is_some());
    let meaning = if several { meaning(rows, names, choices, notes)? } else { Meaning::Total };
    let lengths = rows.iter().zip(names).map(|(row, name)| length(row, name, meaning));
    let lengths: Vec<Length> = lengths.collect::<Result<_, _>>()?;
    notes.extend(rows.iter().zip(names).zip(&lengths).filter_map(|((row, name), length)| {
        Some(Note::Warning(format!("'{name}' ({}): {}", row.place, unlike_joints(length)?)))
    }));
    Ok(lengths)
}

/// Doubt of a length that makes joints of it which no pipe has, with the unit in which they would be
/// usual.
fn unlike_joints(length: &Length) -> Option<String> {
    let Length::Of { number, unit, joints: Some(joints), .. } = length else { return None };
    if *joints < FEWEST_JOINTS {
        return None;
    }
    let each = number / joints;
    let is_joint = |m: f64| (JOINT_M[0]..=JOINT_M[1]).contains(&m);
    // Short drill collars and pup joints.
    if (SHORT_M..=JOINT_M[1]).contains(&unit.to_si(each)) {
        return None;
    }
    let rounded = number_text(significant(each, 4));
    let found = format!(
        "{} joints in {} {} are {rounded} {} each, and joints are {} to {} m long",
        number_text(*joints),
        number_text(*number),
        unit.symbol,
        unit.symbol,
        JOINT_M[0],
        JOINT_M[1]
    );
    let others = ["m", "ft"].into_iter().filter(|other| *other != unit.symbol);
    let mut others = others.filter_map(|other| Dimension::Length.find_unit(other));
    Some(match others.find(|other| is_joint(other.to_si(each))) {
        Some(other) => format!(
            "{found}: {rounded} {} would be usual; IS THE UNIT of the lengths {} and not {}?",
            other.symbol, other.symbol, unit.symbol
        ),
        None => format!("{found}; is the length or the number of joints wrong?"),
    })
}

/// Number of joints and length of a row of several joints whose length may be that of each.
fn counted(row: &TallyRow) -> Option<(f64, &TallyCell)> {
    let joints = row.get(Column::Joints)?.count().filter(|&joints| joints > 1.0)?;
    let length = row.get(Column::Length)?;
    (row.get(Column::JointLength).is_none() && length.si().is_some()).then_some((joints, length))
}

/// Determines whether lengths are those of all joints or of each: from the user's choice, the
/// cumulative length, or typical joint lengths.
fn meaning(
    rows: &[TallyRow],
    names: &[String],
    choices: &Choices,
    notes: &mut Vec<Note>,
) -> Result<Meaning, Refusal> {
    match choices.picked("length") {
        Some("total") => return Ok(Meaning::Total),
        Some("each") => return Ok(Meaning::Each),
        Some(other) => {
            let kind = ImportErrorKind::NoSuch {
                what: "length".to_owned(),
                name: other.to_owned(),
                names: ["total", "each"].map(str::to_owned).to_vec(),
            };
            return Err((None, kind));
        }
        None => {}
    }
    // An unreadable length is refused later.
    let as_meant = |meaning| {
        let lengths = rows.iter().zip(names).map(|(row, name)| length(row, name, meaning));
        let lengths: Result<Vec<Length>, Refusal> = lengths.collect();
        let steps = lengths.map(|lengths| sums::steps(rows, &lengths));
        steps.map_or(0, |steps| steps.grow.max(steps.fall))
    };
    let (total, each) = (as_meant(Meaning::Total), as_meant(Meaning::Each));
    let column = counted_heading(rows);
    let sentence = |joints: &str, why: &str| format!("{column} is that of {joints}: {why}");
    if total > each {
        notes.push(Note::Checked(sentence("all joints", "the cumulative lengths confirm it")));
        return Ok(Meaning::Total);
    }
    if each > total {
        notes.push(Note::Checked(sentence("each joint", "the cumulative lengths confirm it")));
        return Ok(Meaning::Each);
    }
    let is_joint = |length_m: f64| (JOINT_M[0]..=JOINT_M[1]).contains(&length_m);
    for (row, (joints, length)) in rows.iter().filter_map(|row| Some((row, counted(row)?))) {
        let length_m = length.si().unwrap_or_default();
        if !is_joint(length_m / joints) && is_joint(length_m) {
            let sentence = format!(
                "the length '{}' of {} joints may be that of all or of each, and no cumulative \
                 length decides; choose with --pick length=total or --pick length=each",
                length.written,
                number_text(joints)
            );
            return Err((Some(row.place.clone()), ImportErrorKind::Refused(sentence)));
        }
    }
    notes.push(Note::Assumed(sentence(
        "all joints",
        "divided by their number it is the length of \
         a joint",
    )));
    Ok(Meaning::Total)
}

fn counted_heading(rows: &[TallyRow]) -> String {
    let cell = rows.iter().find_map(counted).map(|(_, cell)| cell.place.as_str());
    cell.map_or_else(|| "the length".to_owned(), |place| format!("the length ({place})"))
}

/// Returns the length of a row.
fn length(row: &TallyRow, name: &str, meaning: Meaning) -> Result<Length, Refusal> {
    let is_open = row.cells.iter().any(|cell| cell.holds == Holds::ToSurface);
    let lower = name.to_lowercase();
    if is_open || lower.ends_with("to surface") {
        return Ok(Length::ToSurface);
    }
    let joints = row.get(Column::Joints).and_then(TallyCell::count);
    let found = |cell: &TallyCell, joints| match cell.holds {
        Holds::Quantity { number, unit, .. } => {
            Some(Length::Of { number, unit, origin: origin(cell), joints })
        }
        _ => None,
    };
    let times = |cell: &TallyCell, joints: f64| match cell.holds {
        Holds::Quantity { number, unit, .. } => Some(Length::Of {
            number: number * joints,
            unit,
            origin: Origin::Derived {
                from: format!(
                    "{} joints of {} {} ({})",
                    number_text(joints),
                    number_text(number),
                    unit.symbol,
                    cell.place
                ),
            },
            joints: Some(joints),
        }),
        _ => None,
    };
    let whole = row.get(Column::Length).and_then(|cell| match (meaning, joints) {
        (Meaning::Each, Some(joints)) if joints > 1.0 && counted(row).is_some() => {
            times(cell, joints)
        }
        _ => found(cell, joints),
    });
    let each = || row.get(Column::JointLength).and_then(|cell| times(cell, joints.unwrap_or(1.0)));
    let Some(length) = whole.or_else(each) else {
        let what = format!("the length of '{name}' (a number, or TO SURFACE for the topmost)");
        return Err((Some(row.place.clone()), ImportErrorKind::Missing { what }));
    };
    let length_m = length.si_m().unwrap_or(LENGTHS_M[0]);
    if !(LENGTHS_M[0]..=LENGTHS_M[1]).contains(&length_m) {
        let kind = ImportErrorKind::OutOfRange {
            what: format!("length of '{name}'"),
            found: match &length {
                Length::Of { number, unit, .. } => {
                    format!("{} {}", number_text(*number), unit.symbol)
                }
                Length::ToSurface => String::new(),
            },
            expected: "0.01 to 20000 m".to_owned(),
        };
        return Err((Some(row.place.clone()), kind));
    }
    Ok(length)
}
