//! Stations of a path.

pub(crate) mod imported;
pub(crate) mod said;
pub(crate) mod stations;
