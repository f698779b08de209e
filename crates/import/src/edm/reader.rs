//! Context of the readers of an export, and their notes.

use super::{row::Rows, unit_set::Units};
use crate::{choices::Choices, fragment::Note};

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
