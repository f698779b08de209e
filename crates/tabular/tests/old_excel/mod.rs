//! Writes a minimal `.xls`: a compound file with a workbook of one sheet.

#![allow(dead_code, reason = "not every test that includes this needs all of it")]

/// Value of a cell.
pub(crate) enum Value<'a> {
    Number(f64),
    Text(&'a str),
    /// A text that is stored once in the workbook for all cells that refer to it, as Excel writes
    /// texts.
    Shared(&'a str),
    /// A number of hundredths in four bytes, as Excel writes numbers that fit.
    Short(f64),
    /// Several of them in a row, from this cell on.
    Shorts(&'a [f64]),
    /// A day by its number, which the cell's format shows as a date.
    Date(f64),
    /// A formula whose result is an empty text.
    EmptyFormula,
    /// A formula whose result is 0, to be calculated when the workbook is opened.
    ZeroFormula,
}

/// A workbook whose sheet "Survey" has these cells at row and column.
pub(crate) fn workbook(cells: &[(u16, u16, Value)]) -> Vec<u8> {
    whole(cells, 1, &[])
}

/// A workbook that lists the sheet this many times.
pub(crate) fn workbook_of(cells: &[(u16, u16, Value)], times: usize) -> Vec<u8> {
    whole(cells, times, &[])
}

/// A workbook with merged cells: first and last row, first and last column of each.
pub(crate) fn workbook_merged(cells: &[(u16, u16, Value)], merged: &[[u16; 4]]) -> Vec<u8> {
    whole(cells, 1, merged)
}

/// A workbook with a hidden row and a hidden column.
pub(crate) fn workbook_hidden(
    cells: &[(u16, u16, Value)],
    row: u16,
    column: Option<u16>,
) -> Vec<u8> {
    let mut hidden = record(
        0x0208,
        &[&row.to_le_bytes()[..], &[0, 0, 3, 0, 0xff, 0, 0, 0, 0, 0], &[0x20, 1, 15, 0]].concat(),
    );
    if let Some(column) = column {
        let at = column.to_le_bytes();
        hidden.extend(record(0x007d, &[&at[..], &at, &[0, 8, 15, 0, 1, 0, 0, 0]].concat()));
    }
    of_records(cells, 1, &[], &hidden)
}

fn whole(cells: &[(u16, u16, Value)], times: usize, merged: &[[u16; 4]]) -> Vec<u8> {
    of_records(cells, times, merged, &[])
}

fn of_records(
    cells: &[(u16, u16, Value)],
    times: usize,
    merged: &[[u16; 4]],
    hidden: &[u8],
) -> Vec<u8> {
    let mut shared: Vec<&str> = Vec::new();
    let mut sheet = record(0x0809, &[&[0, 6, 0x10, 0], &[0; 12][..]].concat());
    let rows = cells.iter().map(|cell| cell.0 + 1).max().unwrap_or(0);
    let columns = cells.iter().map(|cell| cell.1 + 1).max().unwrap_or(0);
    let dimensions = [
        &0u32.to_le_bytes()[..],
        &u32::from(rows).to_le_bytes(),
        &0u16.to_le_bytes(),
        &columns.to_le_bytes(),
        &[0, 0],
    ];
    sheet.extend(record(0x0200, &dimensions.concat()));
    sheet.extend(hidden);
    for (row, column, value) in cells {
        let place = [row.to_le_bytes(), column.to_le_bytes()].concat();
        let format = u16::from(matches!(value, Value::Date(_)));
        let at = [&place[..], &format.to_le_bytes()].concat();
        sheet.extend(match value {
            Value::Number(number) | Value::Date(number) => {
                record(0x0203, &[&at[..], &number.to_le_bytes()].concat())
            }
            Value::Text(text) => {
                let length = (text.len() as u16).to_le_bytes();
                record(0x0204, &[&at[..], &length, &[0], text.as_bytes()].concat())
            }
            Value::Shared(text) => {
                let known = shared.iter().position(|shared| shared == text);
                let index = known.unwrap_or(shared.len()) as u32;
                if known.is_none() {
                    shared.push(text);
                }
                record(0x00fd, &[&at[..], &index.to_le_bytes()].concat())
            }
            Value::EmptyFormula => {
                let result = [3, 0, 0, 0, 0, 0, 0xff, 0xff];
                record(0x0006, &[&at[..], &result, &[0; 6], &[0, 0]].concat())
            }
            Value::ZeroFormula => {
                record(0x0006, &[&at[..], &[0; 8], &[3, 0, 0, 0, 0, 0], &[0, 0]].concat())
            }
            Value::Short(number) => record(0x027e, &[&at[..], &short(*number)].concat()),
            Value::Shorts(numbers) => {
                let last = (column + numbers.len() as u16 - 1).to_le_bytes();
                let numbers =
                    numbers.iter().flat_map(|number| [&[0, 0], &short(*number)[..]].concat());
                record(0x00bd, &[&place[..], &numbers.collect::<Vec<u8>>(), &last].concat())
            }
        });
    }
    if !merged.is_empty() {
        let ranges = merged.iter().flatten().flat_map(|range| range.to_le_bytes());
        let count = (merged.len() as u16).to_le_bytes();
        sheet.extend(record(0x00e5, &[&count[..], &ranges.collect::<Vec<u8>>()].concat()));
    }
    sheet.extend(record(0x000a, &[]));

    let mut stream = record(0x0809, &[&[0, 6, 5, 0], &[0; 12][..]].concat());
    if cells.iter().any(|(.., value)| matches!(value, Value::Date(_))) {
        stream.extend(formats());
    }
    let strings = strings(&shared, cells.len());
    let name = b"Survey";
    let sheet_at = (stream.len() + times * (4 + 8 + name.len()) + strings.len() + 4) as u32;
    let bound = [&sheet_at.to_le_bytes()[..], &[0, 0, name.len() as u8, 0], name];
    for _ in 0..times {
        stream.extend(record(0x0085, &bound.concat()));
    }
    stream.extend(strings);
    stream.extend(record(0x000a, &[]));
    assert_eq!(stream.len(), sheet_at as usize);
    stream.extend(sheet);
    compound(stream)
}

/// Hundredths as a whole number of 30 bits: \[MS-XLS\] 2.5.217, RkNumber.
fn short(number: f64) -> [u8; 4] {
    let hundredths = (number * 100.0).round() as i32;
    ((hundredths << 2) | 3).to_le_bytes()
}

/// The format of a date, and the two formats of cells: plain, and that of dates.
fn formats() -> Vec<u8> {
    const DATE: u16 = 164;
    let pattern = b"d\\-mmm";
    let length = (pattern.len() as u16).to_le_bytes();
    let format = [&DATE.to_le_bytes()[..], &length, &[0], pattern].concat();
    let form = |format: u16| [&[0, 0][..], &format.to_le_bytes(), &[0; 16]].concat();
    [record(0x041e, &format), record(0x00e0, &form(0)), record(0x00e0, &form(DATE))].concat()
}

/// Shared texts, if there are any.
fn strings(shared: &[&str], uses: usize) -> Vec<u8> {
    if shared.is_empty() {
        return Vec::new();
    }
    let counts = [(uses as u32).to_le_bytes(), (shared.len() as u32).to_le_bytes()].concat();
    let texts = shared
        .iter()
        .flat_map(|text| [&(text.len() as u16).to_le_bytes()[..], &[0], text.as_bytes()].concat());
    record(0x00fc, &[counts, texts.collect()].concat())
}

fn record(kind: u16, data: &[u8]) -> Vec<u8> {
    [&kind.to_le_bytes()[..], &(data.len() as u16).to_le_bytes(), data].concat()
}

/// A compound file with the stream "Workbook": header, table of sectors, directory, stream.
fn compound(mut stream: Vec<u8>) -> Vec<u8> {
    const SECTOR: usize = 512;
    const END: u32 = 0xffff_fffe;
    const FREE: u32 = 0xffff_ffff;
    // Shorter streams are stored in the mini stream.
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
