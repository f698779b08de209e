//! Weights on bit at which the string of a plan begins to buckle.

use serde::{Deserialize, Serialize};
use wholestring::{operation::OperationKind, outcome::ModelKind, well::FrictionLevel};

use crate::{
    columns::{FRICTION, MODEL, OPERATION},
    row::rows,
};

rows! {
    /// The weight on bit at which the string begins to buckle.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct PlanBuckling {
        model: ModelKind => Words as MODEL, "The model: `soft`";
        friction: FrictionLevel => Words as FRICTION, "Level of friction";
        operation: OperationKind => Words as OPERATION, "The operation: `drill` or `slide`";
        bit_depth_m: f64 => Depth, "Measured depth of the bit";
        sinusoidal_weight_N: Option<f64> => Force,
            "Least weight on bit at which part of the string buckles to a sinusoid, 0 where it \
             does without any; `null` where no weight does or there is no answer",
            null_where "no weight does, or there is no answer";
        helical_weight_N: Option<f64> => Force, "The same for a helix, or `null`",
            null_where "no weight does, or there is no answer";
        message: Option<String> => Words, "Reason why there is no answer; else empty",
            null_where "there is an answer";
    }

    /// Columns of `plan_buckling.parquet`: the weight on bit under which the string begins to
    /// buckle, a row for each depth of the bit, of each operation that drills and each friction.
    pub const PLAN_BUCKLING;
}
