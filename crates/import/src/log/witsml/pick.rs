//! Which of several logs is meant, and what one lacks.

use crate::{
    error::{ImportError, ImportErrorKind},
    xml::Xml,
};

/// The error of a log without something.
pub(super) fn missing(xml: &Xml, what: &str) -> ImportError {
    xml.error(ImportErrorKind::Missing { what: what.to_owned() })
}

/// The name that `--pick log=` gives, and whether a log of these names is meant.
pub(super) fn is_picked(picked: Option<&str>, names: &[&str]) -> bool {
    picked.is_none_or(|picked| names.contains(&picked))
}
