//! A survey in a table.

use wholestring_tabular::{Said, read_as};
use wholestring_units::Dimension;

use crate::{
    choices::Choices,
    error::ImportError,
    fragment::{Fragment, Note, Survey},
};

/// The survey of a file.
pub(crate) fn read(bytes: &[u8], name: &str, choices: &Choices) -> Result<Fragment, ImportError> {
    let at = |kind| ImportError::new(name, None, kind);
    let said = Said { length_unit: choices.unit_of(&["md"], Dimension::Length).map_err(at)? };
    let survey = read_as(bytes, name, &said)?;
    Ok(Fragment {
        what: format!("a survey of {} stations", survey.stations.len()),
        survey: Some(Survey {
            stations: survey.stations,
            tie_in: survey.tie_in,
            place: String::new(),
            units: String::new(),
        }),
        notes: survey.notes.into_iter().map(Note::Read).collect(),
        ..Fragment::default()
    })
}
