//! Rows of the tables of uncertain inputs and their effect, for plans and reaches alike.

use serde::{Deserialize, Serialize};
use wholestring::{
    operation::OperationKind,
    outcome::QuantityKind::{Depth, Ratio},
};
use wholestring_judge::DepthLimit;

use crate::{ColumnSpec, or_empty, row::rows};

/// The number that scatters.
const QUANTITY: ColumnSpec = ColumnSpec::text(
    "quantity",
    "`hook_load`, `surface_torque`, `reserve` for a limit (its factor over the \
     required one, the least of all depths and components), `sinusoidal_weight` and \
     `helical_weight` on bit; for a reach `depth` where a limit is met, or `margin`",
);

/// Its limit.
const LIMIT: ColumnSpec =
    ColumnSpec::text("limit", "The limit, as in the table of limits; empty for other numbers")
        .null_where("it is of no limit");

/// Its operation.
const OPERATION: ColumnSpec = ColumnSpec::text(
    "operation",
    "`trip_out`, `drill`, ...; empty for the depth that stops the well in any of them",
)
.null_where("it is of all operations");

/// Its friction.
const FRICTION: ColumnSpec = ColumnSpec::number(
    "friction",
    Ratio,
    "Friction factor of all sections in place of their own, else `null`",
)
.null_where("the sections have their own");

/// Its depth of the bit.
const BIT_DEPTH: ColumnSpec = ColumnSpec::number(
    "bit_depth_m",
    Depth,
    "Measured depth of the bit; `null` for a number of all depths",
)
.null_where("it is of all depths");

rows! {
    /// Distribution of a number.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct UncertainBand {
        quantity: String => Words as QUANTITY,
            "`hook_load`, `surface_torque`, `reserve`, `sinusoidal_weight`, `helical_weight`, \
             `depth` or `margin`";
        limit: String => Words as LIMIT, "The limit; empty for other numbers";
        #[serde(with = "or_empty")]
        operation: Option<OperationKind> => Words as OPERATION,
            "The operation; none for all, empty in the file";
        friction: Option<f64> => Ratio as FRICTION,
            "Friction factor of all sections; none where they have their own";
        bit_depth_m: Option<f64> => Depth as BIT_DEPTH,
            "Measured depth of the bit; none for all depths";
        unit: String => Words, "Unit of the following columns: `N`, `N·m`, `m`, or `1`";
        expected: Option<f64> => Ratio, "The case's own number, or `null` where it has none",
            null_where "the case has none";
        quantiles: [f64; 5],
            "The 5th, 10th, 50th, 90th and 95th percentiles of the samples",
            columns {
                p05 = |quantiles| quantiles[0] => Ratio, "5th percentile of the samples";
                p10 = |quantiles| quantiles[1] => Ratio, "10th percentile";
                p50 = |quantiles| quantiles[2] => Ratio, "Median";
                p90 = |quantiles| quantiles[3] => Ratio, "90th percentile";
                p95 = |quantiles| quantiles[4] => Ratio, "95th percentile";
            };
        mean: f64 => Ratio, "Mean of the samples";
        std: f64 => Ratio, "Their standard deviation";
        answers: usize => Ratio, "Samples that have the number";
        without_answer: usize => Ratio,
            "Samples without an answer, such as a string that locks up: they are not in the band";
        not_met: usize => Ratio,
            "For a depth: samples whose limit is not met down to the last one; they count with \
             that depth";
        owed: Option<UncertainOwed>,
            "Sensitivity to the inputs (Sobol indices); none where it was not computed or the \
             number does not scatter";
    }

    /// Columns of `plan_uncertain.parquet` and `reach_uncertain.parquet`: distribution of the
    /// samples, a row for each number.
    pub const UNCERTAIN;
}

/// Sensitivity of a number to the inputs (Sobol indices); one value for each input.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct UncertainOwed {
    /// First-order indices.
    pub first: Vec<Option<f64>>,
    /// Total indices.
    pub total: Vec<f64>,
    /// Part of the variance that the fit predicts.
    pub predicts: f64,
    /// Degree of its polynomials.
    pub degree: usize,
}

rows! {
    /// Share of an input in the variance of a number.
    #[derive(Debug, Clone, PartialEq)]
    pub struct UncertainIndex {
        quantity: String => Words as QUANTITY, "The number that scatters";
        limit: String => Words as LIMIT, "The limit; empty for other numbers";
        operation: Option<OperationKind> => Words as OPERATION, "The operation; none for all";
        friction: Option<f64> => Ratio as FRICTION,
            "Friction factor of all sections; none where they have their own";
        bit_depth_m: Option<f64> => Depth as BIT_DEPTH,
            "Measured depth of the bit; none for all depths";
        input: String => Words, "Key of the input";
        first_order: Option<f64> => Ratio,
            "Part of the variance that would vanish if the input were known; `null` for a choice \
             among more than four values",
            null_where "it is a choice among more than four values";
        total: f64 => Ratio,
            "Part that would remain if all other inputs were known; for a choice among more than \
             four values all that the others do not explain";
        predicts: f64 => Ratio,
            "Part of the variance that the fit predicts at samples outside the fit: indices mean \
             little below 0.9, but where a choice among more than four values has the rest";
        degree: usize => Ratio, "Degree of its polynomials";
    }

    /// Columns of `plan_uncertain_indices.parquet` and `reach_uncertain_indices.parquet`: shares of
    /// the inputs in the variance of the samples, a row for each number and input.
    pub const UNCERTAIN_INDICES;
}

rows! {
    /// Limit that stops a well first.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct UncertainStop {
        friction: Option<f64> => Ratio,
            "Friction factor of all sections in place of their own, else `null`",
            null_where "the sections have their own";
        #[serde(with = "or_empty")]
        operation: Option<OperationKind> => Words,
            "`trip_out`, `drill`, ...; empty where nothing stops it",
            null_where "nothing stops it";
        #[serde(with = "or_empty")]
        limit: Option<DepthLimit> => Words, "As in `reach.parquet`; empty where nothing stops it",
            null_where "nothing stops it";
        samples: usize => Ratio, "Number of samples";
    }

    /// Columns of `reach_uncertain_stops.parquet`: the limits that stop a well first, and the
    /// number of samples of each; a row for each stop and friction.
    pub const UNCERTAIN_STOPS;
}

rows! {
    /// Value of an input in a sample.
    #[derive(Debug, Clone, PartialEq)]
    pub struct UncertainSample {
        sample: usize => Ratio, "Number of the sample, from one";
        input: String => Words, "Key of the input";
        value: f64 => Ratio, "Its value, in `unit`; `null` for a choice among texts",
            null_where "it is a choice among texts";
        unit: String => Words, "The unit as the case has it; empty of a bare number",
            null_where "it is a bare number";
        written: String => Words, "The value as a case has it";
        without_answer: Option<usize> => Ratio,
            "Number of points of this sample without an answer; `null` where it was not solved",
            null_where "it was not solved";
        message: Option<String> => Words,
            "Reason why the first of them has none; else empty",
            null_where "all have an answer";
    }

    /// Columns of `plan_uncertain_samples.parquet` and `reach_uncertain_samples.parquet`: the drawn
    /// samples, a row for each sample and input.
    pub const UNCERTAIN_SAMPLES;
}
