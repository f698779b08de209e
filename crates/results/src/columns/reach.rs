//! Columns of the tables of a reach.

use super::specs;
use crate::ColumnSpec;

/// Columns of `reach.parquet`: a row for each limit of each operation at each depth and friction.
pub const REACH: &[ColumnSpec] = specs! {
    "operation": Words, "`trip_out`, `drill`, ...";
    "limit": Words,
        "`top_drive`, `hoist`, `hook_load_zero`, `push_spent`, `lock_up`, `yield_strength`, `helix`, \
         `sinusoid` or `vertical_helix`";
    "friction": Ratio, "Friction factor of all sections, `null` where they have the case's own",
        null_where "the sections have the case's own";
    "bit_depth_m": Depth, "Measured depth of the bit";
    "margin": Ratio,
        "Part of the limit that is left, zero where it is met and negative beyond; of `lock_up` the \
         part of an added push that arrives at the bit; `null` of a string that is locked up",
        null_where "the string is locked up";
    "force_N": Force,
        "What is held against a force: hook load, with the block for `hoist`, with what pushes for \
         `push_spent`; compression; else `null`",
        null_where "the limit is no force, or the string is locked up";
    "force_limit_N": Force, "That force: capacity, zero, critical load; else `null`",
        null_where "the limit is no force, nothing is compressed, or the string is locked up";
    "torque_N_m": Torque, "Torque at surface for `top_drive`, else `null`",
        null_where "the limit is no torque";
    "torque_limit_N_m": Torque, "Rated torque of the top drive, else `null`",
        null_where "the limit is no torque";
    "md_m": Depth, "Where in the string it is worst, `null` of what the surface sees",
        null_where "the surface sees it, or nothing is compressed";
};

/// Columns of `reach_limits.parquet`: a row for each limit of each operation and friction.
pub const REACH_LIMITS: &[ColumnSpec] = specs! {
    "operation": Words, "As in `reach.parquet`";
    "limit": Words, "As in `reach.parquet`";
    "friction": Ratio, "As in `reach.parquet`, `null` where the sections have the case's own",
        null_where "the sections have the case's own";
    "stops": Ratio, "1 where the string stops there, 0 where it goes on buckled";
    "depth_m": Depth, "Depth of the bit where it is met first, `null` where it is not met",
        null_where "it is not met";
    "already": Ratio, "1 where it is met at the first depth already, else 0";
    "margin_at_from": Ratio, "`margin` at the first depth, `null` of a string that is locked up",
        null_where "the string is locked up";
    "margin_at_to": Ratio, "`margin` at the last depth, `null` of a string that is locked up",
        null_where "the string is locked up";
    "md_m": Depth,
        "Where in the string it is worst then, at the last depth where it is not met; `null` of what \
         the surface sees",
        null_where "the surface sees it, or nothing is compressed";
};
