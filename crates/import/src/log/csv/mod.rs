//! Logs as delimited text, as electronic drilling recorders (EDR) write them.
//!
//! Tables of surveys and tallies are read whole; a log is read row by row, and its head is found in
//! its first lines.

mod head;
mod rows;

use super::{lines::Lines, log::Opened};
use crate::{
    error::{ImportError, ImportErrorKind},
    input::Input,
};

/// Whether a delimited text begins as a log of a rig: a line of headings that include a time and a
/// rig measurement, or depths with hook load and block position.
pub(crate) fn is_log(head: &[u8]) -> bool {
    let Ok(mut lines) = Lines::new(Input::of_bytes("", head)) else { return false };
    let mut ahead = Vec::new();
    // Overlong lines are refused when the file is read.
    let _ = head::ahead(&mut lines, &mut ahead);
    head::find(&ahead).is_some_and(|found| found.is_log())
}

/// Reads the head.
pub(super) fn open(input: Input) -> Result<Opened, ImportError> {
    let mut lines = Lines::new(input)?;
    let mut ahead = Vec::new();
    head::ahead(&mut lines, &mut ahead)?;
    let Some(found) = head::find(&ahead) else {
        let sentence = "no line of headings names a time, a depth, a hook load".to_owned();
        return Err(ImportError::new(lines.file(), None, ImportErrorKind::Refused(sentence)));
    };
    rows::open(lines, ahead, found)
}
