//! Stations of a path.

pub(crate) mod imported;
pub(crate) mod preamble;
pub(crate) mod reader;
pub(crate) mod said;
pub(crate) mod stated;
pub(crate) mod stations;
pub(crate) mod tables;
