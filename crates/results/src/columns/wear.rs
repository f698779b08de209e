//! Columns of `wear.parquet`.

use wholestring::outcome::HOLE_WEAR;

use super::{MODEL, OPERATION, table};
use crate::ColumnSpec;

/// Columns of `wear.parquet`: the work of friction on the hole, one row per 5 m of hole, from the
/// surface down, for each model and operation.
pub const WEAR: &[ColumnSpec] =
    &table::<_, { HOLE_WEAR.len() + 2 }>(&[MODEL, OPERATION], HOLE_WEAR, &[]);
