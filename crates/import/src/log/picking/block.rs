//! The weight of the block, which a log does not tell apart from the string's.

use wholestring_units::{Dimension, Unit, number_text};

use super::beginning::Beginning;
use crate::{
    choices::Choices,
    error::ImportErrorKind,
    fragment::{Note, Value},
};

/// The weight of block and top drive, and whether the logged hook loads hold it.
#[derive(Debug, Clone, PartialEq)]
pub struct BlockWeight {
    /// As it was said.
    pub said: Value,
    /// The same, N.
    pub weight_N: f64,
    /// Median hook load in slips, N; none where the log shows no slips.
    pub slips_N: Option<f64>,
    /// Whether it is in the hook loads of the log; where it is not, the sensor was set to zero with
    /// the block on it, and the picked weights have it added.
    pub in_log: bool,
}

/// Its name in `--value`.
const NAME: &str = "block-weight";

/// How much hook load in slips and the block's weight may differ, over the weight: a weight indicator
/// errs by some per cent of the load, by the friction in the sheaves and by elevators and hoses that
/// hang on the hook.
const AGREES: f64 = 0.15;

/// How much of the block's weight a weight indicator shows another one in slips without being
/// corrected: as much as its scale is read to.
const SAME: f64 = 0.01;

impl BlockWeight {
    /// The weight that is said, held against the hook load in slips.
    ///
    /// # Errors
    /// It is not said, or neither the hook load in slips nor nothing.
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
            // Nothing weighs less than nothing: below it the sensor's zero is off.
            Some(slips_N) if slips_N <= AGREES * weight_N => false,
            Some(slips_N) => {
                let slips = self::shown(slips_N, unit);
                return Err(ImportErrorKind::Refused(format!(
                    "in slips the hook load is {slips} at the median, and the block was said to \
                     weigh {shown}; expected about {shown}, or about 0 where the sensor was set to \
                     zero with the block on it; say the weight that hangs on the sensor: --value \
                     {NAME}=\"{slips}\""
                )));
            }
        };
        Ok(Self { said, weight_N, slips_N, in_log })
    }

    /// What is added to a hook load of the log so that it is what a weight indicator shows whose zero
    /// is right, N: below the block hangs what is logged less what is logged in slips.
    pub fn added_N(&self) -> f64 {
        let off_N = self.slips_N.map_or(0.0, |slips_N| self.weight_N - slips_N);
        if self.in_log && off_N.abs() <= SAME * self.weight_N { 0.0 } else { off_N }
    }

    /// What hangs on the sensor besides the string, N.
    pub(super) fn on_sensor_N(&self) -> f64 {
        self.slips_N.unwrap_or(self.weight_N)
    }

    fn shown_added(&self, unit: &Unit) -> String {
        shown(self.added_N(), unit)
    }

    /// How hook loads and the block's weight belong together.
    pub(super) fn note(&self, unit: &Unit) -> Note {
        let said = shown(self.weight_N, unit);
        match self.slips_N.map(|slips| shown(slips, unit)) {
            None => Note::Assumed(format!(
                "the hook loads hold the block's {said}, for no slips show what is left on the hook"
            )),
            Some(slips) if self.in_log && self.added_N() == 0.0 => Note::Checked(format!(
                "in slips the hook load is {slips} at the median, and the block was said to weigh \
                 {said}: the weights are as they were logged, with the block; `block_weight` of \
                 [rig] takes it off"
            )),
            Some(slips) if self.in_log => Note::Assumed(format!(
                "in slips the hook load is {slips} at the median, and the block was said to weigh \
                 {said}: the zero of the weight indicator is off, and {} were added to the weights, \
                 so that `block_weight` of [rig] leaves what hangs below the block",
                self.shown_added(unit)
            )),
            Some(slips) if self.slips_N.is_some_and(|off| off.abs() > SAME * self.weight_N) => {
                Note::Assumed(format!(
                    "in slips the hook load is {slips} at the median, so the sensor was set to zero \
                     with the block on it, and its zero is off by {slips}: {} were added to the \
                     weights, the block's {said} less that, which are those of a weight indicator; \
                     `block_weight` of [rig] takes it off again",
                    self.shown_added(unit)
                ))
            }
            Some(slips) => Note::Assumed(format!(
                "in slips the hook load is {slips} at the median, so the sensor was set to zero with \
                 the block on it: its {said} were added to the weights, which are those of a weight \
                 indicator; `block_weight` of [rig] takes it off again"
            )),
        }
    }
}

fn not_said(slips_N: Option<f64>, unit: &Unit) -> ImportErrorKind {
    let hint = match slips_N.map(|slips| shown(slips, unit)) {
        Some(slips) => format!(
            "; in slips the hook load is {slips} at the median, which is the weight of block and top \
             drive if the sensor was not set to zero with them"
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

/// A weight in the log's unit, in three digits.
pub(super) fn shown(newtons: f64, unit: &Unit) -> String {
    let value = unit.from_si(newtons);
    let size = if value == 0.0 { 0.0 } else { libm::log10(value.abs()).floor() };
    let scale = libm::pow(10f64, 2.0 - size);
    let rounded = if size < -2.0 { 0.0 } else { (value * scale).round() / scale };
    format!("{} {}", number_text(rounded), unit.symbol)
}
