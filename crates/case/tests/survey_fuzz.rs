//! No bytes make the import panic, and what it accepts is sound.

use std::f64::consts::{PI, TAU};
use std::sync::LazyLock;

use proptest::collection::vec;
use proptest::prelude::*;
use wholestring_case::survey::{ImportedSurvey, SurveyError, read, read_csv, read_excel};

/// What must hold for any bytes.
fn sound(result: Result<ImportedSurvey, SurveyError>) -> Result<(), TestCaseError> {
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

static WORKBOOK: LazyLock<Vec<u8>> = LazyLock::new(|| {
    let mut workbook = rust_xlsxwriter::Workbook::new();
    let sheet = workbook.add_worksheet();
    for (column, heading) in ["MD (m)", "Inc", "Azi"].into_iter().enumerate() {
        sheet.write_string(0, column as u16, heading).unwrap();
        for row in 1..4 {
            sheet
                .write_number(row, column as u16, f64::from(row))
                .unwrap();
        }
    }
    workbook.save_to_buffer().unwrap()
});

#[test]
fn what_is_damaged_below_is_whole() {
    for (bytes, name) in [(TEXT, "a.csv"), (REPORT, "a.txt"), (&WORKBOOK, "a.xlsx")] {
        assert!(
            read(bytes, name).is_ok_and(|survey| survey.stations.len() == 3),
            "{name}"
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn any_bytes(bytes in vec(any::<u8>(), 0..400), head in prop::sample::select(vec![
        &b""[..], b"PK\x03\x04", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", b"\xff\xfe", b"\xef\xbb\xbf",
    ])) {
        let bytes = [head, &bytes].concat();
        sound(read_csv(&bytes, "a.csv"))?;
        sound(read_excel(&bytes, "a.xlsx"))?;
        for name in ["a.csv", "a.xlsx", "a", ""] {
            sound(read(&bytes, name))?;
        }
    }

    #[test]
    fn any_text(text in ".{0,200}") {
        sound(read_csv(text.as_bytes(), "a.csv"))?;
    }

    #[test]
    fn pieces_of_surveys(bytes in nearly_a_survey()) {
        sound(read(&bytes, "a.csv"))?;
    }

    #[test]
    fn damaged_text(bytes in prop_oneof![damaged(TEXT), damaged(REPORT)]) {
        sound(read(&bytes, "a.csv"))?;
    }

    #[test]
    fn damaged_workbooks(bytes in damaged(&WORKBOOK)) {
        sound(read_excel(&bytes, "a.xlsx"))?;
    }
}
