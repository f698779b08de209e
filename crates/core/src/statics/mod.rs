//! Static torque and drag.

pub mod soft;
