use std::io::Cursor;

use calamine::{Data, Reader, Xlsx};

use super::{Cells, Sheet, SheetColumn, Workbook, WorkbookChart, WorkbookSeries};
use crate::figure::Stroke;

fn workbook() -> Workbook {
    let column = |heading: &str, unit: &str, cells| SheetColumn {
        heading: heading.into(),
        unit: unit.into(),
        meaning: format!("Meaning of {heading}"),
        cells,
    };
    Workbook {
        title: "A plan".into(),
        about: vec!["Made for a test".into()],
        first: Vec::new(),
        printed_rows: None,
        charts: vec![WorkbookChart {
            title: "Hook load".into(),
            across: "Hook load, kN".into(),
            down: "Depth, m".into(),
            series: vec![WorkbookSeries {
                name: "pick-up".into(),
                sheet: "Broomstick".into(),
                across: 2,
                down: 1,
                rows: 0..3,
                colour: 1,
                stroke: Some(Stroke::Dashed),
            }],
        }],
        sheets: vec![Sheet {
            name: "Broomstick".into(),
            about: "A row for each depth".into(),
            columns: vec![
                column("operation", "", Cells::Words(vec!["pick-up".into(); 3])),
                column("bit depth", "m", Cells::Numbers([500.0, 1000.0, 1500.5].map(Some).into())),
                column(
                    "hook load",
                    "kN",
                    Cells::Numbers(vec![Some(1.0 / 3.0), None, Some(f64::NAN)]),
                ),
            ],
        }],
    }
}

/// Written cells are read back: every digit, units in the headings, and empty cells.
#[test]
fn a_workbook_is_read_back() {
    let bytes = workbook().bytes().expect("a workbook");
    let mut read: Xlsx<_> = Xlsx::new(Cursor::new(bytes)).expect("a workbook");
    assert_eq!(read.sheet_names(), ["Charts", "Broomstick", "Columns"]);
    let sheet = read.worksheet_range("Broomstick").expect("a sheet");
    let cell = |row: u32, column: u32| sheet.get_value((row, column)).cloned().unwrap_or_default();
    let text = |text: &str| Data::String(text.to_owned());
    assert_eq!(cell(0, 2), text("hook load, kN"));
    assert_eq!(cell(1, 0), text("pick-up"));
    assert_eq!(cell(3, 1), Data::Float(1500.5));
    assert_eq!(cell(1, 2), Data::Float(1.0 / 3.0));
    assert_eq!([cell(2, 2), cell(3, 2)], [Data::Empty, Data::Empty]);
    let columns = read.worksheet_range("Columns").expect("a sheet");
    assert_eq!(columns.get_value((1, 3)), Some(&text("A row for each depth")));
    assert_eq!(columns.get_value((4, 3)), Some(&text("Meaning of hook load")));
}

/// The chart is Excel's own, of the cells: its file names their rows and reverses the depth axis.
#[test]
fn charts_are_of_the_cells() {
    let bytes = workbook().bytes().expect("a workbook");
    let mut file = zip::ZipArchive::new(Cursor::new(bytes)).expect("an archive");
    let mut text = String::new();
    let mut part = file.by_name("xl/charts/chart1.xml").expect("a chart");
    std::io::Read::read_to_string(&mut part, &mut text).expect("a text");
    for expected in ["Broomstick!$C$2:$C$4", "Broomstick!$B$2:$B$4", "maxMin"] {
        assert!(text.contains(expected), "{expected} is not in {text}");
    }
}
