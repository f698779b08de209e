//! Logs of a rig: what was measured at the surface against time or depth.

mod record;

pub use record::Record;
