//! A tally in a table: the components of a string.

mod block;
mod designation;
mod joints;
mod lengths;
mod mass;
mod order;
mod part;
mod quote;
mod sums;

use part::{Length, Part, Refusal};
use quote::{Said, shown};
use wholestring::string::nested_casings;
use wholestring_tabular::{Column, ImportedTally, TableErrorKind, TallyRow, is_bit, read_tally};
use wholestring_units::{Dimension, Unit};

use crate::{
    choices::Choices,
    doubts,
    error::{ImportError, ImportErrorKind},
    fragment::{Block, Fragment, Note, Value},
};

/// Difference up to which two diameters are those of one gauge, m: sizes are rounded to sixteenths of
/// an inch.
const SAME_GAUGE_M: f64 = 0.0254 / 16.0 + 1e-6;

/// Maximum number of components of a string, identical joints counted once; each is looked up in
/// the catalogue, which takes milliseconds.
const MOST_COMPONENTS: usize = 500;

/// Reads the tally of a file, or of a sheet.
pub(crate) fn read(
    bytes: &[u8],
    name: &str,
    sheet: Option<&str>,
    choices: &Choices,
) -> Result<Fragment, ImportError> {
    let mut wrong = None;
    let mut said = |column: Column| match unit_said(column, choices) {
        Ok(unit) => unit,
        Err(error) => {
            wrong.get_or_insert(error);
            None
        }
    };
    let tally = read_tally(bytes, name, sheet, &mut said);
    if let Some(kind) = wrong {
        return Err(ImportError::new(name, None, kind));
    }
    let tally = tally.map_err(|error| asking(error.into()))?;
    let mut notes: Vec<Note> = Vec::new();
    let string = blocks(&tally, choices, &mut notes)
        .map_err(|(place, kind)| ImportError::new(name, place, kind))?;
    let count = string.len();
    let in_sheet = tally.sheet.map_or(String::new(), |sheet| format!(" in sheet '{sheet}'"));
    notes.extend(tally.notes.into_iter().map(doubts::table_note));
    notes.extend(tally.left_out.into_iter().map(Note::LeftOut));
    let what =
        format!("a tally of {count} component{}{in_sheet}", if count == 1 { "" } else { "s" });
    Ok(Fragment { what, string, notes, ..Fragment::default() })
}

fn blocks(
    tally: &ImportedTally,
    choices: &Choices,
    notes: &mut Vec<Note>,
) -> Result<Vec<Block>, Refusal> {
    let names = names(&tally.rows, notes)?;
    let lengths = lengths::of(&tally.rows, &names, choices, notes)?;
    let steps = sums::steps(&tally.rows, &lengths);
    let order = order::find(&tally.rows, &names, &steps, choices, notes)?;
    sums::check(tally, &lengths, &steps, notes);
    let parts = tally.rows.iter().zip(names).zip(lengths);
    let mut parts: Vec<Part> =
        parts.map(|((row, name), length)| Part { rows: vec![row], name, length }).collect();
    if order == order::Order::BitLast {
        parts.reverse();
    }
    let parts = joints::join(parts, notes);
    if parts.len() > MOST_COMPONENTS {
        let kind = ImportErrorKind::TooMuch {
            found: format!("{} components", parts.len()),
            most: MOST_COMPONENTS.to_string(),
        };
        return Err((None, kind));
    }
    let top = parts.len() - 1;
    let below_top = parts[..top].iter().find(|part| part.length == Length::ToSurface);
    if let Some(part) = below_top {
        let sentence = format!(
            "'{}' reaches to the surface, and '{}' is above it; only the topmost component can",
            part.name, parts[top].name
        );
        return Err((Some(part.row().place.clone()), ImportErrorKind::Refused(sentence)));
    }
    let mut blocks = Vec::with_capacity(parts.len());
    let mut said = Said::default();
    for (index, part) in parts.iter().enumerate() {
        blocks.push(block::of(part, index == 0, parts.len() > 1, &mut said, notes)?);
    }
    said.tell(notes);
    notes.extend(programme(&blocks));
    notes.extend(gauges(&parts, &blocks));
    Ok(blocks)
}

/// Notes on a bit with another diameter than its name begins with, and on blades above it that are
/// wider than the hole it drills.
fn gauges(parts: &[Part], blocks: &[Block]) -> Vec<Note> {
    let (Some(bit), Some(block)) = (parts.first(), blocks.first()) else { return Vec::new() };
    let si_m = |block: &Block, key: &str| block.get(key).and_then(Value::si);
    let (true, Some(bit_m), Some(od)) = (is_bit(&bit.name), si_m(block, "od"), block.get("od"))
    else {
        return Vec::new();
    };
    let mut notes = Vec::new();
    if let Some((text, named_m)) = named_size(&bit.name)
        && (named_m - bit_m).abs() > SAME_GAUGE_M
    {
        notes.push(Note::Warning(format!(
            "'{}' ({}) HAS A DIAMETER of {}, and its name begins with {text}: the diameter is used",
            bit.name,
            bit.row().place,
            shown(od)
        )));
    }
    for (part, block) in parts.iter().zip(blocks).skip(1) {
        let Some(blades) = block.get("blade_od") else { continue };
        let lower = part.name.to_lowercase();
        let opens = ["ream", "opener"].iter().any(|word| lower.contains(word));
        if !opens && blades.si().is_some_and(|blades_m| blades_m > bit_m + SAME_GAUGE_M) {
            notes.push(Note::Warning(format!(
                "the gauge of '{}' ({}), {}, is above that of the bit, {}: it does not fit in the \
                 hole that the bit drills",
                part.name,
                part.row().place,
                shown(blades),
                shown(od)
            )));
        }
    }
    notes
}

