//! Changes of an example, a table of them.

/// Rows of "name: `what stands there` -> `what stands there instead`", in which `\n` ends a line.
pub(crate) fn changes(table: &str) -> Vec<(&str, String, String)> {
    let parts: Vec<&str> = table.split('`').collect();
    let (rows, rest) = parts.as_chunks::<4>();
    assert!(
        !rows.is_empty() && rest.concat().trim().is_empty(),
        "{table}"
    );
    rows.iter()
        .map(|[name, from, arrow, to]| {
            let name = name.trim().strip_suffix(':').expect("a name and a colon");
            assert_eq!(arrow.trim(), "->", "{name}");
            (name, from.replace("\\n", "\n"), to.replace("\\n", "\n"))
        })
        .collect()
}
