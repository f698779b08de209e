//! A sheet as CSV.

use wholestring_export::number;
use wholestring_report::{Cells, Sheet};

/// The sheet as CSV: headings with units in brackets, which the table reader accepts.
pub(super) fn csv(sheet: &Sheet) -> String {
    let head = |column: &wholestring_report::SheetColumn| match column.unit.as_str() {
        "" => column.heading.clone(),
        unit => format!("{} ({unit})", column.heading),
    };
    let headings = sheet.columns.iter().map(|column| quoted(&head(column)));
    let mut text = headings.collect::<Vec<_>>().join(",") + "\n";
    let rows = sheet.columns.first().map_or(0, |column| column.cells.len());
    for row in 0..rows {
        let cells = sheet.columns.iter().map(|column| match &column.cells {
            Cells::Numbers(values) => values[row].and_then(number).unwrap_or_default(),
            Cells::Words(words) => quoted(&words[row]),
        });
        text += &(cells.collect::<Vec<_>>().join(",") + "\n");
    }
    text
}

/// A cell in quotes where it needs them.
fn quoted(text: &str) -> String {
    match text.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use wholestring_report::SheetColumn;

    use super::*;

    #[test]
    fn cells_are_quoted_where_they_must_be() {
        let column = |heading: &str, unit: &str, cells| SheetColumn {
            heading: heading.into(),
            unit: unit.into(),
            meaning: String::new(),
            cells,
        };
        let words = ["8 1/2\" bit, PDC", "pipe"].map(str::to_owned).to_vec();
        let sheet = Sheet {
            name: "S".into(),
            about: String::new(),
            columns: vec![
                column("component", "", Cells::Words(words)),
                column("od", "in", Cells::Numbers(vec![Some(8.5), None])),
            ],
        };
        assert_eq!(csv(&sheet), "component,od (in)\n\"8 1/2\"\" bit, PDC\",8.5\npipe,\n");
    }
}
