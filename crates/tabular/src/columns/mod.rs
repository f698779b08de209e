//! Columns of a table: meaning of their headings and units.

pub(crate) mod column;
pub(crate) mod header;
pub(crate) mod heading;
pub(crate) mod layout;
pub(crate) mod names;
pub(crate) mod words;
