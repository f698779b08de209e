//! Commands on a page for its reader to type.

/// A part of a page, in order.
#[derive(Debug, PartialEq)]
pub(super) enum Part<'a> {
    /// A line for a shell.
    Command(&'a str),
    /// A file to save under a name.
    File(&'a str, &'a str),
}

/// Programs whose lines are commands; other indented text is not.
const PROGRAMS: [&str; 6] = ["cargo", "wholestring", "git", "cd", "cp", "pip"];

/// Beginning of the text with which a page presents a file: the name is in backquotes.
const SAVE: &str = "Save this as `";

/// The commands of a page, indented or in a shell block, and the files to save.
pub(super) fn parts(page: &str) -> Vec<Part<'_>> {
    let mut parts = Vec::new();
    let mut saved = None;
    let mut fence: Option<(&str, usize)> = None;
    let mut at = 0;
    for line in page.split_inclusive('\n') {
        let (begin, end) = (at, at + line.len());
        at = end;
        let word = line.trim_end();
        if let Some(language) = word.strip_prefix("```") {
            fence = match fence {
                None => Some((language, end)),
                Some((_, content)) => {
                    if let Some(name) = saved.take() {
                        parts.push(Part::File(name, &page[content..begin]));
                    }
                    None
                }
            };
            continue;
        }
        let shell = match fence {
            Some((language, _)) => (language == "sh").then_some(word),
            None => word.strip_prefix("    "),
        };
        if let Some(command) = shell.filter(|line| is_command(line)) {
            parts.push(Part::Command(command));
        }
        if fence.is_none()
            && let Some((_, rest)) = line.split_once(SAVE)
        {
            saved = rest.split_once('`').map(|(name, _)| name);
        }
    }
    parts
}

fn is_command(line: &str) -> bool {
    PROGRAMS.iter().any(|program| line.split(' ').next() == Some(program))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_and_files_come_in_order() {
        let page = "\
Try\n\n    wholestring check a.toml\n    12 kN\n\nSave this as `b.toml`:\n\n```toml\nx = 1\n```\n
```sh\nwholestring run b.toml\n```\n\n```text\nwholestring says nothing\n```\n";
        assert_eq!(
            parts(page),
            [
                Part::Command("wholestring check a.toml"),
                Part::File("b.toml", "x = 1\n"),
                Part::Command("wholestring run b.toml"),
            ]
        );
    }
}
