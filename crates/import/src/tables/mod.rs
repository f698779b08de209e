//! Tables in text and workbooks: surveys and tallies.

mod survey;

use crate::{
    choices::Choices,
    error::ImportError,
    fragment::{Contents, Fragment},
    input::Input,
};

/// No table of a well is larger.
const LARGEST_BYTES: usize = 64 << 20;

/// Reads the table of a file.
pub(crate) fn read(input: Input, choices: &Choices) -> Result<Fragment, ImportError> {
    let name = input.name().to_owned();
    let bytes = input.bytes(LARGEST_BYTES)?;
    survey::read(&bytes, &name, choices)
}

/// What a table is, and what it holds.
pub(crate) fn contents(input: Input) -> Result<Contents, ImportError> {
    let fragment = read(input, &Choices::default())?;
    let lines = fragment.notes.iter().map(|note| note.text().to_owned()).collect();
    Ok(Contents { what: fragment.what, lines })
}
