//! Workbooks with hidden or uncalculated contents: the visible contents are read, and notes report
//! the rest.

mod old_excel;

use old_excel::Value;
use rust_xlsxwriter::{Formula, Workbook, Worksheet};
use wholestring_tabular::{
    Column, ImportedSurvey, ImportedTally, TableErrorKind, read, read_readings, read_tally,
};

fn file(name: &str) -> Vec<u8> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/workbooks/");
    std::fs::read(format!("{folder}{name}.xlsx")).unwrap()
}

fn survey(bytes: &[u8]) -> ImportedSurvey {
    read(bytes, "a.xlsx").unwrap_or_else(|error| panic!("{error}"))
}

fn tally(bytes: &[u8]) -> Result<ImportedTally, String> {
    read_tally(bytes, "a.xlsx", None, &mut |_| None).map_err(|error| error.to_string())
}

/// A sheet "S" of a survey of five stations at 0, 100, ... 400 m, changed.
fn changed(change: impl FnOnce(&mut Worksheet)) -> Vec<u8> {
    let mut workbook = Workbook::new();
    let sheet = workbook.add_worksheet();
    sheet.set_name("S").unwrap();
    for (column, heading) in ["MD (m)", "Inc (deg)", "Azi (deg)", "Temp"].iter().enumerate() {
        sheet.write_string(0, column as u16, *heading).unwrap();
    }
    for row in 1..=5_u32 {
        let step = f64::from(row - 1);
        for (column, value) in [100.0 * step, 2.0 * step, 45.0, 60.0].into_iter().enumerate() {
            sheet.write_number(row, column as u16, value).unwrap();
        }
    }
    change(sheet);
    workbook.save_to_buffer().unwrap()
}

fn depths(survey: &ImportedSurvey) -> Vec<f64> {
    survey.stations.iter().map(|station| station.md_m).collect()
}

/// The azimuth is a formula that a program left to be calculated: each was read as 0.
#[test]
fn formulas_that_were_never_calculated_are_refused_with_their_cell() {
    let calculated = "holds a formula whose result was never calculated";
    for (name, cell) in [
        ("azimuth-formula-not-calculated", "sheet 'Survey', cell C2"),
        ("survey-formula-without-value", "sheet 'Survey', cell A3"),
    ] {
        let error = read(&file(name), "a.xlsx").unwrap_err();
        assert_eq!(error.kind(), &TableErrorKind::FormulaNotCalculated, "{name}");
        assert_eq!(error.place().map(ToString::to_string).as_deref(), Some(cell));
        assert!(error.to_string().contains(calculated), "{error}");
    }
    let error = read_readings(&file("readings-formula-not-calculated"), "a.xlsx").unwrap_err();
    assert!(error.to_string().contains("cell C2: the cell holds a formula"), "{error}");
    let error = tally(&file("tally-weight-formula-without-value")).unwrap_err();
    assert!(error.contains("cell E3: the cell holds a formula"), "{error}");
}

/// A formula outside the columns that are read, or with its result, is valid; an empty text may be
/// a result.
#[test]
fn formulas_that_do_no_harm_are_read() {
    let beside = changed(|sheet| {
        sheet.write_formula(2, 3, "=60+1").unwrap();
    });
    assert_eq!(depths(&survey(&beside)), [0.0, 100.0, 200.0, 300.0, 400.0]);
    let calculated = changed(|sheet| {
        sheet.write_formula(2, 0, Formula::new("=A2+100").set_result("100")).unwrap();
    });
    assert_eq!(depths(&survey(&calculated)), [0.0, 100.0, 200.0, 300.0, 400.0]);
    let array = changed(|sheet| {
        sheet.write_array_formula(1, 2, 5, 2, "=D2:D6").unwrap();
    });
    let error = read(&array, "a.xlsx").unwrap_err();
    assert!(error.to_string().contains("cell C2: the cell holds a formula"), "{error}");
}

/// A rejected station, a joint that was laid out: hidden, and previously read as if they were
/// visible.
#[test]
fn hidden_rows_are_not_read_and_said() {
    let survey = survey(&file("hidden-row-in-survey"));
    assert_eq!(survey.stations.len(), 8);
    assert!(!depths(&survey).contains(&1000.0));
    let hidden = "row 6 of sheet 'Survey' is hidden and not read".to_owned();
    assert!(survey.notes.contains(&hidden), "{:?}", survey.notes);
    let tally = tally(&file("hidden-row-in-tally")).unwrap();
    assert_eq!(tally.rows.len(), 4);
    let hidden = "row 4 of sheet 'Data' is hidden and not read".to_owned();
    assert!(tally.notes.contains(&hidden), "{:?}", tally.notes);
}

