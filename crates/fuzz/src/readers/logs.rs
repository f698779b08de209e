//! Logs of a rig, as `wholestring import` reads them.

use wholestring_import::Choices;

use super::{
    imports::{XML, reads},
    reader::{New, Reader},
    workbooks,
};

/// The readers of this file.
pub(super) const READERS: &[(&str, New)] = &[
    ("import-las", las),
    ("import-log-csv", csv),
    ("import-log-witsml", witsml),
    ("import-log-xlsx", xlsx),
];

/// Words of logs.
const WORDS: &[&str] = &[
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

/// Rows of several lines.
const WRAPPED: &[u8] =
    b"~Version\nVERS. 2.0 :\nWRAP. YES :\n~Well\nNULL. -999.25 :\n~Curve\nTIME.s :\nDBTM.m :\n\
      DMEA.m :\nBPOS.m :\nHKLA.kN :\n~ASCII\n0\n 2990 3000\n 10 600\n5\n 2985 3000\n 15 900\n10\n \
      2980 3000\n 20 -999.25\n15\n 2980 3000\n 20 200\n20\n 2985 3000\n 15 700\n";

/// Sections of definitions and data, one of which is the log.
const LAS_3: &[u8] =
    b"~Version\nVERS. 3.0:\nWRAP. NO:\nDLM. COMMA:\n~Well\nNULL. -999.25:\nWELL. A-1: name\n\
      ~Parameter\nHKLA.kN 3 : no curve {F}\n~Log_Definition\nTIME.s : time {F8.1}\n\
      TOOL. : text {S}\nDBTM.m :{F}\nDMEA.m :{F}\nHKLA.klbf : Hook load {F8.2} | x\n\
      ~Core_Definition\nCORE.m:\n~Core_Data | Core_Definition\n1,2,3,4\n\
      ~Log_Data | Log_Definition\n0,\"A, b\",2990,3000,100\n5,B,2985,3000,200\n\
      10,,2980,3000,-999.25\n15,B,2980,3000,50\n20,B,2985,3000,201\n~Tops_Data\n5,6\n";

/// A log of series 2.
const LOG_2: &str = "\
<Log xmlns=\"http://www.energistics.org/energyml/data/witsmlv2\" schemaVersion=\"VERSION\">
<Citation><Title>L</Title></Citation><ChannelSet><Citation><Title>surface</Title></Citation>
<Index><IndexKIND>date time</IndexKIND><Uom>s</Uom><Mnemonic>Time</Mnemonic></Index>
<Channel><Mnemonic>DBTM</Mnemonic><Uom>m</Uom><DataType>double</DataType></Channel>
<Channel><Mnemonic>DMEA</Mnemonic><Uom>m</Uom></Channel>
<Channel><Mnemonic>HKLA</Mnemonic><Uom>kN</Uom></Channel>
<Data><Data>[[[&quot;2021-03-24T10:00:00Z&quot;],[2990,3000,600]],
[[\"2021-03-24T10:00:05Z\"],[2985,3000,900]],[[\"2021-03-24T10:00:10Z\"],[2980,3000,null]],
[[\"2021-03-24T10:00:15Z\"],[2980,[3000,true],200]],[[\"2021-03-24T10:00:20Z\"],[2985,3000,701]]
]</Data></Data></ChannelSet></Log>";

/// Logs in LAS.
fn las() -> Reader {
    let seeds: [&[u8]; 4] = [
        include_bytes!("../../../import/tests/samples/own/surface-log.las"),
        WRAPPED,
        LAS_3,
        // Decimal commas, and a declared null value.
        b"~V\nVERS. 2.0:\n~W\nNULL. -1:\n~C\nTIME.s:\nDBTM.m:\nDMEA.m:\nBPOS.m:\nHKLA.kN:\n~A\n\
          0 2990 3000 10 600,5\n5 2985 3000 15 900,5\n10 2980 3000 20 905\n15 2980 3000 20 -1\n\
          20 2980 3000 20 200\n25 2985 3000 15 700\n",
    ];
    Reader::text("import-las", seeds, WORDS, reads(block()))
}

/// Logs of recorders, as text.
fn csv() -> Reader {
    let seeds: [&[u8]; 2] = [
        b"Time (s),Bit Depth (m),Hole Depth (m),Block Position (m),Hook Load (kN),Torque (kN.m),RPM\n\
          0,2990,3000,10,600,0,0\n5,2985,3000,15,900,0,0\n10,2980,3000,20,905,0,0\n15,2980,3000,20,200,0,0\n\
          20,2985,3000,15,700,0,0\n25,2990,3000,10,702,0,0\n30,2990,3000,10,201,0,0\n",
        b"DATE;TIME;DBTM;DMEA;BPOS;HKLA\ndd;hh;ft;ft;ft;klbf\n2026-11-21;06:00:00;9990;10000;60;150,5\n\
          2026-11-21;06:00:05;9985;10000;65;200,1\n2026-11-21;06:00:10;9985;10000;65;50,1\n",
    ];
    Reader::text("import-log-csv", seeds, WORDS, reads(block()))
}

/// Logs in WITSML.
fn witsml() -> Reader {
    let one = b"<logs xmlns=\"http://www.witsml.org/schemas/1series\" version=\"1.4.1.1\"><log uid=\"1\">\
          <nameWell>W</nameWell><name>L</name><indexType>date time</indexType>\
          <indexCurve>TIME</indexCurve><nullValue>-999.25</nullValue>\
          <logCurveInfo uid=\"1\"><mnemonic>TIME</mnemonic><unit>s</unit></logCurveInfo>\
          <logCurveInfo uid=\"2\"><mnemonic>DBTM</mnemonic><unit>m</unit></logCurveInfo>\
          <logCurveInfo uid=\"3\"><mnemonic>DMEA</mnemonic><unit>m</unit></logCurveInfo>\
          <logCurveInfo uid=\"4\"><mnemonic>HKLA</mnemonic><unit>kN</unit></logCurveInfo><logData>\
          <mnemonicList>TIME,DBTM,DMEA,HKLA</mnemonicList><unitList>s,m,m,kN</unitList>\
          <data>2026-11-21T06:00:00Z,2990,3000,600</data><data>2026-11-21T06:00:05Z,2985,3000,900</data>\
          <data>2026-11-21T06:00:10Z,2980,3000,905</data><data>2026-11-21T06:00:15Z,2980,3000,-999.25</data>\
          <data>2026-11-21T06:00:20Z,2980,3000,200</data></logData></log></logs>";
    let two = |version: &str, kind: &str| {
        LOG_2.replace("VERSION", version).replace("IndexKIND", kind).into_bytes()
    };
    let [two, two_one] = [two("2.0", "IndexType"), two("2.1", "IndexKind")];
    Reader::text("import-log-witsml", [&one[..], &two, &two_one], XML, reads(block()))
}

/// Choices for picking a log's weights.
fn block() -> Choices {
    Choices::default().value("block-weight", "20 tf")
}

/// Shared strings of a log's workbook.
const STRINGS: &str = r#"<?xml version="1.0"?><sst xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main" count="7" uniqueCount="7"><si><t>Time</t></si><si><t>Bit Depth (m)</t></si><si><t>Hole Depth (m)</t></si><si><t>Block Position (m)</t></si><si><t>Hook Load (kN)</t></si><si><t>Torque (kN.m)</t></si><si><t>RPM</t></si></sst>"#;

/// Its sheet, with Excel dates, a formula and a hidden row.
const SHEET: &str = r#"<?xml version="1.0"?><worksheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"><dimension ref="A1:G9"/><sheetData><row r="1"><c r="A1" t="s"><v>0</v></c><c r="B1" t="s"><v>1</v></c><c r="C1" t="s"><v>2</v></c><c r="D1" t="s"><v>3</v></c><c r="E1" t="s"><v>4</v></c><c r="F1" t="s"><v>5</v></c><c r="G1" t="s"><v>6</v></c></row><row r="2"><c r="A2" s="1"><v>45368.16660000</v></c><c r="B2"><v>2990</v></c><c r="C2"><v>3000</v></c><c r="D2"><v>10</v></c><c r="E2"><v>600</v></c><c r="F2"><v>0</v></c><c r="G2"><v>0</v></c></row><row r="3"><c r="A3" s="1"><v>45368.16665787</v></c><c r="B3"><v>2985</v></c><c r="C3"><v>3000</v></c><c r="D3"><v>15</v></c><c r="E3"><f>400+500</f><v>900</v></c><c r="F3"><v>0</v></c><c r="G3"><v>0</v></c></row><row r="4"><c r="A4" s="1"><v>45368.16671574</v></c><c r="B4"><v>2980</v></c><c r="C4"><v>3000</v></c><c r="D4"><v>20</v></c><c r="E4"><v>905</v></c><c r="F4"><v>0</v></c><c r="G4"><v>0</v></c></row><row r="5"><c r="A5" s="1"><v>45368.16677361</v></c><c r="B5"><v>2980</v></c><c r="C5"><v>3000</v></c><c r="D5"><v>20</v></c><c r="E5"><v>200</v></c><c r="F5"><v>0</v></c><c r="G5"><v>0</v></c></row><row r="6" hidden="1"><c r="A6" t="inlineStr"><is><t>changed bit</t></is></c></row><row r="7"><c r="A7" s="1"><v>45368.16683148</v></c><c r="B7"><v>2985</v></c><c r="C7"><v>3000</v></c><c r="D7"><v>15</v></c><c r="E7"><v>700</v></c><c r="F7"><v>0</v></c><c r="G7"><v>0</v></c></row><row r="8"><c r="A8" s="1"><v>45368.16688935</v></c><c r="B8"><v>2990</v></c><c r="C8"><v>3000</v></c><c r="D8"><v>10</v></c><c r="E8"><v>702</v></c><c r="F8"><v>0</v></c><c r="G8"><v>0</v></c></row><row r="9"><c r="A9" s="1"><v>45368.16694722</v></c><c r="B9"><v>2990</v></c><c r="C9"><v>3000</v></c><c r="D9"><v>10</v></c><c r="E9"><v>201</v></c><c r="F9"><v>0</v></c><c r="G9"><v>0</v></c></row></sheetData></worksheet>"#;

/// A log in a new workbook.
fn xlsx() -> Reader {
    workbooks::new("import-log-xlsx", STRINGS, SHEET, reads(block()))
}
