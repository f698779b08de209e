//! Equations of a page: LaTeX between lines of `$$`, converted to MathML, which browsers show
//! without any script. LaTeX between two `$` of a line is converted within it.

use math_core::{LatexToMathML, MathCoreConfig, MathDisplay};

use super::inline::Text;

/// Text before the name of an equation that the documentation of the code also shows, on the line
/// before it.
const NAMED: &str = "<!-- equation: ";

/// A part of a page, in order.
pub(super) enum Part<'a> {
    Line(&'a str),
    /// A line of a block of code.
    Code(&'a str),
    Equation(Equation<'a>),
}

pub(super) struct Equation<'a> {
    pub(super) name: Option<&'a str>,
    pub(super) latex: String,
    /// Line where it begins, from 1.
    line: usize,
    indent: &'a str,
}

/// Returns the page's lines and equations; or the line of an error, with the reason.
pub(super) fn parts(page: &str) -> Result<Vec<Part<'_>>, String> {
    let mut parts = Vec::new();
    let mut in_code = false;
    let mut name = None;
    let mut lines = page.lines().enumerate();
    while let Some((number, line)) = lines.next() {
        let word = line.trim();
        // The fence that opens a block may name a language, the one that closes it does not.
        let fence = word == "```" || !in_code && word.starts_with("```");
        in_code ^= fence;
        if in_code || word != "$$" {
            if name.is_some() {
                return Err(format!("line {number}: a name without an equation below it"));
            }
            match word.strip_prefix(NAMED) {
                Some(rest) if !in_code => name = Some(rest.trim_end_matches("-->").trim_end()),
                _ if in_code || fence => parts.push(Part::Code(line)),
                _ => parts.push(Part::Line(line)),
            }
            continue;
        }
        let indent = &line[..line.len() - line.trim_start().len()];
        let mut latex = String::new();
        loop {
            match lines.next() {
                Some((_, line)) if line.trim() == "$$" => break,
                Some((_, line)) => {
                    latex.push_str(line.trim());
                    latex.push('\n');
                }
                None => return Err(format!("line {}: an equation does not end", number + 1)),
            }
        }
        parts.push(Part::Equation(Equation { name: name.take(), latex, line: number + 1, indent }));
    }
    match name {
        Some(name) => Err(format!("the last line: no equation below the name {name}")),
        None => Ok(parts),
    }
}

impl Equation<'_> {
    /// Converts it to MathML on one line, because an empty line ends an element of a page. If
    /// `annotated`, it includes its LaTeX.
    pub(super) fn set(&self, annotated: bool) -> Result<String, String> {
        let Self { latex, line, .. } = self;
        let config = MathCoreConfig { annotation: annotated, ..MathCoreConfig::default() };
        let setter = LatexToMathML::new(config)
            .map_err(|error| format!("the setter of equations does not start: {error:?}"))?;
        let math = setter
            .convert_with_local_counter(latex.trim_end(), MathDisplay::Block)
            .map_err(|error| format!("line {line}: {error:?} in\n{latex}"))?;
        Ok(one_line(&math))
    }
}

/// Joins lines: elements without a space between them, LaTeX with one.
fn one_line(math: &str) -> String {
    let mut line = String::with_capacity(math.len());
    for part in math.lines().map(str::trim) {
        if !line.is_empty() && !part.starts_with('<') {
            line.push(' ');
        }
        line.push_str(part);
    }
    line
}

/// Returns the page with its equations converted; or the line of the first that cannot be, with the
/// reason.
pub(super) fn set_all(page: &str) -> Result<String, String> {
    let mut set = String::with_capacity(page.len());
    let mut text = Text::default();
    for part in parts(page)? {
        match part {
            Part::Line(line) => set.push_str(&text.set(line)?),
            Part::Code(line) => set.push_str(line),
            Part::Equation(equation) => {
                let indent = equation.indent;
                let math = equation.set(false)?;
                set.push_str(&format!("{indent}<div class=\"equation\">\n"));
                set.push_str(&format!("{indent}{math}\n{indent}</div>"));
            }
        }
        set.push('\n');
    }
    Ok(set)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::site::tree::pages;

    #[test]
    fn an_equation_is_set_and_code_is_left() {
        let page = "a\n\n$$\n\\frac{a}{b}\n$$\n\n```sh\n$$\n```\nb\n";
        let set = set_all(page).unwrap_or_else(|error| panic!("{error}"));
        assert!(set.contains("<div class=\"equation\">\n<math"), "{set}");
        assert!(set.contains("<mfrac>"), "{set}");
        assert!(set.ends_with("```sh\n$$\n```\nb\n"), "{set}");
    }

    #[test]
    fn what_cannot_be_set_is_named() {
        assert!(set_all("$$\nx\n").is_err_and(|error| error.contains("line 1")));
        assert!(set_all("x\n\n$$\n\\frac{\n$$\n").is_err_and(|error| error.contains("line 3")));
    }

    #[test]
    fn a_name_belongs_to_the_equation_below_it() {
        let page = "<!-- equation: a-b -->\n$$\nx\n$$\n";
        let parts = parts(page).unwrap_or_else(|error| panic!("{error}"));
        assert!(matches!(&parts[..], [Part::Equation(Equation { name: Some("a-b"), .. })]));
        let set = set_all(page).unwrap_or_else(|error| panic!("{error}"));
        assert!(!set.contains("a-b"), "{set}");
        let apart = set_all("<!-- equation: a-b -->\n\n$$\nx\n$$\n");
        assert!(apart.is_err_and(|error| error.contains("line 1")));
        assert!(set_all("<!-- equation: a-b -->\n").is_err());
    }

    #[test]
    fn every_equation_of_the_book_can_be_set() {
        let mut seen = 0;
        for (path, page) in pages().unwrap_or_else(|failure| panic!("{}", failure.reason)) {
            let set = set_all(&page).unwrap_or_else(|error| panic!("{path:?}, {error}"));
            seen += set.matches("<math").count();
        }
        assert!(seen > 0);
    }
}
