//! A short identifier of bytes: equal for equal bytes, on every machine.

use sha1::{Digest, Sha1};

/// Sixteen hexadecimal digits, which distinguish contents but are not cryptographic.
pub(crate) fn fingerprint(bytes: &[u8]) -> String {
    Sha1::digest(bytes).iter().take(8).map(|byte| format!("{byte:02x}")).collect()
}
