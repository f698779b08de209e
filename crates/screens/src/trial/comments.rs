//! Comments about changed values: their detection, and the correction of those that would become
//! false.

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// Words that give the source of a value: true for the old value, not for a new one.
const ORIGINS: [&str; 13] = [
    "calibrat",
    "fitted",
    "measured",
    "interval",
    "readings",
    "matched",
    "tuned",
    "back-calculated",
    "estimated",
    "confirmed",
    "per cent",
    "±",
    "+/-",
];

/// A number in a comment refers to a value if it is within this factor.
const NEAR: f64 = 2.0;

/// First words of a comment block that refers to old values.
const MARK: &str = "Before a change";

/// Treatment of a comment.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum Fate {
    /// Keeps it unchanged.
    Keep,
    /// Marks it as referring to the old value.
    Mark,
    /// Removes it.
    Remove,
}

/// A comment after or above a changed value.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub struct Comment {
    /// Its first line in the text, from 1.
    pub line: usize,
    /// Its lines, without `#`.
    pub text: String,
    /// Its treatment.
    pub fate: Fate,
    /// Its text when it is marked.
    pub marked: String,
    /// Number of its lines.
    #[serde(skip)]
    lines: usize,
    /// Column of its start, if it follows a value on the line.
    #[serde(skip)]
    behind: Option<usize>,
}

/// A value as written, with its place.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Written<'a> {
    /// The last part of its key.
    pub(crate) name: &'a str,
    /// Bytes of the text.
    pub(crate) start: usize,
    pub(crate) end: usize,
}

/// The comments that a change of these values of a text concerns, in the order of the text: those
/// after a value or above it that may refer to it, those above its table, and those elsewhere that
/// name it and give its source.
pub(crate) fn comments(text: &str, values: &[Written<'_>]) -> Vec<Comment> {
    let lines: Vec<&str> = text.lines().collect();
    let line_of = |at: usize| text[..at].matches('\n').count();
    let mut found: Vec<Comment> = Vec::new();
    let mut done: Vec<usize> = Vec::new();
    for value in values {
        let line = line_of(value.start);
        if done.contains(&line) {
            continue;
        }
        done.push(line);
        let beside: Vec<_> = values.iter().filter(|one| line_of(one.start) == line).collect();
        let written = |one: &Written<'_>| &text[one.start..one.end];
        let named = |one: &&Written<'_>| match beside.len() {
            1 => written(one).to_owned(),
            _ => format!("{} {}", one.name, written(one)),
        };
        let old = beside.iter().map(named).collect::<Vec<_>>().join(", ");
        let numbers: Vec<f64> = beside.iter().flat_map(|one| numbers(written(one))).collect();
        let whole = lines[line];
        let line_start = text[..value.start].rfind('\n').map_or(0, |end| end + 1);
        if let Some(at) = comment_at(whole, value.end - line_start) {
            found.push(behind(line, at, whole, &old, &numbers));
        }
        let key = whole.split('=').next().unwrap_or_default().trim();
        let old = format!("{key} {old}");
        if let Some(block) = block_above(&lines, line) {
            let is_about = is_about(&block.text, &numbers);
            add(&mut found, block, &old, is_about);
        }
        let heading = (0..line).rev().find(|at| lines[*at].trim_start().starts_with('['));
        if let Some(block) = heading.and_then(|at| block_above(&lines, at)) {
            let is_about = says_origin(&block.text);
            if is_about || names(&block.text, key) {
                add(&mut found, block, &old, is_about);
            }
        }
        let is_comment = |line: &str| line.trim_start().starts_with('#');
        let says = |line: &str| is_comment(line) && says_origin(line) && names(line, key);
        for (at, _) in lines.iter().enumerate().filter(|(_, line)| says(line)) {
            add(
                &mut found,
                Block { line: at, lines: 1, text: bare(lines[at]).to_owned() },
                &old,
                true,
            );
        }
    }
    found.sort_by_key(|comment| comment.line);
    found
}

/// Adds a comment block, once, with the old value that it may refer to.
fn add(found: &mut Vec<Comment>, block: Block, old: &str, is_about: bool) {
    let holds = |one: &&mut Comment| {
        one.behind.is_none() && (one.line..one.line + one.lines).contains(&(block.line + 1))
    };
    let is_marked = block.text.starts_with(MARK);
    let fate = if is_about && !is_marked { Fate::Mark } else { Fate::Keep };
    if let Some(known) = found.iter_mut().find(holds) {
        let (first, rest) = known.marked.split_once('\n').unwrap_or((&known.marked, ""));
        known.marked = format!("{}; {old}:\n{rest}", first.trim_end_matches(':'));
        known.fate = if known.fate == Fate::Mark { Fate::Mark } else { fate };
        return;
    }
    let Block { line, lines, text } = block;
    let marked = format!("{MARK}: {old}:\n{text}");
    found.push(Comment { line: line + 1, text, fate, marked, lines, behind: None });
}

/// The text with its comments treated.
pub(crate) fn treated(text: &str, comments: &[Comment]) -> String {
    let mut lines: Vec<String> = text.split('\n').map(str::to_owned).collect();
    // From the last to the first, so that line numbers stay valid.
    for comment in comments.iter().rev() {
        let at = comment.line - 1;
        match (comment.fate, comment.behind) {
            (Fate::Keep, _) => {}
            (Fate::Mark, Some(place)) => {
                let end = if lines[at].ends_with('\r') { "\r" } else { "" };
                lines[at] = format!("{}# {}{end}", &lines[at][..place], comment.marked);
            }
            (Fate::Remove, Some(place)) => {
                let end = if lines[at].ends_with('\r') { "\r" } else { "" };
                lines[at] = format!("{}{end}", lines[at][..place].trim_end());
            }
            (Fate::Mark, None) => {
                let marked = comment.marked.lines().next().unwrap_or_default();
                lines.insert(at, format!("# {marked}"));
            }
            (Fate::Remove, None) => drop(lines.drain(at..at + comment.lines)),
        }
    }
    lines.join("\n")
}

