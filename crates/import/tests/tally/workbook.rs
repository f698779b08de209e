//! Workbooks, current ones and those of Excel 97.

use insta::assert_snapshot;
use rust_xlsxwriter::{Format, Worksheet};
use wholestring_import::{Choices, Input, import};

use crate::old_excel::{self, Value as Old};
use crate::{components, header, of_bytes, saved, string};

/// A sheet with headings that span several columns and three rows.
fn merged() -> Worksheet {
    let mut sheet = Worksheet::new();
    sheet.set_name("BHA 7").unwrap();
    let centre = Format::new();
    sheet.merge_range(0, 0, 0, 8, "Bottom-hole assembly 7", &centre).unwrap();
    sheet.merge_range(2, 2, 2, 3, "Body", &centre).unwrap();
    sheet.merge_range(2, 4, 2, 5, "Tool joint", &centre).unwrap();
    header(&mut sheet, 2, &["", "", "", "", "", "", "", "Cum."]);
    header(
        &mut sheet,
        3,
        &["#", "Description", "OD", "ID", "OD", "ID", "Length", "length", "Weight"],
    );
    header(&mut sheet, 4, &["", "", "(in)", "(in)", "(in)", "(in)", "(m)", "(m)", "(kg/m)"]);
    let rows: [(&str, [f64; 7]); 3] = [
        ("8 1/2\" bit", [8.5, 2.25, 0.0, 0.0, 0.3, 0.3, 0.0]),
        ("Collar", [6.5, 2.25, 0.0, 0.0, 9.1, 9.4, 148.0]),
        ("Pipe", [5.1, 4.2, 6.625, 3.25, 95.0, 104.4, 31.0]),
    ];
    for (at, (name, numbers)) in rows.iter().enumerate() {
        let row = 5 + at as u32;
        sheet.write(row, 0, at as u32 + 1).unwrap();
        sheet.write(row, 1, *name).unwrap();
        for (column, number) in numbers.iter().enumerate().filter(|(_, number)| **number != 0.0) {
            // Some numbers are stored as text.
            match column {
                2 => sheet.write(row, 2 + column as u16, number.to_string()).unwrap(),
                _ => sheet.write(row, 2 + column as u16, *number).unwrap(),
            };
        }
    }
    sheet.merge_range(9, 0, 9, 8, "Lengths without pins.", &centre).unwrap();
    sheet
}

#[test]
fn merged_headings_and_numbers_as_text_in_a_workbook() {
    let imported = of_bytes("BHA.xlsx", &saved(vec![merged()]), &Choices::default());
    components(&imported);
    assert_snapshot!("merged", imported.text);
}

#[test]
fn a_workbook_gives_survey_and_tally_of_its_sheets() {
    let mut survey = Worksheet::new();
    survey.set_name("Survey").unwrap();
    header(&mut survey, 0, &["MD (m)", "Inc (deg)", "Azi (deg)"]);
    for (row, station) in
        [[0.0, 0.0, 0.0], [1000.0, 0.0, 0.0], [2000.0, 30.0, 90.0]].iter().enumerate()
    {
        for (column, number) in station.iter().enumerate() {
            survey.write(row as u32 + 1, column as u16, *number).unwrap();
        }
    }
    let bytes = saved(vec![merged(), survey]);
    let both = of_bytes("well.xlsx", &bytes, &Choices::default());
    assert_snapshot!(both.files[0].1, @"a survey of 3 stations, and a tally of 3 components in sheet 'BHA 7'");
    assert_eq!(both.missing.len(), 2);
    // One table alone, picked by name.
    let one = of_bytes("well.xlsx", &bytes, &Choices::default().pick("table", "survey"));
    assert!(!one.text.contains("\n[[string]]"));
    // Two tallies.
    let mut other = merged();
    other.set_name("BHA 8").unwrap();
    let bytes = saved(vec![merged(), other]);
    let error = import(vec![Input::of_bytes("two.xlsx", &bytes)], &Choices::default());
    assert_snapshot!(error.unwrap_err(), @"two.xlsx: it holds 2 of the kind 'tally': 'BHA 7', 'BHA 8'; pick one: --pick tally=NAME");
    let eight = of_bytes("two.xlsx", &bytes, &Choices::default().pick("tally", "BHA 8"));
    assert!(eight.text.contains("sheet 'BHA 8', cell C6"));
}

