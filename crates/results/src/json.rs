//! JSON files with a version of their layout.

use std::{io::Write, ops::RangeInclusive, path::Path};

use serde::{Serialize, de::DeserializeOwned};

use crate::{
    ResultsError,
    file::{read_at_most, write_unsynced, write_whole},
};

/// Upper bound of any summary, bytes: as a tree it is sixteen times as large.
const LARGEST: u64 = 32 << 20;

/// Writes a value as indented JSON.
pub(crate) fn write_json(value: &impl Serialize, path: &Path) -> Result<(), ResultsError> {
    write_whole(path, |writer| {
        serde_json::to_writer_pretty(&mut *writer, value)?;
        writer.write_all(b"\n")
    })
}

/// Writes a value as JSON without a blank, and does not wait for the disk.
pub(crate) fn write_json_compact(value: &impl Serialize, path: &Path) -> Result<(), ResultsError> {
    write_unsynced(path, |writer| {
        serde_json::to_writer(&mut *writer, value)?;
        writer.write_all(b"\n")
    })
}

/// Reads back a value, and refuses one whose `schema_version` is not among those known.
pub(crate) fn read_versioned<T: DeserializeOwned>(
    path: &Path,
    known: RangeInclusive<u32>,
) -> Result<T, ResultsError> {
    versioned(path, &read_at_most(path, LARGEST)?, known)
}

/// The same for a text; `path` names it in errors.
pub(crate) fn versioned<T: DeserializeOwned>(
    path: &Path,
    text: &[u8],
    known: RangeInclusive<u32>,
) -> Result<T, ResultsError> {
    let value: serde_json::Value =
        serde_json::from_slice(text).map_err(|error| ResultsError::format(path, error))?;
    // Checked first, so that a newer file is not reported as malformed.
    match value.get("schema_version").and_then(|v| v.as_u64()) {
        Some(version) if u32::try_from(version).is_ok_and(|version| known.contains(&version)) => {}
        Some(version) => {
            return Err(ResultsError::format(
                path,
                format_args!("its schema_version is {version}, expected {}", in_words(&known)),
            ));
        }
        None => return Err(ResultsError::format(path, "it has no schema_version")),
    }
    serde_json::from_value(value).map_err(|error| ResultsError::format(path, error))
}

/// `1`, or `1 to 3`.
fn in_words(known: &RangeInclusive<u32>) -> String {
    match (known.start(), known.end()) {
        (first, last) if first == last => first.to_string(),
        (first, last) => format!("{first} to {last}"),
    }
}
