//! Runs the program in a temporary folder.

use std::{
    env, fs,
    path::{Path, PathBuf},
    process::{Child, Command, Output, Stdio},
    thread::sleep,
    time::{Duration, Instant},
};

use wholestring_results::{Summary, Table};

/// Replacement for the program that was built with the tests, set by `scripts/portability.py`, one word
/// per line: an emulator, and the program of the emulated system.
const IN_ITS_PLACE: &str = "WHOLESTRING_IN_ITS_PLACE";

/// A folder that contains the test's case.
pub(crate) struct Desk {
    folder: tempfile::TempDir,
}

impl Desk {
    pub(crate) fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
        for name in ["slant.toml", "survey.csv"] {
            fs::copy(data.join(name), folder.path().join(name)).unwrap();
        }
        Self { folder }
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    pub(crate) fn command(&self, arguments: &[&str]) -> Command {
        let mut command = program();
        command.current_dir(self.folder.path()).args(arguments);
        command
    }

    pub(crate) fn run(&self, arguments: &[&str]) -> Output {
        self.command(arguments).output().unwrap()
    }

    /// The same for a command that must succeed.
    #[track_caller]
    pub(crate) fn done(&self, arguments: &[&str]) -> Output {
        let output = self.run(arguments);
        assert!(output.status.success(), "{}", transcript(&output));
        output
    }

    /// Contents of a file, as text.
    #[track_caller]
    pub(crate) fn text(&self, name: &str) -> String {
        let path = self.path(name);
        fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
    }

    #[track_caller]
    pub(crate) fn table(&self, name: &str) -> Table {
        Table::read_parquet(&self.path(name)).unwrap()
    }

    /// Starts a command and waits for the condition `so_far`, which must hold before the command
    /// ends.
    #[track_caller]
    pub(crate) fn begun(&self, arguments: &[&str], so_far: impl Fn() -> bool) -> Child {
        let mut command = self.command(arguments);
        let mut child = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
        let start = Instant::now();
        // An emulator is about a hundred times slower.
        let patience =
            Duration::from_secs(if env::var_os(IN_ITS_PLACE).is_some() { 3600 } else { 120 });
        while !so_far() {
            assert!(start.elapsed() < patience, "nothing done");
            assert!(child.try_wait().unwrap().is_none(), "done too soon");
            sleep(Duration::from_millis(2));
        }
        child
    }

    /// Kills a command as soon as the condition `so_far` holds.
    #[track_caller]
    pub(crate) fn killed(&self, arguments: &[&str], so_far: impl Fn() -> bool) {
        let mut child = self.begun(arguments, so_far);
        child.kill().unwrap();
        child.wait().unwrap();
    }

    /// Standard error of a command that is interrupted, as by Ctrl-C, this long after the condition
    /// `so_far` holds.
    #[cfg(unix)]
    pub(crate) fn interrupted(
        &self,
        arguments: &[&str],
        so_far: impl Fn() -> bool,
        then: Duration,
    ) -> String {
        let child = self.begun(arguments, so_far);
        sleep(then);
        let id = child.id().to_string();
        let sent = Command::new("kill").args(["-INT", &id]).status();
        assert!(sent.unwrap().success());
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(130));
        String::from_utf8(output.stderr).unwrap()
    }

    pub(crate) fn summary(&self, folder: &str) -> Summary {
        Summary::read(&self.path(folder).join("summary.json")).unwrap()
    }
}

/// The program that is built with the tests, or its replacement.
fn program() -> Command {
    let Ok(words) = env::var(IN_ITS_PLACE) else {
        return Command::new(env!("CARGO_BIN_EXE_wholestring"));
    };
    let mut words = words.lines();
    let mut command = Command::new(words.next().expect("a program"));
    command.args(words);
    command
}

/// The arguments of a command line; single quotes enclose those that contain blanks.
pub(crate) fn args(text: &str) -> Vec<&str> {
    let parts = text.split('\'').enumerate();
    let arguments = parts.map(|(place, part)| match place % 2 {
        0 => part.split_whitespace().collect(),
        _ => vec![part],
    });
    arguments.collect::<Vec<_>>().concat()
}

/// Output, with line ends and paths the same on every system.
pub(crate) fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec())
        .unwrap()
        .replace("\r\n", "\n")
        .replace('\\', "/")
        .replace("wholestring.exe", "wholestring")
}

/// Exit status and all output, for snapshots; the same on every system.
pub(crate) fn transcript(output: &Output) -> String {
    format!(
        "exit status {}\n--- standard output\n{}--- standard error\n{}",
        output.status.code().unwrap(),
        text(&output.stdout),
        text(&output.stderr)
    )
}

/// Replaces numbers whose digits differ between processors with `#`, and runs of blanks and rules,
/// whose length depends on them, with one.
pub(crate) fn masked(transcript: &str) -> String {
    let mut masked = String::new();
    for letter in transcript.chars() {
        let letter = if letter.is_ascii_digit() { '#' } else { letter };
        if !(masked.ends_with(letter) && matches!(letter, '#' | ' ' | '─')) {
            masked.push(letter);
        }
    }
    masked.replace("#.#", "#").replace(" -#", " #")
}
