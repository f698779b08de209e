//! WITSML 1.4.1.1 and 2.0.
//!
//! Elements stand in the order of their schemas; symbols of units are those that both versions
//! have. What a schema asks for and a case has not is said to be unknown.

mod log;
mod trajectory;
mod tubular;
mod xml;

pub use log::logs;
pub use trajectory::trajectory;
pub use tubular::tubular;

/// A version of WITSML.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Version {
    /// 1.4.1.1.
    V1411,
    /// 2.0.
    V20,
}
