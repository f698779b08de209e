//! Files of other programs, as `wholestring import` reads them.

use std::collections::BTreeMap;

use wholestring_case::Template;
use wholestring_import::{Choices, Input, contents, import};

use super::{
    reader::{New, Reader},
    workbooks::{self, Value},
};

/// The readers of this file.
pub(super) const READERS: &[(&str, New)] = &[
    ("import-tally", tally),
    ("import-xlsx", xlsx),
    ("import-xls", xls),
    ("import-witsml", witsml),
    ("import-edm", edm),
    ("import-las", las),
    ("import-log-csv", log_csv),
    ("import-log-witsml", log_witsml),
];

/// What stands in files of XML.
const XML: &[&str] = &[
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

/// What stands in logs.
const LOG: &[&str] = &[
    "~V",
    "~W",
    "~C",
    "~A",
    "~P",
    "\n",
    "\r\n",
    ":",
    ".",
    ".ft",
    ".klbs",
    "WRAP. YES :",
    "NULL. -9 :",
    "DLM. COMMA :",
    "#",
    "-999.25",
    "1,5",
    "1.2.3",
    "2026-11-21T06:00:00Z",
    "\t",
    "\u{feff}",
    "TIME",
    "DBTM",
    "HKLA",
    "TQA",
    "RPMA",
    "BPOS",
];

/// What holds of any file: it is read or refused with a sentence, with or without choices, and a case
/// that it gives is sound or has its mistakes told.
fn reads(choices: Choices) -> impl FnMut(&[u8]) -> bool {
    move |input| {
        let file = || Input::of_bytes("file", input);
        match contents(file()) {
            Ok(contents) => assert!(!contents.what.is_empty()),
            Err(error) => assert!(!error.to_string().is_empty()),
        }
        match import(vec![file()], &choices) {
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

/// What its units are.
fn units(said: &[(&str, &str)]) -> Choices {
    said.iter().fold(Choices::default(), |all, (name, unit)| all.unit(*name, *unit))
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

/// Components in an old workbook.
fn xls() -> Reader {
    let rows = [("Bit", 8.5, 2.0, 1.0), ("DC", 6.75, 2.8125, 300.0), ("DP", 5.0, 4.276, 9000.0)];
    let mut cells = Vec::new();
    for (column, heading) in (0..).zip(["Component", "OD (in)", "ID (in)", "Length (ft)"]) {
        cells.push((0, column, Value::Text(heading)));
    }
    for (row, (name, od, id, length)) in (1..).zip(rows) {
        cells.push((row, 0, Value::Text(name)));
        let numbers = (1..).zip([od, id, length]);
        cells.extend(numbers.map(|(column, number)| (row, column, Value::Number(number))));
    }
    workbooks::old("import-xls", &cells, reads(Choices::default()))
}

/// Objects of WITSML.
fn witsml() -> Reader {
    let seeds: [&[u8]; 9] = [
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
    // Of the second one's wells, wellbores and cases.
    let picked = [("well", "WS-1"), ("wellbore", "WS-1"), ("case", "8 1/2 in drilling")]
        .into_iter()
        .fold(api(), |choices, (what, name)| choices.pick(what, name));
    let (mut alone, mut picked) = (reads(api()), reads(picked));
    Reader::text("import-edm", seeds, XML, move |input| alone(input) || picked(input))
}

/// Logs in LAS.
fn las() -> Reader {
    let seeds: [&[u8]; 1] = [include_bytes!("../../../import/tests/samples/own/surface-log.las")];
    Reader::text("import-las", seeds, LOG, reads(block()))
}

/// Logs of recorders, as text.
fn log_csv() -> Reader {
    let seeds: [&[u8]; 2] = [
        b"Time (s),Bit Depth (m),Hole Depth (m),Block Position (m),Hook Load (kN),Torque (kN.m),RPM\n\
          0,2990,3000,10,600,0,0\n5,2985,3000,15,900,0,0\n10,2980,3000,20,905,0,0\n15,2980,3000,20,200,0,0\n\
          20,2985,3000,15,700,0,0\n25,2990,3000,10,702,0,0\n30,2990,3000,10,201,0,0\n",
        b"DATE;TIME;DBTM;DMEA;BPOS;HKLA\ndd;hh;ft;ft;ft;klbf\n2026-11-21;06:00:00;9990;10000;60;150,5\n\
          2026-11-21;06:00:05;9985;10000;65;200,1\n2026-11-21;06:00:10;9985;10000;65;50,1\n",
    ];
    Reader::text("import-log-csv", seeds, LOG, reads(block()))
}

/// Logs in WITSML.
fn log_witsml() -> Reader {
    let seeds: [&[u8]; 1] = [
        b"<logs xmlns=\"http://www.witsml.org/schemas/1series\" version=\"1.4.1.1\"><log uid=\"1\">\
          <nameWell>W</nameWell><name>L</name><indexType>date time</indexType>\
          <indexCurve>TIME</indexCurve><nullValue>-999.25</nullValue>\
          <logCurveInfo uid=\"1\"><mnemonic>TIME</mnemonic><unit>s</unit></logCurveInfo>\
          <logCurveInfo uid=\"2\"><mnemonic>DBTM</mnemonic><unit>m</unit></logCurveInfo>\
          <logCurveInfo uid=\"3\"><mnemonic>DMEA</mnemonic><unit>m</unit></logCurveInfo>\
          <logCurveInfo uid=\"4\"><mnemonic>HKLA</mnemonic><unit>kN</unit></logCurveInfo><logData>\
          <mnemonicList>TIME,DBTM,DMEA,HKLA</mnemonicList><unitList>s,m,m,kN</unitList>\
          <data>2026-11-21T06:00:00Z,2990,3000,600</data><data>2026-11-21T06:00:05Z,2985,3000,900</data>\
          <data>2026-11-21T06:00:10Z,2980,3000,905</data><data>2026-11-21T06:00:15Z,2980,3000,-999.25</data>\
          <data>2026-11-21T06:00:20Z,2980,3000,200</data></logData></log></logs>",
    ];
    Reader::text("import-log-witsml", seeds, XML, reads(block()))
}

/// What a log's weights are picked with.
fn block() -> Choices {
    Choices::default().value("block-weight", "20 tf")
}
