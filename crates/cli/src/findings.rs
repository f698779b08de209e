//! Findings under the table of a run.

use wholestring_results::{Finding, Level, Summary};
use wholestring_runner::findings::name;

/// Space before what does not fit in the first line.
const INDENT: usize = 4;

/// Narrower than this nothing is wrapped.
const NARROWEST: usize = 40;

/// The findings of all operations, the gravest first, in lines of at most `width` characters.
pub(crate) fn lines(summary: &Summary, width: Option<usize>, color: bool) -> String {
    let all = summary.operations.iter().flat_map(|of| {
        let name = name(of);
        of.findings.iter().map(move |found| (name.clone(), found))
    });
    let mut all: Vec<(String, &Finding)> = all.collect();
    all.sort_by_key(|(_, found)| std::cmp::Reverse(found.level));
    let mut text = String::new();
    for (name, found) in all {
        let level = found.level.name();
        let line = wrapped(&format!("{level}: {name}: {}", found.message), width);
        text +=
            &if color { format!("{}{}", painted(found.level), &line[level.len()..]) } else { line };
        text.push('\n');
    }
    text
}

fn painted(level: Level) -> String {
    let color = match level {
        Level::Error => "1;31",
        Level::Warning => "33",
        Level::Note => "36",
    };
    format!("\x1b[{color}m{}\x1b[0m", level.name())
}

fn wrapped(line: &str, width: Option<usize>) -> String {
    let Some(width) = width.filter(|width| *width >= NARROWEST) else {
        return line.to_owned();
    };
    let mut text = String::new();
    let mut used = 0;
    for word in line.split(' ') {
        let long = word.chars().count();
        if used > 0 && used + 1 + long > width {
            text += &format!("\n{:INDENT$}", "");
            used = INDENT;
        } else if used > 0 {
            text.push(' ');
            used += 1;
        }
        text += word;
        used += long;
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_no_longer_than_the_screen() {
        let line =
            "warning: trip in (soft): Helically buckled from 100 m to 2000 m, and so on and so on";
        assert_eq!(wrapped(line, None), line);
        let text = wrapped(line, Some(45));
        assert!(text.lines().all(|line| line.chars().count() <= 45), "{text}");
        assert!(text.lines().skip(1).all(|line| line.starts_with("    ")));
        let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(words(&text), words(line));
    }
}
