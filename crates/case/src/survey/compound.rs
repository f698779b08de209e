//! The guard before old workbooks (`.xls`).
//!
//! The reader of workbooks makes room for as many cells as the file claims. A damaged claim can ask
//! for more memory than there is, which ends the program and not only the reading. So the claims
//! are checked first against the limits of the format: 65 536 rows, 256 columns.
//!
//! Formats: \[MS-CFB\] Compound File Binary File Format, \[MS-XLS\] Excel Binary File Format.

/// Streams below this size stand in the mini stream, in sectors of [`MINI_SECTOR`] bytes.
const MINI_STREAM: usize = 4096;
const MINI_SECTOR: usize = 64;

/// Ids from here on are marks and no sectors.
const LAST_SECTOR: u32 = 0xffff_fffa;

/// Rows and columns of a sheet.
const ROWS: u32 = 65_536;
const COLUMNS: u16 = 256;

/// Whether every cell of the workbook, and every claim of how many there are, is within the limits
/// of the format. A file without a workbook's stream is not.
pub(super) fn is_plausible(bytes: &[u8]) -> bool {
    let Some(stream) = workbook_stream(bytes) else {
        return false;
    };
    let mut sheets = Vec::new();
    for (kind, data) in Records(&stream) {
        match kind {
            0x0085 => sheets.extend(u32_at(data, 0)),
            0x000a => break,
            _ => {}
        }
    }
    sheets.iter().all(|&start| {
        let start = (start as usize).min(stream.len());
        Records(&stream[start..]).all(|(kind, data)| is_within_limits(kind, data))
    })
}

fn is_within_limits(kind: u16, data: &[u8]) -> bool {
    let column = |at| u16_at(data, at).is_none_or(|column| column < COLUMNS);
    match kind {
        // Number, Label, RString, BoolErr, RK, LabelSst, Formula: row, column.
        0x0203 | 0x0204 | 0x00d6 | 0x0205 | 0x027e | 0x00fd | 0x0006 => column(2),
        // MulRk: row, first column, values, last column.
        0x00bd => column(2) && data.len().checked_sub(2).is_none_or(column),
        // Dimensions: first row, row after the last, first column, column after the last.
        0x0200 => {
            let (first, after, columns) = if data.len() < 14 {
                let wide = |at| u16_at(data, at).map(u32::from);
                (wide(0), wide(2), u16_at(data, 6))
            } else {
                (u32_at(data, 0), u32_at(data, 4), u16_at(data, 10))
            };
            after.is_none_or(|after| after <= ROWS && (after == 0 || first < Some(after)))
                && columns.is_none_or(|columns| columns <= COLUMNS)
        }
        _ => true,
    }
}

/// The records of a stream: their kind and data.
struct Records<'a>(&'a [u8]);

impl<'a> Iterator for Records<'a> {
    type Item = (u16, &'a [u8]);

    fn next(&mut self) -> Option<Self::Item> {
        let kind = u16_at(self.0, 0)?;
        let length = usize::from(u16_at(self.0, 2)?);
        let data = self.0.get(4..4 + length)?;
        self.0 = &self.0[4 + length..];
        Some((kind, data))
    }
}

/// The stream in a compound file that holds the workbook.
fn workbook_stream(bytes: &[u8]) -> Option<Vec<u8>> {
    let size = match u16_at(bytes, 30)? {
        9 => 512,
        12 => 4096,
        _ => return None,
    };
    let sector = |id: u32| {
        let start = (id as usize).checked_add(1)?.checked_mul(size)?;
        let end = bytes.len().min(start.checked_add(size)?);
        bytes.get(start..end)
    };

    // The header names the first 109 sectors of the table of sectors; a chain names the rest.
    let mut table_sectors: Vec<u32> = (0..109).filter_map(|i| u32_at(bytes, 76 + 4 * i)).collect();
    let mut more = u32_at(bytes, 68)?;
    for _ in 0..bytes.len() / size {
        if more >= LAST_SECTOR {
            break;
        }
        let ids = sector(more)?;
        let mut ids: Vec<u32> = (0..ids.len() / 4)
            .filter_map(|i| u32_at(ids, 4 * i))
            .collect();
        more = ids.pop()?;
        table_sectors.extend(ids);
    }
    let table: Vec<u32> = table_sectors
        .into_iter()
        .filter(|&id| id < LAST_SECTOR)
        .filter_map(sector)
        .flat_map(numbers)
        .collect();

    let directory = chain(u32_at(bytes, 48)?, &table, sector);
    let entries: Vec<&[u8]> = directory.chunks_exact(128).collect();
    let entry = ["Workbook", "Book"]
        .iter()
        .find_map(|name| entries.iter().find(|entry| has_name(entry, name)))?;
    let (start, length) = (u32_at(entry, 116)?, u32_at(entry, 120)? as usize);
    let mut stream = if length < MINI_STREAM {
        let mini = chain(u32_at(entries.first()?, 116)?, &table, sector);
        let table: Vec<u32> = numbers(&chain(u32_at(bytes, 60)?, &table, sector)).collect();
        let mini_sector = |id: u32| {
            let start = (id as usize).checked_mul(MINI_SECTOR)?;
            mini.get(start..mini.len().min(start.checked_add(MINI_SECTOR)?))
        };
        chain(start, &table, mini_sector)
    } else {
        chain(start, &table, sector)
    };
    stream.truncate(length);
    (!stream.is_empty()).then_some(stream)
}

/// The bytes of a chain of sectors. One that runs in a circle ends after as many as there are.
fn chain<'a>(start: u32, table: &[u32], sector: impl Fn(u32) -> Option<&'a [u8]>) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut id = start;
    for _ in 0..table.len() {
        let Some(sector) = (id < LAST_SECTOR).then(|| sector(id)).flatten() else {
            break;
        };
        bytes.extend_from_slice(sector);
        let Some(&next) = table.get(id as usize) else {
            break;
        };
        id = next;
    }
    bytes
}

/// Whether a directory entry has this name; names are UTF-16 with a zero at the end.
fn has_name(entry: &[u8], name: &str) -> bool {
    let units: Vec<u16> = (0..32).filter_map(|i| u16_at(entry, 2 * i)).collect();
    let end = units
        .iter()
        .position(|&unit| unit == 0)
        .unwrap_or(units.len());
    String::from_utf16_lossy(&units[..end]).eq_ignore_ascii_case(name)
}

fn numbers(bytes: &[u8]) -> impl Iterator<Item = u32> {
    bytes
        .chunks_exact(4)
        .map(|four| u32::from_le_bytes([four[0], four[1], four[2], four[3]]))
}

fn u16_at(bytes: &[u8], at: usize) -> Option<u16> {
    let two = bytes.get(at..at.checked_add(2)?)?;
    Some(u16::from_le_bytes([two[0], two[1]]))
}

fn u32_at(bytes: &[u8], at: usize) -> Option<u32> {
    let four = bytes.get(at..at.checked_add(4)?)?;
    Some(u32::from_le_bytes([four[0], four[1], four[2], four[3]]))
}