/// Size in inches at the beginning of a name: `8 1/2"`, `8-1/2 in`, `8.5in`.
fn named_size(name: &str) -> Option<(String, f64)> {
    let end = name.find(|c: char| !(c.is_ascii_digit() || "./- ".contains(c)))?;
    let number = name[..end].trim_end_matches([' ', '-', '.', '/']);
    let after = name[number.len()..].trim_start_matches([' ', '-']);
    let is_inch = ["\"", "''", "”", "″"].iter().any(|sign| after.starts_with(sign))
        || after.split(|c: char| !c.is_alphanumeric()).next().is_some_and(|word| {
            ["in", "inch", "inches"].iter().any(|unit| word.eq_ignore_ascii_case(unit))
        });
    if !is_inch && !number.contains('/') {
        return None;
    }
    let text = format!("{number} in");
    let size_m = Dimension::Diameter.parse(&text).ok()?;
    Some((text, size_m))
}

/// Note on casings that fit into each other: they are a casing programme, not a string.
fn programme(blocks: &[Block]) -> Option<Note> {
    let si = |block: &Block, key: &str| block.get(key).and_then(Value::si);
    let tubulars: Vec<(f64, f64)> =
        blocks.iter().filter_map(|block| Some((si(block, "od")?, si(block, "id")?))).collect();
    nested_casings(&tubulars).then(|| {
        Note::Warning(
            "THE CASINGS FIT INTO EACH OTHER: this is a casing programme, and the case makes one \
             string of it; casings that are in the hole belong under [[well.hole]]"
                .to_owned(),
        )
    })
}

/// Names of the components.
fn names(rows: &[TallyRow], notes: &mut Vec<Note>) -> Result<Vec<String>, Refusal> {
    let mut names: Vec<String> = Vec::with_capacity(rows.len());
    let mut unnamed = Vec::new();
    for row in rows {
        match (row.get(Column::Component), names.last()) {
            (Some(cell), _) => names.push(cell.written.clone()),
            (None, Some(above)) => {
                unnamed.push(row.place.clone());
                names.push(above.clone());
            }
            (None, None) => {
                let what = "the name of the component".to_owned();
                return Err((Some(row.place.clone()), ImportErrorKind::Missing { what }));
            }
        }
    }
    if let Some(first) = unnamed.first() {
        let others = match unnamed.len() {
            1 => String::new(),
            count => format!(" and {} more rows", count - 1),
        };
        notes.push(Note::Assumed(format!(
            "{first}{others} without a name: more of the component above"
        )));
    }
    Ok(names)
}

/// Name of a column in `--unit`, and an alternative.
fn unit_names(column: Column) -> &'static [&'static str] {
    match column {
        Column::OutsideDiameter => &["od", "diameter"],
        Column::InsideDiameter => &["id", "diameter"],
        Column::Gauge => &["gauge", "diameter"],
        Column::JointOutsideDiameter => &["joint-od", "diameter"],
        Column::JointInsideDiameter => &["joint-id", "diameter"],
        Column::JointLength => &["joint-length", "length"],
        Column::CumulativeLength => &["cumulative", "length"],
        Column::Mass => &["weight"],
        Column::NominalMass => &["nominal-weight", "weight"],
        Column::TotalMass => &["total-weight"],
        Column::YieldStrength => &["yield-strength"],
        _ => &["length"],
    }
}

fn unit_said(column: Column, choices: &Choices) -> Result<Option<&'static Unit>, ImportErrorKind> {
    choices.unit_of(unit_names(column), column.dimension())
}

/// Converts the error of a missing unit to one that names the option.
fn asking(error: ImportError) -> ImportError {
    let ImportErrorKind::Table(table) = error.kind() else { return error };
    let TableErrorKind::MissingReadingUnit { column, header } = table.kind() else { return error };
    let kind = ImportErrorKind::MissingUnit {
        what: format!("{column} under '{header}'"),
        name: unit_names(*column)[0].to_owned(),
        dimension: column.dimension(),
    };
    ImportError::new(error.file(), error.place().map(str::to_owned), kind)
}

/// Formats a component as a line.
pub(crate) fn line(block: &Block) -> String {
    let shown_value = |key: &str| block.get(key).map(shown);
    let mut text = shown_value("component").unwrap_or_default();
    for key in ["catalogue", "od", "id", "blade_od", "mass_per_length", "length"] {
        if let Some(value) = shown_value(key) {
            text += &match key {
                "catalogue" => format!(", {value}"),
                key => format!(", {} {value}", key.replace('_', " ")),
            };
        }
    }
    text
}
