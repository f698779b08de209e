//! Strings that are kept in the workspace, to be continued.

use wholestring_screens::live::{KeptEntry, KeptString, LiveError};

use crate::workspace::{KeptFile, Workspace};

/// Keeps a string in the folder, and gives what requests call it.
///
/// # Errors
/// Whatever the system says.
pub(crate) fn keep(kept: &KeptString, workspace: &Workspace) -> Result<String, LiveError> {
    let failed = |error: &dyn std::fmt::Display| LiveError::Failed(error.to_string());
    let bytes = kept.bytes().map_err(|error| failed(&error))?;
    workspace.keep(&bytes).map_err(|error| failed(&error))
}

/// Those that are kept in the folder, the latest first; files that are damaged are left out.
pub(crate) fn all(workspace: &Workspace) -> Vec<KeptEntry> {
    let entry = |file: KeptFile| {
        let kept = KeptString::of_bytes(&file.read().ok()?)?;
        Some(KeptEntry {
            name: file.name,
            case: kept.case_id,
            title: kept.name,
            operation: kept.operation,
            time_s: kept.time_s,
            modified_ms: file.modified_ms,
        })
    };
    workspace.kept().into_iter().filter_map(entry).collect()
}

/// The one of a name.
///
/// # Errors
/// Where none has it, and a file that is damaged.
pub(crate) fn of_name(workspace: &Workspace, name: &str) -> Result<KeptString, LiveError> {
    let file = workspace.kept_file(name).map_err(|_| LiveError::Nothing("kept string"))?;
    let bytes = file.read().map_err(|error| LiveError::Failed(error.to_string()))?;
    let damaged = || LiveError::Refused("the string that was kept is damaged".to_owned());
    KeptString::of_bytes(&bytes).ok_or_else(damaged)
}
