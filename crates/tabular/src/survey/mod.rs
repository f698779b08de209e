//! Stations of a path.

pub(crate) mod doubts;
pub(crate) mod imported;
pub(crate) mod places;
pub(crate) mod positions;
pub(crate) mod preamble;
pub(crate) mod reader;
pub(crate) mod said;
pub(crate) mod stations;
pub(crate) mod surface;
pub(crate) mod tables;
