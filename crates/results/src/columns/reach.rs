//! Columns of the tables of a reach.

use super::specs;
use crate::ColumnSpec;

/// Columns of `reach.parquet`: a row for each limit of each operation at each depth and friction.
pub const REACH: &[ColumnSpec] = specs! {
    "operation": Words, "`trip_out`, `drill`, ...";
    "limit": Words,
        "`top_drive`, `hoist`, `hook_load_zero`, `push_spent`, `push_absorbed`, `make_up`, `torsion`, \
         `yield_strength`, `helix`, `sinusoid`, `vertical_helix` or `vertical_sinusoid`";
    "friction": Ratio, "Friction factor of all sections, `null` where they have the case's own",
        null_where "the sections have the case's own";
    "bit_depth_m": Depth, "Measured depth of the bit";
    "margin": Ratio,
        "Remaining part of the limit, zero where it is reached and negative beyond; for \
         `push_absorbed` the part of an added push that reaches the bit; `null` for a string that is locked up",
        null_where "the string is locked up";
    "force_N": Force,
        "Force compared with a limit: hook load, with the block for `hoist`, with the push for \
         `push_spent`; compression; else `null`",
        null_where "the limit is no force, or the string is locked up";
    "force_limit_N": Force, "Its limit: capacity, zero, critical load; else `null`",
        null_where "the limit is no force, nothing is compressed, or the string is locked up";
    "torque_N_m": Torque, "Torque compared with a limit: at the surface for `top_drive`, at `md_m` for `make_up` and \
         `torsion`; else `null`",
        null_where "the limit is no torque, or the string is locked up";
    "torque_limit_N_m": Torque, "Its limit: rated torque of the top drive, capacity of connection or pipe, over the required \
         factor; else `null`",
        null_where "the limit is no torque, or no component with a known capacity turns";
    "md_m": Depth,
        "Measured depth of the smallest margin in the string, `null` for a limit at the surface",
        null_where "it is a limit at the surface, or nothing is compressed";
};

/// Columns of `reach_limits.parquet`: a row for each limit of each operation and friction.
pub const REACH_LIMITS: &[ColumnSpec] = specs! {
    "operation": Words, "As in `reach.parquet`";
    "limit": Words, "As in `reach.parquet`";
    "friction": Ratio, "As in `reach.parquet`, `null` where the sections have the case's own",
        null_where "the sections have the case's own";
    "stops": Ratio, "1 where the string stops there, 0 where it continues buckled";
    "depth_m": Depth, "Depth of the bit where it is first reached, `null` where it is not reached",
        null_where "it is not reached";
    "already": Ratio, "1 where it is reached at the first depth already, else 0";
    "margin_at_from": Ratio, "`margin` at the first depth, `null` for a string that is locked up",
        null_where "the string is locked up";
    "margin_at_to": Ratio, "`margin` at the last depth, `null` for a string that is locked up",
        null_where "the string is locked up";
    "md_m": Depth,
        "Measured depth of the smallest margin in the string at that depth of the bit, or at the \
         last depth where it is not reached; `null` for a limit at the surface",
        null_where "it is a limit at the surface, or nothing is compressed";
};
