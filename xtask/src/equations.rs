//! Equations of the book: LaTeX between lines of `$$`, or between two `$` of a line, becomes
//! MathML, which browsers show without any script.
//!
//! An equation with a name is also shown by one doc comment, which includes a file of its crate.

use std::{
    collections::BTreeMap,
    fs,
    io::{self, Read},
    path::{Path, PathBuf},
};

use math_core::{LatexToMathML, MathCoreConfig, MathDisplay};
use serde_json::Value;

use crate::{
    command::{files, relative, root},
    outcome::{Failure, Finding},
};

/// Text before the name of an equation, on the line above it.
const NAMED: &str = "<!-- equation: ";

/// Folder of a crate's equations.
const FOLDER: &str = "equations";

/// Text in a doc comment before the name of the equation's file.
const INCLUDED: &str = "include_str!(\"";

/// Rustdoc has no style for equations: they have their natural width, and scroll on a narrow
/// screen.
const STYLE: &str = "margin: 0.4em 0 0.8em; padding: 0.4em 0; overflow: auto hidden";

/// Characters of a formula within a line that a page would read as its own markup.
const MARKS: [(char, &str); 6] = [
    ('|', "&#124;"),
    ('*', "&#42;"),
    ('_', "&#95;"),
    ('[', "&#91;"),
    (']', "&#93;"),
    ('`', "&#96;"),
];

/// A page with its equations in MathML, and names and LaTeX of those with a name.
#[derive(Debug, Default)]
struct Page {
    text: String,
    named: Vec<(String, String)>,
}

impl Page {
    /// Converts a page; the error has the line and the reason.
    fn read(page: &str) -> Result<Self, String> {
        let mut read = Self::default();
        let (mut in_code, mut code, mut name) = (false, None, None);
        let mut lines = page.lines().zip(1..);
        while let Some((line, number)) = lines.next() {
            let word = line.trim();
            let at = |error: String| format!("line {number}: {error}");
            if name.is_some() && word != "$$" {
                return Err(at("there is a name above it, and it is no equation".into()));
            }
            // The fence that opens a block may name a language, the one that closes it does not.
            let fence = word == "```" || !in_code && word.starts_with("```");
            in_code ^= fence;
            if in_code || fence {
                read.text += line;
            } else if let Some(rest) = word.strip_prefix(NAMED) {
                name = Some(rest.trim_end_matches("-->").trim_end().to_owned());
                continue;
            } else if word == "$$" {
                let indent = &line[..line.len() - line.trim_start().len()];
                let mut latex = Vec::new();
                loop {
                    match lines.next() {
                        Some((line, _)) if line.trim() == "$$" => break,
                        Some((line, _)) => latex.push(line.trim()),
                        None => return Err(at("the equation does not end".into())),
                    }
                }
                let latex = latex.join("\n");
                let math = math(&latex, MathDisplay::Block, false).map_err(at)?;
                read.text +=
                    &format!("{indent}<div class=\"equation\">\n{indent}{math}\n{indent}</div>");
                read.named.extend(name.take().map(|name| (name, latex)));
            } else {
                read.text += &inline(line, &mut code).map_err(at)?;
            }
            read.text.push('\n');
        }
        match name {
            Some(name) => Err(format!("the last line: no equation below the name {name}")),
            None => Ok(read),
        }
    }
}

/// MathML on one line, because an empty line ends an element of a page; with its LaTeX on request.
fn math(latex: &str, display: MathDisplay, annotation: bool) -> Result<String, String> {
    let setter = LatexToMathML::new(MathCoreConfig { annotation, ..MathCoreConfig::default() })
        .map_err(|error| format!("math-core does not start: {error:?}"))?;
    let math = setter
        .convert_with_local_counter(latex, display)
        .map_err(|error| format!("{error:?} in\n{latex}"))?;
    let mut line = String::with_capacity(math.len());
    for part in math.lines().map(str::trim) {
        if !line.is_empty() && !part.starts_with('<') {
            line.push(' ');
        }
        line.push_str(part);
    }
    Ok(line)
}

/// A line with its formulas converted. Code is unchanged, and so are dollars that do not enclose a
/// formula. `code` has the backquotes that end the code that is open at the end of the line.
fn inline(line: &str, code: &mut Option<usize>) -> Result<String, String> {
    if line.trim().is_empty() {
        *code = None;
    }
    let (mut done, mut rest) = (String::with_capacity(line.len()), line);
    while let Some(at) = rest.find(['`', '$']) {
        let (before, marked) = rest.split_at(at);
        done.push_str(before);
        let ticks = marked.len() - marked.trim_start_matches('`').len();
        let opens = !before.ends_with(|last: char| last.is_alphanumeric() || last == '\\');
        let latex = formula(marked).filter(|_| opens && code.is_none());
        let taken = match latex {
            Some(latex) => {
                let math = math(latex, MathDisplay::Inline, false)?;
                let escape = |math: String, (mark, text): &(char, &str)| math.replace(*mark, text);
                done.push_str(&MARKS.iter().fold(math, escape));
                latex.len() + 2
            }
            None => {
                if ticks > 0 {
                    *code = match *code {
                        None => Some(ticks),
                        Some(open) => Some(open).filter(|open| *open != ticks),
                    };
                }
                done.push_str(&marked[..ticks.max(1)]);
                ticks.max(1)
            }
        };
        rest = &marked[taken..];
    }
    Ok(done + rest)
}

