//! Strings that are saved in the workspace, to be continued.

use wholestring_screens::live::{KeptEntry, KeptString, LiveError};

use crate::workspace::{KeptFile, Workspace};

/// Saves a string in the folder, and returns its identifier in requests.
///
/// # Errors
/// Errors of the system.
pub(crate) fn keep(string: &KeptString, workspace: &Workspace) -> Result<String, LiveError> {
    let failed = |error: &dyn std::fmt::Display| LiveError::Failed(error.to_string());
    let bytes = string.bytes().map_err(|error| failed(&error))?;
    workspace.keep(&bytes).map_err(|error| failed(&error))
}

/// The saved strings of the folder, the latest first; damaged files are skipped.
pub(crate) fn all(workspace: &Workspace) -> Vec<KeptEntry> {
    let entry = |file: KeptFile| {
        let string = KeptString::of_bytes(&file.read().ok()?)?;
        Some(KeptEntry {
            name: file.name,
            case: string.case_id,
            title: string.name,
            operation: string.operation,
            time_s: string.time_s,
            modified_ms: file.modified_ms,
        })
    };
    workspace.kept().into_iter().filter_map(entry).collect()
}

/// Returns the saved string with a name.
///
/// # Errors
/// No string has it, or its file is damaged.
pub(crate) fn of_name(workspace: &Workspace, name: &str) -> Result<KeptString, LiveError> {
    let file = workspace.kept_file(name).map_err(|_| LiveError::Nothing("kept string"))?;
    let bytes = file.read().map_err(|error| LiveError::Failed(error.to_string()))?;
    let damaged = || LiveError::Refused("the string that was kept is damaged".to_owned());
    KeptString::of_bytes(&bytes).ok_or_else(damaged)
}
