//! Columns of `bottom_hole.parquet`.

use wholestring::outcome::QuantityKind;

use crate::ColumnSpec;

/// Columns of `bottom_hole.parquet`: the pattern on the bottom of the hole at the end, one row per
/// cell, ring after ring from the axis outwards, for each operation whose bit stood on solid rock.
pub const BOTTOM_HOLE: &[ColumnSpec] = &[
    ColumnSpec::text("operation", "`drill`, `slide`, ..."),
    ColumnSpec::number("radius_m", QuantityKind::Length, "Radius of the middle of the ring"),
    ColumnSpec::number(
        "angle_rad",
        QuantityKind::Angle,
        "Angle of the middle of the sector from the high side towards the right, looking down the \
         hole",
    ),
    ColumnSpec::number(
        "depth_m",
        QuantityKind::Length,
        "Depth of the rock that is uppermost there, below the nose of the bit; `null` where none \
         stands",
    )
    .null_where("no rock stands"),
];
