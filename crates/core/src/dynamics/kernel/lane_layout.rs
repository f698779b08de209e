//! Lengths of the pieces that a chain is cut into.

use serde::{Deserialize, Serialize};

/// Lengths of the pieces that a chain is cut into.
///
/// Every number of a node is looked up by its place, and divisions would take most of the time: the
/// inverse of the length, rounded up, is multiplied with instead.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "usize", into = "usize")]
pub struct LaneLayout {
    rows: usize,
    inverse: u64,
}

impl LaneLayout {
    /// Binary places of the inverse.
    const PLACES: u32 = 40;
    /// Length up to which places are exact in 32 lanes: `32 LONGEST² < 2^PLACES`. No string is as
    /// long.
    const LONGEST: usize = 1 << 17;

    /// Part of its length by which a piece may be longer than it must, so that the pattern fits.
    const SPARE: f64 = 0.06;

    /// As long as so many nodes in so many lanes need. `pattern` is the number of nodes after which
    /// a string looks the same: pieces that hold it a whole number of times have their tool joints
    /// side by side, and the rows between them, where no node touches the wall, are done with
    /// sooner.
    pub fn new(nodes: usize, lanes: usize, pattern: usize) -> Self {
        let rows = nodes.div_ceil(lanes);
        let fitting = rows.next_multiple_of(pattern);
        let spare = (fitting - rows) as f64;
        let rows = if spare <= Self::SPARE * rows as f64 { fitting } else { rows };
        Self::of(rows)
    }

    /// Of so many rows.
    ///
    /// # Panics
    /// If there are more than any string has.
    pub fn of(rows: usize) -> Self {
        Self::try_from(rows).unwrap_or_else(|reason| panic!("{reason}"))
    }

    /// Number of rows.
    pub fn rows(self) -> usize {
        self.rows
    }

    /// Row and lane of a node, and of the element below it.
    #[inline]
    pub fn place(self, index: usize) -> (usize, usize) {
        // Before its fraction is cut off it is too large by `index / 2^PLACES` at most, less than
        // `1 / rows`: exact.
        let lane = ((index as u64 * self.inverse) >> Self::PLACES) as usize;
        (index - lane * self.rows, lane)
    }

    /// The node at a row and a lane; none of the string's where the last lane is not full.
    pub fn index(self, (row, lane): (usize, usize)) -> usize {
        lane * self.rows + row
    }
}

impl TryFrom<usize> for LaneLayout {
    type Error = String;

    fn try_from(rows: usize) -> Result<Self, String> {
        if rows > Self::LONGEST {
            return Err(format!("pieces of {rows} nodes"));
        }
        Ok(Self { rows, inverse: (1 << Self::PLACES) / rows.max(1) as u64 + 1 })
    }
}

impl From<LaneLayout> for usize {
    fn from(lane_layout: LaneLayout) -> Self {
        lane_layout.rows
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simd::lanes::{DOUBLES, SINGLES};

    /// 1347 nodes with a joint at every third are 85 rows of sixteen, which 87 hold as well; at
    /// every twelfth it would take 96.
    #[test]
    fn joints_stand_side_by_side_where_that_costs_little() {
        let rows = |pattern| LaneLayout::new(1347, DOUBLES, pattern).rows();
        assert_eq!([1, 3, 12].map(rows), [85, 87, 85]);
    }

    #[test]
    fn a_place_is_the_quotient_and_its_rest() {
        let longest = LaneLayout::LONGEST;
        for rows in (1..300).chain([4095, 4096, 4097, longest - 1, longest]) {
            let lane_layout = LaneLayout::of(rows);
            for lane in 0..SINGLES {
                for row in [0, 1, rows / 2, rows - 1].map(|row| row.min(rows - 1)) {
                    assert_eq!(lane_layout.place(lane * rows + row), (row, lane));
                    assert_eq!(lane_layout.index((row, lane)), lane * rows + row);
                }
            }
        }
    }
}
