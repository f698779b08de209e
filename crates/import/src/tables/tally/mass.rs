//! Mass of a component of a tally.

use wholestring::string::{
    Material,
    catalogue::{CatalogueEntry, nominal_pipe},
};
use wholestring_case::STEEL_DENSITY_KG_PER_M3;
use wholestring_tabular::{Column, Holds, TallyCell};
use wholestring_units::{Dimension, number_text, significant};

use super::{
    part::{Part, Refusal},
    quote::{Said, origin, shown, unit},
};
use crate::{
    error::ImportErrorKind,
    fragment::{Note, Origin, Value},
    pipe::{LIGHTEST, body_mass, mass_in_range, other_unit},
};

/// Standard gravity, m/s²; converts a weight as a force to a mass.
const GRAVITY_M_PER_S2: f64 = 9.80665;

/// Relative difference below which two weights of one component agree.
const AGREES: f64 = 0.02;

/// Diameters with which a mass is compared, m.
pub(crate) struct Body<'a> {
    pub(crate) od_m: f64,
    pub(crate) id_m: f64,
    /// Diameter of the tool joints, if any.
    pub(crate) joint_od_m: Option<f64>,
    /// Whether the diameter is that over the blades.
    pub(crate) has_blades: bool,
    /// Density of its metal, if the table has it.
    pub(crate) density_kg_per_m3: Option<f64>,
    /// Catalogue entry with its mass.
    pub(crate) entry: Option<&'a CatalogueEntry>,
    /// Whether its name is that of pipe.
    pub(crate) is_pipe: bool,
}

/// Returns the mass per length of a component and its origin; `None` if the table has none.
pub(crate) fn of(
    part: &Part,
    body: &Body<'_>,
    said: &mut Said,
    notes: &mut Vec<Note>,
) -> Result<Option<(Value, Origin)>, Refusal> {
    let row = part.row();
    let per_length = row.get(Column::Mass).filter(|cell| cell.si() != Some(0.0));
    let whole = whole(part);
    let nominal = row.get(Column::NominalMass).filter(|cell| cell.si() != Some(0.0));
    let (value, from, place) = match (per_length, whole, nominal) {
        (Some(cell), whole, _) => {
            let (value, from) = per_metre(cell);
            if let Some(note) = nominal_weight(part, body, &value, cell) {
                notes.push(note);
                if body.entry.is_some() {
                    return Ok(None);
                }
            }
            if let (Some((_, whole)), Some(own)) = (whole, value.si())
                && let Some(other) = whole.si()
                && (own - other).abs() > AGREES * own
            {
                notes.push(Note::Warning(format!(
                    "THE WEIGHTS of '{}' DIFFER: {} per length against {} by its total \
                     weight; the first is used",
                    part.name,
                    shown(&value),
                    shown(&whole)
                )));
            }
            (value, from, cell.place.clone())
        }
        (None, Some((place, value)), _) => {
            let from = format!("its total weight ({place}) over its length");
            (value, Origin::Derived { from }, place)
        }
        (None, None, Some(cell)) if body.entry.is_none() => {
            said.nominal.push(part.name.clone());
            let (value, from) = per_metre(cell);
            (value, from, cell.place.clone())
        }
        (None, None, _) => {
            if body.entry.is_none() && body.is_pipe {
                said.unweighed_pipe.push(part.name.clone());
            } else if body.entry.is_none() {
                said.unweighed.push(part.name.clone());
            }
            return Ok(None);
        }
    };
    let mass = value.si().unwrap_or_default();
    let density = body.density_kg_per_m3.unwrap_or(STEEL_DENSITY_KG_PER_M3);
    let found = format!("{} of '{}'", shown(&value), part.name);
    let mass_unit = match &value {
        Value::Quantity { unit, .. } => unit,
        _ => unit(Dimension::MassPerLength, "kg/m"),
    };
    let kg = |mass: f64| {
        format!(
            "{} {}",
            number_text((mass_unit.from_si(mass) * 10.0).round() / 10.0),
            mass_unit.symbol
        )
    };
    let refused = |expected: String| {
        let what = "weight per length".to_owned();
        let kind = ImportErrorKind::OutOfRange { what, found: found.clone(), expected };
        Err((Some(place.clone()), kind))
    };
    let diameters_m = [body.od_m, body.id_m, body.joint_od_m.unwrap_or(body.od_m)];
    let steel = body_mass(diameters_m, density);
    let hint = match value {
        Value::Quantity { number, unit } => other_unit((number, unit), diameters_m, density),
        _ => String::new(),
    };
    if let Err(expected) = mass_in_range(mass, diameters_m, density, kg) {
        let is_bar = body.has_blades && expected.contains("solid bar");
        let blades = if is_bar { ", its blades not counted" } else { "" };
        return refused(expected + blades + &hint);
    }
    if mass < LIGHTEST * steel {
        notes.push(Note::Warning(format!(
            "{found} is less than its body of {} weighs, {}: if its metal is lighter, give its \
             density too{hint}",
            if body.density_kg_per_m3.is_some() { "this metal" } else { "steel" },
            kg(steel)
        )));
    }
    Ok(Some((value, from)))
}

