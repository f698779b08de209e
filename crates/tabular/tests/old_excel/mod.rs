//! Writes the least `.xls` that is one: a compound file with a workbook of one sheet.

/// What a cell holds.
pub(crate) enum Value<'a> {
    Number(f64),
    Text(&'a str),
}

/// A workbook whose sheet "Survey" holds these cells at row and column.
pub(crate) fn workbook(cells: &[(u16, u16, Value)]) -> Vec<u8> {
    workbook_of(cells, 1)
}

/// A workbook that names the sheet so many times.
pub(crate) fn workbook_of(cells: &[(u16, u16, Value)], times: usize) -> Vec<u8> {
    let rows = cells.iter().map(|cell| cell.0 + 1).max().unwrap_or(0);
    let columns = cells.iter().map(|cell| cell.1 + 1).max().unwrap_or(0);

    let mut sheet = record(0x0809, &[&[0, 6, 0x10, 0], &[0; 12][..]].concat());
    let dimensions = [
        &0u32.to_le_bytes()[..],
        &u32::from(rows).to_le_bytes(),
        &0u16.to_le_bytes(),
        &columns.to_le_bytes(),
        &[0, 0],
    ];
    sheet.extend(record(0x0200, &dimensions.concat()));
    for (row, column, value) in cells {
        let at = [&row.to_le_bytes()[..], &column.to_le_bytes(), &[0, 0]].concat();
        sheet.extend(match value {
            Value::Number(number) => record(0x0203, &[&at[..], &number.to_le_bytes()].concat()),
            Value::Text(text) => {
                let length = (text.len() as u16).to_le_bytes();
                record(0x0204, &[&at[..], &length, &[0], text.as_bytes()].concat())
            }
        });
    }
    sheet.extend(record(0x000a, &[]));

    let mut stream = record(0x0809, &[&[0, 6, 5, 0], &[0; 12][..]].concat());
    let name = b"Survey";
    let sheet_at = (stream.len() + times * (4 + 8 + name.len()) + 4) as u32;
    let bound = [&sheet_at.to_le_bytes()[..], &[0, 0, name.len() as u8, 0], name];
    for _ in 0..times {
        stream.extend(record(0x0085, &bound.concat()));
    }
    stream.extend(record(0x000a, &[]));
    assert_eq!(stream.len(), sheet_at as usize);
    stream.extend(sheet);
    compound(stream)
}

fn record(kind: u16, data: &[u8]) -> Vec<u8> {
    [&kind.to_le_bytes()[..], &(data.len() as u16).to_le_bytes(), data].concat()
}

/// A compound file with the stream "Workbook": header, table of sectors, directory, stream.
fn compound(mut stream: Vec<u8>) -> Vec<u8> {
    const SECTOR: usize = 512;
    const END: u32 = 0xffff_fffe;
    const FREE: u32 = 0xffff_ffff;
    // Shorter streams would stand elsewhere.
    stream.resize(stream.len().max(4096).next_multiple_of(SECTOR), 0);
    let sectors = stream.len() / SECTOR;
    assert!(sectors + 2 <= SECTOR / 4, "one sector of the table holds 128 entries");

    let mut header = vec![0; SECTOR];
    header[..8].copy_from_slice(b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1");
    let mut put = |at: usize, bytes: &[u8]| header[at..at + bytes.len()].copy_from_slice(bytes);
    put(24, &[0x3e, 0, 3, 0, 0xfe, 0xff, 9, 0, 6, 0]);
    put(44, &1u32.to_le_bytes());
    put(48, &1u32.to_le_bytes());
    put(56, &4096u32.to_le_bytes());
    put(60, &END.to_le_bytes());
    put(68, &END.to_le_bytes());
    put(76, &0u32.to_le_bytes());
    for i in 1..109 {
        put(76 + 4 * i, &FREE.to_le_bytes());
    }

    let mut table = vec![FREE; SECTOR / 4];
    table[0] = 0xffff_fffd;
    table[1] = END;
    for i in 0..sectors {
        table[2 + i] = if i + 1 == sectors { END } else { 3 + i as u32 };
    }
    let table: Vec<u8> = table.into_iter().flat_map(u32::to_le_bytes).collect();

    let mut directory = entry("Root Entry", 5, END, 0);
    directory.extend(entry("Workbook", 2, 2, stream.len() as u32));
    directory.resize(SECTOR, 0);
    [header, table, directory, stream].concat()
}

fn entry(name: &str, kind: u8, start: u32, length: u32) -> Vec<u8> {
    let mut entry = vec![0; 128];
    for (i, unit) in name.encode_utf16().enumerate() {
        entry[2 * i..2 * i + 2].copy_from_slice(&unit.to_le_bytes());
    }
    entry[64] = (2 * name.len() + 2) as u8;
    entry[66] = kind;
    entry[68..80].fill(0xff);
    if kind == 5 {
        entry[76..80].copy_from_slice(&1u32.to_le_bytes());
    }
    entry[116..120].copy_from_slice(&start.to_le_bytes());
    entry[120..124].copy_from_slice(&length.to_le_bytes());
    entry
}
