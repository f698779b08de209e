//! Tallies as text and workbooks, with typical difficulties.

mod component;
mod found_in_the_field;
mod hostile;
mod layout;
#[path = "../../../tabular/tests/old_excel/mod.rs"]
mod old_excel;
mod order;
mod units;
mod whole;
mod workbook;

use std::collections::BTreeMap;

use rust_xlsxwriter::{Workbook, Worksheet};
use wholestring_case::Template;
use wholestring_import::{Choices, Imported, Input, import};

pub fn imported(text: &str) -> Imported {
    of_bytes("tally.csv", text.as_bytes(), &Choices::default())
}

pub fn of_bytes(name: &str, bytes: &[u8], choices: &Choices) -> Imported {
    match import(vec![Input::of_bytes(name, bytes)], choices) {
        Ok(imported) => imported,
        Err(error) => panic!("{error}"),
    }
}

pub fn refused_with(text: &str, choices: &Choices) -> String {
    match import(vec![Input::of_bytes("tally.csv", text.as_bytes())], choices) {
        Ok(imported) => panic!("{}", imported.text),
        Err(error) => error.to_string(),
    }
}

pub fn refused(text: &str) -> String {
    refused_with(text, &Choices::default())
}

/// The blocks of the string in a case, without comments, separated by blank lines.
pub fn string(imported: &Imported) -> String {
    let text = &imported.text;
    let from = text.find("\n[[string]]\n").unwrap_or_else(|| panic!("no string: {text}"));
    let lines = text[from + 1..].lines().take_while(|line| !line.starts_with("[operation]"));
    let plain = lines.map(|line| line.split(" #").next().unwrap_or(line).trim_end());
    plain.collect::<Vec<_>>().join("\n").trim().to_owned()
}

pub fn notes(imported: &Imported) -> String {
    let notes = imported.notes.iter().map(|(_, note)| format!("{}: {}", note.kind(), note.text()));
    notes.collect::<Vec<_>>().join("\n")
}

/// The components of the case after the parts that the file lacks are filled in.
pub fn components(imported: &Imported) -> Vec<wholestring::string::Component> {
    let text = imported.text.replace(
        "\n[well]\n",
        "\n[well]\nstations = [[0, 0, 0], [\"1000 m\", 0, 0], [\"3000 m\", 40, 90]]\n[[well.hole]]\nkind = \
         \"open\"\nto = \"3000 m\"\ndiameter = \"26 in\"\nfriction = 0.3\n[mud]\ndensity = \"1.2 \
         sg\"\n",
    );
    // Pipe is added above an assembly without pipe.
    let lacks_pipe = imported.missing.iter().any(|missing| missing.starts_with("the pipe above"));
    let pipe = "[[string]]\ncomponent = \"pipe\"\nod = \"5 in\"\nid = \"4 in\"\nlength = \"to surface\"\n\n";
    let text =
        if lacks_pipe { text.replace("[operation]", &format!("{pipe}[operation]")) } else { text };
    let template = Template::in_memory("imported.toml", &text, BTreeMap::new());
    match template.case(&[]) {
        Ok(case) => {
            let mut components = case.model.string.components().to_vec();
            components.truncate(components.len() - usize::from(lacks_pipe));
            components
        }
        Err(report) => panic!("{}", report.render(false)),
    }
}

pub const PLAIN: &str = "Component,OD (in),ID (in),Length (ft),Weight (lb/ft)\n\
    PDC bit,8.5,2.25,0.85,\n\
    Collar,6.5,2.25,30,99.5\n\
    DP,5,4.276,TO SURFACE,21\n";

pub fn header(sheet: &mut Worksheet, row: u32, texts: &[&str]) {
    for (column, text) in texts.iter().enumerate() {
        if !text.is_empty() {
            sheet.write(row, column as u16, *text).unwrap();
        }
    }
}

pub fn saved(sheets: Vec<Worksheet>) -> Vec<u8> {
    let mut workbook = Workbook::new();
    for sheet in sheets {
        workbook.push_worksheet(sheet);
    }
    workbook.save_to_buffer().unwrap()
}
