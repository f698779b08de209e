//! Text that commands write into the book, between markers.

use std::{fs, path::Path};

use crate::command::Failure;

const END: &str = "<!-- end -->\n";

/// The marker at which a command's text begins.
fn begin(command: &str) -> String {
    format!("<!-- written by `cargo xtask {command} --write`: begin -->\n")
}

/// Splits a page into the text before a command's text, that text, and the text after it.
pub(crate) fn parts<'a>(page: &'a str, command: &str) -> Result<[&'a str; 3], Failure> {
    let begin = begin(command);
    let missing = || Failure::new(format!("the page lacks {}", begin.trim_end()));
    let (before, rest) = page.split_once(&begin).ok_or_else(missing)?;
    let (written, after) = rest.split_once(END).ok_or_else(missing)?;
    Ok([before, written, after])
}

/// The page with a new text in place of a command's earlier one.
pub(crate) fn replaced(page: &str, command: &str, text: &str) -> Result<String, Failure> {
    let [before, _, after] = parts(page, command)?;
    Ok(format!("{before}{}\n{text}\n{END}{after}", begin(command)))
}

/// Replaces a command's earlier text in a page.
pub(crate) fn write(page: &Path, command: &str, text: &str) -> Result<(), Failure> {
    let readable = |error| Failure::new(format!("{}: {error}", page.display()));
    let old = fs::read_to_string(page).map_err(readable)?;
    fs::write(page, replaced(&old, command, text)?).map_err(readable)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(result: Result<String, Failure>) -> String {
        result.unwrap_or_else(|failure| panic!("{}", failure.reason))
    }

    #[test]
    fn what_stood_between_the_markers_is_replaced() {
        let begin = begin("a-table");
        let page = format!("before\n{begin}old\n{END}after\n");
        let new = of(replaced(&page, "a-table", "new\n"));
        assert_eq!(new, format!("before\n{begin}\nnew\n\n{END}after\n"));
        assert_eq!(of(replaced(&new, "a-table", "new\n")), new);
        assert!(replaced(&page, "another", "new").is_err());
    }
}
