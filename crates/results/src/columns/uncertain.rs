//! Columns of the tables of uncertain inputs and their effect, for plans and reaches alike.

use crate::ColumnSpec;

/// Adds the columns that identify the number.
macro_rules! uncertain_specs {
    ($($name:literal: $kind:ident, $meaning:literal $(, null_where $none:literal)?;)+) => {
        &[
            $crate::columns::specs!(@one "quantity", Words,
                "`hook_load`, `surface_torque`, `reserve` for a limit (its factor over the \
                 required one, the least of all depths and components), `sinusoidal_weight` and \
                 `helical_weight` on bit; for a reach `depth` where a limit is met, or `margin`"),
            $crate::columns::specs!(@one "limit", Words,
                "The limit, as in the table of limits; empty for other numbers")
                .null_where("it is of no limit"),
            $crate::columns::specs!(@one "operation", Words,
                "`trip_out`, `drill`, ...; empty for the depth that stops the well in any of them")
                .null_where("it is of all operations"),
            $crate::columns::specs!(@one "friction", Ratio,
                "Friction factor of all sections in place of their own, else `null`")
                .null_where("the sections have their own"),
            $crate::columns::specs!(@one "bit_depth_m", Depth,
                "Measured depth of the bit; `null` for a number of all depths")
                .null_where("it is of all depths"),
            $($crate::columns::specs!(@one $name, $kind, $meaning)$(.null_where($none))?),+
        ]
    };
}

/// Columns of `plan_uncertain.parquet` and `reach_uncertain.parquet`: distribution of the samples,
/// a row for each number.
pub const UNCERTAIN: &[ColumnSpec] = uncertain_specs! {
    "unit": Words, "Unit of the following columns: `N`, `N·m`, `m`, or `1`";
    "expected": Ratio, "The case's own number, or `null` where it has none",
        null_where "the case has none";
    "p05": Ratio, "5th percentile of the samples";
    "p10": Ratio, "10th percentile";
    "p50": Ratio, "Median";
    "p90": Ratio, "90th percentile";
    "p95": Ratio, "95th percentile";
    "mean": Ratio, "Mean of the samples";
    "std": Ratio, "Their standard deviation";
    "answers": Ratio, "Samples that have the number";
    "without_answer": Ratio,
        "Samples without an answer, such as a string that locks up: they are not in the band";
    "not_met": Ratio,
        "For a depth: samples whose limit is not met down to the last one; they count with that \
         depth";
};

/// Columns of `plan_uncertain_indices.parquet` and `reach_uncertain_indices.parquet`: shares of the
/// inputs in the variance of the samples, a row for each number and input.
pub const UNCERTAIN_INDICES: &[ColumnSpec] = uncertain_specs! {
    "input": Words, "Key of the input";
    "first_order": Ratio,
        "Part of the variance that would vanish if the input were known; `null` for a choice \
         among more than four values",
        null_where "it is a choice among more than four values";
    "total": Ratio,
        "Part that would remain if all other inputs were known; for a choice among more than four \
         values all that the others do not explain";
    "predicts": Ratio,
        "Part of the variance that the fit predicts at samples outside the fit: indices mean \
         little below 0.9, but where a choice among more than four values has the rest";
    "degree": Ratio, "Degree of its polynomials";
};

/// Columns of `reach_uncertain_stops.parquet`: the limits that stop a well first, and the number of
/// samples of each; a row for each stop and friction.
pub const UNCERTAIN_STOPS: &[ColumnSpec] = super::specs! {
    "friction": Ratio,
        "Friction factor of all sections in place of their own, else `null`",
        null_where "the sections have their own";
    "operation": Words, "`trip_out`, `drill`, ...; empty where nothing stops it",
        null_where "nothing stops it";
    "limit": Words, "As in `reach.parquet`; empty where nothing stops it",
        null_where "nothing stops it";
    "samples": Ratio, "Number of samples";
};

/// Columns of `plan_uncertain_samples.parquet` and `reach_uncertain_samples.parquet`: the drawn
/// samples, a row for each sample and input.
pub const UNCERTAIN_SAMPLES: &[ColumnSpec] = super::specs! {
    "sample": Ratio, "Number of the sample, from one";
    "input": Words, "Key of the input";
    "value": Ratio, "Its value, in `unit`; `null` for a choice among texts",
        null_where "it is a choice among texts";
    "unit": Words, "The unit as the case has it; empty of a bare number",
        null_where "it is a bare number";
    "written": Words, "The value as a case has it";
    "without_answer": Ratio,
        "Number of points of this sample without an answer; `null` where it was not solved",
        null_where "it was not solved";
    "message": Words, "Reason why the first of them has none; else empty",
        null_where "all have an answer";
};
