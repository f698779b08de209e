//! The documentation's tables of columns are the program's.

use std::{env, fs, path::Path};

use wholestring_results::{ColumnSpec, SCHEMA_VERSION, TABLES};

fn rows(columns: &[ColumnSpec]) -> String {
    let mut text = String::from("| column | unit | meaning |\n|---|---|---|\n");
    for column in columns {
        let unit = if column.text { "text" } else { column.unit };
        text += &format!("| `{}` | {unit} | {} |\n", column.name, column.meaning);
    }
    text
}

/// The page with this table after its mark, up to the next empty line.
fn with_table(page: &str, name: &str, table: &str) -> String {
    let mark = format!("<!-- {name} -->\n");
    let (before, rest) =
        page.split_once(&mark).unwrap_or_else(|| panic!("docs/src/outputs.md has no {mark}"));
    let (_, after) = rest.split_once("\n\n").expect("an empty line after it");
    format!("{before}{mark}{table}\n{after}")
}

/// With `WHOLESTRING_UPDATE_DOCS=1` it writes them.
#[test]
fn the_page_lists_every_column() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/src/outputs.md");
    let found = fs::read_to_string(&path).unwrap().replace("\r\n", "\n");
    assert!(found.contains(&format!("version of this layout, now {SCHEMA_VERSION}: ")));
    let mut expected = found.clone();
    for (name, columns) in TABLES {
        expected = with_table(&expected, name, &rows(columns));
    }
    if env::var_os("WHOLESTRING_UPDATE_DOCS").is_some() {
        fs::write(path, expected).unwrap();
        return;
    }
    assert!(
        found == expected,
        "docs/src/outputs.md lists other columns: WHOLESTRING_UPDATE_DOCS=1 writes those of now"
    );
}
