//! The assembled string.

use super::Component;

/// The whole string, from the bit up, exactly as long as the bit is deep.
#[derive(Debug, Clone, PartialEq)]
pub struct DrillString {
    components: Vec<Component>,
}
