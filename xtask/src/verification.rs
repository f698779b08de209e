//! The book's table of verification, from the reports of the tests.

use std::{collections::BTreeMap, fmt::Write as _, fs, path::PathBuf};

use wholestring_verification::{FILE, Line, Tolerance, error, unit};

use crate::{
    command::{WORKSPACE, cargo, read, root, run_counted, succeeds, target},
    outcome::{Failure, Finding},
};

/// File of the reports of the last test run.
fn reported() -> PathBuf {
    // Absolute: each test runs in the folder of its own package.
    let target = target();
    target.canonicalize().unwrap_or(target).join("verification.jsonl")
}

fn page() -> PathBuf {
    root().join("docs/src/verification-table.md")
}

/// Runs every test except those that take minutes.
pub(crate) fn tests() -> Result<Finding, Failure> {
    run_tests(&[], &[])
}

/// Runs every test, including those that take minutes.
pub(crate) fn all_tests() -> Result<Finding, Failure> {
    run_tests(&["--run-ignored", "all"], &["--", "--include-ignored"])
}

/// Runs the tests with nextest and its options, or with cargo and those. nextest runs the tests of
/// all crates in parallel, but not the documentation examples.
fn run_tests(for_nextest: &[&str], for_cargo: &[&str]) -> Result<Finding, Failure> {
    // The reports of an earlier run.
    if reported().exists() {
        fs::remove_file(reported()).map_err(Failure::at(&reported()))?;
    }
    let mut runner = cargo();
    if succeeds(cargo().args(["nextest", "--version"])) {
        runner.args(["nextest", "run", "--no-fail-fast"]).args(WORKSPACE).args(for_nextest);
    } else {
        runner.args(["test", "--no-fail-fast"]).args(WORKSPACE);
        runner.args(["--lib", "--bins", "--tests", "--examples"]).args(for_cargo);
    }
    run_counted(runner.env(FILE, reported())).map(Finding::Tested)
}

/// Writes the table into the book.
pub(crate) fn write_table() -> Result<Finding, Failure> {
    let lines = lines()?;
    let cases = Cases::read()?;
    fs::write(page(), table(&lines, &cases)?).map_err(Failure::at(&page())).map(Finding::from)
}

/// Checks that the table in the book has the cases that the tests reported, and no others than
/// those on record. Its numbers are those of the machine that made it.
pub(crate) fn check_table() -> Result<Finding, Failure> {
    let text = fs::read_to_string(page()).unwrap_or_default();
    let listed: Vec<&str> = text
        .lines()
        .filter_map(|line| line.strip_prefix("## "))
        .map(|heading| heading.split(':').next().unwrap_or(heading))
        .collect();
    let cases = Cases::read()?;
    let stale = |reason: String| Failure::new(format!("{reason}; run `cargo xtask verify`"));
    for line in lines()? {
        if !listed.contains(&&*line.case) {
            let page = page();
            return Err(stale(format!("{} lacks {}", page.display(), line.case)));
        }
    }
    for case in listed {
        if cases.find(case).is_none() {
            return Err(stale(format!("nothing is on record of {case}")));
        }
    }
    Ok(Finding::Done)
}

fn lines() -> Result<Vec<Line<'static>>, Failure> {
    let text = read(&reported())?;
    let parsed =
        |line| serde_json::from_str(line).map_err(|error| Failure::new(format!("{error}: {line}")));
    text.lines().map(parsed).collect()
}

/// The list of cases in `verification/README.md`.
struct Cases(Vec<Case>);

struct Case {
    /// Names of files, or of cases without a file.
    names: Vec<String>,
    what: String,
    source: String,
}

impl Cases {
    fn read() -> Result<Self, Failure> {
        Ok(Self::parse(&read(&root().join("verification/README.md"))?))
    }

    fn parse(text: &str) -> Self {
        let rows = text.lines().filter_map(|line| {
            let line = line.trim().strip_prefix('|')?.strip_suffix('|')?;
            let cells: Vec<&str> = line.split('|').map(str::trim).collect();
            let [names, what, source] = cells[..] else {
                return None;
            };
            let names = names.split('`').skip(1).step_by(2).map(str::to_owned);
            Some(Case { names: names.collect(), what: what.to_owned(), source: source.to_owned() })
        });
        Self(rows.filter(|case| !case.names.is_empty()).collect())
    }

    fn find(&self, name: &str) -> Option<&Case> {
        let is = |file: &String| {
            let rest = file.strip_prefix(name);
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('_'))
        };
        self.0.iter().find(|case| case.names.iter().any(is))
    }
}

const INTRODUCTION: &str = "\
# Verification, number by number

Each number of the tests of [Verification](verification.md) with its reference, tolerance and the
reason for the tolerance. `cargo xtask verify` runs all tests, including those that take minutes,
and writes this page; the numbers are those of the machine that ran them. A row of several numbers shows
the one nearest to its tolerance. Errors and tolerances are relative to the expected value unless a
unit is given. Numbers without a limit are predictions, or numbers of a source that are not
reproduced, with the reason in the last column.
";