/// Consecutive comment lines.
struct Block {
    line: usize,
    lines: usize,
    text: String,
}

/// The comment directly above a line, if there is one.
fn block_above(lines: &[&str], line: usize) -> Option<Block> {
    let is_comment = |at: &usize| lines[*at].trim_start().starts_with('#');
    let first = (0..line).rev().take_while(is_comment).last()?;
    let text: Vec<&str> = lines[first..line].iter().map(|line| bare(line)).collect();
    Some(Block { line: first, lines: line - first, text: text.join("\n") })
}

fn behind(line: usize, at: usize, whole: &str, old: &str, numbers: &[f64]) -> Comment {
    let text = bare(&whole[at..]).to_owned();
    let is_marked = text.starts_with("was ");
    let fate = if is_about(&text, numbers) && !is_marked { Fate::Mark } else { Fate::Keep };
    let marked = format!("was {old}: {text}");
    Comment { line: line + 1, text, fate, marked, lines: 1, behind: Some(at) }
}

/// A comment without its mark.
fn bare(line: &str) -> &str {
    line.trim().trim_start_matches('#').trim()
}

/// The start of the comment of a line, after this place, if there is one.
fn comment_at(line: &str, from: usize) -> Option<usize> {
    let mut quote = None;
    for (at, letter) in line.char_indices().skip_while(|(at, _)| *at < from) {
        match (quote, letter) {
            (None, '#') => return Some(at),
            (None, '"' | '\'') => quote = Some(letter),
            (Some(open), _) if open == letter => quote = None,
            _ => {}
        }
    }
    None
}

/// The numbers of a text.
fn numbers(text: &str) -> Vec<f64> {
    let parts = text.split(|letter: char| !letter.is_ascii_digit() && letter != '.');
    parts.filter_map(|part| part.trim_matches('.').parse().ok()).collect()
}

fn says_origin(comment: &str) -> bool {
    let comment = comment.to_lowercase();
    ORIGINS.iter().any(|word| comment.contains(word))
}

/// Whether a comment may refer to values: it gives their source, or has a number close to them.
fn is_about(comment: &str, values: &[f64]) -> bool {
    let near = |number: f64| {
        values.iter().any(|value| {
            let ratio = number / value;
            *value != 0.0 && (1.0 / NEAR..=NEAR).contains(&ratio)
        })
    };
    says_origin(comment) || numbers(comment).into_iter().any(near)
}

/// Whether a comment has a key among its words.
fn names(comment: &str, key: &str) -> bool {
    let comment = comment.to_lowercase();
    let mut words = comment.split(|letter: char| !letter.is_alphanumeric() && letter != '_');
    words.any(|word| word == key)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = r#"# A well.
# Fitted on the record at 1714 m: the coefficients of friction.
[[well.hole]]
diameter = "220 mm"  # by caliper
friction = { kinetic = 0.24, static = 0.52 }    # fitted on the record

# The rock.
[[well.hole]]
friction = 0.3  # a guess
[plan.friction]
# Its ends: 0.1 to 0.4.
low = 0.15  # cased # and open
"#;

    fn written<'a>(name: &'a str, value: &str) -> Written<'a> {
        let start = TEXT.find(value).expect(value);
        Written { name, start, end: start + value.len() }
    }

    #[test]
    fn a_comment_that_would_be_false_is_marked_and_others_stay() {
        let values = [
            written("kinetic", "0.24"),
            written("static", "0.52"),
            written("friction", "0.3"),
            written("low", "0.15"),
        ];
        let found = comments(TEXT, &values);
        let fates: Vec<_> = found.iter().map(|one| (one.line, one.fate)).collect();
        use Fate::{Keep, Mark};
        assert_eq!(fates, [(1, Mark), (5, Mark), (9, Keep), (11, Mark), (12, Keep)]);
        let text = treated(TEXT, &found);
        let line = "static = 0.52 }    # was kinetic 0.24, static 0.52: fitted on the record";
        assert!(text.contains(line), "{text}");
        assert!(text.contains("# Before a change: low 0.15:\n# Its ends"), "{text}");
        assert!(text.contains("0.3  # a guess") && text.contains("# by caliper"), "{text}");
        // Marked once, a comment stays true.
        let values = [Written { name: "low", ..moved(&text, "0.15  #") }];
        let again = comments(&text, &values);
        assert!(again.iter().all(|one| one.fate == Keep), "{again:?}");
    }

    fn moved(text: &str, value: &str) -> Written<'static> {
        let start = text.find(value).expect(value);
        Written { name: "", start, end: start + 4 }
    }

    #[test]
    fn a_comment_is_removed_alone() {
        let mut found = comments(TEXT, &[written("friction", "0.3"), written("low", "0.15")]);
        found.iter_mut().for_each(|one| one.fate = Fate::Remove);
        let text = treated(TEXT, &found);
        assert!(text.contains("friction = 0.3\n"), "{text}");
        assert!(!text.contains("Its ends") && text.contains("low = 0.15\n"), "{text}");
    }
}