/// Note on a weight that a pipe has in its name: names have nominal weights, such as that of
/// `5-7/8 DP 23.40# S-135`, of whatever bore.
fn weight_of_name(part: &Part, mass: f64, value: &Value, cell: &TallyCell) -> Option<Note> {
    /// Half of the last digit of a weight in a name, lb/ft.
    const ROUNDED: f64 = 0.05;
    let pounds = unit(Dimension::MassPerLength, "lb/ft").from_si(mass);
    let words: Vec<&str> = part.name.split_whitespace().collect();
    let is_unit = |word: &str| matches!(word, "#" | "ppf" | "lb/ft" | "lbs/ft" | "lbf/ft");
    let is_its = |at: usize| {
        let number = words[at].trim_end_matches(|letter: char| !letter.is_ascii_digit());
        let after = &words[at][number.len()..];
        let has_unit = is_unit(&after.to_ascii_lowercase())
            || after.is_empty()
                && words.get(at + 1).is_some_and(|next| is_unit(&next.to_ascii_lowercase()));
        has_unit && number.parse().is_ok_and(|number: f64| (number - pounds).abs() < ROUNDED)
    };
    (0..words.len()).any(is_its).then(|| {
        Note::Warning(format!(
            "the weight of '{}', {} ({}), is the one in its name, which is the NOMINAL WEIGHT, \
             without tool joints: give catalogue, or mass_per_length with tool joints",
            part.name,
            shown(value),
            cell.place
        ))
    })
}

/// Note on a weight that is the nominal one of drill pipe, which excludes tool joints: that of the
/// catalogue entry, or of a pipe of these diameters.
fn nominal_weight(part: &Part, body: &Body, value: &Value, cell: &TallyCell) -> Option<Note> {
    let mass = value.si()?;
    if !body.is_pipe && body.entry.is_none() {
        return None;
    }
    let Some(found) = nominal_pipe(body.entry, body.od_m, body.id_m, mass) else {
        return weight_of_name(part, mass, value, cell);
    };
    let with_joints = found.mass_per_length_kg_per_m(Material::STEEL.density_kg_per_m3);
    let pounds = unit(Dimension::MassPerLength, "lb/ft");
    let pounds = |mass: f64| format!("{:.1} lb/ft", pounds.from_si(mass));
    Some(Note::Warning(format!(
        "the weight of '{}', {} ({}), is the NOMINAL WEIGHT of '{}', without tool joints: with them it \
         weighs {}{}",
        part.name,
        shown(value),
        cell.place,
        found.designation,
        pounds(with_joints),
        match body.entry {
            Some(_) => ", and the case uses that of the catalogue",
            None =>
                "; the case has the tally's: give catalogue, or mass_per_length with tool joints",
        }
    )))
}

/// Mass per length from a cell, in its unit; from a force, in kg/m.
fn per_metre(cell: &TallyCell) -> (Value, Origin) {
    match cell.holds {
        Holds::Quantity { number, unit, dimension: Dimension::MassPerLength } => {
            (Value::quantity(number, unit), origin(cell))
        }
        Holds::Quantity { number, unit: force, .. } => {
            let mass = force.to_si(number) / GRAVITY_M_PER_S2;
            let from = format!(
                "{} {} ({}) under standard gravity",
                number_text(number),
                force.symbol,
                cell.place
            );
            (per_length(mass, force.is_field()), Origin::Derived { from })
        }
        _ => (Value::Number(0.0), origin(cell)),
    }
}

/// A computed mass per length, kg/m, to five digits, in the unit system of its cells.
fn per_length(mass: f64, is_field: bool) -> Value {
    let unit = unit(Dimension::MassPerLength, if is_field { "lb/ft" } else { "kg/m" });
    Value::quantity(significant(unit.from_si(mass), 5), unit)
}

/// Mass per length from the total weight of its rows, with the place of the first.
fn whole(part: &Part) -> Option<(String, Value)> {
    let length_m = part.length.si_m()?;
    let cells: Option<Vec<&TallyCell>> =
        part.rows.iter().map(|row| row.get(Column::TotalMass)).collect();
    let cells = cells?;
    let masses = cells.iter().filter_map(|cell| match cell.holds {
        Holds::Quantity { number, unit, dimension: Dimension::Force } => {
            Some(unit.to_si(number) / GRAVITY_M_PER_S2)
        }
        Holds::Quantity { number, unit, .. } => Some(unit.to_si(number)),
        _ => None,
    });
    let mass: f64 = masses.sum();
    let is_field =
        |cell: &TallyCell| matches!(cell.holds, Holds::Quantity { unit, .. } if unit.is_field());
    let is_field = cells.iter().all(|cell| is_field(cell));
    (mass > 0.0).then(|| (cells[0].place.clone(), per_length(mass / length_m, is_field)))
}
