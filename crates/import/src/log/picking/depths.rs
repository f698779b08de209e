//! Depths of the bit and of the hole, in a log that has only one of them.

use super::{row::Row, thresholds::Thresholds};
use crate::fragment::Note;

/// Way that the bottom of a hole may seem to go up, m: a depth that is set right.
const SET_RIGHT_M: f64 = 20.0;

/// Rows of a hundred whose depth must go up before it is the bit's.
const GOES_UP: f64 = 0.01;

/// What the depths of a log are.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Depths {
    /// The depth of the hole goes up and down: it is the bit's.
    is_of_bit: bool,
    /// The depth of the hole that is taken where none is logged, m.
    hole_m: Option<f64>,
    has_weight_on_bit: bool,
}

impl Depths {
    /// Sees what the first rows tell.
    pub(super) fn of(rows: &[Row], limits: &Thresholds) -> Self {
        let has = |of: fn(&Row) -> f64| rows.iter().any(|row| of(row).is_finite());
        let (bit, hole) = (has(|row| row.bit_depth_m), has(|row| row.hole_depth_m));
        let is_of_bit = !bit && hole && goes_up(rows);
        let depth = |row: &Row| if is_of_bit { row.hole_depth_m } else { row.bit_depth_m };
        let is_alone = is_of_bit || (bit && !hole);
        let deepest_m = rows.iter().map(depth).fold(f64::NAN, f64::max);
        let drills = drilled_m(rows, depth, limits) > limits.off_bottom_m;
        Self {
            is_of_bit,
            // So that it is off bottom wherever it is.
            hole_m: (is_alone && !drills).then_some(deepest_m + 2.0 * limits.off_bottom_m),
            has_weight_on_bit: has(|row| row.weight_on_bit_N),
        }
    }

    /// Gives a row the depths that it lacks.
    pub(super) fn give(&self, row: &mut Row) {
        if self.is_of_bit {
            row.bit_depth_m = row.hole_depth_m;
            row.hole_depth_m = f64::NAN;
        }
        if let Some(hole_m) = self.hole_m {
            row.hole_depth_m = hole_m;
        }
    }

    /// Whether anything tells that the bit is off bottom.
    pub(super) fn tells_bottom(&self) -> bool {
        self.hole_m.is_none() || self.has_weight_on_bit
    }

    /// What was assumed.
    pub(super) fn notes(&self) -> Vec<Note> {
        let mut notes = Vec::new();
        if self.is_of_bit {
            let text = "the only depth goes up and down: it is the bit's and not the hole's";
            notes.push(Note::Assumed(text.to_owned()));
        }
        if self.hole_m.is_some() {
            notes.push(Note::Assumed(
                "no channel has the depth of the hole, and the string does not turn while the bit \
                 gets deeper than before: it is off bottom all along"
                    .to_owned(),
            ));
        }
        if !self.tells_bottom() {
            notes.push(Note::LeftOut(
                "rotating weights, for neither a depth of the hole nor a weight on bit tells that the \
                 bit is off bottom"
                    .to_owned(),
            ));
        }
        notes
    }
}

/// Whether the depth of the hole goes up, which no hole does.
fn goes_up(rows: &[Row]) -> bool {
    let mut deepest_m = f64::NEG_INFINITY;
    let above = rows.iter().filter(|row| {
        deepest_m = deepest_m.max(row.hole_depth_m);
        row.hole_depth_m < deepest_m - SET_RIGHT_M
    });
    above.count() as f64 > GOES_UP * rows.len() as f64
}

/// Way by which the bit gets deeper than ever while the string turns, m.
fn drilled_m(rows: &[Row], depth: impl Fn(&Row) -> f64, limits: &Thresholds) -> f64 {
    let mut deepest_m = f64::NAN;
    let mut drilled_m = 0.0;
    for row in rows {
        let depth_m = depth(row);
        // A comparison with nothing is false.
        let more_m = depth_m - deepest_m;
        if more_m > 0.0 && row.rotary_rad_per_s.abs() > limits.turns_rad_per_s {
            drilled_m += more_m;
        }
        deepest_m = deepest_m.max(depth_m);
    }
    drilled_m
}
