//! Surveys in every format.

use std::f64::consts::{PI, TAU};

use wholestring_tabular::{ImportedSurvey, Said, TableError, read_as};
use wholestring_units::Dimension;

use super::{
    reader::{New, Reader},
    workbooks::{self, Value},
};

/// The readers of this file.
pub(super) const READERS: &[(&str, New)] = &[
    ("survey-csv", csv),
    ("survey-tsv", tsv),
    ("survey-fixed", fixed),
    ("survey-xlsx", xlsx),
    ("survey-xls", xls),
];

/// Words of surveys.
pub(super) const WORDS: &[&str] = &[
    ",", ";", "\t", "  ", "\n", "\r\n", "\"", "\"\"", "(", ")", "MD", "MD (m)", "md_m", "Inc",
    "Azi", "TVD [ft]", "N/S", "E/W", "ft", "ftKB", "deg", "rad", "°", "½", "1,500.0", "1.500,5",
    "!", "#", "--", "\u{c}", "\u{a0}", "Measured", "Depth", "RKB",
];

/// Checks the invariants of any survey that is read, and of any error.
fn valid(read: Result<ImportedSurvey, TableError>) -> bool {
    match read {
        Ok(survey) => {
            assert!(survey.stations.len() >= 2);
            assert!(survey.stations.windows(2).all(|pair| pair[0].md_m < pair[1].md_m));
            for station in &survey.stations {
                assert!(station.md_m >= 0.0 && station.md_m.is_finite());
                assert!((0.0..=PI).contains(&station.inclination_rad));
                assert!((-TAU..=TAU).contains(&station.azimuth_rad));
            }
            assert!(survey.start().tvd_m.is_finite());
            true
        }
        Err(error) => {
            assert!(!error.to_string().is_empty());
            if let Some(span) = error.span() {
                assert!(error.text().is_some_and(|text| text.get(span).is_some()));
            }
            false
        }
    }
}

/// Reads under a name, with or without a unit given by the user.
fn reads(name: &'static str) -> impl FnMut(&[u8]) -> bool {
    let in_feet = Said { length_unit: Dimension::Length.find_unit("ft"), ..Said::default() };
    move |input| {
        let plain = valid(read_as(input, name, &Said::default()));
        plain | valid(read_as(input, name, &in_feet))
    }
}

/// Cells separated by commas and semicolons.
fn csv() -> Reader {
    let seeds: [&[u8]; 5] = [
        b"Survey of S-1\nMD (m),Inc,Azi,TVD (m)\n,deg,deg,\n0,0,0,0\n30,1.5,45,30\n60,3,45,59.9\n",
        b"MD (ftKB),Inc (deg),Azi (deg),N/S (ft),E/W \
         (ft)\n500,0,0,0,0\n530,1,359.5,0,0\n560,2,0.5,1,1\n",
        "MD (m);Inc (°);Azi (°)\n0,0;0,0;0\n30,5;1,25;90,125\n1.060,5;1,25;90\n".as_bytes(),
        b"0,0,0\n30,1.5,45\n60,3,45\n",
        wholestring_cases::NP13_X1042.beside[0].1.as_bytes(),
    ];
    Reader::text("survey-csv", seeds, WORDS, reads("a.csv"))
}

/// Cells separated by tabs.
fn tsv() -> Reader {
    let seeds: [&[u8]; 3] = [
        b"Well S-1\r\n# made by \
         hand\r\n\r\n\"MD\n(m)\"\tInc[deg]\tAzi[deg]\r\n0\t0\t0\r\n\r\n\"1,030.5\"\t0.5\t45\r\nEnd\t\t\r\n",
        b"MD\tINCL\tAzimuth\nft\tdeg\tdeg\n0\t0\t0\n1000\t0\t359.5\n1100\t3\t0.5\n",
        b"\xff\xfem\0d\0_\0m\0\t\0i\0n\0c\0\t\0a\0z\0i\0\n\x000\0\t\x000\0\t\x000\0\n\x009\0\t\x001\0\t\x002\0\n\0",
    ];
    Reader::text("survey-tsv", seeds, WORDS, reads("a.tsv"))
}

