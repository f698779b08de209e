//! A component as keys of `[[string]]`.

use wholestring::string::catalogue::CatalogueEntry;
use wholestring_tabular::{Column, Holds, TallyCell, is_bit, is_stabiliser};
use wholestring_units::{Dimension, number_text};

use super::{
    designation, joints,
    mass::{self, Body},
    order,
    part::{self, Length, Part, Refusal},
    quote::{Said, origin, quantity, unit, written},
};
use crate::{
    error::ImportErrorKind,
    fragment::{Block, Note, Origin, Value},
    pipe::{self, is_pipe},
};

/// Yield strengths that a case accepts, Pa.
const YIELDS_PA: [f64; 2] = [1e7, 1e10];

/// Diameters that a case accepts, m.
const DIAMETERS_M: [f64; 2] = [0.005, 2.0];

/// Returns the keys of a component. `is_lowest`: it may be the bit.
pub(crate) fn of(
    part: &Part,
    is_lowest: bool,
    is_one_of_several: bool,
    said: &mut Said,
    notes: &mut Vec<Note>,
) -> Result<Block, Refusal> {
    let row = part.row();
    let is_bit = is_lowest && is_bit(&part.name);
    let mut block = Block::default();
    let name_place =
        row.get(Column::Component).map_or(row.place.clone(), |cell| cell.place.clone());
    if is_bit && !order::ends_with_bit(&part.name) {
        let name = format!("{} (bit)", part.name);
        block.push("component", Value::text(name), Origin::written(&name_place, &part.name));
    } else {
        block.push("component", Value::text(&part.name), Origin::at(&name_place));
    }
    let od = diameter(part, Column::OutsideDiameter)?;
    let id = inside(part)?;
    let gauge = diameter(part, Column::Gauge)?;
    let joint_od = diameter(part, Column::JointOutsideDiameter)?;
    // The largest diameter of a pipe is that of its tool joints.
    let (gauge, joint_od) = match is_pipe(&part.name) && !is_bit {
        true => (None, joint_od.or(gauge)),
        false => (gauge, joint_od),
    };
    // The body of a bit is its shank.
    let (od, gauge) = match (is_bit, od, gauge) {
        (true, shank, Some(gauge)) => {
            if let Some(shank) = shank.filter(|shank| shank.si() != gauge.si()) {
                notes.push(Note::LeftOut(format!(
                    "the outside diameter of the bit, {} ({}): its od is its gauge",
                    written(shank),
                    shank.place
                )));
            }
            (Some(gauge), None)
        }
        (_, od, gauge) => (od, gauge),
    };
    let lacks = |what: &str| {
        let what = format!("the {what} of '{}'", part.name);
        Err((Some(row.place.clone()), ImportErrorKind::Missing { what }))
    };
    let Some((od, od_m)) = od.and_then(|od| Some((od, od.si()?))) else {
        return lacks("outside diameter");
    };
    let id_m = id.and_then(TallyCell::si);
    let blades = gauge.filter(|gauge| gauge.si() > Some(od_m));
    if let Some(gauge) = gauge.filter(|gauge| gauge.si() < Some(od_m)) {
        return Err(narrower(part, gauge, od));
    }
    let entry = match is_bit || blades.is_some() {
        true => None,
        false => listed(part, od, od_m, id_m, notes),
    };
    let mut is_solid = false;
    match &entry {
        Some(entry) => {
            block.push(
                "catalogue",
                Value::text(&entry.designation),
                Origin::Derived { from: format!("called so in {name_place}") },
            );
        }
        None => {
            block.push("od", quantity(od), origin(od));
            match id {
                Some(id) => block.push("id", quantity(id), origin(id)),
                None if is_lowest && is_one_of_several => is_solid = true,
                None => return lacks("inside diameter"),
            }
        }
    }
    if let Some(id) = id.filter(|id| id.si() >= Some(od_m)) {
        let kind = ImportErrorKind::OutOfRange {
            what: format!("inside diameter of '{}'", part.name),
            found: written(id),
            expected: format!("less than its outside diameter, {}", written(od)),
        };
        return Err((Some(id.place.clone()), kind));
    }
    if is_solid && is_bit {
        notes.push(Note::Assumed("the bit has no inside diameter: solid".to_owned()));
    }
    match &part.length {
        Length::ToSurface => {
            let open = row.cells.iter().find(|cell| cell.holds == Holds::ToSurface);
            let from = open.map_or(Origin::at(&row.place), origin);
            block.push("length", Value::text("to surface"), from);
        }
        Length::Of { number, unit, origin, .. } => {
            block.push("length", Value::quantity(*number, unit), origin.clone());
        }
    }
    if let Some(blades) = blades {
        block.push("blade_od", quantity(blades), origin(blades));
        if let Some(length) = given(part, Column::BladeLength) {
            block.push("blade_length", quantity(length), origin(length));
        } else {
            said.bladed.push(part.name.clone());
        }
    } else if is_stabiliser(&part.name) && entry.is_none() {
        said.bladeless.push(part.name.clone());
    }
    let joints_m =
        joints::of(part, od_m, joint_od, blades.is_some(), entry.as_ref(), &mut block, notes);
    let body = Body {
        od_m: entry.as_ref().map_or(od_m, |entry| entry.od_m),
        id_m: entry.as_ref().map_or(id_m.unwrap_or(0.0), |entry| entry.id_m),
        joint_od_m: joints_m,
        has_blades: blades.is_some(),
        density_kg_per_m3: part::density(part)?.map(|(_, density)| density),
        entry: entry.as_ref(),
        is_pipe: is_pipe(&part.name),
    };
    part::metal_of(part, &mut block)?;
    // A bit is not a ring of steel, so that any mass is accepted.
    let bit_mass =
        is_bit.then(|| row.get(Column::Mass).is_none() && row.get(Column::TotalMass).is_none());
    if bit_mass != Some(true)
        && let Some((value, origin)) = mass::of(part, &body, said, notes)?
    {
        block.push("mass_per_length", value, origin);
    } else if bit_mass == Some(true) {
        said.unweighed.push(part.name.clone());
    }
    let yields = row.get(Column::YieldStrength).filter(|cell| cell.si() > Some(0.0));
    match (yields, &entry) {
        (Some(cell), _) => {
            let yields_Pa = cell.si().unwrap_or_default();
            if !(YIELDS_PA[0]..=YIELDS_PA[1]).contains(&yields_Pa) {
                let kind = ImportErrorKind::OutOfRange {
                    what: format!("yield strength of '{}'", part.name),
                    found: written(cell),
                    expected: "10 to 10000 MPa".to_owned(),
                };
                return Err((Some(cell.place.clone()), kind));
            }
            block.push("yield_strength", quantity(cell), origin(cell));
        }
        (None, None) => strength(part, &mut block, said),
        (None, Some(_)) => {}
    }
    if let Some(entry) = &entry {
        connection(part, entry, notes);
    }
    Ok(block)
}

