//! No bytes make the import panic, and what it accepts is sound.

mod old_excel;

use std::f64::consts::{PI, TAU};
use std::io::{Cursor, Write};
use std::sync::LazyLock;

use old_excel::Value;
use proptest::collection::vec;
use proptest::prelude::*;
use wholestring_survey::{ImportedSurvey, SurveyError, read, read_csv, read_excel};

/// What must hold for any bytes.
fn valid(result: Result<ImportedSurvey, SurveyError>) -> Result<(), TestCaseError> {
    match result {
        Ok(survey) => {
            prop_assert!(survey.stations.len() >= 2);
            for pair in survey.stations.windows(2) {
                prop_assert!(pair[0].md_m < pair[1].md_m);
            }
            for station in &survey.stations {
                prop_assert!(station.md_m >= 0.0 && station.md_m.is_finite());
                prop_assert!((0.0..=PI).contains(&station.inclination_rad));
                prop_assert!((-TAU..=2.0 * TAU).contains(&station.azimuth_rad));
            }
        }
        Err(error) => {
            prop_assert!(!error.to_string().is_empty());
            if let Some(span) = error.span() {
                prop_assert!(error.text().is_some_and(|text| text.get(span).is_some()));
            }
        }
    }
    Ok(())
}

/// Pieces of surveys in any order.
fn nearly_a_survey() -> impl Strategy<Value = Vec<u8>> {
    let piece = prop::sample::select(vec![
        "MD (m)",
        "md",
        "inc",
        "azi",
        "Inc (deg)",
        "Azi",
        "TVD [ft]",
        "N/S",
        "ft",
        "deg",
        ",",
        ",",
        ",",
        ";",
        "\t",
        "  ",
        " ",
        "\n",
        "\n",
        "\r\n",
        "\r",
        "\"",
        "\"\"",
        "(",
        ")",
        "0",
        "30",
        "60",
        "1,500.0",
        "1,5",
        "-1",
        "1e308",
        "NaN",
        "!",
        "#",
        "--",
        "°",
        "½",
        "\u{c}",
        "\u{a0}",
        "Measured",
        "Depth",
        "m",
    ]);
    vec(piece, 0..60).prop_map(|pieces| pieces.concat().into_bytes())
}

/// A survey that is read, with some of its bytes changed, moved or cut off.
fn damaged(whole: &'static [u8]) -> impl Strategy<Value = Vec<u8>> {
    let changes = vec((any::<prop::sample::Index>(), any::<u8>()), 1..8);
    (changes, any::<prop::sample::Index>(), 0..4u8).prop_map(|(changes, at, kind)| {
        let mut bytes = whole.to_vec();
        for (index, byte) in changes {
            let index = index.index(bytes.len());
            bytes[index] = byte;
        }
        match kind {
            0 => bytes.truncate(at.index(whole.len())),
            1 => {
                let middle = at.index(whole.len());
                bytes.rotate_left(middle);
            }
            _ => {}
        }
        bytes
    })
}

const TEXT: &[u8] =
    b"Survey of S-1\nMD (m),Inc,Azi,TVD (m)\n,deg,deg,\n0,0,0,0\n30,1.5,45,30\n60,3,45,59.9\n";

const REPORT: &[u8] = b"  Measured     Incl    Azimuth\n  Depth (ft)  (deg)    (deg)\n    0.0   0.0   0.0\n ! 1,500.0   1.0   2.0\n 1,600.0  1.5  2\n";

/// The parts of the least workbook that is one.
const PARTS: [(&str, &str); 5] = [
    (
        "[Content_Types].xml",
        r#"<?xml version="1.0"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="xml" ContentType="application/xml"/><Override PartName="/xl/workbook.xml" ContentType="application/vnd.openxmlformats-officedocument.spreadsheetml.sheet.main+xml"/></Types>"#,
    ),
    (
        "_rels/.rels",
        r#"<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="rId1" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/officeDocument" Target="xl/workbook.xml"/></Relationships>"#,
    ),
    (
        "xl/_rels/workbook.xml.rels",
        r#"<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="rId1" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/worksheet" Target="worksheets/sheet1.xml"/></Relationships>"#,
    ),
    (
        "xl/workbook.xml",
        r#"<?xml version="1.0"?><workbook xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main" xmlns:r="http://schemas.openxmlformats.org/officeDocument/2006/relationships"><sheets><sheet name="S" sheetId="1" r:id="rId1"/></sheets></workbook>"#,
    ),
    (
        "xl/worksheets/sheet1.xml",
        r#"<?xml version="1.0"?><worksheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"><dimension ref="A1:C4"/><sheetData><row r="1"><c r="A1" t="inlineStr"><is><t>MD (m)</t></is></c><c r="B1" t="inlineStr"><is><t>Inc</t></is></c><c r="C1" t="inlineStr"><is><t>Azi</t></is></c></row><row r="2"><c r="A2"><v>0</v></c><c r="B2"><v>0</v></c><c r="C2"><v>0</v></c></row><row r="3"><c r="A3"><v>30</v></c><c r="B3" t="str"><v>1,5</v></c><c r="C3"><v>45</v></c></row><row r="4"><c r="A4"><v>60</v></c><c r="B4"><v>3</v></c><c r="C4"><v>4.5E1</v></c></row></sheetData></worksheet>"#,
    ),
];

