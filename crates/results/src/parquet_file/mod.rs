//! Tables as Parquet files: the only module that knows the format.

mod read;
mod write;

pub(crate) use read::{guarded, open, read_each_group, read_groups_with};
pub(crate) use write::{begin, copy_groups, io_error, properties, schema, write_group};
