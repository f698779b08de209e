//! The command, run as by a user.

use std::{
    path::Path,
    process::{Child, Command, ExitStatus, Stdio},
};

use wholestring_case::Override;

use crate::Error;

/// Starts the command with these arguments and changes of the case. Its only output is the reason
/// of a failure.
pub(super) fn start(
    program: &Path,
    arguments: &[&str],
    changes: &[Override],
) -> Result<Child, Error> {
    let mut command = Command::new(program);
    // Successive measurements write to the same folder.
    command.args(arguments).args(["--quiet", "--overwrite"]);
    for Override { key, value, .. } in changes {
        command.arg("--set").arg(format!("{key}={value}"));
    }
    command.stdout(Stdio::null());
    command.spawn().map_err(Error::failed)
}

/// Checks the exit status.
pub(super) fn check(status: ExitStatus) -> Result<(), Error> {
    match status.code() {
        Some(0) => Ok(()),
        Some(130) | None => Err(Error::Interrupted),
        // The command has printed the reason.
        Some(_) => Err(Error::Failed(format!("it ended with {status}"))),
    }
}
