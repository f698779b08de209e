//! Numbers in files for people and other programs, which know no infinity.
//!
//! JSON has neither infinities nor NaN: they become `null`, which is read back as NaN. Without this
//! module such files could not be read. Binary formats keep every bit.

use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// Writes a number; in text `null` where it is not finite.
///
/// # Errors
/// The writer's.
pub fn serialize<S: Serializer>(value: &f64, to: S) -> Result<S::Ok, S::Error> {
    if to.is_human_readable() {
        value.is_finite().then_some(*value).serialize(to)
    } else {
        value.serialize(to)
    }
}

/// Reads a number; in text NaN for `null`.
///
/// # Errors
/// The reader's.
pub fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
    if from.is_human_readable() {
        Ok(Option::<f64>::deserialize(from)?.unwrap_or(f64::NAN))
    } else {
        f64::deserialize(from)
    }
}

/// Value of a number that is missing in a file: not a number.
pub const fn unknown() -> f64 {
    f64::NAN
}

/// Whether the number is missing in the file.
pub const fn is_unknown(value: &f64) -> bool {
    value.is_nan()
}

/// The same for people and programs who take `-0.0` for a number of its own: there zero has no
/// sign.
pub mod unsigned_zero {
    use super::*;

    /// Writes a number; zero has no sign in text.
    ///
    /// # Errors
    /// The writer's.
    pub fn serialize<S: Serializer>(value: &f64, to: S) -> Result<S::Ok, S::Error> {
        if to.is_human_readable() {
            super::serialize(&(*value + 0.0), to)
        } else {
            value.serialize(to)
        }
    }

    pub use super::deserialize;
}

/// The same of two numbers.
pub mod pair {
    use super::*;

    #[derive(Serialize, Deserialize)]
    struct One(#[serde(with = "super")] f64);

    /// Writes two numbers.
    ///
    /// # Errors
    /// The writer's.
    pub fn serialize<S: Serializer>(pair: &[f64; 2], to: S) -> Result<S::Ok, S::Error> {
        pair.map(One).serialize(to)
    }

    /// Reads two numbers.
    ///
    /// # Errors
    /// The reader's.
    pub fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<[f64; 2], D::Error> {
        Ok(<[One; 2]>::deserialize(from)?.map(|One(value)| value))
    }
}

#[cfg(test)]
mod tests {
    use serde::{Deserialize, Serialize};

    #[derive(Debug, Serialize, Deserialize)]
    struct Numbers {
        #[serde(with = "crate::finite")]
        one: f64,
        #[serde(with = "crate::finite::pair")]
        two: [f64; 2],
    }

    #[test]
    fn what_is_not_finite_is_null_in_text_and_kept_in_bits() {
        let numbers = Numbers { one: f64::INFINITY, two: [-0.0, f64::NEG_INFINITY] };
        let text = serde_json::to_string(&numbers).unwrap();
        assert_eq!(text, r#"{"one":null,"two":[-0.0,null]}"#);
        let back: Numbers = serde_json::from_str(&text).unwrap();
        assert!(back.one.is_nan() && back.two[1].is_nan());
        let stored = postcard::to_allocvec(&numbers).unwrap();
        let back: Numbers = postcard::from_bytes(&stored).unwrap();
        assert_eq!(back.one, f64::INFINITY);
        assert_eq!(back.two.map(f64::to_bits), numbers.two.map(f64::to_bits));
    }
}
