//! A short name for a long value.

use serde::Serialize;

/// Returns the 128-bit FNV-1a hash of the value as JSON, in hexadecimal digits: equal values have
/// equal digests, different ones differ except by a chance of one in 10³⁸. It guards against
/// mistakes, not against forgery.
///
/// # Panics
/// If the value cannot be JSON, such as a map whose keys are not text.
pub fn digest(value: &impl Serialize) -> String {
    let text = serde_json::to_vec(value).expect("JSON");
    format!("{:032x}", fnv_1a(&text))
}

/// Fowler, Noll and Vo's hash 1a of 128 bits, RFC 9923.
fn fnv_1a(bytes: &[u8]) -> u128 {
    const OFFSET: u128 = 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d;
    const PRIME: u128 = 0x0000_0000_0100_0000_0000_0000_0000_013b;
    let add = |sum: u128, byte: &u8| (sum ^ u128::from(*byte)).wrapping_mul(PRIME);
    bytes.iter().fold(OFFSET, add)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The test vectors of RFC 9923.
    #[test]
    fn agrees_with_the_standard() {
        assert_eq!(fnv_1a(b""), 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d);
        assert_eq!(fnv_1a(b"a"), 0xd228_cb69_6f1a_8caf_7891_2b70_4e4a_8964);
        assert_eq!(fnv_1a(b"foobar"), 0x343e_1662_793c_64bf_6f0d_3597_ba44_6f18);
    }

    #[test]
    fn the_last_digit_counts() {
        let one = digest(&serde_json::json!({ "a": 0.1 }));
        let other = digest(&serde_json::json!({ "a": f64::from_bits(0.1_f64.to_bits() + 1) }));
        assert_eq!(one.len(), 32);
        assert_ne!(one, other);
    }
}
