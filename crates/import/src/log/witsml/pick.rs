//! Selection of one log among several, and errors for an incomplete one.

use crate::{
    error::{ImportError, ImportErrorKind},
    xml::Xml,
};

/// The error of a log that lacks an element.
pub(super) fn missing(xml: &Xml, what: &str) -> ImportError {
    xml.error(ImportErrorKind::Missing { what: what.to_owned() })
}

/// Whether a log of these names is the one chosen with `--pick log=NAME`.
pub(super) fn is_picked(picked: Option<&str>, names: &[&str]) -> bool {
    picked.is_none_or(|picked| names.contains(&picked))
}
