//! Surveys in Excel workbooks, made here.

mod old_excel;

use old_excel::Value;
use rust_xlsxwriter::{ExcelDateTime, Format, Workbook, Worksheet};
use wholestring_tabular::{ImportedSurvey, Place, Said, TableErrorKind, read, read_as, read_excel};

/// Fills a sheet.
type Fill<'a> = &'a dyn Fn(&mut Worksheet);

/// A workbook of sheets, each filled by a function.
fn workbook(sheets: &[(&str, Fill)]) -> Vec<u8> {
    let mut workbook = Workbook::new();
    for (name, fill) in sheets {
        let sheet = workbook.add_worksheet();
        sheet.set_name(*name).unwrap();
        fill(sheet);
    }
    workbook.save_to_buffer().unwrap()
}

fn write(sheet: &mut Worksheet, top: u32, left: u16, rows: &[&[&str]]) {
    for (row, cells) in rows.iter().enumerate() {
        for (column, &text) in cells.iter().enumerate() {
            let (row, column) = (top + row as u32, left + column as u16);
            match text.parse::<f64>() {
                Ok(number) => sheet.write_number(row, column, number).unwrap(),
                Err(_) if text.is_empty() => continue,
                Err(_) => sheet.write_string(row, column, text).unwrap(),
            };
        }
    }
}

