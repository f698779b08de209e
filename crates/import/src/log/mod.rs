//! Logs of a rig: what was measured at the surface against time or depth.

pub(crate) mod picking;
mod record;

pub use record::Record;
