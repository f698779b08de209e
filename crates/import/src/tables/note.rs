//! Notes of the reader of tables.

use crate::fragment::Note;

/// Classifies a note as information on reading or as omission of hidden contents.
pub(super) fn of(text: String) -> Note {
    match text.ends_with("hidden and not read") {
        true => Note::LeftOut(text),
        false => Note::Read(text),
    }
}
