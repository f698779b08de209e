//! Depths of bit and hole in a log that has only one of them.

use super::{row::Row, thresholds::Thresholds};
use crate::fragment::Note;

/// Apparent decrease of hole depth that is a correction of depth, m.
const SET_RIGHT_M: f64 = 20.0;

/// Fraction of the rows with decreasing depth above which the depth is that of the bit.
const GOES_UP: f64 = 0.01;

/// Interpretation of the depths of a log.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Depths {
    /// The logged hole depth increases and decreases: it is the bit depth.
    is_of_bit: bool,
    /// Assumed hole depth where none is logged, m.
    hole_m: Option<f64>,
    has_weight_on_bit: bool,
}

impl Depths {
    /// Derives it from the first rows.
    pub(super) fn of(rows: &[Row], limits: &Thresholds) -> Self {
        let has = |value: fn(&Row) -> f64| rows.iter().any(|row| value(row).is_finite());
        let (bit, hole) = (has(|row| row.bit_depth_m), has(|row| row.hole_depth_m));
        let is_of_bit = !bit && hole && goes_up(rows);
        let depth = |row: &Row| if is_of_bit { row.hole_depth_m } else { row.bit_depth_m };
        let is_alone = is_of_bit || (bit && !hole);
        let deepest_m = rows.iter().map(depth).fold(f64::NAN, f64::max);
        let drills = drilled_m(rows, depth, limits) > limits.off_bottom_m;
        Self {
            is_of_bit,
            // The bit is then off bottom at every depth.
            hole_m: (is_alone && !drills).then_some(deepest_m + 2.0 * limits.off_bottom_m),
            has_weight_on_bit: has(|row| row.weight_on_bit_N),
        }
    }

    /// Adds the missing depths to a row.
    pub(super) fn give(&self, row: &mut Row) {
        if self.is_of_bit {
            row.bit_depth_m = row.hole_depth_m;
            row.hole_depth_m = f64::NAN;
        }
        if let Some(hole_m) = self.hole_m {
            row.hole_depth_m = hole_m;
        }
    }

    /// Whether any channel shows that the bit is off bottom.
    pub(super) fn tells_bottom(&self) -> bool {
        self.hole_m.is_none() || self.has_weight_on_bit
    }

    /// Notes on the assumptions.
    pub(super) fn notes(&self) -> Vec<Note> {
        let mut notes = Vec::new();
        if self.is_of_bit {
            let text = "the only depth increases and decreases: it is that of the bit, not of the \
                 hole";
            notes.push(Note::Assumed(text.to_owned()));
        }
        if self.hole_m.is_some() {
            notes.push(Note::Assumed(
                "no channel has the depth of the hole, and the string does not turn while the bit \
                 gets deeper than before: it is assumed to be off bottom throughout"
                    .to_owned(),
            ));
        }
        if !self.tells_bottom() {
            notes.push(Note::LeftOut(
                "rotating weights, because neither a depth of the hole nor a weight on bit shows \
                 that the bit is off bottom"
                    .to_owned(),
            ));
        }
        notes
    }
}

/// Whether the hole depth decreases, which is impossible for a hole.
fn goes_up(rows: &[Row]) -> bool {
    let mut deepest_m = f64::NEG_INFINITY;
    let above = rows.iter().filter(|row| {
        deepest_m = deepest_m.max(row.hole_depth_m);
        row.hole_depth_m < deepest_m - SET_RIGHT_M
    });
    above.count() as f64 > GOES_UP * rows.len() as f64
}

/// Distance that the bit advances below its deepest point while the string turns, m.
fn drilled_m(rows: &[Row], depth: impl Fn(&Row) -> f64, limits: &Thresholds) -> f64 {
    let mut deepest_m = f64::NAN;
    let mut drilled_m = 0.0;
    for row in rows {
        let depth_m = depth(row);
        // A comparison with NaN is false.
        let more_m = depth_m - deepest_m;
        if more_m > 0.0 && row.rotary_rad_per_s.abs() > limits.turns_rad_per_s {
            drilled_m += more_m;
        }
        deepest_m = deepest_m.max(depth_m);
    }
    drilled_m
}
