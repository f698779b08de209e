//! Files of other programs, as `wholestring import` reads them, except logs.

use std::collections::BTreeMap;

use fastrand::Rng;
use wholestring_case::Template;
use wholestring_import::{Choices, Input, contents, import};

use super::{
    reader::{Make, New, Reader},
    surveys,
    workbooks::{self, Value},
};
use crate::mutation;

/// The readers of this file.
pub(super) const READERS: &[(&str, New)] = &[
    ("import-survey", survey),
    ("import-survey-xlsx", survey_xlsx),
    ("import-tally", tally),
    ("import-xlsx", xlsx),
    ("import-xls", xls),
    ("import-witsml", witsml),
    ("import-edm", edm),
    ("import-utf16", utf16),
];

/// Words of XML files.
pub(super) const XML: &[&str] = &[
    "<",
    ">",
    "/>",
    "</",
    "&lt;",
    "&#0;",
    "&#x10ffff;",
    "&x;",
    "<![CDATA[",
    "]]>",
    "<!--",
    "-->",
    "<!DOCTYPE x [<!ENTITY a \"b\">]>",
    "<?xml version=\"1.0\" encoding=\"UTF-16\"?>",
    "uom=\"ft\"",
    "uom=\"\"",
    "uid=\"a\"",
    "ft",
    "m",
    "klbf",
    "dega",
    "sequence",
    "NaN",
    "1e999",
    "-1",
];

/// Checks the invariants of any file: it is read or refused with a sentence, with or without
/// choices, and a case from it is valid or has reported errors.
pub(super) fn reads(choices: Choices) -> impl FnMut(&[u8]) -> bool {
    move |input| {
        let file = || Input::of_bytes("file", input);
        match contents(file()) {
            Ok(contents) => assert!(!contents.what.is_empty()),
            Err(error) => assert!(!error.to_string().is_empty()),
        }
        // Choices record which of them an import has used: each import has its own copy.
        match import(vec![file()], &choices.clone()) {
            Ok(imported) => {
                let text = imported.text_as("file");
                let files = imported.beside.iter().map(|beside| {
                    (format!("file{}", beside.ending), beside.text.clone().into_bytes())
                });
                let files: BTreeMap<String, Vec<u8>> = files.collect();
                drop(Template::in_memory("file.toml", &text, files).case(&[]));
                true
            }
            Err(error) => {
                assert!(!error.to_string().is_empty());
                false
            }
        }
    }
}

/// Choices of its units.
fn units(units: &[(&str, &str)]) -> Choices {
    units.iter().fold(Choices::default(), |all, (name, unit)| all.unit(*name, *unit))
}

/// Surveys with positions and dogleg severity, which are compared with the path.
fn survey() -> Reader {
    let seeds: [&[u8]; 4] = [
        include_bytes!("../../../import/tests/samples/own/survey-wellpath-report.txt"),
        b"Well: S-1\nMD (ft),Inc (deg),Azi (deg),TVD (ft),NS (ft),EW (ft),DLS (deg/100ft)\n\
          500,0,0,500,0,0,0\n600,3,45,599.95,1.85,1.85,3\n700,6,45,699.63,7.39,7.39,3\n",
        b"MD;Incl;Azim;TVD;DLS\nm;deg;deg;m;deg/30m\n0,0;0,0;0,0;0,0;0,0\n30,0;1,5;45,0;30,0;1,5\n\
          60,0;3,0;45,0;59,97;1,5\n",
        b"Plan\nMD,Inc,Azi\n0,0,0\n1000,1.5,45\n\nActual\nMD,Inc,Azi\n0,0,0\n31,1.5,45\n",
    ];
    let (mut alone, mut with_choices) =
        (reads(Choices::default()), reads(units(&[("md", "ft")]).pick("table", "Actual")));
    Reader::text("import-survey", seeds, surveys::WORDS, move |input| {
        alone(input) | with_choices(input)
    })
}

/// Surveys in a new workbook.
fn survey_xlsx() -> Reader {
    let read = reads(Choices::default());
    workbooks::new("import-survey-xlsx", surveys::STRINGS, surveys::SHEET, read)
}

