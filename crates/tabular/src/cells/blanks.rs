//! Cutting a text report whose columns are separated by blanks.

use std::ops::Range;

use crate::cells::number;
use crate::cells::table::{BLANKS, Cell, Position, Row, Source, Table, line_starts};

/// Number of lines above the numbers that may contain headings.
const HEADING_LINES: usize = 8;

/// Minimum number of numbers in a line of a survey.
const FEWEST: usize = 3;

/// Cuts a text into cells at runs of blanks.
///
/// The first line of numbers determines the number of columns and their positions; each heading
/// above belongs to the column below it.
pub(crate) fn cut<'a>(source: Source<'a>, text: &'a str) -> Table<'a> {
    cut_from(source, text, 0)
}

/// Cuts the text from a byte on, at which a line ends.
pub(crate) fn cut_from<'a>(source: Source<'a>, text: &'a str, from: usize) -> Table<'a> {
    let starts: Vec<usize> = line_starts(text).filter(|start| *start >= from).collect();
    let lines: Vec<Range<usize>> = starts
        .iter()
        .enumerate()
        .map(|(i, &start)| {
            let end = starts.get(i + 1).copied().unwrap_or(text.len());
            start..start + text[start..end].trim_end().len()
        })
        .collect();

    // A remark may follow the numbers of every line.
    let all = |line: &Range<usize>| numbers(text, line).filter(|(_, rest)| !rest);
    let any = |line: &Range<usize>| numbers(text, line);
    let first = lines.iter().position(|line| all(line).is_some());
    let first = first.or_else(|| lines.iter().position(|line| any(line).is_some()));
    let columns: Vec<Range<usize>> = match first {
        Some(i) => {
            let (numbers, _) = numbers(text, &lines[i]).unwrap_or_default();
            numbers.iter().map(|word| in_characters(text, &lines[i], word)).collect()
        }
        None => Vec::new(),
    };

    let mut marks: Vec<(Position, &str)> = Vec::new();
    let mut rows = Vec::new();
    for (i, line) in lines.iter().enumerate() {
        let spans = match first {
            Some(first) if i >= first => {
                let (words, mark) = data(text, line, columns.len());
                marks.extend(mark.map(|mark| (Position(line.start, line.end), mark)));
                words
            }
            Some(first) if i + HEADING_LINES >= first => headings(text, line, &columns),
            _ => phrases(text, line),
        };
        let cells = spans
            .into_iter()
            .map(|span| {
                let at = Position(span.start, span.end);
                Cell::new(text[span].trim().to_owned(), at)
            })
            .collect();
        rows.push(Row { cells, end: Position(line.end, line.end) });
    }
    let note = marks.first().map(|(at, mark)| {
        let line = source.row_name(*at);
        match marks.len() - 1 {
            0 => format!("the mark '{mark}' in {line} is ignored"),
            more => format!("the mark '{mark}' in {line} is ignored, and {more} more below"),
        }
    });
    let notes = note.into_iter().collect();
    let counted = first.is_some().then_some(columns.len());
    Table { source, rows, parted_by: Some(BLANKS), counted, notes }
}

/// The words of a line, with bracketed text as one word.
fn words(text: &str, line: &Range<usize>) -> Vec<Range<usize>> {
    let mut words: Vec<Range<usize>> = Vec::new();
    let mut open = 0usize;
    let mut blank_before = true;
    for (offset, c) in text[line.clone()].char_indices() {
        let at = line.start + offset;
        if c.is_whitespace() && open == 0 {
            blank_before = true;
            continue;
        }
        match words.last_mut() {
            Some(word) if !blank_before => word.end = at + c.len_utf8(),
            _ => words.push(at..at + c.len_utf8()),
        }
        blank_before = false;
        match c {
            '(' | '[' => open += 1,
            ')' | ']' => open = open.saturating_sub(1),
            _ => {}
        }
    }
    words
}

/// The parts of a line separated by two or more blanks.
fn phrases(text: &str, line: &Range<usize>) -> Vec<Range<usize>> {
    let mut phrases: Vec<Range<usize>> = Vec::new();
    for word in words(text, line) {
        match phrases.last_mut() {
            Some(phrase)
                if word.start - phrase.end == 1 && !text[phrase.end..].starts_with('\t') =>
            {
                phrase.end = word.end;
            }
            _ => phrases.push(word),
        }
    }
    phrases
}

/// The numbers at the beginning of a line, after an optional mark, if there are three or more, and
/// whether text follows them.
fn numbers(text: &str, line: &Range<usize>) -> Option<(Vec<Range<usize>>, bool)> {
    let mut words = sides_joined(text, words(text, line));
    if words.first().is_some_and(|word| is_mark(&text[word.clone()])) {
        words.remove(0);
    }
    let count = words.iter().take_while(|word| is_numeric(&text[(*word).clone()])).count();
    let rest = words.len() > count;
    words.truncate(count);
    (count >= FEWEST).then_some((words, rest))
}

