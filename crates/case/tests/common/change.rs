//! Tables of texts, and of changes of an example.

/// Rows of "name: `text`", in which `\n` ends a line.
pub(crate) fn rows(table: &str) -> Vec<(&str, String)> {
    let cells = cells(table).into_iter();
    cells.map(|(before, text)| (name(before), text)).collect()
}

/// Rows of "name: `original text` -> `replacement`", in which `\n` ends a line.
pub(crate) fn changes(table: &str) -> Vec<(&str, String, String)> {
    let cells = cells(table);
    let (rows, rest) = cells.as_chunks::<2>();
    assert!(rest.is_empty(), "{rest:?}");
    rows.iter()
        .map(|[(before, from), (arrow, to)]| {
            assert_eq!(*arrow, "->", "{before}");
            (name(before), from.clone(), to.clone())
        })
        .collect()
}

fn name(before: &str) -> &str {
    before.strip_suffix(':').expect("a name and a colon")
}

/// Texts between backticks, each with the text before it.
fn cells(table: &str) -> Vec<(&str, String)> {
    let parts: Vec<&str> = table.split('`').collect();
    let (cells, rest) = parts.as_chunks::<2>();
    assert!(!cells.is_empty() && rest.concat().trim().is_empty(), "{table}");
    let cells = cells.iter();
    cells.map(|[before, text]| (before.trim(), text.replace("\\n", "\n"))).collect()
}
