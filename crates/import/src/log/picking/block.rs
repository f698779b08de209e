//! Weight of the block, which a log does not separate from that of the string.

use wholestring_units::{Dimension, Unit, number_text, significant};

use super::beginning::Beginning;
use crate::{
    choices::Choices,
    error::ImportErrorKind,
    fragment::{Note, Value},
};

/// Weight of block and top drive, and whether the logged hook loads include it.
#[derive(Debug, Clone, PartialEq)]
pub struct BlockWeight {
    /// The value as the user gave it.
    pub said: Value,
    /// The same value, N.
    pub weight_N: f64,
    /// Median hook load in slips, N; `None` if the log shows no slips.
    pub slips_N: Option<f64>,
    /// Whether the hook loads of the log include it. Otherwise the sensor was zeroed with the block
    /// on it, and the weight is added to the picked weights.
    pub in_log: bool,
}

/// Its name in `--value`.
const NAME: &str = "block-weight";

/// Allowed difference between hook load in slips and block weight, over the weight: a weight
/// indicator errs by some per cent of the load, by friction in the sheaves and by elevators and
/// hoses that hang on the hook.
const AGREES: f64 = 0.15;

/// Difference between the hook load in slips and the block's weight below which no correction is
/// made, over the weight: the resolution to which the scale is read.
const SAME: f64 = 0.01;

/// Largest hook load in slips of a sensor that was zeroed with the block on it, N: a block with a
/// top drive weighs more. Above the smaller, the weight of the block and hook of the smallest rigs,
/// it may be a block whose weight was given in error by one of [`ERRORS`].
const ZERO_N: f64 = 4e4;
const BLOCK_N: f64 = 1.5e4;

/// Relative difference within which a ratio is one of [`ERRORS`].
const NEAR: f64 = 0.05;

/// Ratios of the given weight to the hook load in slips that indicate an error of typing or of
/// units, with their cause.
const ERRORS: [(f64, &str); 9] = [
    (10.0, "a typing error"),
    (0.1, "a typing error"),
    (100.0, "a typing error"),
    (0.01, "a typing error"),
    (2.204_622_6, "a weight of pounds as kilograms"),
    (0.453_592_37, "a weight of kilograms as pounds"),
    (4.448_221_6, "a weight of kN as klbf"),
    (0.224_808_94, "a weight of klbf as kN"),
    (9.806_65, "a weight of kN as tonnes"),
];

impl BlockWeight {
    /// Reads the given weight and compares it with the hook load in slips.
    ///
    /// # Errors
    /// The weight is not given, or the hook load in slips is neither that weight nor zero.
    pub(super) fn of(
        choices: &Choices,
        beginning: &Beginning,
        unit: &Unit,
    ) -> Result<Self, ImportErrorKind> {
        let slips_N = beginning.slips.map(|level| level.median_N);
        let Some(said) = choices.quantity(NAME, Dimension::Force)? else {
            return Err(not_said(slips_N, unit));
        };
        let weight_N = said.si().unwrap_or(f64::NAN);
        let shown = shown(weight_N, unit);
        if !(weight_N > 0.0 && weight_N < 1e7) {
            return Err(ImportErrorKind::OutOfRange {
                what: "weight of the block".to_owned(),
                found: shown,
                expected: "more than 0, to 1000 tf".to_owned(),
            });
        }
        let in_log = match slips_N {
            None => true,
            Some(slips_N) if (slips_N - weight_N).abs() <= AGREES * weight_N => true,
            // No weight is negative: below zero the sensor's zero is off.
            Some(slips_N)
                if slips_N <= ZERO_N.min(AGREES * weight_N)
                    && (slips_N <= BLOCK_N || causes(weight_N / slips_N).is_empty()) =>
            {
                false
            }
            Some(slips_N) => {
                let slips = self::shown(slips_N, unit);
                let ratio = weight_N / slips_N;
                let causes = causes(ratio).join(" or ");
                let cause = match causes.is_empty() {
                    true => String::new(),
                    false => {
                        let channel = other_unit(ratio, unit).map_or(String::new(), |other| {
                            format!(
                                ", or a channel of the hook load in {} instead of {}",
                                other.symbol, unit.symbol
                            )
                        });
                        let times = three_digits(ratio);
                        format!(", {times} times as much, which indicates {causes}{channel}")
                    }
                };
                return Err(ImportErrorKind::Refused(format!(
                    "the median hook load in slips is {slips}, and the given block weight is \
                     {shown}{cause}; expected about {shown} in slips, or about 0 if the sensor \
                     was zeroed with the block on it; give the weight on the sensor with --value \
                     {NAME}=\"{slips}\""
                )));
            }
        };
        Ok(Self { said, weight_N, slips_N, in_log })
    }

