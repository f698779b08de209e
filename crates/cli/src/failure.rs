//! Failures of a command, and their exit statuses.

use std::fmt;

use wholestring_case::Report;
use wholestring_results::ResultsError;
use wholestring_runner::{Error, FolderRefused};

use crate::screen::color;

/// Failure of a command.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The input is invalid: the mistake, its place, the expected form.
    BadInput(String),
    /// The run could not finish.
    Failed(String),
    /// A check of a result is an error, and `--strict` is set.
    Refused(String),
    /// The user interrupted the run.
    Interrupted(String),
}

impl Failure {
    /// The exit status of the program.
    pub(crate) fn status(&self) -> u8 {
        match self {
            Self::BadInput(_) => 2,
            Self::Failed(_) => 3,
            Self::Refused(_) => 4,
            Self::Interrupted(_) => 130,
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::BadInput(text)
            | Self::Failed(text)
            | Self::Refused(text)
            | Self::Interrupted(text) => {
                write!(to, "{}", text.trim_end())
            }
        }
    }
}

impl From<ResultsError> for Failure {
    fn from(error: ResultsError) -> Self {
        Error::from(error).into()
    }
}

/// A failure whose message is that of the error.
pub(crate) fn failed(error: &dyn std::error::Error) -> Failure {
    Failure::Failed(format!("error: {error}"))
}

impl From<Report> for Failure {
    fn from(report: Report) -> Self {
        Self::BadInput(report.render(color()))
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        let message = format!("error: {error}");
        match error {
            Error::Unsound(unsound) => Self::BadInput(unsound.render(color())),
            Error::NotResumable { noun, .. } => {
                Self::BadInput(format!("{message}\nrun the {noun} without --resume to start again"))
            }
            Error::Folder(refused) => Self::BadInput(format!("{message}\n{}", way_out(&refused))),
            Error::Interrupted => Self::Interrupted("interrupted: nothing was run".to_owned()),
            error if error.is_bad_input() => Self::BadInput(message),
            _ => Self::Failed(message),
        }
    }
}

/// Advice for a folder that refuses results.
fn way_out(refused: &FolderRefused) -> String {
    match refused {
        FolderRefused::Occupied { .. } => {
            "name another folder with -o, or add --overwrite to replace its contents".to_owned()
        }
        FolderRefused::Foreign { .. } => {
            "name another folder with -o, or add --overwrite to replace these files".to_owned()
        }
        FolderRefused::Unfinished { path, kind } => {
            let way_on = match kind.as_str() {
                "run" => format!("run the case with --resume {}", path.display()),
                _ => "add --resume".to_owned(),
            };
            format!("to continue with it, {way_on}; to start again, add --overwrite")
        }
        FolderRefused::Busy { .. } => {
            "wait until it has ended, or name another folder with -o".to_owned()
        }
        FolderRefused::ShareBusy { .. } => "wait until it has ended; the shares of one folder are \
             all of one number, and each is solved once"
            .to_owned(),
        FolderRefused::AllOccupied { .. } => "name another folder with -o".to_owned(),
    }
}
