//! Runs other programs in the folders of the repository.

use std::{
    env,
    ffi::OsString,
    fmt::Write as _,
    fs,
    io::{self, BufRead, BufReader, IsTerminal, Read, Write},
    path::{Path, PathBuf},
    process::{Command, Stdio},
    thread,
};

use crate::outcome::{Count, Failure, Finding};

/// All packages, with all features of the command.
pub(crate) const WORKSPACE: [&str; 3] = ["--workspace", "--features", "wholestring-cli/app"];

/// The root of the repository: the parent of this package's folder.
pub(crate) fn root() -> PathBuf {
    // Cargo also sets it at run time: a target folder that two checkouts share may contain the
    // program of the other one.
    let package = env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from);
    let package = package.unwrap_or_else(|| env!("CARGO_MANIFEST_DIR").into());
    package.parent().map(Path::to_path_buf).unwrap_or(package)
}

/// The folder that cargo builds into.
pub(crate) fn target() -> PathBuf {
    root().join(env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into()))
}

/// Copies a file, or a folder with its contents.
pub(crate) fn copy(from: &Path, to: &Path) -> io::Result<()> {
    if !from.is_dir() {
        return fs::copy(from, to).map(|_| ());
    }
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        copy(&entry.path(), &to.join(entry.file_name()))?;
    }
    Ok(())
}

/// Text of a file.
pub(crate) fn read(path: &Path) -> Result<String, Failure> {
    fs::read_to_string(path).map_err(Failure::at(path))
}

/// Files with an extension in a folder and its subfolders, in order, with their texts.
pub(crate) fn files(folder: &Path, extension: &str) -> Result<Vec<(PathBuf, String)>, Failure> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).map_err(Failure::at(folder))? {
        let path = entry.map_err(Failure::at(folder))?.path();
        // Packages that npm installs, and builds, are skipped.
        if path.is_dir() && !path.ends_with("node_modules") && !path.ends_with("target") {
            found.extend(files(&path, extension)?);
        } else if path.extension().is_some_and(|other| other == extension) {
            found.push((path.clone(), read(&path)?));
        }
    }
    found.sort();
    Ok(found)
}

/// Path of a file that another one names relative to its own folder.
pub(crate) fn relative(source: &Path, file: &str) -> PathBuf {
    let mut path = source.parent().unwrap_or(source).to_path_buf();
    for step in file.split('/') {
        match step {
            "." => {}
            ".." => drop(path.pop()),
            _ => path.push(step),
        }
    }
    path
}

/// Runs a step with its requirement. Without it, skips the step, with the reason; in CI, where an
/// untested step would count as passed, it fails.
pub(crate) fn with<T, F: Into<Finding>>(
    requirement: Result<T, String>,
    step: impl FnOnce(T) -> Result<F, Failure>,
) -> Result<Finding, Failure> {
    match requirement {
        Ok(requirement) => step(requirement).map(Into::into),
        Err(reason) if env::var_os("CI").is_some() => Err(Failure::new(reason)),
        Err(reason) => Ok(Finding::Skipped(reason)),
    }
}

/// The cargo that runs this program, in the root of the repository.
pub(crate) fn cargo() -> Command {
    let mut command = Command::new(env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo")));
    command.current_dir(root());
    command
}

/// Runs the command with its output on the screen; `advice` is printed if it fails.
pub(crate) fn run(command: &mut Command, advice: &str) -> Result<(), Failure> {
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(Failure::new(format!("`{}`: {status}; {advice}", line(command)))),
        Err(error) => Err(cannot_start(command, &error)),
    }
}

/// Whether Rust's standard library is installed for a target.
pub(crate) fn has_target(triple: &str) -> bool {
    let rustc = env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let sysroot = printed(Command::new(rustc).args(["--print", "sysroot"]), "Rust has a folder");
    sysroot.is_ok_and(|folder| Path::new(folder.trim()).join("lib/rustlib").join(triple).is_dir())
}

/// A program of the repository, `--bin` or `--example`, built and ready to run. It is built as part
/// of the workspace, so that it uses the crates compiled for the tests.
pub(crate) fn program(kind: &str, name: &str) -> Result<Command, Failure> {
    let mut build = cargo();
    build.args(["build", "--quiet"]).args(WORKSPACE).args([kind, name]);
    run(&mut build, "the program must compile")?;
    let folder = target().join(if kind == "--example" { "debug/examples" } else { "debug" });
    let mut program = Command::new(folder.join(format!("{name}{}", env::consts::EXE_SUFFIX)));
    program.current_dir(root());
    Ok(program)
}

/// Whether the command can be started and succeeds; its output is discarded.
pub(crate) fn succeeds(command: &mut Command) -> bool {
    let command = command.stdout(Stdio::null()).stderr(Stdio::null());
    command.status().is_ok_and(|status| status.success())
}

/// Returns the standard output of a command; `advice` is printed if it fails.
pub(crate) fn printed(command: &mut Command, advice: &str) -> Result<String, Failure> {
    match command.stderr(Stdio::inherit()).output() {
        Ok(output) if output.status.success() => {
            Ok(String::from_utf8_lossy(&output.stdout).into_owned())
        }
        Ok(output) => {
            Err(Failure::new(format!("`{}`: {}; {advice}", line(command), output.status)))
        }
        Err(error) => Err(cannot_start(command, &error)),
    }
}

/// Runs a test runner with its output on the screen and counts the tests that it reports.
pub(crate) fn run_counted(command: &mut Command) -> Result<Count, Failure> {
    // Its output is a pipe here, for which it would omit its colours.
    if io::stderr().is_terminal() {
        command.env("CARGO_TERM_COLOR", "always");
    }
    let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
    let mut child = child.map_err(|error| cannot_start(command, &error))?;
    // cargo test reports on standard output, nextest on standard error.
    let output = child.stdout.take().expect("it is piped");
    let messages = child.stderr.take().expect("it is piped");
    let output = thread::Builder::new().spawn(move || copy_counting(output, io::stdout()));
    let output = match output {
        Ok(output) => output,
        Err(error) => {
            child.kill().and_then(|()| child.wait()).ok();
            return Err(Failure::new(format!("the system refuses a thread: {error}")));
        }
    };
    let mut count = copy_counting(messages, io::stderr());
    count += output.join().expect("copying does not panic");
    match child.wait() {
        Ok(status) if status.success() => Ok(count),
        Ok(status) => Err(Failure { reason: format!("`{}`: {status}", line(command)), count }),
        Err(error) => Err(cannot_start(command, &error)),
    }
}

fn copy_counting(from: impl Read, mut to: impl Write) -> Count {
    let mut count = Count::default();
    let mut from = BufReader::new(from);
    let mut bytes = Vec::new();
    while from.read_until(b'\n', &mut bytes).is_ok_and(|read| read > 0) {
        // The screen may be closed; the tests continue.
        let _ = to.write_all(&bytes);
        if let Some(more) = Count::in_line(&String::from_utf8_lossy(&bytes)) {
            count += more;
        }
        bytes.clear();
    }
    count
}

fn cannot_start(command: &Command, error: &io::Error) -> Failure {
    Failure::new(format!("`{}` cannot be started: {error}", line(command)))
}

fn line(command: &Command) -> String {
    let mut line = String::from(if command.get_program() == cargo().get_program() {
        "cargo".into()
    } else {
        command.get_program().to_string_lossy()
    });
    for argument in command.get_args() {
        let _ = write!(line, " {}", argument.to_string_lossy());
    }
    line
}
