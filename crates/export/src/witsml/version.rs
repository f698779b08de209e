//! Versions of WITSML.

/// A version of WITSML.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Version {
    /// 1.4.1.1.
    V1411,
    /// 2.0.
    V20,
}
