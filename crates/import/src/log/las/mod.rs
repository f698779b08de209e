//! LAS 1.2, 2.0 and 3.0 of the Canadian Well Logging Society.
//!
//! The crates that read LAS (`las_rs`, `liblas`) load the whole file into memory as columns; a time
//! log of a rig may exceed that. This module reads the head and then row after row. A row that
//! contradicts the head is refused with its line and is not repaired.

mod head;
mod item;
mod rows;

use super::{lines::Lines, log::Opened};
use crate::{error::ImportError, input::Input};

/// Whether a file begins as LAS does: comments and blank lines, then `~V`.
pub(crate) fn is_las(head: &[u8]) -> bool {
    let Ok(mut lines) = Lines::new(Input::of_bytes("", head)) else { return false };
    let mut line = Vec::new();
    while let Ok(true) = lines.next(&mut line) {
        let text = line.trim_ascii().strip_prefix(b"\"").unwrap_or(line.trim_ascii());
        if let Some(title) = text.strip_prefix(b"~") {
            let first = title.trim_ascii_start().first();
            // Files without `~V` begin with another section.
            return first.is_some_and(|b| b"VWCP".contains(&b.to_ascii_uppercase()));
        }
        if !text.is_empty() && !text.starts_with(b"#") {
            return false;
        }
        line.clear();
    }
    false
}

/// Reads the head.
pub(super) fn open(input: Input) -> Result<Opened, ImportError> {
    let mut lines = Lines::new(input)?;
    let head = head::read(&mut lines)?;
    rows::open(lines, head)
}
