//! Columns of `frames.parquet`.

use wholestring::{dynamics::FRAME, outcome::QuantityKind};

use super::{OPERATION, table};
use crate::ColumnSpec;

const TIME_S: ColumnSpec = ColumnSpec::number(
    "time_s",
    QuantityKind::Time,
    "Simulated time from the start, settling included",
);

const NODE: ColumnSpec =
    ColumnSpec::number("node", QuantityKind::Ratio, "Number of the node, from 0 at the surface");

/// Columns of `frames.parquet`: the whole string, a row per node of every frame. Channels that were
/// not requested have no column.
pub const FRAMES: &[ColumnSpec] =
    &table::<_, { FRAME.len() + 3 }>(&[OPERATION, TIME_S, NODE], FRAME, &[]);