/// Reports in columns of blanks.
fn fixed() -> Reader {
    let seeds: [&[u8]; 3] = [
        b"  Measured     Incl    Azimuth\n  Depth (ft)  (deg)    (deg)\n    0.0   0.0   0.0\n ! \
         1,500.0   1.0   2.0\n 1,600.0  1.5  2\n",
        "Well:      S-1\n\n   Measured                          Vertical\n    Depth    \
         Inclination  Azimuth     Depth\n     (ft)        (°)        (°)        (ft)\n       \
         0.0      0.00        0.00        0.0\n   1,500.0      0.00        0.00    1,500.0\n ! \
         1,700.0      6.00        0.50    1,699.6\n"
            .as_bytes(),
        b"0 0 0\n30 1.5 45\n60 3 45\n",
    ];
    Reader::text("survey-fixed", seeds, WORDS, reads("a.txt"))
}

/// Shared strings of a survey's workbook.
pub(super) const STRINGS: &str = r#"<?xml version="1.0"?><sst xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main" count="3" uniqueCount="3"><si><t>MD (m)</t></si><si><t>Inc</t></si><si><t>Azi</t></si></sst>"#;

/// Its sheet, with texts of every kind and a formula.
pub(super) const SHEET: &str = r#"<?xml version="1.0"?><worksheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"><dimension ref="A1:C4"/><sheetData><row r="1"><c r="A1" t="s"><v>0</v></c><c r="B1" t="s"><v>1</v></c><c r="C1" t="s"><v>2</v></c></row><row r="2"><c r="A2"><v>0</v></c><c r="B2"><v>0</v></c><c r="C2"><v>0</v></c></row><row r="3"><c r="A3"><v>30</v></c><c r="B3" t="str"><v>1.5</v></c><c r="C3"><f>40+5</f><v>45</v></c></row><row r="4"><c r="A4"><v>60</v></c><c r="B4" t="inlineStr"><is><t>3</t></is></c><c r="C4"><v>4.5E1</v></c></row></sheetData></worksheet>"#;

/// New workbooks.
fn xlsx() -> Reader {
    workbooks::new("survey-xlsx", STRINGS, SHEET, reads("a.xlsx"))
}

/// Old workbooks.
fn xls() -> Reader {
    let mut cells = Vec::new();
    for (column, heading) in (0..).zip(["MD (m)", "Inc", "Azi"]) {
        cells.push((0, column, Value::Text(heading)));
        cells.extend((1..4).map(|row| (row, column, Value::Number(f64::from(row)))));
    }
    workbooks::old("survey-xls", &cells, reads("a.xls"))
}

#[cfg(test)]
mod tests {
    use std::iter::repeat_with;

    use fastrand::Rng;
    use wholestring_tabular::{read, read_csv, read_excel};

    use super::*;
    use crate::worker;

    /// Inputs that begin like known files and continue with random bytes.
    #[test]
    fn any_bytes_are_a_survey_or_are_refused() {
        let heads: [&[u8]; 5] =
            [b"", b"PK\x03\x04", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", b"\xff\xfe", b"\xef\xbb\xbf"];
        for number in 0..2000 {
            let mut rng = Rng::with_seed(number);
            let mut bytes = heads[rng.usize(..heads.len())].to_vec();
            let length = rng.usize(..400);
            bytes.extend(repeat_with(|| rng.u8(..)).take(length));
            let text: String = repeat_with(|| rng.char(..)).take(200).collect();
            let pieces = [WORDS, &["0", "30", "60", "-1", "1e308", "NaN"]].concat();
            let pieces: String =
                repeat_with(|| pieces[rng.usize(..pieces.len())]).take(60).collect();
            valid(read_csv(&bytes, "a.csv"));
            valid(read_excel(&bytes, "a.xlsx"));
            for name in ["a.csv", "a.xlsx", "a", ""] {
                valid(read(&bytes, name));
            }
            valid(read_csv(text.as_bytes(), "a.csv"));
            valid(read(pieces.as_bytes(), "a.csv"));
        }
    }

    #[test]
    fn damaged_surveys_are_read_or_refused() {
        const INPUTS: u64 = 250;
        for new in [csv, tsv, fixed, xlsx, xls] {
            let mut reader = new();
            let accepted = (0..INPUTS).filter(|number| {
                let input = worker::input(&reader, 1, *number);
                reader.read(&input)
            });
            let accepted = accepted.count() as u64;
            // A seed that is always refused tests nothing beyond its first error.
            assert!(accepted > INPUTS / 50, "{accepted} of {INPUTS} by {}", reader.name);
        }
    }
}
