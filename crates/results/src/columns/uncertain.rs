//! Columns of the tables of what is not known exactly, of plans and reaches alike.

use crate::ColumnSpec;

/// Adds what says of which number they are.
macro_rules! uncertain_specs {
    ($($name:literal: $kind:ident, $meaning:literal $(, null_where $none:literal)?;)+) => {
        &[
            $crate::columns::specs!(@one "quantity", Words,
                "`hook_load`, `surface_torque`, `reserve` of a limit (its factor over the required one, \
                 the least of all depths and components), `sinusoidal_weight` and `helical_weight` on \
                 bit; of a reach `depth` where a limit is met, or `margin`"),
            $crate::columns::specs!(@one "limit", Words,
                "Which limit, as in the table of limits; empty where it is of none")
                .null_where("it is of no limit"),
            $crate::columns::specs!(@one "operation", Words,
                "`trip_out`, `drill`, ...; empty of the depth that stops the well, whatever the operation")
                .null_where("it is of all operations"),
            $crate::columns::specs!(@one "friction", Ratio,
                "Friction factor that all sections were given in place of their own, else `null`")
                .null_where("the sections have their own"),
            $crate::columns::specs!(@one "bit_depth_m", Depth,
                "Measured depth of the bit; `null` of what is of all depths")
                .null_where("it is of all depths"),
            $($crate::columns::specs!(@one $name, $kind, $meaning)$(.null_where($none))?),+
        ]
    };
}

/// Columns of `plan_uncertain.parquet` and `reach_uncertain.parquet`: how the samples scatter, a row for
/// each number.
pub const UNCERTAIN: &[ColumnSpec] = uncertain_specs! {
    "unit": Words, "Unit of what follows: `N`, `N·m`, `m`, or `1`";
    "expected": Ratio, "The case's own number, or `null` where it has none",
        null_where "the case has none";
    "p05": Ratio, "Below this lie 5 % of the samples";
    "p10": Ratio, "Below this lie 10 %";
    "p50": Ratio, "Below this lies half of them";
    "p90": Ratio, "Below this lie 90 %";
    "p95": Ratio, "Below this lie 95 %";
    "mean": Ratio, "Mean of the samples";
    "std": Ratio, "Their standard deviation";
    "answers": Ratio, "Samples that have the number";
    "without_answer": Ratio, "Samples without an answer, such as a string that locks up: they are not in the band";
    "not_met": Ratio,
        "Of a depth: samples whose limit is not met down to the last one; they count with that depth";
};

/// Columns of `plan_uncertain_indices.parquet` and `reach_uncertain_indices.parquet`: which inputs the
/// variance of the samples is owed to, a row for each number and input.
pub const UNCERTAIN_INDICES: &[ColumnSpec] = uncertain_specs! {
    "input": Words, "Key of the input";
    "first_order": Ratio,
        "What part of the variance would go if the input were known; `null` of a choice among more than \
         four values",
        null_where "it is a choice among more than four values";
    "total": Ratio,
        "What part would stay if all other inputs were known; of a choice among more than four values \
         all that the others do not tell";
    "predicts": Ratio,
        "What part of the variance the fit predicts at samples that it was not fitted to: indices mean \
         little below 0.9, but where a choice among more than four values has the rest";
    "degree": Ratio, "Degree of its polynomials";
};

/// Columns of `reach_uncertain_stops.parquet`: what stops a well first, and in how many samples; a
/// row for each stop and friction.
pub const UNCERTAIN_STOPS: &[ColumnSpec] = super::specs! {
    "friction": Ratio,
        "Friction factor that all sections were given in place of their own, else `null`",
        null_where "the sections have their own";
    "operation": Words, "`trip_out`, `drill`, ...; empty where nothing stops it",
        null_where "nothing stops it";
    "limit": Words, "As in `reach.parquet`; empty where nothing stops it", null_where "nothing stops it";
    "samples": Ratio, "In how many samples";
};

/// Columns of `plan_uncertain_samples.parquet` and `reach_uncertain_samples.parquet`: what was drawn, a row
/// for each sample and input.
pub const UNCERTAIN_SAMPLES: &[ColumnSpec] = super::specs! {
    "sample": Ratio, "Number of the sample, from one";
    "input": Words, "Key of the input";
    "value": Ratio, "Its value, in `unit`; `null` of a choice among texts",
        null_where "it is a choice among texts";
    "unit": Words, "The unit as the case has it; empty of a bare number", null_where "it is a bare number";
    "written": Words, "The value as a case has it";
    "without_answer": Ratio, "How many points of this sample have no answer; `null` where it was not solved",
        null_where "it was not solved";
    "message": Words, "Why the first of them has none; else empty", null_where "all have an answer";
};
