//! The sections of the hole.

use super::{
    chooser::Chosen,
    datum::Depths,
    reader::{Reader, children},
    row::Row,
    table::Table,
    unit_set::{Found, Measure},
};
use crate::{
    error::{ImportError, ImportErrorKind},
    fragment::{Block, Origin, Value},
};

const KEYS: [&str; 3] = ["well_id", "wellbore_id", "hole_sect_group_id"];

/// Tolerance within which lengths and depths agree, m.
const SAME_M: f64 = 0.3;

/// Maximum friction factor that a case accepts.
const MAX_FRICTION: f64 = wholestring_case::MAX_FRICTION;

/// A section with its depths.
struct Section<'a> {
    row: Row<'a>,
    cased: bool,
    length: Found,
    shoe: Option<Found>,
    top_m: f64,
    bottom_m: f64,
}

/// The sections of the chosen case, from the surface down.
pub(super) fn read(
    reader: &mut Reader,
    chosen: &Chosen,
    depths: Depths,
) -> Result<Vec<Block>, ImportError> {
    let Some(case) = chosen.case else { return Ok(Vec::new()) };
    let Some(group) = case.get("hole_sect_group_id") else {
        reader.left_out("the hole, because the case names no group of hole sections");
        return Ok(Vec::new());
    };
    let rows = children(reader.rows, Table::HoleSection, case, &KEYS)?;
    if rows.is_empty() {
        reader.read(format!(
            "the case refers to the hole sections '{group}', which the file does not have"
        ));
        return Ok(Vec::new());
    }
    let mut sections = Vec::new();
    for row in rows {
        sections.extend(section(reader, row)?);
    }
    order(reader, &mut sections)?;
    place(reader, &mut sections, depths);
    blocks(reader, &sections, depths)
}

/// Reads the row of a section; `None` if it has no length.
fn section<'a>(reader: &mut Reader, row: Row<'a>) -> Result<Option<Section<'a>>, ImportError> {
    let Some(length) = reader.units.positive(row, "length", Measure::Length)? else {
        reader.left_out(format!("the hole section of line {}, which has no length", row.line()));
        return Ok(None);
    };
    let code = row.get("sect_type_code").unwrap_or_default().to_ascii_uppercase();
    let cased = match code.as_str() {
        "CAS" | "CSG" | "LIN" | "LINER" | "LNR" | "RIS" | "RISER" | "RSR" | "TUB" => true,
        "OPEN" | "OH" | "OPN" => false,
        _ => {
            let cased = row.get("od_casing").is_some() || row.get("id_casing").is_some();
            let taken = if cased { "cased, because it has a casing" } else { "open" };
            reader.assumed(format!(
                "the hole section of line {} with the code '{code}' is taken to be {taken}",
                row.line()
            ));
            cased
        }
    };
    let shoe = match cased {
        true => reader.units.quantity(row, "md_shoe", Measure::Length)?,
        false => None,
    };
    let shoe = shoe.filter(|shoe| shoe.number != 0.0);
    Ok(Some(Section { row, cased, length, shoe, top_m: 0.0, bottom_m: 0.0 }))
}

/// Sorts from the surface down: by number if all have one, otherwise casings by their shoes, then
/// open hole.
fn order(reader: &mut Reader, sections: &mut [Section]) -> Result<(), ImportError> {
    let mut numbers = Vec::new();
    for section in sections.iter() {
        numbers.extend(section.row.number("sequence_no")?);
    }
    let mut sorted = numbers.clone();
    sorted.sort_by(f64::total_cmp);
    sorted.dedup();
    if sorted.len() == sections.len() {
        let number = |section: &Section| section.row.number("sequence_no").ok().flatten();
        sections.sort_by(|a, b| {
            number(a).unwrap_or(f64::NAN).total_cmp(&number(b).unwrap_or(f64::NAN))
        });
        return Ok(());
    }
    let is_riser = |section: &Section| {
        section
            .row
            .get("sect_type_code")
            .is_some_and(|code| code.to_ascii_uppercase().starts_with("R"))
    };
    let key = |section: &Section| match (section.cased, section.shoe) {
        _ if is_riser(section) => (0, 0.0),
        (true, Some(shoe)) => (1, shoe.si()),
        (true, None) => (1, section.length.si()),
        (false, _) => (2, 0.0),
    };
    sections.sort_by(|a, b| {
        let (a, b) = (key(a), key(b));
        a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
    });
    if sections.iter().filter(|section| !section.cased).count() > 1 {
        reader.assumed("the open hole sections are in file order, one below the other");
    }
    Ok(())
}

