//! Numbers packed for a page: the bytes of typed arrays, as base64.

use base64::{Engine, engine::general_purpose::STANDARD};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error};

/// Value of a missing number among short ones.
const MISSING: i16 = i16::MIN;

/// Steps between the smallest number and the largest.
const STEPS: f64 = 65_534.0;

/// A column of numbers as stored in the page, little-endian. A missing one is NaN.
#[derive(Debug, Clone)]
pub enum Packed {
    /// In single precision: seven digits.
    Single(Vec<f32>),
    /// In 65 535 even steps from the smallest to the largest: good for a picture, at half the size.
    Short {
        /// Steps above the middle of the range.
        values: Vec<i16>,
        /// The middle of the range.
        middle: f64,
        /// One step.
        step: f64,
    },
}

impl Packed {
    /// In single precision.
    pub fn single(values: impl IntoIterator<Item = f64>) -> Self {
        Self::Single(values.into_iter().map(|value| value as f32).collect())
    }

    /// In even steps over the range of the finite values.
    pub fn short(values: &[f64]) -> Self {
        let finite = || values.iter().copied().filter(|value| value.is_finite());
        let low = finite().fold(f64::INFINITY, f64::min);
        let high = finite().fold(f64::NEG_INFINITY, f64::max);
        let (middle, step) = if low < high {
            (0.5 * low + 0.5 * high, (high / STEPS) - (low / STEPS))
        } else {
            (finite().next().unwrap_or(0.0), 1.0)
        };
        let place = |value: &f64| {
            if value.is_finite() {
                let place = ((value - middle) / step).round();
                place.clamp(-STEPS / 2.0, STEPS / 2.0) as i16
            } else {
                MISSING
            }
        };
        Self::Short { values: values.iter().map(place).collect(), middle, step }
    }

    /// The numbers as read by the page.
    pub fn values(&self) -> Vec<f64> {
        match self {
            Self::Single(values) => values.iter().map(|value| f64::from(*value)).collect(),
            Self::Short { values, middle, step } => {
                let value = |place: &i16| match *place {
                    MISSING => f64::NAN,
                    place => middle + step * f64::from(place),
                };
                values.iter().map(value).collect()
            }
        }
    }
}

/// Numbers in double precision that a page has in single precision.
pub(crate) mod single {
    use super::{Deserialize, Deserializer, Packed, Serialize, Serializer};

    pub(crate) fn serialize<S: Serializer>(values: &[f64], to: S) -> Result<S::Ok, S::Error> {
        Packed::single(values.iter().copied()).serialize(to)
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<f64>, D::Error> {
        Packed::deserialize(from).map(|packed| packed.values())
    }
}

/// Equal where the bits are: a missing number equals a missing one.
impl PartialEq for Packed {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Single(a), Self::Single(b)) => {
                a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.to_bits() == b.to_bits())
            }
            (
                Self::Short { values: a, middle: middle_a, step: step_a },
                Self::Short { values: b, middle: middle_b, step: step_b },
            ) => a == b && middle_a == middle_b && step_a == step_b,
            _ => false,
        }
    }
}

/// The form in the page's JSON.
#[derive(Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Written {
    F32(String),
    I16(String, f64, f64),
}

impl Serialize for Packed {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let written = match self {
            Self::Single(values) => Written::F32(base64(values.iter().map(|v| v.to_le_bytes()))),
            Self::Short { values, middle, step } => {
                Written::I16(base64(values.iter().map(|v| v.to_le_bytes())), *middle, *step)
            }
        };
        written.serialize(to)
    }
}

fn base64<const N: usize>(values: impl Iterator<Item = [u8; N]>) -> String {
    STANDARD.encode(values.flatten().collect::<Vec<u8>>())
}

impl<'de> Deserialize<'de> for Packed {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let written = Written::deserialize(from)?;
        let bytes = |text: &str| STANDARD.decode(text).map_err(D::Error::custom);
        Ok(match &written {
            Written::F32(text) => {
                let bytes = bytes(text)?;
                let (values, _) = bytes.as_chunks();
                Self::Single(values.iter().map(|v| f32::from_le_bytes(*v)).collect())
            }
            Written::I16(text, middle, step) => {
                let bytes = bytes(text)?;
                let (values, _) = bytes.as_chunks();
                Self::Short {
                    values: values.iter().map(|v| i16::from_le_bytes(*v)).collect(),
                    middle: *middle,
                    step: *step,
                }
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// At most half a step is lost, at the ends of the range too.
    #[test]
    fn short_numbers_come_back_within_half_a_step() {
        let values: Vec<f64> = (0..1000).map(|i| (f64::from(i) * 0.7).sin() * 3e5).collect();
        let step = 6e5 / STEPS;
        for (a, b) in Packed::short(&values).values().iter().zip(&values) {
            assert!((a - b).abs() <= 0.5001 * step, "{a} for {b}");
        }
        for odd in [&[][..], &[7.5], &[7.5, 7.5], &[-1e300, 1e300]] {
            for (a, b) in Packed::short(odd).values().iter().zip(odd) {
                assert!((a - b).abs() <= 1e-4 * b.abs(), "{a} for {b}");
            }
        }
        let with_gap = Packed::short(&[1.0, f64::NAN, 2.0]).values();
        assert!(with_gap[1].is_nan() && with_gap[0] == 1.0 && with_gap[2] == 2.0);
    }

    #[test]
    fn json_gives_every_bit_back() {
        for packed in [
            Packed::single([1.5, f64::NAN, -0.0, 1e30]),
            Packed::short(&[1.5, f64::NAN, -3.0]),
            Packed::single([]),
        ] {
            let json = serde_json::to_string(&packed).unwrap();
            assert_eq!(serde_json::from_str::<Packed>(&json).unwrap(), packed);
        }
    }
}
