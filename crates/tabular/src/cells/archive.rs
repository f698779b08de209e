//! Checks before new workbooks (`.xlsx`) are read: a zip archive of XML parts.
//!
//! The sizes in the directory of an archive may be false, so that every part is unpacked once and
//! counted, at most [`limits::UNPACKED_BYTES`] in all. The reader of workbooks allocates as many
//! shared strings as their part claims, so that a claim which its bytes cannot hold is refused.

use std::collections::HashMap;
use std::io::{Cursor, Read};

use zip::ZipArchive;

use crate::cells::limits::{self, too_much};
use crate::error::TableErrorKind;

/// Beginning of every entry in an archive's directory.
const ENTRY: &[u8] = b"PK\x01\x02";

/// The parts of a workbook from which its cells are read, by their names in lower case.
pub(crate) type Parts = HashMap<String, Vec<u8>>;

/// The shortest shared string, `<si/>`, bytes.
const SHORTEST_STRING: u64 = 5;

/// Refuses a workbook that unpacks to, or claims, more than the limits, and an archive of another
/// kind. A file that is not an archive is passed to the reader for its error. Returns the parts of
/// its sheets.
pub(crate) fn check(bytes: &[u8]) -> Result<Parts, TableErrorKind> {
    let entries = bytes.windows(ENTRY.len()).filter(|four| *four == ENTRY);
    let parts = entries.count();
    if parts > limits::PARTS {
        return Err(too_much(parts, "parts", limits::PARTS));
    }
    let Ok(mut archive) = ZipArchive::new(Cursor::new(bytes)) else {
        return Ok(Parts::new());
    };
    if let Some(reason) = other_kind(&mut archive) {
        return Err(TableErrorKind::NotAWorkbook { reason });
    }
    let mut parts = Parts::new();
    let mut left = limits::UNPACKED_BYTES;
    for index in 0..archive.len() {
        // A part that cannot be unpacked uses no memory; if it is needed, the reader reports it.
        let Ok(part) = archive.by_index(index) else {
            continue;
        };
        let name = part.name().unwrap_or_default().to_ascii_lowercase().replace('\\', "/");
        let mut content = Vec::new();
        let _ = part.take(left + 1).read_to_end(&mut content);
        let length = content.len() as u64;
        left = left.checked_sub(length).ok_or_else(|| {
            let most = format!("{} MB", limits::UNPACKED_BYTES >> 20);
            too_much(format!("more than {most}"), "when it is unpacked", most)
        })?;
        if name.ends_with("sharedstrings.xml") {
            let most = length / SHORTEST_STRING;
            if let Some(claim) = claims(&content).into_iter().find(|claim| *claim > most) {
                let most = format!("{most} in {length} bytes");
                return Err(too_much(claim, "shared strings by its own count", most));
            }
        }
        if name.contains("styles") {
            let tags = content.iter().filter(|byte| **byte == b'<').count();
            if tags > limits::STYLE_TAGS {
                return Err(too_much(tags, "tags of styles", limits::STYLE_TAGS));
            }
        }
        let is_other = ["sharedstrings", "styles", "theme", "docprops"];
        let is_xml = name.ends_with(".xml") || name.ends_with(".rels");
        if is_xml && !is_other.iter().any(|other| name.contains(other)) {
            parts.insert(name, content);
        }
    }
    Ok(parts)
}

/// Kind of an archive that is not a workbook of this kind; `None` if it is, or may be.
fn other_kind(archive: &mut ZipArchive<Cursor<&[u8]>>) -> Option<String> {
    /// Maximum number of names in a sentence.
    const LISTED: usize = 5;
    let names: Vec<String> = (0..archive.len())
        .filter_map(|index| {
            let part = archive.by_index(index).ok()?;
            let name = part.name().ok()?.replace('\\', "/");
            (!name.ends_with('/')).then_some(name)
        })
        .collect();
    let has = |part: &str| names.iter().any(|name| name.eq_ignore_ascii_case(part));
    if has("xl/workbook.bin") {
        return Some("it is a binary workbook, .xlsb: save it as .xlsx".to_owned());
    }
    if has("content.xml") && has("META-INF/manifest.xml") {
        return Some("it is an OpenDocument file, .ods or another: save it as .xlsx".to_owned());
    }
    if has("word/document.xml") || has("ppt/presentation.xml") {
        return Some("it is a text or a presentation: save the table as .xlsx or CSV".to_owned());
    }
    // Relationships lead to the workbook, wherever it is.
    if names.is_empty() || has("_rels/.rels") {
        return None;
    }
    let mut listed: Vec<String> =
        names.iter().take(LISTED).map(|name| format!("'{name}'")).collect();
    if names.len() > LISTED {
        listed.push(format!("{} more", names.len() - LISTED));
    }
    Some(format!("it is a zip archive of {}: unpack it first", listed.join(", ")))
}

/// Every number in an attribute named `uniqueCount`; one too large for 64 bits counts as the
/// largest.
fn claims(content: &[u8]) -> Vec<u64> {
    // Zeros and escapes: the text may be in UTF-16 or ISO 2022, whose letters are found between
    // them.
    let mut plain = Vec::with_capacity(content.len());
    let mut bytes = content.iter().copied();
    while let Some(byte) = bytes.next() {
        match byte {
            0 => {}
            0x1b => {
                bytes.by_ref().take(2).for_each(drop);
            }
            byte => plain.push(byte),
        }
    }
    let name = b"uniqueCount";
    plain
        .windows(name.len())
        .enumerate()
        .filter(|(_, window)| window == name)
        .map(|(at, _)| {
            let mut value = plain[at + name.len()..].iter();
            let digits = value
                .by_ref()
                .skip_while(|byte| byte.is_ascii_whitespace() || b"='\"+".contains(byte))
                .take_while(|byte| byte.is_ascii_digit());
            digits.fold(0_u64, |sum, digit| {
                sum.saturating_mul(10).saturating_add(u64::from(digit - b'0'))
            })
        })
        .collect()
}