/// Sets start and end of each section: at its shoe if it has one, otherwise below the section
/// above.
fn place(reader: &mut Reader, sections: &mut [Section], depths: Depths) {
    // Shoes counted from the datum agree with the lengths from the surface; otherwise they agree
    // after a shift.
    let disagree = |shift_m: f64| {
        let mut bottom_m = 0.0;
        sections.iter().any(|section| {
            bottom_m += section.length.si();
            let shoe_m = section.shoe.map(|shoe| shoe.si() + shift_m);
            shoe_m.is_some_and(|shoe_m| (shoe_m - bottom_m).abs() > SAME_M)
        })
    };
    let shift_m = if disagree(depths.shift_m) && !disagree(0.0) { 0.0 } else { depths.shift_m };
    if shift_m != depths.shift_m {
        reader.checked("the shoes agree with the lengths of the sections as depths from the datum");
    }
    let mut above_m = 0.0;
    for section in sections.iter_mut() {
        let length_m = section.length.si();
        match section.shoe.map(|shoe| shoe.si() + shift_m) {
            Some(shoe_m) if (shoe_m - above_m - length_m).abs() > SAME_M => {
                if shoe_m < length_m - SAME_M {
                    reader.warning(format!(
                        "the section of line {} has a length of {} and a shoe at {}: the shoe is \
                         used",
                        section.row.line(),
                        section.length.text(),
                        section.shoe.map_or(String::new(), |shoe| shoe.text()),
                    ));
                }
                section.bottom_m = shoe_m;
                section.top_m = (shoe_m - length_m).max(0.0);
            }
            _ => {
                section.top_m = above_m;
                section.bottom_m = above_m + length_m;
            }
        }
        if section.top_m - above_m > SAME_M {
            reader.warning(format!(
                "the section of line {} begins {} m below the end of the one above; that one is \
                 extended to it",
                section.row.line(),
                ((section.top_m - above_m) * 100.0).round() / 100.0
            ));
        }
        above_m = section.bottom_m.max(above_m);
    }
}

/// Visible interval of each section: a section is hidden by those inside it, which reach deeper.
fn blocks(
    reader: &mut Reader,
    sections: &[Section],
    depths: Depths,
) -> Result<Vec<Block>, ImportError> {
    let mut blocks = Vec::new();
    let mut above_m = 0.0;
    for (place, section) in sections.iter().enumerate() {
        let below = &sections[place + 1..];
        let hidden_m = below.iter().map(|other| other.top_m).fold(f64::INFINITY, f64::min);
        // A gap below belongs to this section.
        let mut end_m = section.bottom_m.min(hidden_m);
        if let Some(next) = below.first()
            && next.top_m > section.bottom_m
        {
            end_m = next.top_m;
        }
        if end_m - above_m < SAME_M {
            reader.left_out(format!(
                "the hole section of line {} ({}), which is hidden behind a deeper one",
                section.row.line(),
                section.row.get("catalog_key_desc").unwrap_or("without a description")
            ));
            continue;
        }
        blocks.push(block(reader, section, end_m, depths)?);
        above_m = end_m;
    }
    Ok(blocks)
}