fn survey(bytes: &[u8]) -> ImportedSurvey {
    read(bytes, "a.xlsx").unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn the_sheet_with_the_columns_is_found() {
    let bytes = workbook(&[
        ("Notes", &|sheet| write(sheet, 0, 0, &[&["Well S-1"], &["Rig", "7"]])),
        ("Survey 2", &|sheet| {
            // A title, a gap, a row of units, a column of remarks, feet, an azimuth through north.
            write(sheet, 0, 0, &[&["Survey of S-1"]]);
            write(
                sheet,
                3,
                2,
                &[
                    &["Measured Depth", "Incl", "Azimuth Grid", "TVD", "N/S", "E/W", "Remark"],
                    &["ft", "deg", "deg", "ft", "ft", "ft", ""],
                    &["0", "0", "359.5", "0", "10", "20", "tie-in"],
                    &["100", "1.25", "0.5", "100", "10.1", "20", ""],
                    &["", "", "", "", "", "", ""],
                    &["200", "2.5", "1.5", "199.9", "12", "20", ""],
                ],
            );
        }),
    ]);
    let survey = survey(&bytes);
    let depths: Vec<f64> = survey.stations.iter().map(|station| station.md_m).collect();
    assert_eq!(depths, [0.0, 30.48, 60.96]);
    assert_eq!(survey.stations[1].inclination_rad, 1.25f64.to_radians());
    assert_eq!(survey.stations[0].azimuth_rad, 359.5f64.to_radians());
    let tie_in = survey.tie_in.unwrap();
    assert_eq!((tie_in.north_m, tie_in.east_m, tie_in.tvd_m), (3.048, 6.096, 0.0));
    assert_eq!(survey.notes[0], "header in row 4 of sheet 'Survey 2'");
}

#[test]
fn numbers_as_text_and_formulas_are_numbers() {
    let bytes = workbook(&[("S", &|sheet| {
        write(sheet, 0, 0, &[&["MD (m)", "Inc", "Azi"], &["0", "0", "0"], &["30", "1", ""]]);
        sheet.write_string(2, 0, "1,030.5").unwrap();
        sheet.write_formula(2, 2, rust_xlsxwriter::Formula::new("=40+5").set_result("45")).unwrap();
    })]);
    let survey = survey(&bytes);
    assert_eq!(survey.stations[1].md_m, 1030.5);
    assert_eq!(survey.stations[1].azimuth_rad, 45f64.to_radians());
}

#[test]
fn three_bare_columns_are_read_in_the_unit_that_is_said() {
    let bytes =
        workbook(&[("S", &|sheet| write(sheet, 0, 0, &[&["0", "0", "0"], &["9", "1", "2"]]))]);
    let error = read(&bytes, "a.xlsx").unwrap_err();
    assert_eq!(error.kind(), &TableErrorKind::NoUnits);
    let said = Said {
        length_unit: wholestring_units::Dimension::Length.find_unit("m"),
        ..Said::default()
    };
    let survey = read_as(&bytes, "a.xlsx", &said).unwrap();
    assert_eq!(survey.stations[1].md_m, 9.0);
}

#[test]
fn faults_name_the_sheet_and_the_cell() {
    let date = |sheet: &mut Worksheet| {
        write(sheet, 0, 0, &[&["MD (m)", "Inc", "Azi"], &["0", "0", "0"], &["30", "1", ""]]);
        let date = ExcelDateTime::from_ymd(2020, 1, 2).unwrap();
        let format = Format::new().set_num_format("yyyy-mm-dd");
        sheet.write_datetime_with_format(2, 2, &date, &format).unwrap();
    };
    let backwards = |sheet: &mut Worksheet| {
        write(sheet, 1, 27, &[&["MD (m)", "Inc", "Azi"], &["90", "0", "0"], &["30", "1", "0"]]);
    };
    let missing = |sheet: &mut Worksheet| {
        write(sheet, 0, 0, &[&["MD (m)", "Inc"], &["90", "0"], &["30", "1"]]);
    };
    let cases: [(Fill, &str); 3] = [
        (&date, "a.xlsx, sheet 'S', cell C3: 'a date' is not a number; the azimuth was expected"),
        (
            &backwards,
            "a.xlsx, sheet 'S', cell AB4: the measured depth runs backwards: 30 m after 90 m; \
             it must grow from station to station",
        ),
        (
            &missing,
            "a.xlsx, sheet 'S', cell A1: no column of azimuth; the header has: 'MD (m)', 'Inc'",
        ),
    ];
    for (fill, message) in cases {
        let error = read_excel(&workbook(&[("S", fill)]), "a.xlsx").unwrap_err();
        assert_eq!(error.to_string(), message);
        assert!(matches!(error.place(), Some(Place::Cell { sheet, .. }) if sheet == "S"));
        assert_eq!((error.text(), error.span()), (None, None));
    }
}

#[test]
fn workbooks_without_a_survey_list_their_sheets() {
    let bytes = workbook(&[
        ("Costs", &|sheet| write(sheet, 0, 0, &[&["Item", "Price"], &["Bit", "1"]])),
        ("Empty", &|_| {}),
    ]);
    let error = read(&bytes, "a.xlsx").unwrap_err();
    let sheets = vec!["Costs".to_owned(), "Empty".to_owned()];
    assert_eq!(error.kind(), &TableErrorKind::NoSurveySheet { sheets });
    assert!(error.to_string().ends_with("the sheets are: 'Costs', 'Empty'"), "{error}");
}

#[test]
fn damaged_workbooks_are_refused() {
    let whole = workbook(&[("S", &|sheet| write(sheet, 0, 0, &[&["MD (m)", "Inc", "Azi"]]))]);
    for bytes in [&whole[..whole.len() / 2], &whole[..4], b"PK\x03\x04", b"PK"] {
        let error = read_excel(bytes, "a.xlsx").unwrap_err();
        assert!(matches!(error.kind(), TableErrorKind::NotAWorkbook { .. }), "{error}");
    }
    let compound = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1 and no more";
    let error = read(compound, "a.xls").unwrap_err();
    assert!(matches!(error.kind(), TableErrorKind::NotAWorkbook { .. }), "{error}");
    assert_eq!(read_excel(b"", "a.xlsx").unwrap_err().kind(), &TableErrorKind::Empty);
}

/// A cell in the sheet's far corner makes the range of its cells hundreds of gigabytes; that it is not
/// read is said.
#[test]
fn a_cell_in_the_far_corner_costs_nothing() {
    let bytes = workbook(&[("S", &|sheet| {
        write(sheet, 0, 0, &[&["md_m", "inc", "azi"], &["0", "0", "0"], &["9", "1", "2"]]);
        sheet.write_number(1_048_575, 16_383, 1.0).unwrap();
    })]);
    let survey = survey(&bytes);
    assert_eq!(survey.stations.len(), 2);
    let far = "cells beyond row 200000 or column SF are not read; one is XFD1048576";
    assert!(survey.notes.iter().any(|note| note == far), "{:?}", survey.notes);
    // The last column that is read, and the first that is not.
    for (column, said) in [(499, false), (500, true)] {
        let bytes = workbook(&[("S", &|sheet| {
            write(sheet, 0, 0, &[&["md_m", "inc", "azi"], &["0", "0", "0"], &["9", "1", "2"]]);
            sheet.write_string(0, column, "tool").unwrap();
        })]);
        let notes = self::survey(&bytes).notes;
        assert_eq!(notes.iter().any(|note| note.contains("column SF")), said, "{notes:?}");
    }
}

/// A survey in the old format, in feet with a row of units.
fn old_survey() -> Vec<u8> {
    let texts = ["MD", "Incl", "Azi", "ft", "deg", "deg"];
    let numbers = [0.0, 0.0, 359.5, 100.0, 1.25, 0.5, 200.0, 2.5, 1.5];
    let at = |i: usize| ((i / 3) as u16, (i % 3) as u16);
    let texts = texts.iter().map(|&text| Value::Text(text));
    let numbers = numbers.iter().map(|&number| Value::Number(number));
    let cells: Vec<(u16, u16, Value)> =
        texts.chain(numbers).enumerate().map(|(i, value)| (at(i).0, at(i).1, value)).collect();
    old_excel::workbook(&cells)
}

#[test]
fn old_workbooks_are_read() {
    let survey = read(&old_survey(), "a.xls").unwrap_or_else(|error| panic!("{error}"));
    let depths: Vec<f64> = survey.stations.iter().map(|station| station.md_m).collect();
    assert_eq!(depths, [0.0, 30.48, 60.96]);
    assert_eq!(survey.stations[0].azimuth_rad, 359.5f64.to_radians());
    assert!(survey.notes[0].starts_with("header in row 1 of sheet 'Survey'"), "{:?}", survey.notes);
}

/// A claim of 2^32 rows would be made room for.
#[test]
fn old_workbooks_that_claim_more_than_the_format_has_are_refused() {
    let whole = old_survey();
    let claim = whole.windows(4).position(|bytes| bytes == [0x00, 0x02, 14, 0]).unwrap();
    let number = whole.windows(4).position(|bytes| bytes == [0x03, 0x02, 14, 0]).unwrap();
    let damages: [(usize, &[u8]); 3] = [
        (claim + 8, &[0xf0, 0xff, 0xff, 0xff]),
        (claim + 14, &[0xff, 0xff]),
        (number + 6, &[0xff, 0xff]),
    ];
    for (at, damage) in damages {
        let mut bytes = whole.clone();
        bytes[at..at + damage.len()].copy_from_slice(damage);
        let error = read(&bytes, "a.xls").unwrap_err();
        assert!(matches!(error.kind(), TableErrorKind::NotAWorkbook { .. }), "{error}");
    }
}

/// A claim of extent that the file ends in, and that zeros would make whole: rows beyond any memory.
#[test]
fn an_old_workbook_that_ends_within_a_claim_is_refused() {
    let mut file = old_survey();
    // The stream begins in the third sector; its second end is the sheet's.
    let mut at = 3 * 512;
    let mut ends = 0;
    while ends < 2 {
        let [kind, length] = [at, at + 2].map(|at| u16::from_le_bytes([file[at], file[at + 1]]));
        ends += usize::from(kind == 0x000a);
        at += 4 + usize::from(length);
    }
    file.truncate(at - 4);
    // Rows from none to 2 ^ 31, columns to 255; two bytes are missing.
    file.extend([0, 2, 14, 0, 0, 0, 0, 0, 0xff, 0xff, 0xff, 0x7f, 0, 0, 0xff, 0]);
    let error = read(&file, "a.xls").unwrap_err();
    assert!(matches!(error.kind(), TableErrorKind::NotAWorkbook { .. }), "{error}");
}

/// The refusal of a workbook by how much it holds, or claims to.
#[track_caller]
fn refused(bytes: &[u8], name: &str) -> String {
    let error = read(bytes, name).unwrap_err();
    assert!(matches!(error.kind(), TableErrorKind::TooMuch { .. }), "{error}");
    error.to_string()
}

/// An archive of these parts beside those of a sound workbook, which they replace.
fn with_parts(parts: &[(&str, &[u8])]) -> Vec<u8> {
    use std::io::{Cursor, Read, Write};
    let whole = workbook(&[("S", &|sheet| write(sheet, 0, 0, &[&["MD (m)", "Inc", "Azi"]]))]);
    let mut from = zip::ZipArchive::new(Cursor::new(whole)).unwrap();
    let mut to = zip::ZipWriter::new(Cursor::new(Vec::new()));
    let options = zip::write::SimpleFileOptions::default();
    for index in 0..from.len() {
        let mut part = from.by_index(index).unwrap();
        let name = part.name().unwrap().to_string();
        let mut content = Vec::new();
        part.read_to_end(&mut content).unwrap();
        let other = parts.iter().find(|(other, _)| *other == name);
        to.start_file(name, options).unwrap();
        to.write_all(other.map_or(&content, |(_, other)| other)).unwrap();
    }
    to.finish().unwrap().into_inner()
}

/// Room was made for as many shared strings as a workbook of 2 KB claims: 96 GB.
#[test]
fn shared_strings_that_are_only_claimed_are_refused() {
    for count in ["4000000000", "18446744073709551615", "99999999999999999999"] {
        let strings = format!("<sst uniqueCount=\"{count}\"><si><t>MD (m)</t></si></sst>");
        let bytes = with_parts(&[("xl/sharedStrings.xml", strings.as_bytes())]);
        let message = refused(&bytes, "a.xlsx");
        assert!(message.contains("shared strings by its own count; at most 1"), "{message}");
        // The same in another encoding, which the reader of workbooks understands.
        let wide: Vec<u8> = std::iter::once(0xfeff)
            .chain(strings.encode_utf16())
            .flat_map(u16::to_le_bytes)
            .collect();
        refused(&with_parts(&[("xl/sharedStrings.xml", &wide)]), "a.xlsx");
    }
}

/// Entities that grow a thousand million fold, in each part that holds texts: none is put in.
#[test]
fn entities_of_a_workbook_are_not_put_in() {
    let grow: String = (1..10)
        .map(|n| format!("<!ENTITY a{n} \"{}\">", format!("&a{};", n - 1).repeat(10)))
        .collect();
    let kind = format!("<!DOCTYPE x [<!ENTITY a0 \"0123456789\">{grow}]>");
    let space = "xmlns=\"http://schemas.openxmlformats.org/spreadsheetml/2006/main\"";
    let strings = format!("{kind}<sst {space} uniqueCount=\"1\"><si><t>MD &a9;</t></si></sst>");
    let cell = "<c r=\"A1\" t=\"inlineStr\"><is><t>MD &a9;</t></is></c>";
    let sheet = format!(
        "{kind}<worksheet {space}><sheetData><row r=\"1\">{cell}</row></sheetData></worksheet>"
    );
    for (part, text) in [("xl/sharedStrings.xml", strings), ("xl/worksheets/sheet1.xml", sheet)] {
        let bytes = with_parts(&[(part, text.as_bytes())]);
        let error = read(&bytes, "a.xlsx").unwrap_err().to_string();
        assert!(error.len() < 1000, "{} bytes", error.len());
    }
}

/// 65 KB that unpack to 65 MB, and a directory of parts that continues.
#[test]
fn workbooks_that_unpack_to_too_much_are_refused() {
    let blanks = vec![b' '; 65 << 20];
    let bytes = with_parts(&[("xl/worksheets/sheet1.xml", &blanks)]);
    assert!(bytes.len() < 1 << 17, "{}", bytes.len());
    assert_eq!(
        refused(&bytes, "a.xlsx"),
        "a.xlsx: the file holds more than 64 MB when it is unpacked; at most 64 MB can be read"
    );
    let entries = [b"PK\x03\x04".as_slice(), &b"PK\x01\x02".repeat(10_001)].concat();
    assert_eq!(
        refused(&entries, "a.xlsx"),
        "a.xlsx: the file holds 10001 parts; at most 10000 can be read"
    );
}

#[test]
fn new_workbooks_with_too_many_sheets_are_refused() {
    let nothing: Fill = &|_| {};
    let names: Vec<String> = (0..101).map(|i| format!("S{i}")).collect();
    let sheets: Vec<(&str, Fill)> = names.iter().map(|name| (name.as_str(), nothing)).collect();
    assert_eq!(
        refused(&workbook(&sheets), "a.xlsx"),
        "a.xlsx: the file holds 101 sheets; at most 100 can be read"
    );
}

/// A cell of one letter far to the right fills its row with empty ones.
#[test]
fn rows_that_are_mostly_gaps_are_refused() {
    let bytes = workbook(&[("S", &|sheet| {
        for row in 0..2100 {
            sheet.write_string(row, 499, "x").unwrap();
        }
    })]);
    assert_eq!(
        refused(&bytes, "a.xlsx"),
        "a.xlsx: the file holds more than 1000000 cells; at most 1000000 can be read"
    );
}

/// Each sheet of an old workbook becomes a table as large as its farthest cell says: forty that
/// were the same one took 8 GB.
#[test]
fn old_workbooks_with_far_cells_are_refused() {
    let corner = [(0, 0, Value::Number(1.0)), (65_534, 255, Value::Number(1.0))];
    assert_eq!(
        refused(&old_excel::workbook(&corner), "a.xls"),
        "a.xls: the file holds more than 1000000 cells; at most 1000000 can be read"
    );
    let near = [(0, 0, Value::Number(1.0)), (4_999, 9, Value::Number(1.0))];
    assert!(matches!(
        read(&old_excel::workbook_of(&near, 1), "a.xls").unwrap_err().kind(),
        TableErrorKind::NoSurveySheet { .. }
    ));
    refused(&old_excel::workbook_of(&near, 40), "a.xls");
    assert_eq!(
        refused(&old_excel::workbook_of(&near, 101), "a.xls"),
        "a.xls: the file holds 101 sheets; at most 100 can be read"
    );
}