/// The cell of a column with a quantity above zero.
fn given<'a>(part: &Part<'a>, column: Column) -> Option<&'a TallyCell> {
    part.row().get(column).filter(|cell| cell.si() > Some(0.0))
}

/// The cell of a diameter above zero.
fn diameter<'a>(part: &Part<'a>, column: Column) -> Result<Option<&'a TallyCell>, Refusal> {
    let Some(cell) = part.row().get(column) else { return Ok(None) };
    let Some(si_m) = cell.si().filter(|&si_m| si_m != 0.0) else { return Ok(None) };
    if (DIAMETERS_M[0]..=DIAMETERS_M[1]).contains(&si_m) {
        return Ok(Some(cell));
    }
    let kind = ImportErrorKind::OutOfRange {
        what: format!("{column} of '{}'", part.name),
        found: written(cell),
        expected: "5 mm to 2 m (0.2 to 78 in)".to_owned(),
    };
    Err((Some(cell.place.clone()), kind))
}

/// The cell of the inside diameter: a solid bar has 0.
fn inside<'a>(part: &Part<'a>) -> Result<Option<&'a TallyCell>, Refusal> {
    match part.row().get(Column::InsideDiameter) {
        Some(cell) if cell.si() == Some(0.0) => Ok(Some(cell)),
        _ => diameter(part, Column::InsideDiameter),
    }
}

