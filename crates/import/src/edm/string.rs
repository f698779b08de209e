//! The string: an assembly and its components.

use super::{
    chooser::{Chosen, label},
    component,
    datum::Depths,
    reader::{Reader, children, parent},
    row::Row,
    table::Table,
    unit_set::Measure,
};
use crate::{
    error::ImportError,
    fragment::{Block, Origin},
};

const KEYS: [&str; 3] = ["well_id", "wellbore_id", "assembly_id"];

/// Reads the string of the chosen case from the bit up, and the depth of its bit.
pub(super) fn read(
    reader: &mut Reader,
    chosen: &Chosen,
    depths: Depths,
    operation: &mut Block,
) -> Result<Vec<Block>, ImportError> {
    let Some(case) = chosen.case else { return Ok(Vec::new()) };
    let Some(id) = case.get("assembly_id") else {
        reader.left_out("the string, because the case names no assembly");
        return Ok(Vec::new());
    };
    let assembly = parent(reader.rows, Table::Assembly, case, &KEYS)?;
    let rows = children(reader.rows, Table::Component, case, &KEYS)?;
    if rows.is_empty() {
        reader.read(format!(
            "the case refers to the assembly '{id}', whose components the file does not have"
        ));
        return Ok(Vec::new());
    }
    match assembly {
        None => reader.read(format!("the assembly '{id}' has components and no row of its own")),
        Some(row) => {
            let kind = row.get("string_type").map_or(String::new(), |kind| format!(" ({kind})"));
            reader.read(format!(
                "the string is the assembly '{}'{kind} of {} components",
                label(row),
                rows.len()
            ));
        }
    }
    let rows = from_the_bit_up(reader, rows)?;
    let mut blocks = Vec::new();
    for row in rows {
        let first = blocks.is_empty();
        blocks.extend(component::read(reader, row, assembly, first)?);
    }
    if let Some(assembly) = assembly
        && let Some(base) = reader.units.positive(assembly, "md_assembly_base", Measure::Length)?
    {
        let place = assembly.place("md_assembly_base");
        let origin = match depths.shift_m == 0.0 {
            true => Origin::at(place),
            false => {
                Origin::Derived { from: format!("{place} {}, moved to the datum", base.text()) }
            }
        };
        operation.push("bit_depth", depths.moved(base), origin);
    }
    Ok(blocks)
}

/// Sorts components by number, reversed if the bit has the last one.
fn from_the_bit_up<'a>(
    reader: &mut Reader,
    rows: Vec<Row<'a>>,
) -> Result<Vec<Row<'a>>, ImportError> {
    let mut numbered = Vec::with_capacity(rows.len());
    for row in rows {
        numbered.push((row.number("sequence_no")?, row));
    }
    if numbered.iter().all(|(number, _)| number.is_some()) {
        let key = |number: Option<f64>| number.unwrap_or(f64::NAN);
        numbered.sort_by(|a, b| key(a.0).total_cmp(&key(b.0)));
        let twice = numbered.windows(2).find(|two| two[0].0 == two[1].0);
        if let Some([(Some(number), first), (_, second)]) = twice {
            let places = [first, second].map(|row| row.place("sequence_no"));
            reader.warning(format!(
                "two components have the sequence_no {number} ({}, {}): both are in the string, in \
                 the order of the file",
                places[0], places[1]
            ));
        }
    } else {
        reader.assumed("components are in file order, because not all have a sequence_no");
    }
    let mut rows: Vec<Row> = numbered.into_iter().map(|(_, row)| row).collect();
    let is_bit = |row: Option<&Row>| row.is_some_and(|row| component::is_bit(*row));
    match (is_bit(rows.first()), is_bit(rows.last())) {
        (true, false) => reader.read("components are numbered from the bit up"),
        (false, true) => {
            reader.read("components are numbered from the surface down, the bit last");
            rows.reverse();
        }
        _ if rows.len() > 1 => reader
            .assumed("components are numbered from the bottom up, because neither end is a bit"),
        _ => {}
    }
    Ok(rows)
}
