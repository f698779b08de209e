//! Static torque and drag.

pub mod buckling;
pub mod soft;
pub mod span;
