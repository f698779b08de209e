//! Datum of the depths of an object.

use super::{measure::short, tree::Node};
use crate::fragment::Note;

/// Note on the datum of depths, if the file gives it.
pub(crate) fn datum(depth: Option<&Node>) -> Option<Note> {
    let depth = depth?;
    let within = || depth.child("Datum").and_then(|datum| datum.text_of("Title"));
    let datum = depth.attribute("datum").or_else(within)?;
    let known = !datum.eq_ignore_ascii_case("unknown");
    known.then(|| Note::Read(format!("measured depths are from the datum '{}'", short(datum))))
}
