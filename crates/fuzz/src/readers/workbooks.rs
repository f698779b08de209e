//! Workbooks of either kind, damaged in the parts that a reader examines.

#[path = "../../../tabular/tests/old_excel/mod.rs"]
mod old_excel;

use std::io::{Cursor, Write};

use fastrand::Rng;
pub(super) use old_excel::Value;
use zip::{CompressionMethod, ZipWriter, write::SimpleFileOptions};

use super::reader::{Make, Reader};
use crate::mutation;

/// Parts of any workbook, with styles.
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
        "xl/styles.xml",
        r#"<?xml version="1.0"?><styleSheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"><numFmts count="1"><numFmt numFmtId="164" formatCode="yyyy-mm-dd"/></numFmts><cellXfs count="2"><xf numFmtId="0"/><xf numFmtId="164"/></cellXfs></styleSheet>"#,
    ),
];

const TAGS: &[&str] = &[
    "<c r=\"XFD1048576\"><v>1</v></c>",
    "<si><t>x</t></si>",
    "<sheet name=\"T\" sheetId=\"2\" r:id=\"rId1\"/>",
    "uniqueCount",
    "count",
    "t=\"s\"",
    "r=\"A99999999\"",
    "<row r=\"4294967295\">",
    "<",
    ">",
    "/>",
    "&#0;",
    "&amp;",
    "rId1",
    "<v>",
    "</v>",
    "<f t=\"shared\" si=\"99999999\" ref=\"A1:B2\">1</f>",
    "<mergeCell ref=\"A1:XFD1048576\"/>",
    "<xf/>",
    "A1:XFD1048576",
    "<row r=\"2\" hidden=\"1\">",
    "hidden=\"1\"",
    "ht=\"0\"",
    "<col min=\"1\" max=\"4294967295\" hidden=\"1\"/>",
    "<f>1</f>",
    "<f t=\"array\" ref=\"A1:XFD1048576\">1</f><v>0</v>",
    "<calcPr fullCalcOnLoad=\"1\"/>",
    "state=\"veryHidden\"",
];

/// The minimal header of an old workbook: the header itself, the sector table and the directory.
const OLD_HEADER: usize = 3 * 512;

fn archive(parts: &[(&str, Vec<u8>)], method: CompressionMethod) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(method);
    for (name, part) in parts {
        zip.start_file(*name, options).expect("a name of a part");
        zip.write_all(part).expect("memory is never full");
    }
    zip.finish().expect("memory is never full").into_inner()
}

/// A reader of new workbooks with one sheet, of these shared strings and this XML: their parts are
/// damaged and packed again, or the archive is damaged.
pub(super) fn new(
    name: &'static str,
    strings: &'static str,
    sheet: &'static str,
    read: impl FnMut(&[u8]) -> bool + 'static,
) -> Reader {
    let all = PARTS
        .into_iter()
        .chain([("xl/sharedStrings.xml", strings), ("xl/worksheets/sheet1.xml", sheet)])
        .map(|(name, part)| (name, part.as_bytes().to_vec()));
    let all: Vec<_> = all.collect();
    let seeds =
        vec![archive(&all, CompressionMethod::Deflated), archive(&all, CompressionMethod::Stored)];
    let archives = seeds.clone();
    let make = move |rng: &mut Rng| {
        if rng.u8(..4) == 0 {
            return mutation::damaged(&archives, &[], false, rng);
        }
        let mut parts = all.clone();
        for _ in 0..=rng.u8(..2) {
            let at = rng.usize(2..parts.len());
            parts[at].1 = mutation::damaged(&[parts[at].1.clone()], TAGS, true, rng);
        }
        archive(&parts, CompressionMethod::Stored)
    };
    Reader { make: Make::Own(Box::new(make)), ..Reader::binary(name, seeds, read) }
}

/// A reader of old workbooks with one sheet of these cells, damaged in their records or anywhere.
pub(super) fn old(
    name: &'static str,
    cells: &[(u16, u16, Value)],
    read: impl FnMut(&[u8]) -> bool + 'static,
) -> Reader {
    // A workbook that names a sheet three times is refused as ambiguous.
    let wholes = vec![old_excel::workbook(cells), old_excel::workbook_of(cells, 3)];
    let seeds = wholes[..1].to_vec();
    let make = move |rng: &mut Rng| {
        let Some(whole) = rng.choice(&wholes) else {
            return Vec::new();
        };
        match rng.u8(..4) {
            0 => mutation::damaged(&wholes, &[], false, rng),
            1 => {
                let mut bytes = whole.clone();
                for _ in 0..=rng.u8(..4) {
                    let at = rng.usize(..OLD_HEADER);
                    bytes[at] = rng.u8(..);
                }
                bytes
            }
            _ => {
                let mut bytes = whole.clone();
                let records = OLD_HEADER..bytes.len().min(OLD_HEADER + 500);
                let damaged =
                    mutation::damaged(&[bytes[records.clone()].to_vec()], &[], false, rng);
                // The stream keeps its length.
                for (to, from) in bytes[records.start..].iter_mut().zip(damaged) {
                    *to = from;
                }
                bytes
            }
        }
    };
    Reader { make: Make::Own(Box::new(make)), ..Reader::binary(name, seeds, read) }
}