/// Whether a word is a number, or a distance with its side.
fn is_numeric(word: &str) -> bool {
    number::is_number(word)
        || number::sided(word).is_some_and(|(sided, _)| number::is_number(sided))
}

/// Joins the side of a distance to its number: `12.5 N`. The values of a station precede them.
fn sides_joined(text: &str, words: Vec<Range<usize>>) -> Vec<Range<usize>> {
    let mut joined: Vec<Range<usize>> = Vec::with_capacity(words.len());
    for word in words {
        let is_side = matches!(&text[word.clone()], "N" | "S" | "E" | "W");
        let behind = joined.len() > FEWEST;
        match joined.last_mut() {
            Some(last) if is_side && behind && number::is_number(&text[last.clone()]) => {
                last.end = word.end;
            }
            _ => joined.push(word),
        }
    }
    joined
}

/// Whether a word belongs to the head or foot of a page.
fn is_of_page(word: &str) -> bool {
    let plain = word.trim_matches(|c: char| !c.is_alphanumeric()).to_lowercase();
    let is_clock = || {
        let mut parts = word.split(':');
        parts.clone().count() > 1
            && parts.all(|part| part.starts_with(|c: char| c.is_ascii_digit()))
    };
    matches!(plain.as_str(), "page" | "seite" | "pagina" | "compass" | "build") || is_clock()
}

/// Whether a word is a mark before a row, such as `!` or `*`, which is not part of its numbers.
fn is_mark(word: &str) -> bool {
    matches!(word, "!" | "*" | "**" | ">" | "+" | "@" | "&" | "x" | "P" | "T")
}

/// The cells of a line below the headings, and the mark before them.
///
/// A line without a number is one cell, a remark. Text after the last column is a remark, too.
fn data<'a>(
    text: &'a str,
    line: &Range<usize>,
    columns: usize,
) -> (Vec<Range<usize>>, Option<&'a str>) {
    let mut words = sides_joined(text, words(text, line));
    let numeric = |word: &Range<usize>| is_numeric(&text[word.clone()]);
    let begins = words.len().min(columns);
    let numbers = words[..begins].iter().filter(|word| numeric(word)).count();
    let is_remark = match words.first() {
        _ if numbers == 0 => words.len() != columns,
        // Numbers within a sentence, in a date, or of a page.
        Some(first) => {
            let of_page = || words.iter().any(|word| is_of_page(&text[word.clone()]));
            let begins_so = numeric(first) || is_mark(&text[first.clone()]);
            2 * numbers <= begins && !begins_so || numbers < begins && of_page()
        }
        None => true,
    };
    if is_remark {
        let whole = words.first().map(|word| word.start..line.end);
        return (whole.into_iter().collect(), None);
    }
    let mut mark = None;
    if words.len() > columns && is_mark(&text[words[0].clone()]) {
        mark = Some(&text[words.remove(0)]);
    }
    (words, mark)
}

/// The headings of a line, one per column; a column without one has an empty cell.
fn headings(text: &str, line: &Range<usize>, columns: &[Range<usize>]) -> Vec<Range<usize>> {
    let phrases = phrases(text, line);
    let mut words = words(text, line);
    // Headings may be in a comment.
    let is_sign = |word: &Range<usize>| matches!(&text[word.clone()], "#" | "%" | "//");
    if words.len() == columns.len() + 1 && is_sign(&words[0]) {
        words.remove(0);
    }
    if phrases.len() == columns.len() {
        return phrases;
    }
    if words.len() == columns.len() {
        return words;
    }
    let bracketed = bracketed(text, &words);
    if bracketed.len() == columns.len() {
        return bracketed;
    }
    if phrases.len() < 2 {
        return phrases;
    }
    let mut cells: Vec<Range<usize>> = columns.iter().map(|_| line.end..line.end).collect();
    for phrase in phrases {
        let place = in_characters(text, line, &phrase);
        let away =
            |column: &Range<usize>| (column.start + column.end).abs_diff(place.start + place.end);
        let nearest = (0..columns.len()).min_by_key(|&i| away(&columns[i]));
        if let Some(cell) = nearest.map(|i| &mut cells[i]) {
            let free = cell.start == cell.end;
            *cell = if free { phrase } else { cell.start..phrase.end };
        }
    }
    cells
}

/// Words joined so that each part ends with a word in brackets.
fn bracketed(text: &str, words: &[Range<usize>]) -> Vec<Range<usize>> {
    let mut parts: Vec<Range<usize>> = Vec::new();
    let mut ended = true;
    for word in words {
        match parts.last_mut() {
            Some(part) if !ended => part.end = word.end,
            _ => parts.push(word.clone()),
        }
        ended = text[word.clone()].ends_with([')', ']']);
    }
    parts
}

/// A range of bytes as the characters of its line.
fn in_characters(text: &str, line: &Range<usize>, span: &Range<usize>) -> Range<usize> {
    let start = text[line.start..span.start].chars().count();
    start..start + text[span.clone()].chars().count()
}
