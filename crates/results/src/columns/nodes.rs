//! Columns of `nodes.parquet`.

use wholestring::outcome::PROFILE;

use super::{MODEL, OPERATION, table};
use crate::ColumnSpec;

/// Columns of `nodes.parquet`: the profile along the string, one row per node, from the surface to
/// the bit, for each model and operation.
pub const NODES: &[ColumnSpec] =
    &table::<_, { PROFILE.len() + 2 }>(&[MODEL, OPERATION], PROFILE, &[]);
