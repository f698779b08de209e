//! A catalogue as CSV: a line of keys, then a tubular a line.
//!
//! A key may be followed by its unit, `od in` or `od (in)`, in which all numbers of that column
//! are. Empty cells are keys that are not given.

use wholestring_config::{node::Key, prelude::*};

/// Keys whose values are words, even if they look like numbers.
const WORDS: [&str; 4] = ["name", "kind", "connection", "source"];

/// The text between two separators, without blanks and quotes.
struct Cell {
    text: String,
    place: Span,
}

/// Returns the tubulars as the TOML file would give them.
pub(super) fn parse(text: &str, source: usize) -> Result<Entries, Diagnostic> {
    let mut from = 0;
    let lines = text.split_inclusive('\n').filter_map(|line| {
        from += line.len();
        let begin = from - line.len();
        (!line.trim().is_empty()).then(|| (begin, line.trim_end()))
    });
    let mut lines = lines.collect::<Vec<_>>().into_iter();
    let Some((begin, head)) = lines.next() else {
        return Ok(Entries::default());
    };
    let separator = if head.matches(';').count() > head.matches(',').count() { ';' } else { ',' };
    let columns: Vec<(String, String, Span)> =
        cells(head, begin, separator, source)?.into_iter().map(heading).collect();
    for (i, (name, _, place)) in columns.iter().enumerate() {
        if let Some((.., first)) = columns[..i].iter().find(|(other, ..)| other == name) {
            return Err(Diagnostic::error(format!("two columns are called `{}`", short(name)))
                .at(*place, "again here")
                .at(*first, "first here"));
        }
    }
    let mut tubulars = Vec::new();
    for (begin, line) in lines {
        let place = Span { source, start: begin, end: begin + line.len() };
        let cells = cells(line, begin, separator, source)?;
        if cells.len() > columns.len() {
            return Err(Diagnostic::error("this line has more cells than there are columns")
                .at(place, format!("expected {} at most", columns.len())));
        }
        let filled = columns.iter().zip(cells).filter(|(_, cell)| !cell.text.is_empty());
        let entries = filled.map(|((name, unit, at), cell)| {
            (Key { name: name.clone(), place: *at }, value(name, unit, cell))
        });
        tubulars.push(Node { place, value: Value::Table(Entries(entries.collect())) });
    }
    let place = Span { source, start: begin, end: begin + head.len() };
    let key = Key { name: "tubular".to_owned(), place };
    Ok(Entries(vec![(key, Node { place, value: Value::List(tubulars) })]))
}

/// Returns the cells of a line; a separator between double quotes does not separate.
fn cells(
    line: &str,
    begin: usize,
    separator: char,
    source: usize,
) -> Result<Vec<Cell>, Diagnostic> {
    let mut cells = Vec::new();
    let mut quoted = false;
    let mut from = 0;
    for (at, letter) in line.char_indices().chain([(line.len(), separator)]) {
        // An inch mark inside a cell does not open or close quotes.
        if letter == '"' && (quoted || line[from..at].trim().is_empty()) {
            let rest = line[at + 1..].trim_start();
            quoted = if quoted { !(rest.is_empty() || rest.starts_with(separator)) } else { true };
        }
        if letter != separator || (quoted && at < line.len()) {
            continue;
        }
        let raw = line[from..at].trim();
        let start = begin + from + (line[from..at].len() - line[from..at].trim_start().len());
        let place = Span { source, start, end: start + raw.len() };
        if quoted {
            return Err(Diagnostic::error("a quote is not closed").at(place, "opened here"));
        }
        let inner = raw.strip_prefix('"').and_then(|inner| inner.strip_suffix('"'));
        let text = inner.map_or(raw.to_owned(), |inner| inner.replace("\"\"", "\""));
        cells.push(Cell { text: text.trim().to_owned(), place });
        from = at + letter.len_utf8();
    }
    Ok(cells)
}

/// The key of a column and its unit, which may be empty.
fn heading(cell: Cell) -> (String, String, Span) {
    let (name, unit) = cell.text.split_once([' ', '(', '[']).unwrap_or((&cell.text, ""));
    let unit = unit.trim_matches([' ', '(', ')', '[', ']']);
    (name.to_owned(), unit.to_owned(), cell.place)
}

fn value(name: &str, unit: &str, cell: Cell) -> Node {
    let number = cell.text.parse::<f64>().ok().filter(|number| number.is_finite());
    let value = match number {
        Some(value) if unit.is_empty() && !WORDS.contains(&name) => {
            Value::Number { value, whole: None }
        }
        _ => {
            let bare = !unit.is_empty() && !cell.text.chars().any(char::is_alphabetic);
            let text = if bare { format!("{} {unit}", cell.text) } else { cell.text };
            Value::Text { text, verbatim_from: None }
        }
    };
    Node { place: cell.place, value }
}