    /// Correction added to a logged hook load to give the reading of a weight indicator with a
    /// correct zero, N: the load below the block is the logged value minus the one logged in slips.
    pub fn added_N(&self) -> f64 {
        let off_N = self.slips_N.map_or(0.0, |slips_N| self.weight_N - slips_N);
        if self.in_log && off_N.abs() <= SAME * self.weight_N { 0.0 } else { off_N }
    }

    /// Weight on the sensor in addition to the string, N.
    pub(super) fn on_sensor_N(&self) -> f64 {
        self.slips_N.unwrap_or(self.weight_N)
    }

    /// Hint at the unit of hook loads that are too small for any string; empty if there is none.
    /// The hook load in slips shows it if it would be the block's weight in that unit.
    pub(super) fn other_unit(&self, beginning: &Beginning, unit: &Unit) -> String {
        /// Hook load that any string with its block exceeds, N.
        const LEAST_N: f64 = 2e4;
        let by_slips = self.slips_N.and_then(|slips_N| other_unit(self.weight_N / slips_N, unit));
        let is_small = beginning.heavy_N < LEAST_N;
        match by_slips.or_else(|| other_unit(1000.0, unit).filter(|_| is_small)) {
            Some(other) => {
                format!("; is the hook load in {} instead of {}?", other.symbol, unit.symbol)
            }
            None => String::new(),
        }
    }

    fn shown_added(&self, unit: &Unit) -> String {
        shown(self.added_N(), unit)
    }

    /// Note on the relation of hook loads and block weight.
    pub(super) fn note(&self, unit: &Unit) -> Note {
        let said = shown(self.weight_N, unit);
        match self.slips_N.map(|slips| shown(slips, unit)) {
            None => Note::Assumed(format!(
                "the hook loads include the block's {said}, because no slips show the remaining \
                 load on the hook"
            )),
            Some(slips) if self.in_log && self.added_N() == 0.0 => Note::Checked(format!(
                "the median hook load in slips is {slips}, and the given block weight is {said}: \
                 the weights are as logged, including the block; `block_weight` of [rig] is \
                 subtracted from them"
            )),
            Some(slips) if self.in_log => Note::Assumed(format!(
                "the median hook load in slips is {slips}, and the given block weight is {said}: \
                 the zero of the weight indicator is off, and {} were added to the weights, so \
                 that subtracting `block_weight` of [rig] gives the load below the block",
                self.shown_added(unit)
            )),
            Some(slips) if self.slips_N.is_some_and(|off| off.abs() > SAME * self.weight_N) => {
                Note::Assumed(format!(
                    "the median hook load in slips is {slips}, so the sensor was zeroed with the \
                     block on it, with an offset of {slips}: {} were added to the weights, the \
                     block's {said} minus the offset, which makes them those of a weight \
                     indicator; `block_weight` of [rig] is subtracted again",
                    self.shown_added(unit)
                ))
            }
            Some(slips) => Note::Assumed(format!(
                "the median hook load in slips is {slips}, so the sensor was zeroed with the \
                 block on it: its {said} were added to the weights, which makes them those of a \
                 weight indicator; `block_weight` of [rig] is subtracted again"
            )),
        }
    }
}

/// The errors that a ratio of the given weight to the hook load in slips indicates.
fn causes(ratio: f64) -> Vec<&'static str> {
    let causes = ERRORS.iter().filter(|(known, _)| (ratio / known - 1.0).abs() < NEAR);
    causes.map(|(_, cause)| *cause).collect()
}

/// The unit of the log's hook loads that explains a ratio of the given weight to the hook load in
/// slips, in place of theirs.
fn other_unit(ratio: f64, unit: &Unit) -> Option<&'static Unit> {
    const EVERYDAY: [&str; 5] = ["kN", "klbf", "tf", "daN", "lbf"];
    let mut others = EVERYDAY.iter().filter_map(|symbol| Dimension::Force.find_unit(symbol));
    others.find(|other| {
        let factor = other.factor / unit.factor;
        (factor - 1.0).abs() > NEAR && (ratio / factor - 1.0).abs() < NEAR
    })
}

fn not_said(slips_N: Option<f64>, unit: &Unit) -> ImportErrorKind {
    let hint = match slips_N.map(|slips| shown(slips, unit)) {
        Some(slips) => format!(
            "; the median hook load in slips is {slips}, which is the weight of block and top \
             drive if the sensor was not zeroed with them"
        ),
        None => String::new(),
    };
    ImportErrorKind::MissingValue {
        what: "weight of block and top drive".to_owned(),
        name: NAME.to_owned(),
        example: "25 tf".to_owned(),
        hint,
    }
}

/// Formats a weight in the log's unit with three digits.
pub(super) fn shown(newtons: f64, unit: &Unit) -> String {
    format!("{} {}", three_digits(unit.from_si(newtons)), unit.symbol)
}

/// Formats a number with three digits; 0 below 0.01.
pub(super) fn three_digits(value: f64) -> String {
    number_text(if value.abs() < 0.01 { 0.0 } else { significant(value, 3) })
}
