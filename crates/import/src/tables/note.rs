//! What the reader of tables says.

use crate::fragment::Note;

/// How something was read, or what is hidden and was not.
pub(super) fn of(text: String) -> Note {
    match text.ends_with("hidden and not read") {
        true => Note::LeftOut(text),
        false => Note::Read(text),
    }
}
