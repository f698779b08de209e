//! The container of old workbooks (`.xls`): a compound file of sectors, from which the workbook's
//! stream is extracted and written to a new valid file.
//!
//! The reader of workbooks follows chains of sectors without limit and trusts their lengths. It
//! therefore receives a file written by this module.
//!
//! Format: \[MS-CFB\] Compound File Binary File Format.

use std::collections::HashSet;

use crate::cells::limits::{self, too_much};
use crate::error::TableErrorKind;

/// Size below which streams are stored in the mini stream, in sectors of [`MINI_SECTOR`] bytes.
const MINI_STREAM: usize = 4096;
const MINI_SECTOR: usize = 64;

/// First of the ids that are marks instead of sectors.
const LAST_SECTOR: u32 = 0xffff_fffa;

/// Marks: a sector of the table of sectors, the end of a chain, a free sector.
const TABLE: u32 = 0xffff_fffd;
const END: u32 = 0xffff_fffe;
const FREE: u32 = 0xffff_ffff;

/// Signature of a compound file.
pub(crate) const MARK: &[u8; 8] = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1";

/// Returns the stream of the workbook in a compound file.
pub(crate) fn workbook_stream(bytes: &[u8]) -> Result<Vec<u8>, TableErrorKind> {
    let file = File::open(bytes).ok_or_else(|| damaged("it is not a compound file"))?;
    let directory = file.chain(u32_at(bytes, 48), &file.table)?;
    let entries: Vec<&[u8]> = directory.chunks_exact(128).collect();
    let entry = ["Workbook", "Book"]
        .iter()
        .find_map(|name| entries.iter().find(|entry| has_name(entry, name)))
        .ok_or_else(|| {
            let is_locked = entries.iter().any(|entry| has_name(entry, "EncryptedPackage"));
            damaged(match is_locked {
                true => "it is locked with a password: save it without",
                false => "it holds no workbook",
            })
        })?;
    let length = u32_at(entry, 120).unwrap_or(0) as usize;
    if length > limits::STREAM_BYTES {
        let [found, most] =
            [length, limits::STREAM_BYTES].map(|bytes| format!("{} MB", bytes >> 20));
        return Err(too_much(found, "of records", most));
    }
    let start = u32_at(entry, 116);
    let mut stream = if length < MINI_STREAM {
        let mini = file.chain(u32_at(entries[0], 116), &file.table)?;
        let table = file.chain(u32_at(bytes, 60), &file.table)?;
        let table: Vec<u32> = numbers(&table).collect();
        let sector = |id: u32| {
            let start = (id as usize).checked_mul(MINI_SECTOR)?;
            mini.get(start..mini.len().min(start.checked_add(MINI_SECTOR)?))
        };
        chain(start, &table, sector)?
    } else {
        file.chain(start, &file.table)?
    };
    stream.truncate(length);
    if stream.is_empty() {
        return Err(damaged("its workbook is empty"));
    }
    Ok(stream)
}

fn damaged(reason: &str) -> TableErrorKind {
    TableErrorKind::NotAWorkbook { reason: reason.to_owned() }
}

/// A compound file and its sector table with the successor of each sector.
struct File<'a> {
    bytes: &'a [u8],
    sector: usize,
    table: Vec<u32>,
}

impl<'a> File<'a> {
    fn open(bytes: &'a [u8]) -> Option<Self> {
        if !bytes.starts_with(MARK) {
            return None;
        }
        let mut file = Self {
            bytes,
            sector: match u16_at(bytes, 30)? {
                9 => 512,
                12 => 4096,
                _ => return None,
            },
            table: Vec::new(),
        };
        // The header lists the first 109 sectors of the table; a chain of sectors lists the rest.
        let mut named: Vec<u32> = (0..109).filter_map(|i| u32_at(bytes, 76 + 4 * i)).collect();
        let mut more = u32_at(bytes, 68)?;
        for _ in 0..bytes.len() / file.sector {
            if more >= LAST_SECTOR {
                break;
            }
            let mut ids: Vec<u32> = numbers(file.sector(more)?).collect();
            more = ids.pop()?;
            named.extend(ids);
        }
        // A sector that is listed twice would make the table larger than the file.
        let mut seen = HashSet::new();
        for id in named.into_iter().filter(|id| *id < LAST_SECTOR) {
            if !seen.insert(id) {
                return None;
            }
            if let Some(sector) = file.sector(id) {
                file.table.extend(numbers(sector));
            }
        }
        Some(file)
    }

    fn sector(&self, id: u32) -> Option<&'a [u8]> {
        let start = (id as usize).checked_add(1)?.checked_mul(self.sector)?;
        let end = self.bytes.len().min(start.checked_add(self.sector)?);
        self.bytes.get(start..end)
    }

    fn chain(&self, start: Option<u32>, table: &[u32]) -> Result<Vec<u8>, TableErrorKind> {
        chain(start, table, |id| self.sector(id))
    }
}

