//! Results of steps, and the tests that they count.

use std::{fmt, io, ops::AddAssign, path::Path};

/// Result of a step that has not failed.
pub(crate) enum Finding {
    Done,
    Tested(Count),
    Skipped(String),
}

impl From<()> for Finding {
    fn from((): ()) -> Self {
        Self::Done
    }
}

impl From<Count> for Finding {
    fn from(count: Count) -> Self {
        Self::Tested(count)
    }
}

/// Reason why a step failed, and the tests counted until then.
#[derive(Debug)]
pub(crate) struct Failure {
    pub(crate) reason: String,
    pub(crate) count: Count,
}

impl Failure {
    pub(crate) fn new(reason: impl Into<String>) -> Self {
        Self { reason: reason.into(), count: Count::default() }
    }

    /// The failure to read or write a path.
    pub(crate) fn at(path: &Path) -> impl Fn(io::Error) -> Self {
        move |error| Self::new(format!("{}: {error}", path.display()))
    }
}

/// Numbers of tests.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Count {
    pub(crate) passed: usize,
    pub(crate) failed: usize,
}

impl Count {
    /// The count in a closing line of cargo test (`test result: ok. 3 passed; 0 failed; ...`) or of
    /// nextest (`Summary [0.1s] 4 tests run: 3 passed (1 slow), 1 failed, 2 skipped`) or of pytest
    /// (`1 failed, 3 passed in 0.12s`).
    pub(crate) fn in_line(line: &str) -> Option<Self> {
        let line = without_colour(line);
        let line = line.trim_start();
        let is_pytest = line.starts_with(|first: char| first.is_ascii_digit())
            && line
                .split_once(" in ")
                .is_some_and(|(_, time)| time.starts_with(|first: char| first.is_ascii_digit()))
            && (line.contains(" passed") || line.contains(" failed"));
        if !is_pytest && !line.starts_with("test result:") && !line.starts_with("Summary [") {
            return None;
        }
        let before = |name: &str| {
            line.split([' ', ';', ',', '(', ')'])
                .filter(|word| !word.is_empty())
                .collect::<Vec<_>>()
                .windows(2)
                .filter(|pair| pair[1] == name)
                .find_map(|pair| pair[0].parse().ok())
                .unwrap_or(0)
        };
        Some(Self { passed: before("passed"), failed: before("failed") + before("timed") })
    }
}

fn without_colour(line: &str) -> String {
    let mut plain = String::new();
    let mut rest = line;
    while let Some((before, after)) = rest.split_once('\u{1b}') {
        plain += before;
        rest = after.split_once('m').map_or("", |(_, after)| after);
    }
    plain + rest
}

impl AddAssign for Count {
    fn add_assign(&mut self, other: Self) {
        self.passed += other.passed;
        self.failed += other.failed;
    }
}

impl fmt::Display for Count {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "{} passed, {} failed", self.passed, self.failed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn closing_lines_are_counted() {
        for (line, passed, failed) in [
            (
                "test result: ok. 12 passed; 0 failed; 1 ignored; 0 measured; finished in 0.1s",
                12,
                0,
            ),
            ("test result: \u{1b}[31mFAILED\u{1b}[m. 3 passed; 2 failed; 0 ignored", 3, 2),
            ("     Summary [   2.315s] 45 tests run: 45 passed, 0 skipped", 45, 0),
            (
                "\u{1b}[32;1m     Summary\u{1b}[0m [   2.3s] \u{1b}[1m7\u{1b}[0m tests \
                 run: \u{1b}[1m4\u{1b}[0m passed (\u{1b}[1m1\u{1b}[0m slow), \u{1b}[1m2\u{1b}[0m \
                 failed, \u{1b}[1m1\u{1b}[0m timed out, 0 skipped",
                4,
                3,
            ),
            ("1 failed, 47 passed, 2 warnings in 3.21s", 47, 1),
            ("48 passed in 61.50s (0:01:01)", 48, 0),
        ] {
            assert_eq!(Count::in_line(line), Some(Count { passed, failed }), "{line}");
        }
        assert_eq!(Count::in_line("running 3 tests: 3 passed"), None);
    }
}