/// The text between the first dollar and the one that closes it: `$PWD and $OUT` is not a formula.
fn formula(marked: &str) -> Option<&str> {
    let (latex, after) = marked.strip_prefix('$')?.split_once('$')?;
    let spaced = latex.is_empty() || latex.starts_with(' ') || latex.ends_with(' ');
    let closes = !after.starts_with(|next: char| next.is_alphanumeric());
    (!spaced && closes && !latex.contains('`')).then_some(latex)
}

/// Reads a book from standard input in the format of mdBook's preprocessors, and writes it with its
/// equations converted.
pub(crate) fn preprocess(arguments: &[&str]) -> Result<Finding, Failure> {
    if let ["supports", format] = arguments {
        let reason = || format!("equations are converted for html, not for {format}");
        return if *format == "html" { Ok(Finding::Done) } else { Err(Failure::new(reason())) };
    }
    let mut text = String::new();
    io::stdin().read_to_string(&mut text).map_err(Failure::at(Path::new("standard input")))?;
    let parts: Result<[Value; 2], _> = serde_json::from_str(&text);
    let [_, mut book] =
        parts.map_err(|error| Failure::new(format!("this is no book of mdBook: {error}")))?;
    convert(&mut book).map_err(Failure::new)?;
    println!("{book}");
    Ok(Finding::Done)
}

/// Converts chapters, which are in lists and nested; an object with a name and content is one.
fn convert(value: &mut Value) -> Result<(), String> {
    match value {
        Value::Array(parts) => parts.iter_mut().try_for_each(convert),
        Value::Object(parts) => {
            let name = parts.get("name").and_then(Value::as_str).unwrap_or_default().to_owned();
            if let Some(Value::String(content)) = parts.get_mut("content") {
                let page = Page::read(content).map_err(|error| format!("{name}: {error}"))?;
                *content = page.text;
            }
            parts.values_mut().try_for_each(convert)
        }
        _ => Ok(()),
    }
}

/// Each file of a crate's equations equals the one made from the book.
pub(crate) fn check() -> Result<Finding, Failure> {
    let (expected, present) = (expected()?, present()?);
    let differs = |path: &&PathBuf| expected.get(*path) != present.get(*path);
    match expected.keys().chain(present.keys()).find(differs) {
        Some(path) => Err(Failure::new(format!(
            "{} is not the one made from the book; run `cargo xtask equations --write`",
            path.display()
        ))),
        None => Ok(Finding::Done),
    }
}

/// Writes them, and removes unused ones.
pub(crate) fn write() -> Result<Finding, Failure> {
    let expected = expected()?;
    for path in present()?.keys().filter(|path| !expected.contains_key(*path)) {
        fs::remove_file(path).map_err(Failure::at(path))?;
    }
    for (path, text) in &expected {
        let folder = path.parent().unwrap_or(path);
        fs::create_dir_all(folder).map_err(Failure::at(folder))?;
        fs::write(path, text).map_err(Failure::at(path))?;
    }
    println!("{} equations of the book in the documentation of the code", expected.len());
    Ok(Finding::Done)
}

/// The existing files.
fn present() -> Result<BTreeMap<PathBuf, String>, Failure> {
    let crates = root().join("crates");
    let mut all = files(&crates, "html")?;
    all.retain(|(path, _)| {
        name(path).is_some() && path.iter().count() == crates.iter().count() + 3
    });
    Ok(all.into_iter().collect())
}

/// The required files: one for each equation with a name, in the one crate that shows it.
fn expected() -> Result<BTreeMap<PathBuf, String>, Failure> {
    let mut named = BTreeMap::new();
    for (path, page) in files(&root().join("docs/src"), "md")? {
        let place = path.strip_prefix(root()).unwrap_or(&path).to_string_lossy().replace('\\', "/");
        let failed = |error| Failure::new(format!("{place}, {error}"));
        for (name, latex) in Page::read(&page).map_err(failed)?.named {
            let text = documentation(&name, &latex, &place).map_err(failed)?;
            if named.insert(name.clone(), text).is_some() {
                return Err(Failure::new(format!("two equations of the book are named {name}")));
            }
        }
    }
    let mut expected = BTreeMap::new();
    for (path, source) in files(&root().join("crates"), "rs")? {
        let included = source.split(INCLUDED).skip(1).filter_map(|rest| rest.split_once('"'));
        for file in included.map(|(file, _)| relative(&path, file)) {
            let Some(name) = name(&file) else { continue };
            let text = named.remove(name).ok_or_else(|| {
                let reason = "the book has no equation of this name, or it is shown twice";
                Failure::new(format!("{}, {name}: {reason}", path.display()))
            })?;
            expected.insert(file, text);
        }
    }
    match named.keys().next() {
        Some(name) => Err(Failure::new(format!(
            "the book's equation {name}: no doc comment shows it, and it needs no name"
        ))),
        None => Ok(expected),
    }
}

