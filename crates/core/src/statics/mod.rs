//! Static torque and drag.

pub mod soft;
pub mod span;
