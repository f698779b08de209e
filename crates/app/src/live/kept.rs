//! A string as it is kept in the workspace, to be continued.

use std::io;

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

use super::{command::LiveError, recording::RecordedEvent};
use crate::workspace::{KeptFile, Workspace};

/// What a kept string begins with.
const MARK: &[u8; 8] = b"WSLIVE1\n";

/// What is kept beside the checkpoint.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Head {
    case_id: String,
    name: String,
    operation: String,
    time_s: f64,
    text: String,
    events: Vec<RecordedEvent>,
}

/// A string that is kept.
#[derive(Debug, Clone)]
pub(crate) struct KeptString {
    /// The id of its case.
    pub(crate) case_id: String,
    /// What the case calls itself.
    pub(crate) name: String,
    /// Name of the operation.
    pub(crate) operation: String,
    /// Its time, s.
    pub(crate) time_s: f64,
    /// The text that the case was made of.
    pub(crate) text: String,
    /// What was set.
    pub(crate) events: Vec<RecordedEvent>,
    /// The checkpoint.
    pub(crate) checkpoint: Vec<u8>,
}

/// A kept string in a list.
#[derive(Debug, Clone, Serialize, ToSchema)]
pub(crate) struct KeptEntry {
    /// What requests call it.
    pub(crate) name: String,
    /// The id of its case.
    pub(crate) case: String,
    /// What the case calls itself.
    pub(crate) title: String,
    /// Name of the operation.
    pub(crate) operation: String,
    /// Its time, s.
    pub(crate) time_s: f64,
    /// When it was kept, milliseconds since 1970.
    pub(crate) modified_ms: u64,
}

impl KeptString {
    /// Keeps it in the folder, and gives what requests call it.
    ///
    /// # Errors
    /// Whatever the system says.
    pub(crate) fn keep(&self, workspace: &Workspace) -> Result<String, LiveError> {
        let failed = |error: &dyn std::fmt::Display| LiveError::Failed(error.to_string());
        let bytes = self.bytes().map_err(|error| failed(&error))?;
        workspace.keep(&bytes).map_err(|error| failed(&error))
    }

    /// Those that are kept in the folder, the latest first; files that are damaged are left out.
    pub(crate) fn all(workspace: &Workspace) -> Vec<KeptEntry> {
        let entry = |file: KeptFile| {
            let kept = Self::of_bytes(&file.read().ok()?)?;
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
    pub(crate) fn of_name(workspace: &Workspace, name: &str) -> Result<Self, LiveError> {
        let file = workspace.kept_file(name).map_err(|_| LiveError::Nothing("kept string"))?;
        let bytes = file.read().map_err(|error| LiveError::Failed(error.to_string()))?;
        let damaged = || LiveError::Refused("the string that was kept is damaged".to_owned());
        Self::of_bytes(&bytes).ok_or_else(damaged)
    }

    /// As the bytes of a file.
    ///
    /// # Errors
    /// None that a string gives.
    fn bytes(&self) -> io::Result<Vec<u8>> {
        let Self { case_id, name, operation, time_s, text, events, checkpoint } = self.clone();
        let head = Head { case_id, name, operation, time_s, text, events };
        let head = serde_json::to_vec(&head)?;
        let length = u32::try_from(head.len()).map_err(io::Error::other)?;
        let mut bytes = MARK.to_vec();
        bytes.extend(length.to_le_bytes());
        bytes.extend(head);
        bytes.extend(checkpoint);
        Ok(bytes)
    }

    /// Of the bytes of a file; none of what is no such file.
    fn of_bytes(bytes: &[u8]) -> Option<Self> {
        let rest = bytes.strip_prefix(MARK)?;
        let (length, rest) = rest.split_first_chunk::<4>()?;
        let (head, checkpoint) = rest.split_at_checked(u32::from_le_bytes(*length) as usize)?;
        let Head { case_id, name, operation, time_s, text, events } =
            serde_json::from_slice(head).ok()?;
        let checkpoint = checkpoint.to_vec();
        Some(Self { case_id, name, operation, time_s, text, events, checkpoint })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_kept_is_read_back_and_damage_is_none() {
        let kept = KeptString {
            case_id: "0".into(),
            name: "slant".into(),
            operation: "drill".into(),
            time_s: 12.5,
            text: "a = 1\n".into(),
            events: Vec::new(),
            checkpoint: vec![1, 2, 3],
        };
        let bytes = kept.bytes().expect("bytes");
        let back = KeptString::of_bytes(&bytes).expect("a kept string");
        assert_eq!((back.time_s, back.text.as_str()), (12.5, "a = 1\n"));
        assert_eq!(back.checkpoint, [1, 2, 3]);
        for end in 0..bytes.len() - 3 {
            assert!(KeptString::of_bytes(&bytes[..end]).is_none(), "{end}");
        }
    }
}
