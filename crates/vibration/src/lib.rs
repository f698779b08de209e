//! Linear vibration of a drill string about its state at rest: natural frequencies, critical speeds
//! and responses ([`modal`]), and whether steady rotation grows into stick-slip
//! ([`torsional_stability`]).
#![warn(missing_docs)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod complex;
pub mod modal;
pub mod torsional_stability;
