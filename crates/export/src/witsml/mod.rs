//! WITSML 1.4.1.1, 2.0 and 2.1.
//!
//! Elements are in the order of their schemas; symbols of units are those that all versions have.
//! Required elements that a case lacks are written as unknown.

mod log;
mod trajectory;
mod tubular;
mod xml;

pub use log::{Curve, Log, logs};
pub use trajectory::trajectory;
pub use tubular::{Component, tubular};

// Versions of WITSML.

/// A version of WITSML.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Version {
    /// 1.4.1.1.
    V1411,
    /// 2.0.
    V20,
    /// 2.1.
    V21,
}

impl Version {
    /// Its number.
    pub fn number(self) -> &'static str {
        match self {
            Self::V1411 => "1.4.1.1",
            Self::V20 => "2.0",
            Self::V21 => "2.1",
        }
    }
}
