//! Columns of `contact.parquet`.

use wholestring::outcome::CONTACT_MAP;

use super::{OPERATION, table};
use crate::ColumnSpec;

/// Columns of `contact.parquet`: contact over depth and time, coarse, for each operation that was
/// solved by dynamics.
pub const CONTACT: &[ColumnSpec] =
    &table::<_, { CONTACT_MAP.len() + 1 }>(&[OPERATION], CONTACT_MAP, &[]);
