//! Values that several tables share.

pub(crate) mod auto;
pub(crate) mod dimension;
pub(crate) mod names;
