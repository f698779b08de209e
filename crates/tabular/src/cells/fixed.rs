//! Cutting a text in aligned columns, with words and empty cells among them.

use std::ops::Range;

use crate::cells::limits;
use crate::cells::table::{Cell, Position, Row, Source, Table, line_starts};

/// Minimum number of phrases in a line of a table; fewer are a title or a remark.
const FEWEST: usize = 4;

/// Separator of the cells, in words.
const PARTED_BY: &str = "blanks above one another";

/// Maximum number of characters of a line that are examined.
const WIDEST: usize = 1000;

/// Cuts a text into cells where all lines of its table have a blank and a heading begins.
///
/// A line with fewer phrases than a table has is one cell, unless it begins at a column other than
/// the first.
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
    let is_of_table = |line: &&Range<usize>| phrases(&text[(*line).clone()]) >= FEWEST;
    let of_table: Vec<&Range<usize>> = lines.iter().filter(is_of_table).collect();
    let mut columns = columns(text, &of_table);
    // Every line gets a cell of every column.
    if columns.len().saturating_mul(lines.len()) > limits::CELLS {
        columns.clear();
    }
    let rows = lines
        .iter()
        .map(|line| {
            let whole = phrases(&text[line.clone()]) < 2;
            let spans = match whole {
                true => Vec::new(),
                false => in_bytes(text, line, &columns),
            };
            let spans = if spans.is_empty() { vec![line.clone()] } else { spans };
            let cells = spans.into_iter().map(|span| cell(text, span)).collect();
            Row { cells, end: Position(line.end, line.end) }
        })
        .collect();
    Table { source, rows, parted_by: Some(PARTED_BY), counted: None, notes: Vec::new() }
}

/// Number of parts of a line that are separated by two or more blanks.
fn phrases(line: &str) -> usize {
    line.replace('\t', "  ").split("  ").filter(|part| !part.trim().is_empty()).count()
}

/// The columns as characters of a line: where some line of the table has a letter. Text under no
/// heading, such as a word of a name in all rows, belongs to the preceding column.
fn columns(text: &str, lines: &[&Range<usize>]) -> Vec<Range<usize>> {
    let mut written = vec![false; WIDEST];
    for line in lines {
        for (at, c) in text[(*line).clone()].chars().take(WIDEST).enumerate() {
            written[at] |= !c.is_whitespace();
        }
    }
    // The headings: the lines above the first one with a digit.
    let is_heading =
        |line: &&&Range<usize>| !text[(**line).clone()].chars().any(|c: char| c.is_ascii_digit());
    let mut headed = vec![false; WIDEST];
    for line in lines.iter().take_while(is_heading) {
        for (at, c) in text[(*line).clone()].chars().take(WIDEST).enumerate() {
            headed[at] |= !c.is_whitespace();
        }
    }
    let mut columns: Vec<Range<usize>> = Vec::new();
    let mut at = 0;
    while at < WIDEST {
        if !written[at] {
            at += 1;
            continue;
        }
        let end = (at..WIDEST).find(|&i| !written[i]).unwrap_or(WIDEST);
        let has_heading = headed[at..end].contains(&true);
        match columns.last_mut() {
            Some(last) if !has_heading => last.end = end,
            _ => columns.push(at..end),
        }
        at = end;
    }
    // The last column includes the text after it.
    if let Some(last) = columns.last_mut() {
        last.end = usize::MAX;
    }
    // Each column extends to the next, because a title above may be between them.
    for i in 1..columns.len() {
        columns[i - 1].end = columns[i].start;
    }
    if let Some(first) = columns.first_mut() {
        first.start = 0;
    }
    columns
}

/// Columns of characters as bytes of a line of the text.
fn in_bytes(text: &str, line: &Range<usize>, columns: &[Range<usize>]) -> Vec<Range<usize>> {
    let bytes: Vec<usize> =
        text[line.clone()].char_indices().take(WIDEST).map(|(at, _)| line.start + at).collect();
    let byte = |character: usize| bytes.get(character).copied().unwrap_or(line.end);
    columns.iter().map(|column| byte(column.start)..byte(column.end)).collect()
}

fn cell(text: &str, span: Range<usize>) -> Cell {
    let content = &text[span.clone()];
    let trimmed = content.trim();
    let from = span.start + (content.len() - content.trim_start().len());
    let from = if trimmed.is_empty() { span.start } else { from };
    let at = Position(from, from + trimmed.len());
    Cell::new(trimmed.to_owned(), at)
}

#[cfg(test)]
mod tests {
    use super::{Source, cut};

    #[test]
    fn empty_cells_and_names_of_several_words_stay_in_their_columns() {
        let text = "\
BHA 7

No  Component        OD     ID    Gauge   Length
                     in     in    in      ft
1   8 1/2 PDC bit    6.5    2.25  8 1/2   0.85
2   6 3/4 RSS        6.75   1.92          13.6
3   5 1/2 DP         5.5    4.778         TO SURFACE
    Total                                 14.45
* lengths in ft
";
        let source = Source::Text { file: "a.txt", text };
        let table = cut(source, text);
        let texts: Vec<Vec<&str>> = table
            .rows
            .iter()
            .map(|row| row.cells.iter().map(|cell| cell.text.as_str()).collect())
            .collect();
        assert_eq!(texts[0], ["BHA 7"]);
        assert_eq!(texts[2], ["No", "Component", "OD", "ID", "Gauge", "Length"]);
        assert_eq!(texts[3], ["", "", "in", "in", "in", "ft"]);
        assert_eq!(texts[4], ["1", "8 1/2 PDC bit", "6.5", "2.25", "8 1/2", "0.85"]);
        assert_eq!(texts[5], ["2", "6 3/4 RSS", "6.75", "1.92", "", "13.6"]);
        assert_eq!(texts[6][5], "TO SURFACE");
        assert_eq!(texts[7], ["", "Total", "", "", "", "14.45"]);
        assert_eq!(texts[8], ["* lengths in ft"]);
        for row in &table.rows {
            for cell in &row.cells {
                assert!(text.get(cell.at.0..cell.at.1).is_some());
            }
        }
    }
}
