//! Fronts show verdicts and make none: their sources contain no word of a verdict.

use std::{
    fs,
    path::{Path, PathBuf},
};

use wholestring_judge::Verdict;

/// Folders of the fronts, from the root of the repository.
const FRONTS: [&str; 4] =
    ["web/app/src", "web/components", "crates/report/web/src", "crates/python/python/wholestring"];

/// Endings of their sources.
const SOURCES: [&str; 4] = ["ts", "js", "svelte", "py"];

/// Phrases of which the judge makes sentences, in lower case.
const PHRASES: [&str; 19] = [
    "lock-up",
    "locks up",
    "locked up",
    "buckles",
    "goes down",
    "does not go down",
    "cannot be drilled",
    "cannot be slid",
    "no static equilibrium",
    "did not converge",
    "stuck",
    "stalls",
    "stalled",
    "overloaded",
    "too little reserve",
    "needs attention",
    "all limits",
    "within its limits",
    "is valid",
];

/// Comparisons from which a front would derive a level of its own.
const COMPARED: [&str; 9] = [
    ".reserve <",
    ".reserve >",
    ".factor <",
    ".factor >",
    "factor < required",
    "load > ",
    "severity >",
    "severity <",
    "torque_use >",
];

/// Lines that contain one of these words and make no verdict: a part of the line, and the reason.
const DECLARED: [(&str, &str); 11] = [
    ("export type CheckKind =", "a type of the page, written from the declarations of the engine"),
    ("``\"", "a docstring lists the judge's words"),
    ("``marginal``", "a docstring lists the judge's words, written from their declaration"),
    (">>> ", "an example in a docstring"),
    ("nothing locks up", "help on an option of the reach that leaves the helix's friction out"),
    ("ok: [\"OK\"", "the word of the judge's severity `ok`"),
    ("\"top_drive_stalled\"", "a kind of check, whose severity a read-out shows"),
    ("\"weight_on_bit_exceeded\"", "a kind of check, whose severity a read-out shows"),
    ("stuck_fraction", "a field of the driller's seat, made by the engine"),
    ("must not get stuck", "a comment on a queue"),
    ("check that needs attention", "a comment on what is filtered by the judge's severity"),
];

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if path.is_dir() && name != "node_modules" {
            sources(&path, found);
        } else if path
            .extension()
            .is_some_and(|ending| SOURCES.iter().any(|source| ending == *source))
        {
            found.push(path);
        }
    }
}

/// The word of a verdict in a line of source; `None` for a comment and for a declared line.
fn verdict_in(line: &str) -> Option<&'static str> {
    let line = line.trim();
    let is_comment = ["//", "#", "*", "/*", "<!--"].iter().any(|mark| line.starts_with(mark));
    if is_comment || DECLARED.iter().any(|(part, _)| line.contains(part)) {
        return None;
    }
    let words = [Verdict::Marginal, Verdict::BelowRequired, Verdict::Exceeded];
    let lower = line.to_lowercase();
    let is_own = |word: &&str| {
        let begins = |at: usize| {
            lower[..at].chars().next_back().is_none_or(|before| !before.is_alphanumeric())
        };
        let ends = |at: usize| {
            lower[at + word.len()..].chars().next().is_none_or(|after| !after.is_alphanumeric())
        };
        lower.match_indices(*word).any(|(at, _)| begins(at) && ends(at))
    };
    let verdict = words.map(Verdict::words).into_iter().find(|word| is_own(word));
    let quoted_ok = ["\"OK\"", "'OK'", "`OK`", ">OK<"].into_iter().find(|word| line.contains(word));
    let phrase = PHRASES.into_iter().find(is_own);
    let compared = COMPARED.into_iter().find(|sign| line.contains(sign));
    verdict.or(quoted_ok).or(phrase).or(compared)
}

#[test]
fn fronts_make_no_verdicts() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut files = Vec::new();
    for front in FRONTS {
        sources(&root.join(front), &mut files);
    }
    assert!(files.len() > 100, "{} sources", files.len());
    let mut found = Vec::new();
    for file in &files {
        let text = fs::read_to_string(file).expect("a text");
        for (number, line) in text.lines().enumerate() {
            if let Some(word) = verdict_in(line) {
                found.push(format!("{}:{}: `{word}`: {line}", file.display(), number + 1));
            }
        }
    }
    assert!(found.is_empty(), "the judge makes verdicts, no front:\n{}", found.join("\n"));
}

#[test]
fn a_verdict_in_a_front_is_found() {
    for line in [
        "const word = reserve < 1 ? \"exceeded\" : \"kept\";",
        "<td>{limit.reserve < 1 ? a : b}</td>",
        "return \"below required factor\"",
        "{#if ok}<b>OK</b>{/if}",
        "message = f\"{operation}: locks up at {depth}\"",
        "const level = lamps.torque_use >= 1 ? \"over\" : \"near\";",
        "? \"Marginal\"",
        "<p>No check of these answers needs attention.</p>",
    ] {
        assert!(verdict_in(line).is_some(), "{line}");
    }
    for line in
        ["// exceeded", "} else if (problem.name === \"QuotaExceededError\")", "if (!response.ok)"]
    {
        assert_eq!(verdict_in(line), None, "{line}");
    }
}