/// The bytes of a chain of sectors, which ends at the end of the file at the latest.
fn chain<'a>(
    start: Option<u32>,
    table: &[u32],
    sector: impl Fn(u32) -> Option<&'a [u8]>,
) -> Result<Vec<u8>, TableErrorKind> {
    let mut bytes = Vec::new();
    let mut id = start.unwrap_or(END);
    let mut met = 0;
    while id < LAST_SECTOR {
        met += 1;
        if met > table.len() {
            return Err(damaged("it is damaged or cut off"));
        }
        let Some(sector) = sector(id) else { break };
        bytes.extend_from_slice(sector);
        let Some(&next) = table.get(id as usize) else {
            break;
        };
        id = next;
    }
    Ok(bytes)
}

/// Returns a compound file with only this workbook stream.
pub(crate) fn file_of(stream: &[u8]) -> Vec<u8> {
    const SECTOR: usize = 4096;
    const PER_SECTOR: usize = SECTOR / 4;
    let length = stream.len().max(MINI_STREAM);
    let sectors = length.div_ceil(SECTOR);
    // One more for the directory, and those of the table itself: 109 suffice for 450 MB.
    let tables = (sectors + 1).div_ceil(PER_SECTOR - 1);
    let [directory_at, stream_at] = [tables as u32, tables as u32 + 1];

    let mut file = vec![0; SECTOR];
    let mut put = |at: usize, bytes: &[u8]| file[at..at + bytes.len()].copy_from_slice(bytes);
    put(0, MARK);
    // Versions, order of the bytes, sectors of 2^12 bytes and of 2^6.
    put(24, &[0x3e, 0, 3, 0, 0xfe, 0xff, 12, 0, 6, 0]);
    put(44, &(tables as u32).to_le_bytes());
    put(48, &directory_at.to_le_bytes());
    put(56, &(MINI_STREAM as u32).to_le_bytes());
    put(60, &END.to_le_bytes());
    put(68, &END.to_le_bytes());
    for i in 0..109 {
        let id = if i < tables { i as u32 } else { FREE };
        put(76 + 4 * i, &id.to_le_bytes());
    }
    let mut table = vec![TABLE; tables];
    table.push(END);
    table.extend((1..sectors as u32).map(|next| stream_at + next));
    table.push(END);
    table.resize(tables * PER_SECTOR, FREE);
    file.extend(table.into_iter().flat_map(u32::to_le_bytes));

    let mut directory = entry("Root Entry", 5, END, 0);
    directory.extend(entry("Workbook", 2, stream_at, length as u64));
    directory.resize(SECTOR, 0);
    file.extend(directory);
    file.extend_from_slice(stream);
    file.resize((1 + tables + 1 + sectors) * SECTOR, 0);
    file
}

fn entry(name: &str, kind: u8, start: u32, length: u64) -> Vec<u8> {
    let mut entry = vec![0; 128];
    for (i, unit) in name.encode_utf16().enumerate() {
        entry[2 * i..2 * i + 2].copy_from_slice(&unit.to_le_bytes());
    }
    entry[64] = (2 * name.len() + 2) as u8;
    entry[66] = kind;
    entry[68..80].fill(0xff);
    entry[116..120].copy_from_slice(&start.to_le_bytes());
    entry[120..128].copy_from_slice(&length.to_le_bytes());
    entry
}

/// Whether a directory entry has this name; names are UTF-16 with a zero at the end.
fn has_name(entry: &[u8], name: &str) -> bool {
    let units: Vec<u16> = (0..32).filter_map(|i| u16_at(entry, 2 * i)).collect();
    let end = units.iter().position(|&unit| unit == 0).unwrap_or(units.len());
    String::from_utf16_lossy(&units[..end]).eq_ignore_ascii_case(name)
}

fn numbers(bytes: &[u8]) -> impl Iterator<Item = u32> {
    bytes.chunks_exact(4).map(|four| u32::from_le_bytes([four[0], four[1], four[2], four[3]]))
}

pub(crate) fn u16_at(bytes: &[u8], at: usize) -> Option<u16> {
    let two = bytes.get(at..at.checked_add(2)?)?;
    Some(u16::from_le_bytes([two[0], two[1]]))
}

pub(crate) fn u32_at(bytes: &[u8], at: usize) -> Option<u32> {
    let four = bytes.get(at..at.checked_add(4)?)?;
    Some(u32::from_le_bytes([four[0], four[1], four[2], four[3]]))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The stream is read back unchanged for any number of sectors of the table.
    #[test]
    fn a_stream_is_found_again() {
        for length in [4096, 5000, 4096 * 1022, 4096 * 1023 + 1, 5 << 20] {
            let stream: Vec<u8> = (0..length).map(|i| (i % 251) as u8).collect();
            assert!(workbook_stream(&file_of(&stream)) == Ok(stream), "{length}");
        }
    }

    /// A circular chain was followed until memory was exhausted.
    #[test]
    fn a_circle_of_sectors_is_refused() {
        let mut file = file_of(&[7; 20_000]);
        // The third sector of the stream is followed by the first.
        let table = 4096;
        file[table + 4 * 4..][..4].copy_from_slice(&2_u32.to_le_bytes());
        assert_eq!(workbook_stream(&file), Err(damaged("it is damaged or cut off")));
        // The directory as well.
        let mut file = file_of(&[7; 20_000]);
        file[table + 4..][..4].copy_from_slice(&1_u32.to_le_bytes());
        assert_eq!(workbook_stream(&file), Err(damaged("it is damaged or cut off")));
    }
}
