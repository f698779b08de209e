//! Cutting a text report whose columns are parted by blanks.

use std::ops::Range;

use crate::cells::number;
use crate::cells::table::{Cell, Position, Row, Source, Table, line_starts};

/// Lines above the numbers that may hold headings.
const HEADING_LINES: usize = 8;

/// The fewest numbers that make a line of a survey.
const FEWEST: usize = 3;

/// Cuts a text into cells at runs of blanks.
///
/// The first line of numbers shows how many columns there are and where they stand; the headings
/// above go to the column under which they stand.
pub(crate) fn cut<'a>(source: Source<'a>, text: &'a str) -> Table<'a> {
    let starts: Vec<usize> = line_starts(text).collect();
    let lines: Vec<Range<usize>> = starts
        .iter()
        .enumerate()
        .map(|(i, &start)| {
            let end = starts.get(i + 1).copied().unwrap_or(text.len());
            start..start + text[start..end].trim_end().len()
        })
        .collect();

    let first = lines.iter().position(|line| numbers(text, line).is_some());
    let columns: Vec<Range<usize>> = match first {
        Some(i) => {
            let numbers = numbers(text, &lines[i]).unwrap_or_default();
            numbers.iter().map(|word| in_characters(text, &lines[i], word)).collect()
        }
        None => Vec::new(),
    };

    let mut marks: Vec<(usize, &str)> = Vec::new();
    let mut rows = Vec::new();
    for (i, line) in lines.iter().enumerate() {
        let spans = match first {
            Some(first) if i >= first => {
                let (words, mark) = data(text, line, columns.len());
                marks.extend(mark.map(|mark| (i + 1, mark)));
                words
            }
            Some(first) if i + HEADING_LINES >= first => headings(text, line, &columns),
            _ => phrases(text, line),
        };
        let cells = spans
            .into_iter()
            .map(|span| Cell {
                text: text[span.clone()].trim().to_owned(),
                number: None,
                at: Position(span.start, span.end),
            })
            .collect();
        rows.push(Row { cells, end: Position(line.end, line.end) });
    }
    let note = marks.first().map(|(line, mark)| match marks.len() - 1 {
        0 => format!("the mark '{mark}' in line {line} is passed over"),
        more => format!("the mark '{mark}' in line {line} is passed over, and {more} more below"),
    });
    let notes = note.into_iter().collect();
    let counted = first.is_some().then_some(columns.len());
    Table { source, rows, parted_by: Some("blanks"), counted, notes }
}

/// The words of a line, with what stands in brackets as one word.
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

/// The parts of a line between two blanks or more.
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

/// The numbers of a line that holds three or more and nothing else, a mark before them aside.
fn numbers(text: &str, line: &Range<usize>) -> Option<Vec<Range<usize>>> {
    let mut words = words(text, line);
    if words.first().is_some_and(|word| is_mark(&text[word.clone()])) {
        words.remove(0);
    }
    let numeric = |word: &Range<usize>| number::is_number(&text[word.clone()]);
    (words.len() >= FEWEST && words.iter().all(numeric)).then_some(words)
}

/// A sign before a row, such as `!` or `*`, that is not part of its numbers.
fn is_mark(word: &str) -> bool {
    matches!(word, "!" | "*" | "**" | ">" | "+" | "@" | "&" | "x" | "P" | "T")
}

/// The cells of a line below the headings, and the mark before them.
///
/// A line without a number is one cell: a remark. What follows the last column is a remark, too.
fn data<'a>(
    text: &'a str,
    line: &Range<usize>,
    columns: usize,
) -> (Vec<Range<usize>>, Option<&'a str>) {
    let mut words = words(text, line);
    let numeric = |word: &Range<usize>| number::is_number(&text[word.clone()]);
    if !words.iter().any(numeric) && words.len() != columns {
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
    // Headings may stand in a comment.
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
