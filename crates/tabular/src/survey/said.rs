//! What a caller knows of a file.

use wholestring_units::Unit;

/// What is said of a survey beside its file.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Said {
    /// Unit of the lengths whose unit the file does not tell.
    pub length_unit: Option<&'static Unit>,
}
