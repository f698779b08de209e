//! From where the depths of an object are measured.

use super::{measure::short, tree::Node};
use crate::fragment::Note;

/// What is said of the datum of depths, where the file tells it.
pub(crate) fn datum(depth: Option<&Node>) -> Option<Note> {
    let depth = depth?;
    let within = || depth.child("Datum").and_then(|datum| datum.text_of("Title"));
    let datum = depth.attribute("datum").or_else(within)?;
    let told = !datum.eq_ignore_ascii_case("unknown");
    told.then(|| Note::Read(format!("measured depths are from the datum '{}'", short(datum))))
}