/// Text that a doc comment includes, with the LaTeX.
fn documentation(name: &str, latex: &str, place: &str) -> Result<String, String> {
    let math = math(latex, MathDisplay::Block, true)?
        // Rows with the same spacing and size as in the book.
        .replace("<math ", "<math style=\"min-width: max-content\" ")
        .replace("<mtable ", "<mtable style=\"math-style: normal\" ")
        .replace("<mtd style=\"", "<mtd style=\"padding-block: 0.25em;")
        // It begins on a new line so that it is easy to find in the file.
        .replace("<annotation", "\n<annotation");
    let origin = format!("<!-- {name} of {place}, by `cargo xtask equations --write` -->");
    Ok(format!("{origin}\n<div style=\"{STYLE}\">{math}</div>\n"))
}

/// The equation's name, if the file is one of a crate's equations.
fn name(file: &Path) -> Option<&str> {
    let ours = file.parent()?.ends_with(FOLDER) && file.extension()? == "html";
    ours.then(|| file.file_stem()?.to_str()).flatten()
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn converted(page: &str) -> String {
        Page::read(page).unwrap_or_else(|error| panic!("{error}")).text
    }

    #[test]
    fn an_equation_is_converted_and_code_is_left() {
        let text = converted("a\n\n$$\n\\frac{a}{b}\n$$\n\n```sh\n$$\n```\nb\n");
        assert!(text.contains("<div class=\"equation\">\n<math"), "{text}");
        assert!(text.contains("<mfrac>"), "{text}");
        assert!(text.ends_with("```sh\n$$\n```\nb\n"), "{text}");
    }

    #[test]
    fn errors_have_their_line() {
        for (page, line) in [
            ("$$\nx\n", "line 1"),
            ("x\n\n$$\n\\frac{\n$$\n", "line 3"),
            ("x\nA $\\nonsense$.\n", "line 2"),
            ("<!-- equation: a-b -->\n\n$$\nx\n$$\n", "line 2"),
            ("<!-- equation: a-b -->\n", "the last line"),
        ] {
            assert!(Page::read(page).is_err_and(|error| error.contains(line)), "{page}");
        }
    }

    #[test]
    fn formulas_of_a_line_are_converted() {
        let line = converted("With $\\mu N$, and ($r$):");
        assert!(line.starts_with("With <math><mi>μ</mi><mi>N</mi></math>, and (<math>"), "{line}");
        assert!(line.ends_with("</math>):\n"), "{line}");
        // Its bars end no cell.
        assert_eq!(converted("| $|q|$ | b |").matches('|').count(), 3);
    }

    #[test]
    fn other_dollars_and_code_are_left() {
        for text in ["`$x$` and ``a ` $x$``", "$PWD/a and $OUT/b", "5 $ or 6 $", "a `b\n$x$ c` d"] {
            assert_eq!(converted(text), format!("{text}\n"));
        }
        assert!(converted("a `b\nc` $x$").contains("<math>"));
        // Code without an end stops at the end of its paragraph.
        assert!(converted("a ` b\n\n$x$").contains("<math>"));
    }

    #[test]
    fn chapters_in_chapters_are_found() {
        let inner =
            json!({ "Chapter": { "name": "b", "content": "$$\nx\n$$\n", "sub_items": [] } });
        let outer = json!({ "Chapter": { "name": "a", "content": "x", "sub_items": [inner] } });
        let mut book = json!({ "items": [outer, "Separator"] });
        convert(&mut book).unwrap();
        assert!(book.to_string().contains("<math"), "{book}");
    }

    #[test]
    fn files_are_those_of_the_book() {
        check().unwrap();
        assert!(!expected().unwrap().is_empty());
    }

    #[test]
    fn named_equations_have_their_latex() {
        let page = "$$\nx\n$$\n\n<!-- equation: half -->\n$$\n\\frac12\n$$\n";
        let page = Page::read(page).unwrap();
        assert!(!page.text.contains("half"), "{}", page.text);
        assert_eq!(page.named, [("half".to_owned(), "\\frac12".to_owned())]);
        let text = documentation("half", &page.named[0].1, "a.md").unwrap();
        assert!(text.contains("<mfrac>") && text.contains("\\frac12</annotation>"), "{text}");
        // An empty line would end the element.
        assert!(!text.contains("\n\n"), "{text}");
        assert_eq!(name(Path::new("/crates/core/equations/half.html")), Some("half"));
        assert_eq!(name(Path::new("/crates/core/src/a.html")), None);
    }
}
