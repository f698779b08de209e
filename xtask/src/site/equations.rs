//! Equations of a page: LaTeX between lines of `$$`, set as MathML, which browsers show without any
//! script.

use math_core::{LatexToMathML, MathCoreConfig, MathDisplay};

/// The page with its equations set; else the line of the first that cannot be, and why.
pub(super) fn set_all(page: &str) -> Result<String, String> {
    let setter = LatexToMathML::new(MathCoreConfig::default())
        .map_err(|error| format!("the setter of equations does not start: {error:?}"))?;
    let mut set = String::with_capacity(page.len());
    let mut fence: Option<&str> = None;
    let mut lines = page.lines().enumerate();
    while let Some((number, line)) = lines.next() {
        let word = line.trim();
        match fence {
            Some(mark) if word == mark => fence = None,
            None if word.starts_with("```") => fence = Some("```"),
            _ => {}
        }
        if fence.is_some() || word != "$$" {
            set.push_str(line);
            set.push('\n');
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
        let math = setter
            .convert_with_local_counter(&latex, MathDisplay::Block)
            .map_err(|error| format!("line {}: {error:?} in\n{latex}", number + 1))?;
        // An element that ends at an empty line, of which it has none.
        set.push_str(&format!("{indent}<div class=\"equation\">\n"));
        set.push_str(&format!("{indent}{}\n{indent}</div>\n", math.replace('\n', " ")));
    }
    Ok(set)
}

#[cfg(test)]
mod tests {
    use std::{fs, path::Path};

    use super::*;
    use crate::folders::root;

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
    fn every_equation_of_the_book_can_be_set() {
        fn look(folder: &Path, seen: &mut usize) {
            for entry in fs::read_dir(folder).expect("a folder of the book") {
                let path = entry.expect("a page").path();
                if path.is_dir() {
                    look(&path, seen);
                } else if path.extension().is_some_and(|extension| extension == "md") {
                    let page = fs::read_to_string(&path).expect("a page");
                    let set = set_all(&page).unwrap_or_else(|error| panic!("{path:?}, {error}"));
                    *seen += set.matches("<math").count();
                }
            }
        }
        let mut seen = 0;
        look(&root().join("docs/src"), &mut seen);
        assert!(seen > 0);
    }
}
