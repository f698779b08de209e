//! WITSML 1.4.1.1, 2.0 and 2.1.
//!
//! Elements are in the order of their schemas; symbols of units are those that all versions have.
//! Required elements that a case lacks are written as unknown.

mod log;
mod trajectory;
mod tubular;
mod version;
mod xml;

pub use log::logs;
pub use trajectory::trajectory;
pub use tubular::tubular;
pub use version::Version;