/// Components of a string.
fn tally() -> Reader {
    let seeds: [&[u8]; 3] = [
        include_bytes!("../../../import/tests/samples/own/tally.csv"),
        b"Component\tOD (in)\tID (in)\tLength (ft)\tWeight (lb/ft)\nBit\t8 1/2\t2\t1\t90\n\
          DC\t6 3/4\t2 13/16\t300\t99\nDP\t5\t4.276\tto surface\t22\n",
        b"No;Component;OD;ID;Length;Cum Length\n;;mm;mm;m;m\n1;Bit;215,9;50;0,3;0,3\n2;HWDP;127;76,2;100;100,3\n\
          3;Drill pipe;127;108,6;2000;2100,3\n",
    ];
    let words = &[
        ",",
        ";",
        "\t",
        "\n",
        "\"",
        "OD",
        "ID",
        "Length",
        "in",
        "ft",
        "mm",
        "8 1/2",
        "8½",
        "1/0",
        "8-Jan",
        "TOTAL",
        "TO SURFACE",
        "Cum. Length",
        "Jts",
        "#",
        "(lb/ft)",
        "5\"",
        "-",
        "1.500,5",
        "DP",
        "Bit",
    ];
    Reader::text("import-tally", seeds, words, reads(Choices::default()))
}

/// Shared strings of a tally's workbook.
const STRINGS: &str = r#"<?xml version="1.0"?><sst xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main" count="9" uniqueCount="9"><si><t>Component</t></si><si><t>OD (in)</t></si><si><t>ID (in)</t></si><si><t>Length (ft)</t></si><si><t>Bit</t></si><si><t>DC</t></si><si><t>DP</t></si><si><t>8 1/2"</t></si><si><r><t xml:space="preserve">to </t></r><r><t>surface</t></r></si></sst>"#;

/// Its sheet: a merged heading, fractions as texts, a formula and a text in place.
const SHEET: &str = r#"<?xml version="1.0"?><worksheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"><dimension ref="A1:D5"/><sheetData><row r="1"><c r="A1" t="inlineStr"><is><t>String of S-1</t></is></c></row><row r="2"><c r="A2" t="s"><v>0</v></c><c r="B2" t="s"><v>1</v></c><c r="C2" t="s"><v>2</v></c><c r="D2" t="s"><v>3</v></c></row><row r="3"><c r="A3" t="s"><v>4</v></c><c r="B3" t="s"><v>7</v></c><c r="C3"><v>2</v></c><c r="D3"><v>1</v></c></row><row r="4"><c r="A4" t="s"><v>5</v></c><c r="B4"><v>6.75</v></c><c r="C4"><v>2.8125</v></c><c r="D4"><f>10*30</f><v>300</v></c></row><row r="5"><c r="A5" t="s"><v>6</v></c><c r="B5"><v>5</v></c><c r="C5"><v>4.276</v></c><c r="D5" t="s"><v>8</v></c></row></sheetData><mergeCells count="1"><mergeCell ref="A1:D1"/></mergeCells></worksheet>"#;

/// Components in a new workbook.
fn xlsx() -> Reader {
    workbooks::new("import-xlsx", STRINGS, SHEET, reads(Choices::default()))
}

/// Components in an old workbook, in each form of its cells.
fn xls() -> Reader {
    let rows =
        [("Bit", 8.5, [2.0, 1.0]), ("DC", 6.75, [2.8125, 300.0]), ("DP", 5.0, [4.28, 9000.0])];
    let mut cells = Vec::new();
    for (column, heading) in (0..).zip(["Component", "OD (in)", "ID (in)", "Length (ft)", "Made"]) {
        cells.push((0, column, Value::Text(heading)));
    }
    for (row, (name, od, [id, length])) in (1..).zip(&rows) {
        cells.push((row, 0, Value::Shared(name)));
        cells.push((row, 1, Value::Short(*od)));
        cells.push((row, 2, Value::Number(*id)));
        cells.push((row, 3, Value::Number(*length)));
        cells.push((row, 4, Value::Date(46_030.0)));
    }
    // In one record.
    cells.retain(|(row, column, _)| *row != 3 || !(2..4).contains(column));
    cells.push((3, 2, Value::Shorts(&rows[2].2)));
    workbooks::old("import-xls", &cells, reads(Choices::default()))
}

