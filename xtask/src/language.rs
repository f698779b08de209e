//! Plain technical English: turns of phrase that a native engineer does not use, counted in the comments of the
//! code and in the book.
//!
//! Limits per 10,000 words are three times the worst of nine well-kept Rust projects of numerics and tools.

use std::{fmt::Write as _, process::Command};

use crate::{
    command::{printed, read, root},
    outcome::{Failure, Finding},
};

/// A turn of phrase and how often it may occur.
struct Turn {
    /// Its words, any of which counts.
    words: &'static [&'static str],
    /// Largest number of occurrences in 10,000 words.
    limit: f64,
}

const TURNS: [Turn; 6] = [
    Turn { words: &["what"], limit: 22.0 },
    Turn { words: &["says", "say", "said", "told", "tell", "tells"], limit: 6.3 },
    Turn { words: &["stands", "stand", "stood"], limit: 0.9 },
    Turn { words: &["lies", "lie", "lay"], limit: 1.5 },
    Turn { words: &["beside"], limit: 0.6 },
    Turn { words: &["asks", "asked", "ask"], limit: 4.5 },
];

/// Largest part of the documentation comments that begin with "What", %.
const BEGIN_WITH_WHAT: f64 = 0.45;

/// Uses of these words that are plain: positions of pipe.
const PLAIN: [&str; 3] = ["lies on the wall", "lies on the low side", "lie on the wall"];

/// Words before a stand of pipe, a noun.
const BEFORE_A_STAND: [&str; 35] = [
    "a", "the", "this", "that", "each", "every", "one", "two", "three", "four", "five", "six",
    "some", "many", "several", "all", "whole", "of", "to", "from", "with", "within", "between",
    "over", "per", "into", "for", "their", "new", "next", "last", "longer", "drilled", "tripped",
    "drawn",
];

/// The words of a kind of text and the turns found in them.
#[derive(Default)]
struct Prose {
    words: usize,
    turns: [usize; TURNS.len()],
    documentation: usize,
    begin_with_what: usize,
}

impl Prose {
    /// Counts a line of prose.
    fn add(&mut self, line: &str) {
        let line = PLAIN
            .iter()
            .fold(without_code(line).to_lowercase(), |line, plain| line.replace(plain, ""));
        let mut before = "";
        let words = line
            .split(|letter: char| !letter.is_ascii_alphabetic() && letter != '\'' && letter != '-')
            .filter(|word| word.starts_with(|first: char| first.is_ascii_alphabetic()));
        for word in words {
            self.words += 1;
            let is_pipe = word.starts_with("stand")
                && (BEFORE_A_STAND.contains(&before)
                    || matches!(before, "number" | "thousand" | ""));
            for (count, turn) in self.turns.iter_mut().zip(&TURNS) {
                *count += usize::from(turn.words.contains(&word) && !is_pipe);
            }
            before = word;
        }
    }

    /// Counts the comments of a Rust source.
    fn add_source(&mut self, text: &str) {
        let mut continues = false;
        for line in text.lines() {
            let line = line.trim_start();
            let documentation = ["/// ", "//! "].iter().find_map(|mark| line.strip_prefix(mark));
            if let (Some(first), false) = (documentation, continues) {
                self.documentation += 1;
                self.begin_with_what += usize::from(first.starts_with("What "));
            }
            continues = line.starts_with("///") || line.starts_with("//!");
            let comment = documentation.or_else(|| line.strip_prefix("// "));
            if let Some(comment) = comment.or_else(|| Some(line.split_once(" // ")?.1)) {
                self.add(comment);
            }
        }
    }

    /// Counts a page of the book, apart from its examples of code.
    fn add_page(&mut self, text: &str) {
        let mut in_code = false;
        for line in text.lines() {
            if line.trim_start().starts_with("```") {
                in_code = !in_code;
            } else if !in_code {
                self.add(line);
            }
        }
    }

    /// Turns that occur too often, a line each; empty where none does.
    fn excess(&self, title: &str) -> String {
        let mut excess = String::new();
        for (count, turn) in self.turns.iter().zip(&TURNS) {
            let rate = 1e4 * *count as f64 / self.words.max(1) as f64;
            if rate > turn.limit {
                let words = turn.words.join(", ");
                let _ = writeln!(
                    excess,
                    "{title}: {words}: {rate:.1} in 10,000 words, limit {}",
                    turn.limit
                );
            }
        }
        let part = 100.0 * self.begin_with_what as f64 / self.documentation.max(1) as f64;
        if part > BEGIN_WITH_WHAT {
            let _ = writeln!(
                excess,
                "{title}: {part:.2} % of the documentation comments begin with \"What\", limit \
                 {BEGIN_WITH_WHAT} %"
            );
        }
        excess
    }
}

/// A line without its code in back quotes.
fn without_code(line: &str) -> String {
    line.split('`').step_by(2).collect::<Vec<_>>().join(" ")
}

/// Tracked files that match a pattern.
fn files(pattern: &str) -> Result<Vec<String>, Failure> {
    let mut git = Command::new("git");
    git.current_dir(root()).args([
        "ls-files",
        "--cached",
        "--others",
        "--exclude-standard",
        pattern,
    ]);
    Ok(printed(&mut git, "git lists the files")?.lines().map(str::to_owned).collect())
}

/// Holds the comments of the code and the hand-written pages of the book to the limits.
pub(crate) fn check() -> Result<Finding, Failure> {
    let [mut code, mut book] = [Prose::default(), Prose::default()];
    for file in files("*.rs")? {
        code.add_source(&read(&root().join(file))?);
    }
    for file in files("docs/src/*.md")?.iter().chain(&["README.md".to_owned()]) {
        // Written by a program from the names of quantities.
        if !file.ends_with("verification-table.md") {
            book.add_page(&read(&root().join(file))?);
        }
    }
    let excess = code.excess("code") + &book.excess("book");
    if excess.is_empty() {
        return Ok(Finding::Done);
    }
    Err(Failure::new(format!("{excess}write plain technical English, see CONTRIBUTING.md")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_are_counted_in_comments_alone() {
        let mut prose = Prose::default();
        prose.add_source(
            "/// What it is: it stands beside `what`, a stand of pipe.\n/// More of it.\nlet what = \"says\"; // says so\n\
             // It lies on the wall, and asks.\n",
        );
        assert_eq!(prose.turns, [1, 1, 1, 0, 1, 1]);
        assert_eq!((prose.documentation, prose.begin_with_what), (1, 1));
    }

    #[test]
    fn prose_beyond_the_limits_fails() {
        let mut prose = Prose::default();
        prose.add_page(&"Sliding friction at a node, in newtons.\n".repeat(100));
        assert_eq!(prose.excess("book"), "");
        prose.add_page("```\nwhat it says\n```\n");
        assert_eq!(prose.excess("book"), "");
        prose.add_page("What it says.\nWhat it does.\nIt tells.\n");
        assert_eq!(prose.excess("book").lines().count(), 2);
    }
}