fn table(lines: &[Line<'_>], cases: &Cases) -> Result<String, Failure> {
    // The text is part of the key, because 0.01 and 0.1 have the same pieces.
    type Key<'a> = (Vec<Piece<'a>>, &'a str);
    let mut sorted: BTreeMap<&str, BTreeMap<Key<'_>, &Line<'_>>> = BTreeMap::new();
    for line in lines {
        let rows = sorted.entry(&line.case).or_default();
        rows.insert((pieces(&line.quantity), &line.quantity), line);
    }
    let mut text = INTRODUCTION.to_owned();
    for (name, rows) in sorted {
        let case = cases.find(name).ok_or_else(|| {
            Failure::new(format!(
                "the tests report {name}, which verification/README.md does not list"
            ))
        })?;
        let _ = write!(
            text,
            "\n## {name}: {}\n\nSource: {}.\n\n\
             | quantity | expected | computed | error | within | why \
             |\n|---|---|---|---|---|---|\n",
            case.what, case.source
        );
        for line in rows.values() {
            let _ = writeln!(text, "{}", row(line));
        }
    }
    Ok(text)
}

fn row(line: &Line<'_>) -> String {
    let Line { quantity, expected, computed, tolerance, reason, of: count, .. } = line;
    let many = if *count > 1 { format!(" (of {count})") } else { String::new() };
    let apart = error(*expected, *computed, *tolerance);
    // The unit of `climb, rad` is rad.
    let unit = unit(quantity);
    let in_unit = |value: f64| format!("{} {unit}", short(value)).trim_end().to_owned();
    let (apart, within) = match tolerance {
        Tolerance::Relative(most) => (short(apart), short(*most)),
        Tolerance::Absolute(most) => (in_unit(apart), in_unit(*most)),
        Tolerance::AtLeast => ("–".to_owned(), "at least".to_owned()),
        Tolerance::Any => (short(apart), "no limit".to_owned()),
    };
    let cells = [
        format!("{quantity}{many}"),
        number(*expected),
        number(*computed),
        apart,
        within,
        reason.to_string(),
    ];
    format!("| {} |", cells.map(|cell| cell.replace('|', "\\|")).join(" | "))
}

/// Six digits.
fn number(value: f64) -> String {
    // Adding zero removes the sign of zero.
    let plain: f64 = format!("{value:.5e}").parse().unwrap_or(value) + 0.0;
    if plain == 0.0 || (1e-3..1e7).contains(&plain.abs()) {
        plain.to_string()
    } else {
        format!("{plain:e}")
    }
}

/// Two digits.
fn short(value: f64) -> String {
    let plain: f64 = format!("{value:.1e}").parse().unwrap_or(value);
    if plain == 0.0 || plain >= 1e-3 { plain.to_string() } else { format!("{plain:e}") }
}

/// A section of a text: digits are sorted by their number.
#[derive(Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Piece<'a> {
    Number(u64),
    Word(&'a str),
}

fn pieces(text: &str) -> Vec<Piece<'_>> {
    let mut pieces = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let digit = first.is_ascii_digit();
        let end = rest.find(|letter: char| letter.is_ascii_digit() != digit).unwrap_or(rest.len());
        let (piece, after) = rest.split_at(end);
        pieces.push(match piece.parse() {
            Ok(number) if digit => Piece::Number(number),
            _ => Piece::Word(piece),
        });
        rest = after;
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    const README: &str = "\
# Inputs

| file | what | source |
|---|---|---|
| `A01`, `A02` | soft string | our own |
| `E05_climb.json` | a climb | closed | forms |
| `E06_hertz.json` | a blow | closed forms |
| `energy` | the balance | an identity |
";

    fn line(case: &'static str, quantity: &'static str, tolerance: Tolerance) -> Line<'static> {
        Line {
            case: case.into(),
            quantity: quantity.into(),
            expected: 2e-5,
            computed: 2.000_02e-5,
            tolerance,
            reason: "a reason".into(),
            of: 3,
        }
    }

    #[test]
    fn a_row_for_every_number() {
        let cases = Cases::parse(README);
        let lines = [
            line("E06", "force at 10 m", Tolerance::Relative(1e-4)),
            line("A02", "torque", Tolerance::Any),
            line("A02", "spread", Tolerance::AtLeast),
            line("E06", "force at 9 m, N", Tolerance::Absolute(0.25)),
            line("E06", "force at 0.1 m", Tolerance::Any),
            line("E06", "force at 0.01 m", Tolerance::Any),
        ];
        let text = table(&lines, &cases).unwrap_or_else(|failure| panic!("{}", failure.reason));
        let expected = "\
\n## A02: soft string\n\nSource: our own.\n
| quantity | expected | computed | error | within | why |
|---|---|---|---|---|---|
| spread (of 3) | 2e-5 | 2.00002e-5 | – | at least | a reason |
| torque (of 3) | 2e-5 | 2.00002e-5 | 1e-5 | no limit | a reason |
\n## E06: a blow\n\nSource: closed forms.\n
| quantity | expected | computed | error | within | why |
|---|---|---|---|---|---|
| force at 0.01 m (of 3) | 2e-5 | 2.00002e-5 | 1e-5 | no limit | a reason |
| force at 0.1 m (of 3) | 2e-5 | 2.00002e-5 | 1e-5 | no limit | a reason |
| force at 9 m, N (of 3) | 2e-5 | 2.00002e-5 | 2e-10 N | 0.25 N | a reason |
| force at 10 m (of 3) | 2e-5 | 2.00002e-5 | 1e-5 | 1e-4 | a reason |
";
        assert_eq!(text.strip_prefix(INTRODUCTION), Some(expected));
    }

    #[test]
    fn a_case_that_is_not_on_record_is_refused() {
        let cases = Cases::parse(README);
        for name in ["E0", "E05_climb.jso", "E07", "A0"] {
            assert!(cases.find(name).is_none(), "{name}");
        }
        assert!(cases.find("A01").is_some() && cases.find("energy").is_some());
        let unknown = [line("E07", "a number", Tolerance::Any)];
        assert!(table(&unknown, &cases).is_err());
    }
}
