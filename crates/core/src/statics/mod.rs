//! Static torque and drag.

pub mod assembly;
pub mod buckling;
mod circulation;
mod sliding;
pub mod soft;
pub mod span;
pub mod stiff;
