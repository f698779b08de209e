//! The table of the number of files in a change.

use super::{
    patch::Patch,
    places::{PATCHES, TABLE},
};

/// Errors in the table or in a patch's head, each in a sentence.
pub(super) fn faults(text: &str, patches: &[Patch]) -> Vec<String> {
    let rows: Vec<Row> = text.lines().filter_map(Row::parse).collect();
    let mut faults = Vec::new();
    for Row { name, .. } in &rows {
        if !patches.iter().any(|patch| patch.name == *name) {
            faults.push(format!("{TABLE} names {PATCHES}/{name}.patch, which is not there"));
        }
    }
    for patch in patches {
        let (file, by_hand) = (patch.file(), patch.by_hand());
        match rows.iter().find(|row| row.name == patch.name) {
            None => faults.push(format!("the table in {TABLE} has no row of {file}")),
            Some(row) if row.files.parse() == Ok(by_hand.len()) => {}
            Some(row) => faults.push(format!(
                "{file} touches {} files written by hand ({}), {TABLE} says `{}`",
                by_hand.len(),
                by_hand.join(", "),
                row.files
            )),
        }
        for part in by_hand {
            if !patch.head.contains(part) {
                faults.push(format!("the head of {file} does not describe the change of {part}"));
            }
        }
    }
    faults
}

/// A row that links a patch, with its number of files as written.
struct Row<'a> {
    name: &'a str,
    files: &'a str,
}

impl<'a> Row<'a> {
    fn parse(line: &'a str) -> Option<Self> {
        let mut cells = line.strip_prefix('|')?.split('|').map(str::trim);
        let (kind, files) = (cells.next()?, cells.next()?);
        let (_, link) = kind.split_once("](")?;
        let name = link.strip_prefix(PATCHES)?.strip_prefix('/')?.strip_suffix(".patch)")?;
        Some(Self { name, files })
    }
}
