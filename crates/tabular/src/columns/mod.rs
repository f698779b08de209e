//! The columns of a table: what their headings and units say.

pub(crate) mod column;
pub(crate) mod header;
pub(crate) mod heading;
pub(crate) mod layout;
pub(crate) mod names;
pub(crate) mod sort;
pub(crate) mod words;
