//! The key of a sweep that its figures have as an axis.

use super::Sweep;
use crate::cell::capital;

/// The axis of the varied key.
pub(super) enum Varied {
    /// The depth of the bit, down the page, as is usual.
    Depth,
    /// Another key whose values are numbers of one unit.
    Number { key: usize, unit: String },
    /// A key whose values are words.
    Words { key: usize },
}

impl Varied {
    /// The depth of the bit if it varies; else the key with the most values, numbers before words.
    pub(super) fn of(sweep: &Sweep) -> Self {
        let many = |key: &usize| sweep.values(*key).len();
        let keys = || 0..sweep.keys.len();
        if keys().any(|key| short(&sweep.keys[key]) == "bit depth" && many(&key) > 1) {
            return Self::Depth;
        }
        let unit = |key: usize| {
            let values = sweep.values(key);
            let mut units = values.iter().map(|value| Some(split(value)?.1));
            let first = units.next().flatten()?;
            units.all(|unit| unit == Some(first)).then(|| first.to_owned())
        };
        let numbers = keys().filter(|key| many(key) > 1);
        let numbers = numbers.filter_map(|key| Some((key, unit(key)?)));
        if let Some((key, unit)) = numbers.max_by_key(|(key, _)| many(key)) {
            return Self::Number { key, unit };
        }
        let key = keys().max_by_key(many).unwrap_or(0);
        Self::Words { key }
    }

    pub(super) fn key(&self, sweep: &Sweep) -> Option<usize> {
        match self {
            Self::Depth => {
                let mut keys = sweep.keys.iter();
                keys.position(|key| short(key) == "bit depth")
            }
            Self::Number { key, .. } | Self::Words { key } => Some(*key),
        }
    }
}

/// A value as a number and its unit; `None` where it is not a number.
pub(super) fn split(value: &str) -> Option<(f64, &str)> {
    let value = value.trim();
    let is_number = |letter: char| letter.is_ascii_digit() || "+-.".contains(letter);
    let end = value.find(|letter| !is_number(letter)).unwrap_or(value.len());
    // An exponent belongs to the number where the whole is one.
    if let Ok(number) = value.parse::<f64>() {
        return number.is_finite().then_some((number, ""));
    }
    let number = value[..end].parse().ok()?;
    Some((number, value[end..].trim()))
}

/// The last part of a key in readable form: `operation.bit_depth` is the bit depth.
pub(super) fn short(key: &str) -> String {
    let last = key.rsplit('.').next().unwrap_or(key);
    match last {
        "rpm" => "rotary speed".into(),
        "wob" => "weight on bit".into(),
        other => other.replace('_', " "),
    }
}

/// The same with a capital.
pub(super) fn name(key: &str) -> String {
    capital(&short(key))
}
