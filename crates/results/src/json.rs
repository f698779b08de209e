//! JSON files with a version of their layout.

use std::{io::Write, ops::RangeInclusive, path::Path};

use serde::{Serialize, de::DeserializeOwned};
use serde_json::error::Category;

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
        serde_json::from_slice(text).map_err(|error| ResultsError::format(path, defect(&error)))?;
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
    serde_json::from_value(value).map_err(|error| {
        // The text, read once more, gives the line.
        let error = serde_json::from_slice::<T>(text).err().unwrap_or(error);
        ResultsError::format(path, defect(&error))
    })
}

/// Reads a summary of any kind and version.
///
/// # Errors
/// A file that cannot be read, or is no JSON.
pub fn read_any_summary(path: &Path) -> Result<serde_json::Value, ResultsError> {
    let text = read_at_most(path, LARGEST)?;
    serde_json::from_slice(&text).map_err(|error| ResultsError::format(path, defect(&error)))
}

/// Defect of a JSON file in words. The library's sentences name types of the program.
fn defect(error: &serde_json::Error) -> String {
    let place = match error.line() {
        0 => String::new(),
        line => format!(" at line {line}"),
    };
    match error.classify() {
        Category::Eof => {
            format!("its text ends{place} before it is complete, expected the whole summary")
        }
        Category::Syntax | Category::Io => {
            format!("its text is no JSON{place}, expected the summary as it was written")
        }
        Category::Data => format!("{}{place}", unexpected(&error.to_string())),
    }
}

/// A value that is not of its kind, in words.
fn unexpected(sentence: &str) -> String {
    let sentence = sentence.rsplit_once(" at line ").map_or(sentence, |(sentence, _)| sentence);
    if let Some(key) = sentence.strip_prefix("missing field ") {
        return format!("it has no {key}");
    }
    if let Some((word, expected)) =
        sentence.strip_prefix("unknown variant ").and_then(|rest| rest.split_once(", "))
    {
        return format!("{word} is unknown, {expected}");
    }
    let typed = ["invalid type: ", "invalid value: "]
        .iter()
        .find_map(|begin| sentence.strip_prefix(begin)?.split_once(", expected "));
    match typed {
        Some((value, expected)) => format!("a value is {value}, expected {}", kind(expected)),
        None => sentence.to_owned(),
    }
}

/// The kind of a value that the library names by a type of the program.
fn kind(expected: &str) -> &str {
    let begins = |words: &[&str]| words.iter().any(|word| expected.starts_with(word));
    match expected {
        "f64" | "f32" => "a number",
        "usize" | "u64" | "u32" | "u8" | "i64" | "i32" => "a whole number",
        _ if begins(&["struct ", "a map", "internally tagged", "adjacently tagged"]) => "a table",
        _ if begins(&["a sequence", "a tuple", "tuple ", "an array"]) => "a list",
        other => other,
    }
}

/// `1`, or `1 to 3`.
fn in_words(known: &RangeInclusive<u32>) -> String {
    match (known.start(), known.end()) {
        (first, last) if first == last => first.to_string(),
        (first, last) => format!("{first} to {last}"),
    }
}