fn narrower(part: &Part, gauge: &TallyCell, od: &TallyCell) -> Refusal {
    let kind = ImportErrorKind::OutOfRange {
        what: format!("gauge of '{}'", part.name),
        found: written(gauge),
        expected: format!("its outside diameter, {}, or more", written(od)),
    };
    (Some(gauge.place.clone()), kind)
}

/// The catalogue entry that the row designates, if its diameters agree.
fn listed(
    part: &Part,
    od: &TallyCell,
    od_m: f64,
    id_m: Option<f64>,
    notes: &mut Vec<Note>,
) -> Option<CatalogueEntry> {
    let row = part.row();
    let words = |column| row.get(column).map(|cell: &TallyCell| cell.written.as_str());
    let entry = designation::designated(&part.name, words(Column::Connection)).or_else(|| {
        // `Drill pipe`, 5 in, 19.5 lb/ft, S-135, each in a column of its own.
        let (nominal, grade) = (row.get(Column::NominalMass)?, words(Column::Grade)?);
        let lower = part.name.to_lowercase();
        let is_pipe = lower.split(|c: char| !c.is_alphanumeric()).any(|word| word == "dp");
        if !is_pipe && !lower.contains("drill pipe") {
            return None;
        }
        let inches = Dimension::Diameter.find_unit("in")?.from_si(od_m);
        let pounds = Dimension::MassPerLength.find_unit("lb/ft")?.from_si(nominal.si()?);
        let (inches, pounds) = (number_text(inches), number_text(pounds));
        designation::designated(&format!("{inches} in {pounds} lb/ft {grade}"), None)
    })?;
    let Some((which, own_m, here_m)) = designation::differs(&entry, od_m, id_m) else {
        notes.push(Note::Read(format!(
            "'{}' is the catalogue's '{}': od and id agree, and the case uses the catalogue's",
            part.name, entry.designation
        )));
        return Some(entry);
    };
    let od_unit = match od.holds {
        Holds::Quantity { unit, .. } => unit,
        _ => unit(Dimension::Diameter, "mm"),
    };
    let length = |m: f64| {
        format!("{} {}", number_text((od_unit.from_si(m) * 1e3).round() / 1e3), od_unit.symbol)
    };
    notes.push(Note::Warning(format!(
        "'{}' is called like the catalogue's '{}', but its {which} is {} and not {}: the tally's \
         diameters are used",
        part.name,
        entry.designation,
        length(here_m),
        length(own_m)
    )));
    None
}

/// Yield strength from the grade.
fn strength(part: &Part, block: &mut Block, said: &mut Said) {
    let cell = part.row().get(Column::Grade);
    let of_name = pipe::grade_in_name(&part.name);
    let Some((grade, place)) = cell
        .map(|cell| (cell.written.as_str(), cell.place.clone()))
        .or(of_name.map(|grade| (grade, part.row().place.clone())))
    else {
        return;
    };
    match pipe::yield_psi(grade) {
        Some(psi) => block.push(
            "yield_strength",
            Value::quantity(psi, unit(Dimension::Stress, "psi")),
            Origin::Derived { from: format!("grade {grade} ({place})") },
        ),
        None => said.grades.push((grade.to_owned(), format!("'{}' ({place})", part.name))),
    }
}

/// Adds a note if the catalogue's connection differs from the row's.
fn connection(part: &Part, entry: &CatalogueEntry, notes: &mut Vec<Note>) {
    let Some(listed) = &entry.connection else { return };
    let plain = |text: &str| -> String {
        text.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_uppercase).collect()
    };
    let stated = part.row().get(Column::Connection).map(|cell| cell.written.clone());
    let stated = stated.or_else(|| designation::connection_of(&part.name).map(str::to_owned));
    let Some(stated) = stated.filter(|stated| !plain(stated).contains(&plain(&listed.name))) else {
        return;
    };
    notes.push(Note::LeftOut(format!(
        "the connection {stated} of '{}': the case has the catalogue's {}; where tool joints or \
         their torques matter, give joint_od and make_up_torque",
        part.name, listed.name
    )));
}