/// A workbook of these parts, one of them replaced.
fn workbook(replaced: usize, by: &[u8]) -> Vec<u8> {
    let mut zip = zip::ZipWriter::new(Cursor::new(Vec::new()));
    let options =
        zip::write::SimpleFileOptions::default().compression_method(zip::CompressionMethod::Stored);
    for (index, (name, part)) in PARTS.iter().enumerate() {
        zip.start_file(*name, options).unwrap();
        zip.write_all(if index == replaced { by } else { part.as_bytes() }).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

static WORKBOOK: LazyLock<Vec<u8>> = LazyLock::new(|| workbook(0, PARTS[0].1.as_bytes()));

static OLD_WORKBOOK: LazyLock<Vec<u8>> = LazyLock::new(|| {
    let mut cells = Vec::new();
    for (column, heading) in (0..).zip(["MD (m)", "Inc", "Azi"]) {
        cells.push((0, column, Value::Text(heading)));
        cells.extend((1..4).map(|row| (row, column, Value::Number(f64::from(row)))));
    }
    old_excel::workbook(&cells)
});

/// A workbook of which one part is damaged, its archive whole.
fn damaged_part() -> impl Strategy<Value = Vec<u8>> {
    (2..PARTS.len()).prop_flat_map(|part| {
        damaged(PARTS[part].1.as_bytes()).prop_map(move |bytes| workbook(part, &bytes))
    })
}

/// An old workbook damaged where its records are: the rest of the file is padding.
fn damaged_records() -> impl Strategy<Value = Vec<u8>> {
    let whole: &'static [u8] = &OLD_WORKBOOK;
    let records = 3 * 512..3 * 512 + 400;
    damaged(&whole[records.clone()]).prop_map(move |bytes| {
        let mut all = whole.to_vec();
        all[records.start..records.start + bytes.len()].copy_from_slice(&bytes);
        all
    })
}

#[test]
fn what_is_damaged_below_is_whole() {
    for (bytes, name) in
        [(TEXT, "a.csv"), (REPORT, "a.txt"), (&WORKBOOK, "a.xlsx"), (&OLD_WORKBOOK, "a.xls")]
    {
        assert!(read(bytes, name).is_ok_and(|survey| survey.stations.len() == 3), "{name}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn any_bytes(bytes in vec(any::<u8>(), 0..400), head in prop::sample::select(vec![
        &b""[..], b"PK\x03\x04", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", b"\xff\xfe", b"\xef\xbb\xbf",
    ])) {
        let bytes = [head, &bytes].concat();
        valid(read_csv(&bytes, "a.csv"))?;
        valid(read_excel(&bytes, "a.xlsx"))?;
        for name in ["a.csv", "a.xlsx", "a", ""] {
            valid(read(&bytes, name))?;
        }
    }

    #[test]
    fn any_text(text in ".{0,200}") {
        valid(read_csv(text.as_bytes(), "a.csv"))?;
    }

    #[test]
    fn pieces_of_surveys(bytes in nearly_a_survey()) {
        valid(read(&bytes, "a.csv"))?;
    }

    #[test]
    fn damaged_text(bytes in prop_oneof![damaged(TEXT), damaged(REPORT)]) {
        valid(read(&bytes, "a.csv"))?;
    }

    #[test]
    fn damaged_workbooks(bytes in prop_oneof![
        damaged(&WORKBOOK), damaged_part(), damaged(&OLD_WORKBOOK), damaged_records(),
    ]) {
        valid(read_excel(&bytes, "a.xlsx"))?;
    }
}
