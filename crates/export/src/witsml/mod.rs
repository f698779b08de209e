//! WITSML 1.4.1.1, 2.0 and 2.1.
//!
//! Elements stand in the order of their schemas; symbols of units are those that all versions
//! have. What a schema asks for and a case has not is said to be unknown.

mod log;
mod trajectory;
mod tubular;
mod version;
mod xml;

pub use log::logs;
pub use trajectory::trajectory;
pub use tubular::tubular;
pub use version::Version;