/// A workbook as Excel writes the old format: shared texts, short numbers, merged headings.
fn old_tally(od: Old<'static>) -> Vec<u8> {
    let mut cells = vec![
        (0, 0, Old::Shared("Bottom-hole assembly 7")),
        (2, 1, Old::Shared("Body")),
        (2, 3, Old::Shared("Tool joint")),
    ];
    let headings = ["Component", "OD (in)", "ID (in)", "OD (in)", "ID (in)", "Length (m)"];
    cells.extend((0..).zip(headings).map(|(column, text)| (3, column, Old::Shared(text))));
    cells.extend([(4, 0, Old::Shared("Bit")), (4, 1, od), (4, 2, Old::Short(2.25))]);
    cells.extend([(4, 5, Old::Short(0.3)), (5, 0, Old::Shared("Collar"))]);
    cells.extend([(5, 1, Old::Shorts(&[6.5, 2.25])), (5, 5, Old::Number(9.144))]);
    cells.extend([(6, 0, Old::Shared("Pipe")), (6, 1, Old::Shorts(&[5.0, 4.28, 6.63, 3.25]))]);
    cells.push((6, 5, Old::Number(95.0)));
    old_excel::workbook_merged(&cells, &[[0, 0, 0, 5], [2, 2, 1, 2], [2, 2, 3, 4]])
}

#[test]
fn an_old_workbook_as_excel_writes_it() {
    let imported = of_bytes("a.xls", &old_tally(Old::Short(8.5)), &Choices::default());
    assert_snapshot!(string(&imported));
}

/// The cell contains the day, and only its format shows that it is a date.
#[test]
fn dates_of_an_old_workbook_are_refused_with_their_cell() {
    let bytes = old_tally(Old::Date(46_030.0));
    let error = import(vec![Input::of_bytes("a.xls", &bytes)], &Choices::default());
    let error = error.unwrap_err().to_string();
    assert!(
        error.starts_with("a.xls, sheet 'Survey', cell B5: the outside diameter is a date"),
        "{error}"
    );
}

#[test]
fn an_old_workbook_is_read() {
    let texts = ["Component", "OD (in)", "ID (in)", "Length (ft)"];
    let mut cells: Vec<(u16, u16, Old)> = texts
        .iter()
        .enumerate()
        .map(|(column, text)| (0, column as u16, Old::Text(text)))
        .collect();
    cells.extend([(1, 0, Old::Text("Bit")), (1, 1, Old::Text("8 1/2")), (1, 2, Old::Number(2.0))]);
    cells.extend([(1, 3, Old::Number(1.0)), (2, 0, Old::Text("DC")), (2, 1, Old::Number(6.5))]);
    cells.extend([(2, 2, Old::Number(2.25)), (2, 3, Old::Number(30.0))]);
    let imported = of_bytes("a.xls", &old_excel::workbook(&cells), &Choices::default());
    assert_snapshot!(string(&imported), @r#"
    [[string]]
    component = "Bit"
    od = "8.5 in"
    id = "2 in"
    length = "1 ft"

    [[string]]
    component = "DC"
    od = "6.5 in"
    id = "2.25 in"
    length = "30 ft"

    # Missing: the pipe above the topmost component: write it as the last [[string]], "to surface"
    # [[string]]
    # component = "drill pipe"
    # catalogue = "5 in 19.50 lb/ft S-135"
    # length = "to surface"
    "#);
    assert!(imported.text.contains("sheet 'Survey', cell B2: '8 1/2'"), "{}", imported.text);
}
