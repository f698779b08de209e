//! This program, run again as a user runs it.

use std::{
    env,
    process::{Child, Command, ExitStatus, Stdio},
};

use wholestring_case::Override;

use crate::failure::{Failure, failed};

/// Starts the program with these arguments and changes of the case. It says nothing but why it
/// failed.
pub(crate) fn start(arguments: &[&str], changes: &[Override]) -> Result<Child, Failure> {
    let program = env::current_exe().map_err(|error| failed(&error))?;
    let mut command = Command::new(program);
    // One measurement after the other goes to the same folder.
    command.args(arguments).args(["--quiet", "--overwrite"]);
    for Override { key, value, .. } in changes {
        command.arg("--set").arg(format!("{key}={value}"));
    }
    command.stdout(Stdio::null());
    command.spawn().map_err(|error| failed(&error))
}

/// Whether it did what it should.
pub(crate) fn check(status: ExitStatus) -> Result<(), Failure> {
    match status.code() {
        Some(0) => Ok(()),
        Some(130) | None => Err(Failure::Interrupted("interrupted".to_owned())),
        // It has said why.
        Some(_) => Err(Failure::Failed(format!("error: it ended with {status}"))),
    }
}
