//! Context of the readers of an export and their notes, and relations between its rows.

use super::{
    row::{Row, Rows},
    table::Table,
    unit_set::Units,
};
use crate::{
    choices::Choices,
    error::{ImportError, ImportErrorKind},
    fragment::Note,
};

/// Context shared by the readers of an export.
pub(super) struct Reader<'a> {
    pub(super) rows: &'a Rows,
    pub(super) choices: &'a Choices,
    pub(super) units: Units,
    pub(super) notes: Vec<Note>,
}

impl Reader<'_> {
    pub(super) fn assumed(&mut self, text: impl Into<String>) {
        self.notes.push(Note::Assumed(text.into()));
    }

    pub(super) fn left_out(&mut self, text: impl Into<String>) {
        self.notes.push(Note::LeftOut(text.into()));
    }

    pub(super) fn checked(&mut self, text: impl Into<String>) {
        self.notes.push(Note::Checked(text.into()));
    }

    pub(super) fn warning(&mut self, text: impl Into<String>) {
        self.notes.push(Note::Warning(text.into()));
    }

    pub(super) fn read(&mut self, text: impl Into<String>) {
        self.notes.push(Note::Read(text.into()));
    }
}

// Relations between rows: ids are unique only within their well.

/// Whether two rows agree in keys: the last key, which both must have, and the earlier ones if both
/// have them.
pub(super) fn agree(a: Row, b: Row, keys: &[&str]) -> bool {
    let Some((own, above)) = keys.split_last() else { return false };
    a.get(own).is_some()
        && a.get(own) == b.get(own)
        && above.iter().all(|key| match (a.get(key), b.get(key)) {
            (Some(a), Some(b)) => a == b,
            _ => true,
        })
}

/// The row of a table to which another refers; `None` if it is missing.
pub(super) fn parent<'a>(
    rows: &'a Rows,
    table: Table,
    child: Row<'a>,
    keys: &[&str],
) -> Result<Option<Row<'a>>, ImportError> {
    let mut found: Option<Row> = None;
    for row in rows.of(table).filter(|row| agree(*row, child, keys)) {
        match found {
            Some(first) if !first.same(row) => {
                let own = keys.last().copied().unwrap_or_default();
                return Err(child.error(own, two(table, own, child, first, row)));
            }
            Some(_) => {}
            None => found = Some(row),
        }
    }
    Ok(found)
}

/// The rows of a table that belong to another row.
///
/// # Errors
/// One of them may belong to another row as well, because it does not contain its well.
pub(super) fn children<'a>(
    rows: &'a Rows,
    table: Table,
    owner: Row<'a>,
    keys: &[&str],
) -> Result<Vec<Row<'a>>, ImportError> {
    let mut found: Vec<Row> = Vec::new();
    found.extend(rows.of(table).filter(|row| agree(*row, owner, keys)));
    // Duplicate rows are skipped.
    let mut seen = std::collections::HashSet::new();
    found.retain(|row| seen.insert(row.text()));
    let lacking = found
        .iter()
        .find(|row| keys.iter().any(|key| row.get(key).is_none() && owner.get(key).is_some()));
    if let Some(child) = lacking {
        let differs = |other: &Row| keys.iter().any(|key| other.get(key) != owner.get(key));
        let other =
            rows.of(owner.table).find(|other| agree(*child, *other, keys) && differs(other));
        if let (Some(other), Some(own)) = (other, keys.last()) {
            return Err(child.error(own, two(owner.table, own, *child, owner, other)));
        }
    }
    Ok(found)
}

fn two(table: Table, own: &str, child: Row, first: Row, second: Row) -> ImportErrorKind {
    ImportErrorKind::Refused(format!(
        "it belongs to {own} '{}', of which {} has two (lines {} and {}), and does not name its \
         well",
        child.get(own).unwrap_or_default(),
        table.declared().name,
        first.line(),
        second.line()
    ))
}
