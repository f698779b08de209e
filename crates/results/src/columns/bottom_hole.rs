//! Columns of `bottom_hole.parquet`.

use super::specs;
use crate::ColumnSpec;

/// Columns of `bottom_hole.parquet`: the pattern on the bottom of the hole at the end, one row per
/// cell, ring after ring from the axis outwards, for each operation whose bit was on solid rock.
pub const BOTTOM_HOLE: &[ColumnSpec] = specs! {
    "operation": Words, "`drill`, `slide`, ...";
    "radius_m": Length, "Radius of the middle of the ring";
    "angle_rad": Angle,
        "Angle of the middle of the sector from the high side towards the right, looking down the \
         hole";
    "depth_m": Length,
        "Depth of the uppermost rock, below the nose of the bit; `null` where no \
         rock is left",
        null_where "no rock is left";
};
