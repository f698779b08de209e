//! The case that tests start from.
#![allow(dead_code, reason = "each test file uses its own part")]

pub(crate) mod change;
pub(crate) mod schema_check;

use wholestring_case::{Case, InMemory, Override, Report, parse};

/// A case with every table, as the documentation shows it.
pub(crate) const EXAMPLE: &str = include_str!("example.toml");

/// Its survey: vertical, a build, a tangent.
pub(crate) const SURVEY: &str = include_str!("example-survey.csv");

pub(crate) const SURVEY_NAME: &str = "np13-x1042-survey.csv";

pub(crate) fn survey_files(survey: &[u8]) -> InMemory {
    let mut files = InMemory::default();
    files.0.insert(SURVEY_NAME.to_owned(), survey.to_vec());
    files
}

pub(crate) fn read(text: &str) -> Result<Case, Report> {
    parse("case.toml", text.as_bytes(), &survey_files(SURVEY.as_bytes()), &[])
}

pub(crate) fn read_with(text: &str, settings: &[&str]) -> Result<Case, Report> {
    let changes: Vec<Override> =
        settings.iter().map(|text| text.parse().expect("KEY=VALUE")).collect();
    parse("case.toml", text.as_bytes(), &survey_files(SURVEY.as_bytes()), &changes)
}

/// The example with one text, which must occur in it once, replaced by another.
pub(crate) fn changed(from: &str, to: &str) -> String {
    assert_eq!(EXAMPLE.matches(from).count(), 1, "`{from}` must occur once in the example");
    EXAMPLE.replace(from, to)
}
