//! Columns of `time.parquet`.

use wholestring::outcome::TIME_SERIES;

use super::{OPERATION, table};
use crate::ColumnSpec;

/// Note of the schedule's line for a row.
const NOTE: ColumnSpec =
    ColumnSpec::text("note", "Note of the line of the schedule that began last; empty without one")
        .null_where("no line of the schedule with a note has begun");

/// Columns of `time.parquet`: the scalars against time, one row per sample, for each operation that
/// was solved by dynamics.
pub const TIME: &[ColumnSpec] =
    &table::<_, { TIME_SERIES.len() + 2 }>(&[OPERATION], TIME_SERIES, &[NOTE]);
