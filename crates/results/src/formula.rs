//! Text in CSV files that a spreadsheet would take for a formula.
//!
//! A cell that begins with `=`, `+`, `-`, `@`, a tab or an end of line is computed when the file is
//! opened in a spreadsheet: the value of a key, or a name in a case from elsewhere, could run a
//! command. The usual guard is an apostrophe before it (OWASP, *CSV Injection*). Numbers are left
//! as they are.

use std::borrow::Cow;

const APOSTROPHE: char = '\'';

/// Whether a spreadsheet would compute the text, or would once some of its apostrophes are removed.
fn is_formula(text: &str) -> bool {
    let bare = text.trim_start_matches(APOSTROPHE);
    bare.starts_with(['=', '+', '-', '@', '\t', '\r', '\n']) && text.parse::<f64>().is_err()
}

/// Returns the text as it is written.
pub(crate) fn guarded(text: &str) -> Cow<'_, str> {
    match is_formula(text) {
        true => Cow::Owned(format!("{APOSTROPHE}{text}")),
        false => Cow::Borrowed(text),
    }
}

/// Returns the original text of a written cell.
pub(crate) fn unguarded(cell: &str) -> &str {
    match cell.strip_prefix(APOSTROPHE) {
        Some(text) if is_formula(text) => text,
        _ => cell,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_are_guarded_and_come_back() {
        for text in [
            "=1+2",
            "=HYPERLINK(\"http://x\")",
            "@SUM(1)",
            "+cmd|' /C calc'!A0",
            "-5 m",
            "\t=1",
            "'=1",
            "''-x",
            "-",
        ] {
            let written = guarded(text);
            assert!(written.starts_with('\''), "{text}");
            assert_eq!(unguarded(&written), text);
        }
        for text in ["", "-5", "+1e3", "0.3", "drill", "'", "'tis", "a=b", "5 m", "-inf"] {
            assert_eq!(guarded(text), text);
            assert_eq!(unguarded(text), text);
        }
    }
}