/// A mud report with two fluids; none of the samples of series 1 contains one.
const MUD_REPORT: &[u8] =
    b"<?xml version=\"1.0\"?>\n<mudReports xmlns=\"http://www.witsml.org/schemas/1series\" \
      version=\"1.4.1.1\">\n<mudReport uid=\"1\"><nameWell>W</nameWell><name>M</name>\n\
      <fluid uid=\"1\"><type>WBM</type><density uom=\"g/cm3\">1.2</density></fluid>\n\
      <fluid uid=\"2\"><type>OBM</type><density uom=\"lbm/galUS\">10.5</density>\n\
      <pv uom=\"cP\">20</pv><yp uom=\"lbf/100ft2\">15</yp><gel10Min uom=\"Pa\">9</gel10Min>\n\
      </fluid></mudReport></mudReports>";

/// Objects of WITSML.
fn witsml() -> Reader {
    let seeds: [&[u8]; 10] = [
        MUD_REPORT,
        include_bytes!("../../../import/tests/samples/own/witsml-trajectory.xml"),
        include_bytes!("../../../import/tests/samples/own/witsml-tubular.xml"),
        include_bytes!("../../../import/tests/samples/own/witsml-wbgeometry.xml"),
        include_bytes!("../../../import/tests/samples/own/witsml-bharun.xml"),
        include_bytes!("../../../import/tests/samples/own/witsml21-bharun.xml"),
        include_bytes!("../../../import/tests/samples/own/witsml21-fluids.xml"),
        include_bytes!("../../../import/tests/samples/own/witsml21-geometry.xml"),
        include_bytes!("../../../import/tests/samples/own/witsml21-trajectory.xml"),
        include_bytes!("../../../import/tests/samples/own/witsml21-tubular.xml"),
    ];
    Reader::text("import-witsml", seeds, XML, reads(Choices::default()))
}

/// Exports of Landmark EDM.
fn edm() -> Reader {
    let seeds: [&[u8]; 2] = [
        include_bytes!("../../../import/tests/samples/own/edm-mini-td.xml"),
        include_bytes!("../../../import/tests/samples/own/edm-well.xml"),
    ];
    let api = || units(&[("edm", "api")]);
    // Well, wellbore and case of the second one.
    let picked = [("well", "WS-1"), ("wellbore", "WS-1"), ("case", "8 1/2 in drilling")]
        .into_iter()
        .fold(api(), |choices, (what, name)| choices.pick(what, name));
    let (mut alone, mut picked) = (reads(api()), reads(picked));
    Reader::text("import-edm", seeds, XML, move |input| alone(input) || picked(input))
}

/// Files of any format in two bytes per character, with and without a byte order mark.
fn utf16() -> Reader {
    let texts: Vec<Vec<u8>> = [
        &include_bytes!("../../../import/tests/samples/own/witsml-trajectory.xml")[..],
        include_bytes!("../../../import/tests/samples/own/surface-log.las"),
        include_bytes!("../../../import/tests/samples/own/survey-wellpath-report.txt"),
        include_bytes!("../../../import/tests/samples/own/tally.csv"),
    ]
    .map(<[u8]>::to_vec)
    .into();
    let seeds = texts.iter().map(|text| in_utf16(text, true, false)).collect();
    let make = move |rng: &mut Rng| {
        let text = mutation::damaged(&texts, XML, true, rng);
        let wide = in_utf16(&text, rng.bool(), rng.bool());
        if rng.bool() { wide } else { mutation::damaged(&[wide], &[], false, rng) }
    };
    let choices = Choices::default().value("block-weight", "20 tf");
    let (mut log, mut other) = (reads(choices), reads(Choices::default()));
    let read = move |input: &[u8]| log(input) | other(input);
    Reader { make: Make::Own(Box::new(make)), ..Reader::binary("import-utf16", seeds, read) }
}

/// A text in UTF-16, with bytes that are not UTF-8 replaced.
fn in_utf16(text: &[u8], mark: bool, big: bool) -> Vec<u8> {
    let text = String::from_utf8_lossy(text);
    let mark = mark.then_some('\u{feff}');
    let units = mark.into_iter().chain(text.chars()).collect::<String>();
    let bytes = |unit: u16| if big { unit.to_be_bytes() } else { unit.to_le_bytes() };
    units.encode_utf16().flat_map(bytes).collect()
}
