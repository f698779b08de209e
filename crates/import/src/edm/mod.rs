//! Landmark EDM: exports of the Engineer's Data Model as XML, an element for each row of a table.
//!
//! Names of tables and columns are those used by public readers of such exports and of the
//! underlying database.

mod chooser;
mod component;
mod datum;
mod drag_chart;
mod hole;
mod mud;
mod reader;
mod row;
mod string;
mod survey;
mod table;
mod unit_set;

use crate::{
    choices::Choices,
    error::ImportError,
    fragment::{Block, Contents, Entry, Fragment, Origin, Value},
    input::Input,
    xml::Xml,
};
use reader::Reader;
use row::Rows;
use table::Table;
use unit_set::Units;

/// The root element of an export.
pub(crate) const ROOT: &str = "export";

/// Reads one case of an export.
pub(crate) fn read(input: Input, choices: &Choices) -> Result<Fragment, ImportError> {
    let rows = Rows::read(Xml::new(input))?;
    let mut notes = Vec::new();
    let chosen = chooser::choose(&rows, choices, &mut notes)?;
    let units = Units::said(&rows, choices)?;
    let reader = &mut Reader { rows: &rows, choices, units, notes };
    let (survey, depths) = survey::read(reader, &chosen)?;
    let mut operation = Block::default();
    let hole = hole::read(reader, &chosen, depths)?;
    let string = string::read(reader, &chosen, depths, &mut operation)?;
    let mud = mud::read(reader, &chosen)?;
    let overlay = drag_chart::read(reader, &chosen, depths)?;
    let name = chosen.name();
    Ok(Fragment {
        what: format!("a Landmark EDM export: {name}"),
        name: name_entry(&chosen, name),
        survey,
        hole,
        string,
        mud,
        operation,
        overlay,
        notes: std::mem::take(&mut reader.notes),
        ..Fragment::default()
    })
}

fn name_entry(chosen: &chooser::Chosen, name: String) -> Option<Entry> {
    let row = chosen.case.or(chosen.wellbore)?;
    let column = if row.table == Table::Case { "case_name" } else { "wellbore_name" };
    Some(Entry { key: "name", value: Value::text(name), origin: Origin::at(row.place(column)) })
}

/// Lists the wellbores of an export and the cases of each.
pub(crate) fn contents(input: Input) -> Result<Contents, ImportError> {
    let rows = Rows::read(Xml::new(input))?;
    Ok(Contents {
        what: "a Landmark EDM export".to_owned(),
        lines: chooser::list(&rows)?,
        ..Contents::default()
    })
}
