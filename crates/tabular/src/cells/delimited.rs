//! Cutting a text at a separator: comma, semicolon, tab.

use crate::cells::table::{Cell, Position, Row, Source, Table};

/// Maximum length of a quoted cell, bytes; beyond it the quote is an inch mark.
const LONGEST_QUOTE: usize = 4096;

/// Cuts a text into cells. A cell may be in double quotes, and then contain the separator, doubled
/// quotes, and line ends.
pub(crate) fn cut<'a>(
    source: Source<'a>,
    text: &'a str,
    sign: u8,
    parted_by: &'static str,
) -> Table<'a> {
    let mut rows = Vec::new();
    let mut cells = Vec::new();
    let mut at = 0;
    loop {
        let (cell, end) = cell(text, at, sign);
        cells.push(cell);
        at = end;
        match text.as_bytes().get(at) {
            Some(&byte) if byte == sign => at += 1,
            ended => {
                rows.push(Row { cells: std::mem::take(&mut cells), end: Position(at, at) });
                match ended {
                    Some(b'\r') if text.as_bytes().get(at + 1) == Some(&b'\n') => at += 2,
                    Some(_) => at += 1,
                    None => break,
                }
            }
        }
    }
    Table { source, rows, parted_by: Some(parted_by), counted: None, notes: Vec::new() }
}

/// The cell from a byte on, and its end: at the separator, the end of the line or of the text.
fn cell(text: &str, start: usize, sign: u8) -> (Cell, usize) {
    let blank = |byte: &u8| *byte == b' ' || (*byte == b'\t' && sign != b'\t');
    let bytes = text.as_bytes();
    let first = start + bytes[start..].iter().take_while(|byte| blank(byte)).count();
    if bytes.get(first) == Some(&b'"')
        && let Some(close) = closing_quote(bytes, first + 1, sign)
    {
        let inside = text[first + 1..close].replace("\"\"", "\"");
        let words: Vec<&str> = inside.split_whitespace().collect();
        let end = close + 1 + bytes[close + 1..].iter().take_while(|byte| blank(byte)).count();
        let at = Position(first + 1, close);
        return (Cell::new(words.join(" "), at), end);
    }
    let ends = |byte: &u8| *byte == sign || matches!(byte, b'\n' | b'\r');
    let end = bytes[start..].iter().position(ends).map_or(text.len(), |length| start + length);
    let content = &text[start..end];
    let trimmed = content.trim();
    let from = start + (content.len() - content.trim_start().len());
    let from = if trimmed.is_empty() { start } else { from };
    let at = Position(from, from + trimmed.len());
    (Cell::new(trimmed.to_owned(), at), end)
}

/// The closing quote of a cell: not doubled, and followed only by blanks up to the cell's end.
fn closing_quote(bytes: &[u8], from: usize, sign: u8) -> Option<usize> {
    let mut at = from;
    let limit = bytes.len().min(from + LONGEST_QUOTE);
    while at < limit {
        if bytes[at] != b'"' {
            at += 1;
        } else if bytes.get(at + 1) == Some(&b'"') {
            at += 2;
        } else {
            let mut after = bytes[at + 1..].iter().skip_while(|byte| **byte == b' ');
            return match after.next() {
                None | Some(b'\n' | b'\r') => Some(at),
                Some(&byte) if byte == sign => Some(at),
                Some(_) => None,
            };
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::{Source, cut};

    fn texts(text: &str) -> Vec<Vec<String>> {
        let source = Source::Text { file: "a.csv", text };
        let table = cut(source, text, b',', "commas");
        table
            .rows
            .iter()
            .map(|row| {
                for cell in &row.cells {
                    // Errors underline these positions, so that they must be valid ranges of the
                    // text.
                    assert!(text.get(cell.at.0..cell.at.1).is_some());
                }
                row.cells.iter().map(|cell| cell.text.clone()).collect()
            })
            .collect()
    }

    #[test]
    fn cells_are_cut_at_the_sign() {
        assert_eq!(texts("a, b ,c\r\n1,,3"), [vec!["a", "b", "c"], vec!["1", "", "3"]]);
        assert_eq!(texts("a\rb\n"), [vec!["a"], vec!["b"], vec![""]]);
    }

    #[test]
    fn quotes_hold_signs_lines_and_quotes() {
        assert_eq!(texts("\"MD\n(ft)\", \"1,500.0\" ,x"), [vec!["MD (ft)", "1,500.0", "x"]]);
        assert_eq!(texts("\"8 1/2\"\" bit\",2"), [vec!["8 1/2\" bit", "2"]]);
    }

    #[test]
    fn a_quote_that_never_closes_is_an_inch_sign() {
        assert_eq!(texts("\"a,b\n1,2"), [vec!["\"a", "b"], vec!["1", "2"]]);
        assert_eq!(texts("8\" hole,b"), [vec!["8\" hole", "b"]]);
    }
}
