//! The documentation's tables of columns are the program's.

use std::{fs, path::Path};

use wholestring_results::{
    BIT_TEST, BOTTOM_HOLE, CONTACT, ColumnSpec, FRAMES, NODES, SPECTRA, TIME, WEAR,
};

fn rows(columns: &[ColumnSpec]) -> String {
    let mut text = String::from("| column | unit | meaning |\n|---|---|---|\n");
    for column in columns {
        let unit = if column.text { "text" } else { column.unit };
        text += &format!("| `{}` | {unit} | {} |\n", column.name, column.meaning);
    }
    text
}

#[test]
fn the_page_lists_every_column() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/src/outputs.md");
    let page = fs::read_to_string(page).unwrap().replace("\r\n", "\n");
    for (name, columns) in [
        ("nodes", NODES),
        ("time", TIME),
        ("frames", FRAMES),
        ("spectra", SPECTRA),
        ("wear", WEAR),
        ("contact", CONTACT),
        ("bit-test", BIT_TEST),
        ("bottom_hole", BOTTOM_HOLE),
    ] {
        let expected = rows(columns);
        assert!(
            page.contains(&expected),
            "docs/src/outputs.md should hold this table of {name}.parquet:\n\n{expected}"
        );
    }
}
