//! Channels, numbers and depths in the sentences of checks, and the median.

use wholestring_judge::{CheckKind, Quantity, ReadingCheck, Rounding, Severity};
use wholestring_plan::calibration::Channel;
use wholestring_tabular::CHANNEL_WORDS;
use wholestring_units::Dimension;

/// A warning that does not concern single readings.
pub(in crate::calibrate) fn warning(kind: CheckKind, sentence: String) -> ReadingCheck {
    ReadingCheck::new(kind, Severity::Warning, sentence)
}

/// Dimension of a channel's readings.
pub(in crate::calibrate) fn dimension(channel: Channel) -> Dimension {
    if channel.is_torque() { Dimension::Torque } else { Dimension::Force }
}

/// A channel in words.
pub(in crate::calibrate) fn words(channel: Channel) -> &'static str {
    CHANNEL_WORDS[channel as usize]
}

/// Readings of a channel in words: `torques on bottom`.
pub(in crate::calibrate) fn plural(channel: Channel) -> String {
    let (noun, rest) = match words(channel).split_once(" o") {
        Some((noun, rest)) => (noun, format!(" o{rest}")),
        None => (words(channel), String::new()),
    };
    format!("{noun}s{rest}")
}

/// A number in three digits, with its unit.
pub(in crate::calibrate) const fn shown(value: f64, dimension: Dimension) -> Quantity {
    Quantity::new(dimension, value, Rounding::Three)
}

/// A relative deviation in per cent, and above 1000 % as a multiple.
pub(in crate::calibrate) fn share(part: f64) -> String {
    match part {
        part if part <= 10.0 => format!("{:.0} %", 100.0 * part),
        part if part < 1e4 => format!("{part:.0} times their values"),
        part => format!("{part:.1e} times their values"),
    }
}

/// The median; zero for no values.
pub(in crate::calibrate) fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    match values.len() {
        0 => 0.0,
        count if count % 2 == 1 => values[count / 2],
        count => 0.5 * (values[count / 2 - 1] + values[count / 2]),
    }
}