/// Rows and columns hidden in different ways: by hand, in a closed group, of zero height or width.
#[test]
fn rows_and_columns_are_hidden_in_several_ways() {
    let grouped = changed(|sheet| {
        sheet.group_rows_collapsed(2, 3).unwrap();
    });
    let without = survey(&grouped);
    assert_eq!(depths(&without), [0.0, 300.0, 400.0]);
    let hidden = "rows 3 to 4 of sheet 'S' are hidden and not read".to_owned();
    assert!(without.notes.contains(&hidden), "{:?}", without.notes);
    assert_eq!(without.place, "rows 2 to 6 of sheet 'S'");
    let flat = changed(|sheet| {
        sheet.set_row_height(4, 0).unwrap();
    });
    assert_eq!(depths(&survey(&flat)), [0.0, 100.0, 200.0, 400.0]);
    // A column between those that are read.
    let column = changed(|sheet| {
        sheet.insert_column_of_text(1);
    });
    let read = survey(&column);
    assert_eq!(read.stations[2].azimuth_rad, 45f64.to_radians());
    let hidden = "column B of sheet 'S' is hidden and not read".to_owned();
    assert!(read.notes.contains(&hidden), "{:?}", read.notes);
    // A required column: the error states that it is hidden.
    let needed = changed(|sheet| {
        sheet.set_column_hidden(2).unwrap();
    });
    let error = wholestring_tabular::read(&needed, "a.xlsx").unwrap_err().to_string();
    assert!(error.contains("no column of azimuth"), "{error}");
    assert!(error.ends_with("(column C of sheet 'S' is hidden and not read)"), "{error}");
}

trait Hidden {
    /// Moves inclination and azimuth one column to the right, and hides the column between.
    fn insert_column_of_text(&mut self, at: u16);
}

impl Hidden for Worksheet {
    fn insert_column_of_text(&mut self, at: u16) {
        for (column, heading) in
            [(at, "Old inc (deg)"), (at + 1, "Inc (deg)"), (at + 2, "Azi (deg)")]
        {
            self.write_string(0, column, heading).unwrap();
        }
        for row in 1..=5_u32 {
            let step = f64::from(row - 1);
            for (column, value) in [(at, 80.0), (at + 1, 2.0 * step), (at + 2, 45.0)] {
                self.write_number(row, column, value).unwrap();
            }
        }
        self.set_column_hidden(at).unwrap();
    }
}

/// An old plan on a hidden sheet was taken for the survey; the visible one is read.
#[test]
fn a_visible_sheet_is_read_and_no_hidden_one() {
    let read = survey(&file("hidden-sheet-first"));
    let last = read.stations.last().unwrap();
    assert_eq!((last.md_m, last.inclination_rad), (2300.0, 61.9f64.to_radians()));
    let hidden = "the sheet 'Old plan' is hidden and not read".to_owned();
    assert!(read.notes.contains(&hidden), "{:?}", read.notes);
    // If there is no other sheet, the error gives the reason.
    let mut workbook = Workbook::new();
    workbook.add_worksheet().set_name("Front").unwrap().write_string(0, 0, "Well S-1").unwrap();
    let sheet = workbook.add_worksheet().set_name("Survey").unwrap();
    for (column, text) in ["MD (m)", "Inc", "Azi"].iter().enumerate() {
        sheet.write_string(0, column as u16, *text).unwrap();
    }
    sheet.set_hidden(true);
    let bytes = workbook.save_to_buffer().unwrap();
    let error = wholestring_tabular::read(&bytes, "a.xlsx").unwrap_err().to_string();
    assert!(error.ends_with("(the sheet 'Survey' is hidden and not read)"), "{error}");
    let error = read_readings(&bytes, "a.xlsx").unwrap_err().to_string();
    assert!(error.ends_with("(the sheet 'Survey' is hidden and not read)"), "{error}");
}

