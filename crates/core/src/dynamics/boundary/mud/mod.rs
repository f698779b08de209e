//! The mud around and inside the string, in time.

pub mod flow_pressures;
pub mod squeezed;
pub mod viscous;
