//! The guard before new workbooks (`.xlsx`): a zip archive of parts in XML.
//!
//! What the directory of an archive says of sizes may be a lie, so that every part is unpacked once
//! and counted, at most [`limits::UNPACKED_BYTES`] in all. The reader of workbooks makes room for
//! as many shared strings as their part claims: a claim that its bytes cannot hold is refused.

use std::collections::HashMap;
use std::io::{Cursor, Read};

use zip::ZipArchive;

use crate::cells::limits::{self, too_much};
use crate::error::TableErrorKind;

/// What every entry of an archive's directory begins with.
const ENTRY: &[u8] = b"PK\x01\x02";

/// The parts of a workbook that its cells are read from: by their names in small letters.
pub(crate) type Parts = HashMap<String, Vec<u8>>;

/// The shortest shared string, `<si/>`, bytes.
const SHORTEST_STRING: u64 = 5;

/// Refuses a workbook that unpacks, or claims, to more than is read, and an archive of something else.
/// One that is no archive at all is left to the reader, which says why. Parts of its sheets are
/// returned.
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
    let mut kept = Parts::new();
    let mut left = limits::UNPACKED_BYTES;
    for index in 0..archive.len() {
        // What cannot be unpacked takes no room; where it is needed the reader says so.
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
            kept.insert(name, content);
        }
    }
    Ok(kept)
}

/// What an archive is that is no workbook of this kind; none of one that is, or may be.
fn other_kind(archive: &mut ZipArchive<Cursor<&[u8]>>) -> Option<String> {
    /// Names that a sentence lists.
    const LISTED: usize = 5;
    let names: Vec<String> = (0..archive.len())
        .filter_map(|index| {
            let part = archive.by_index(index).ok()?;
            let name = part.name().ok()?.replace('\\', "/");
            (!name.ends_with('/')).then_some(name)
        })
        .collect();
    let has = |wanted: &str| names.iter().any(|name| name.eq_ignore_ascii_case(wanted));
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

/// Every number that an attribute named `uniqueCount` gives; one that is too large for 64 bits
/// counts as the largest.
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