/// The same in the old format.
#[test]
fn old_workbooks_hide_and_leave_results_out_too() {
    let numbers = |row: u16| {
        let step = f64::from(row - 1);
        [100.0 * step, 2.0 * step, 45.0]
    };
    let mut cells: Vec<(u16, u16, Value)> = ["MD (m)", "Inc (deg)", "Azi (deg)"]
        .into_iter()
        .enumerate()
        .map(|(column, text)| (0, column as u16, Value::Text(text)))
        .collect();
    for row in 1..=4 {
        for (column, number) in numbers(row).into_iter().enumerate() {
            cells.push((row, column as u16, Value::Number(number)));
        }
    }
    let hidden = read(&old_excel::workbook_hidden(&cells, 2, None), "a.xls").unwrap();
    assert_eq!(depths(&hidden), [0.0, 200.0, 300.0]);
    let note = "row 3 of sheet 'Survey' is hidden and not read".to_owned();
    assert!(hidden.notes.contains(&note), "{:?}", hidden.notes);
    let error = read(&old_excel::workbook_hidden(&cells, 9, Some(2)), "a.xls").unwrap_err();
    assert!(error.to_string().contains("no column of azimuth"), "{error}");
    assert!(error.to_string().contains("column C of sheet 'Survey' is hidden"), "{error}");
    // A formula written by programs that do not calculate: an empty text, or a zero to be
    // calculated.
    for value in [Value::EmptyFormula, Value::ZeroFormula] {
        let mut cells = cells.iter().map(copy).collect::<Vec<_>>();
        cells.retain(|cell| (cell.0, cell.1) != (3, 2));
        cells.push((3, 2, value));
        let error = read(&old_excel::workbook(&cells), "a.xls").unwrap_err();
        assert!(error.to_string().contains("cell C4: the cell holds a formula"), "{error}");
    }
}

fn copy<'a>((row, column, value): &(u16, u16, Value<'a>)) -> (u16, u16, Value<'a>) {
    let value = match value {
        Value::Text(text) => Value::Text(text),
        Value::Number(number) => Value::Number(*number),
        _ => panic!("of another kind"),
    };
    (*row, *column, value)
}

/// Errors name the kind of other archives, and of unsupported workbooks.
#[test]
fn other_archives_say_what_they_are() {
    use std::io::{Cursor, Write};
    let archive = |names: &[&str], method: zip::CompressionMethod| {
        let mut to = zip::ZipWriter::new(Cursor::new(Vec::new()));
        let options = zip::write::SimpleFileOptions::default().compression_method(method);
        for name in names {
            to.start_file(*name, options).unwrap();
            to.write_all(b"MD (m),Inc,Azi\n0,0,0\n30,1,0\n").unwrap();
        }
        to.finish().unwrap().into_inner()
    };
    let stored = zip::CompressionMethod::Stored;
    let refusal =
        |names: &[&str], name: &str| read(&archive(names, stored), name).unwrap_err().to_string();
    let binary = refusal(&["[Content_Types].xml", "_rels/.rels", "xl/workbook.bin"], "a.xlsb");
    assert!(binary.contains("a binary workbook, .xlsb: save it as .xlsx"), "{binary}");
    let open = refusal(&["mimetype", "content.xml", "META-INF/manifest.xml"], "a.ods");
    assert!(open.contains("an OpenDocument file, .ods or another: save it as .xlsx"), "{open}");
    // The text in the archive is not read as if the archive were a text.
    let text = refusal(&["survey.csv"], "survey.zip");
    assert!(text.contains("a zip archive of 'survey.csv': unpack it first"), "{text}");
}

/// A workbook whose parts are stored uncompressed is accepted.
#[test]
fn a_workbook_that_is_not_compressed_is_read() {
    use std::io::{Cursor, Read, Write};
    let whole = changed(|_| {});
    let mut from = zip::ZipArchive::new(Cursor::new(whole)).unwrap();
    let mut to = zip::ZipWriter::new(Cursor::new(Vec::new()));
    let options =
        zip::write::SimpleFileOptions::default().compression_method(zip::CompressionMethod::Stored);
    for index in 0..from.len() {
        let mut part = from.by_index(index).unwrap();
        let mut content = Vec::new();
        part.read_to_end(&mut content).unwrap();
        to.start_file(part.name().unwrap().to_string(), options).unwrap();
        to.write_all(&content).unwrap();
    }
    let bytes = to.finish().unwrap().into_inner();
    assert_eq!(depths(&survey(&bytes)), [0.0, 100.0, 200.0, 300.0, 400.0]);
    assert_eq!(Column::Azimuth.to_string(), "azimuth");
}