fn block(
    reader: &mut Reader,
    section: &Section,
    end_m: f64,
    depths: Depths,
) -> Result<Block, ImportError> {
    let row = section.row;
    let mut block =
        Block { remark: row.get("catalog_key_desc").map(str::to_owned), ..Block::default() };
    let kind = if section.cased { "casing" } else { "open" };
    block.push(
        "kind",
        Value::text(kind),
        Origin::written(row.place("sect_type_code"), row.get("sect_type_code").unwrap_or_default()),
    );
    let unit = section.length.unit;
    let end = (unit.from_si(end_m) * 1e4).round() / 1e4;
    let origin = match section.shoe {
        Some(shoe) if (shoe.si() - end_m).abs() < 1e-6 => Origin::at(row.place("md_shoe")),
        Some(shoe) if (shoe.si() + depths.shift_m - end_m).abs() < 1e-6 => Origin::Derived {
            from: format!("{} {}, moved to the datum", row.place("md_shoe"), shoe.text()),
        },
        _ => Origin::Derived {
            from: format!(
                "{}: {} below the section above",
                row.place("length"),
                section.length.text()
            ),
        },
    };
    block.push("to", Value::quantity(end, unit), origin);
    diameter(reader, section, &mut block)?;
    // A zero means that no value was entered.
    if let Some(friction) = row.number("cof")?.filter(|friction| *friction != 0.0) {
        if !(0.0..=MAX_FRICTION).contains(&friction) {
            let kind = ImportErrorKind::OutOfRange {
                what: "friction factor".to_owned(),
                found: friction.to_string(),
                expected: format!("0 to {MAX_FRICTION}"),
            };
            return Err(row.error("cof", kind));
        }
        block.push("friction", Value::Number(friction), Origin::at(row.place("cof")));
    }
    Ok(block)
}

/// Inside diameter that the string meets.
fn diameter(reader: &mut Reader, section: &Section, block: &mut Block) -> Result<(), ImportError> {
    let row = section.row;
    let mut push = |reader: &Reader, column| {
        reader.units.push(block, "diameter", row, column, Measure::Diameter)
    };
    if section.cased {
        let od = reader.units.positive(row, "od_casing", Measure::Diameter)?;
        if let Some(id) = push(reader, "id_casing")? {
            if let Some(od) = od.filter(|od| id.si() >= od.si()) {
                let kind = ImportErrorKind::OutOfRange {
                    what: "inside diameter of the casing".to_owned(),
                    found: id.text(),
                    expected: format!("less than its od_casing, {}", od.text()),
                };
                return Err(row.error("id_casing", kind));
            }
            return Ok(());
        }
        let bore = reader.units.positive(row, "hole_size", Measure::Diameter)?;
        if let Some(bore) = bore
            && od.is_none_or(|od| bore.si() < od.si())
        {
            reader.assumed(format!(
                "hole_size {} of line {} is the inside diameter of its casing, which has no \
                 id_casing",
                bore.text(),
                row.line()
            ));
            push(reader, "hole_size")?;
            return Ok(());
        }
    } else {
        let size = reader.units.positive(row, "hole_size", Measure::Diameter)?;
        let effective = reader.units.positive(row, "effective_diameter", Measure::Diameter)?;
        if let Some(effective) = effective
            && size.is_none_or(|size| effective.si() >= size.si())
        {
            if let Some(size) = size.filter(|size| size.number != effective.number) {
                reader.read(format!(
                    "the open hole of line {} has the effective diameter of {}, its hole_size is \
                     {}",
                    row.line(),
                    effective.text(),
                    size.text()
                ));
            }
            push(reader, "effective_diameter")?;
            return Ok(());
        }
        if push(reader, "hole_size")?.is_some() {
            return Ok(());
        }
    }
    let column = if section.cased { "id_casing" } else { "hole_size" };
    Err(row.error(
        column,
        ImportErrorKind::Missing { what: "the diameter of the hole section".to_owned() },
    ))
}
