//! The pattern on the bottom of the hole.

use crate::row::rows;

rows! {
    /// A cell of the bottom of a hole.
    #[derive(Debug, Clone, PartialEq)]
    pub struct BottomHoleCell {
        operation: String => Words, "`drill`, `slide`, ...";
        radius_m: f64 => Length, "Radius of the middle of the ring";
        angle_rad: f64 => Angle,
            "Angle of the middle of the sector from the high side towards the right, looking down \
             the hole";
        depth_m: Option<f64> => Length,
            "Depth of the uppermost rock, below the nose of the bit; `null` where no \
             rock is left",
            null_where "no rock is left";
    }

    /// Columns of `bottom_hole.parquet`: the pattern on the bottom of the hole at the end, one row
    /// per cell, ring after ring from the axis outwards, for each operation whose bit was on solid
    /// rock.
    pub const BOTTOM_HOLE;
}
