//! Formulas in the text: LaTeX between two `$` of a line, converted to MathML.

use math_core::{LatexToMathML, MathCoreConfig, MathDisplay};

/// Characters between the elements of a formula that a page would read as its own markup.
const MARKS: [(char, &str); 6] = [
    ('|', "&#124;"),
    ('*', "&#42;"),
    ('_', "&#95;"),
    ('[', "&#91;"),
    (']', "&#93;"),
    ('`', "&#96;"),
];

/// Consecutive lines of a page: code may begin on one and end on another.
#[derive(Default)]
pub(super) struct Text {
    /// The backquotes that end the open code; `None` outside code.
    code: Option<usize>,
}

impl Text {
    /// Returns the line with its formulas converted; or the formula that cannot be, with the
    /// reason. Code is unchanged, and so are dollars that do not enclose a formula.
    pub(super) fn set(&mut self, line: &str) -> Result<String, String> {
        if line.trim().is_empty() {
            self.code = None;
        }
        let mut done = String::with_capacity(line.len());
        let mut rest = line;
        while let Some(at) = rest.find(['`', '$']) {
            let (before, marked) = rest.split_at(at);
            done.push_str(before);
            let ticks = marked.len() - marked.trim_start_matches('`').len();
            let opens = !before.ends_with(|last: char| last.is_alphanumeric() || last == '\\');
            let taken = if ticks > 0 {
                self.code = match self.code {
                    None => Some(ticks),
                    Some(open) => Some(open).filter(|open| *open != ticks),
                };
                done.push_str(&marked[..ticks]);
                ticks
            } else if let Some(latex) = formula(marked).filter(|_| opens && self.code.is_none()) {
                done.push_str(&math(latex)?);
                latex.len() + 2
            } else {
                done.push('$');
                1
            };
            rest = &marked[taken..];
        }
        done.push_str(rest);
        Ok(done)
    }
}

/// The text between the first dollar and the one that closes it: `$PWD and $OUT` is not a formula.
fn formula(marked: &str) -> Option<&str> {
    let (latex, after) = marked.strip_prefix('$')?.split_once('$')?;
    let spaced = latex.is_empty() || latex.starts_with(' ') || latex.ends_with(' ');
    let closes = !after.starts_with(|next: char| next.is_alphanumeric());
    (!spaced && closes && !latex.contains('`')).then_some(latex)
}

fn math(latex: &str) -> Result<String, String> {
    let setter = LatexToMathML::new(MathCoreConfig::default())
        .map_err(|error| format!("the setter of equations does not start: {error:?}"))?;
    let mut math = setter
        .convert_with_local_counter(latex, MathDisplay::Inline)
        .map_err(|error| format!("{error:?} in {latex}"))?;
    for (mark, written) in MARKS {
        math = math.replace(mark, written);
    }
    Ok(math)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn set(lines: &str) -> String {
        let mut text = Text::default();
        let lines = lines.lines().map(|line| text.set(line));
        lines.collect::<Result<Vec<_>, _>>().unwrap_or_else(|error| panic!("{error}")).join("\n")
    }

    #[test]
    fn formulas_are_set() {
        let line = set("With $\\mu N$, and ($r$):");
        assert!(line.starts_with("With <math><mi>μ</mi><mi>N</mi></math>, and (<math>"), "{line}");
        assert!(line.ends_with("</math>):"), "{line}");
        assert!(Text::default().set("$\\frac{$").is_err());
    }

    #[test]
    fn bars_of_a_formula_end_no_cell() {
        let line = set("| $|q|$ | b |");
        assert_eq!(line.matches('|').count(), 3, "{line}");
    }

    #[test]
    fn other_dollars_and_code_are_left() {
        for text in ["`$x$` and ``a ` $x$``", "$PWD/a and $OUT/b", "5 $ or 6 $", "a `b\n$x$ c` d"] {
            assert_eq!(set(text), text);
        }
        assert!(set("a `b\nc` $x$").contains("<math>"));
        // Code without an end stops at the end of its paragraph.
        assert!(set("a ` b\n\n$x$").contains("<math>"));
    }
}
