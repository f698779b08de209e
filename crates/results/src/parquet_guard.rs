//! Checks of a Parquet file's claims before it is read.
//!
//! The Parquet library allocates memory for as many bytes, rows and words as a file claims, and
//! trusts that its offsets are within it. The claims are therefore checked against the file's
//! length and against the amount that is ever read at once.

use std::{
    fs::File,
    io::{BufReader, Read, Seek, SeekFrom},
};

use parquet::file::{
    metadata::RowGroupMetaData, reader::FileReader, serialized_reader::SerializedFileReader,
};

use crate::thrift;

/// Footers are some kilobytes, and some megabytes of files with a thousand row groups.
const LONGEST_FOOTER: u64 = 4 << 20;

/// Pages are about a megabyte.
const LARGEST_PAGE: i64 = 32 << 20;

/// Numbers that are read at once, 640 MB: an hour of samples every 10 ms in a hundred columns is 36
/// million.
const MAX_VALUES: u64 = 40_000_000;

/// Number of numbers that take as much memory as a word.
const WORD: u64 = 4;

/// Text that is read at once, bytes.
pub(crate) const MAX_TEXT: usize = 128 << 20;

/// Last bytes of every Parquet file, after the length of its footer.
const MARK: &[u8] = b"PAR1";

/// Checks the footer: it is within the file, not longer than `LONGEST_FOOTER`, and describes a flat
/// table.
pub(crate) fn footer(file: &File) -> Result<(), String> {
    let io = |error: std::io::Error| error.to_string();
    let length = file.metadata().map_err(io)?.len();
    let mut tail = [0; 8];
    let mut reader = BufReader::new(file);
    let begin = length.checked_sub(12).ok_or("it is too short")? + 4;
    reader.seek(SeekFrom::Start(begin)).map_err(io)?;
    reader.read_exact(&mut tail).map_err(io)?;
    let (size, mark) = tail.split_at(4);
    if mark != MARK {
        return Err("it does not end like a Parquet file".into());
    }
    let size = u64::from(u32::from_le_bytes([size[0], size[1], size[2], size[3]]));
    if size > LONGEST_FOOTER {
        return Err(format!("its footer has {size} bytes; at most {LONGEST_FOOTER} are read"));
    }
    let start = begin.checked_sub(size).ok_or("its footer is longer than the file")?;
    reader.seek(SeekFrom::Start(start)).map_err(io)?;
    let mut groups = 0_u64;
    let mut negative = false;
    thrift::numbers(reader.take(size), &mut |path, value| match path {
        // The children of an element of the schema: only the table has any.
        [2, 5] => groups += u64::from(value != 0),
        // Rows, sizes and offsets.
        [3] | [4, 2 | 3] | [4, 1, 3, 5 | 6 | 7 | 9 | 10 | 11] => negative |= value < 0,
        _ => {}
    })
    .map_err(|_| "its footer is damaged")?;
    if groups > 1 {
        return Err("its columns are nested; a flat table was expected".into());
    }
    if negative {
        return Err("its footer is damaged (a size is negative)".into());
    }
    Ok(())
}

/// Checks the part of the row groups to be read: columns by their index.
pub(crate) fn columns(
    file: &File,
    reader: &SerializedFileReader<File>,
    groups: std::ops::Range<usize>,
    columns: &[(usize, bool)],
) -> Result<(), String> {
    let length = file.metadata().map_err(|error| error.to_string())?.len();
    let each: u64 = columns.iter().map(|(_, is_text)| if *is_text { WORD } else { 1 }).sum();
    let rows = groups.clone().try_fold(0_u64, |sum, group| {
        let rows = u64::try_from(reader.metadata().row_group(group).num_rows()).ok()?;
        sum.checked_add(rows)
    });
    let rows = rows.ok_or("its number of rows is damaged")?;
    if rows.checked_mul(each).is_none_or(|values| values > MAX_VALUES) {
        return Err(format!(
            "it has {rows} rows of {} columns; at most {MAX_VALUES} values are read",
            columns.len()
        ));
    }
    for group in groups {
        let group = reader.metadata().row_group(group);
        for (column, _) in columns {
            pages(file, length, group, *column)?;
        }
    }
    Ok(())
}

/// Checks the heads of the pages of a column.
fn pages(file: &File, length: u64, group: &RowGroupMetaData, column: usize) -> Result<(), String> {
    let about = group.columns().get(column).ok_or("a row group lacks a column")?;
    let damaged = || format!("its column `{}` is damaged", about.column_path().string());
    let start = about.dictionary_page_offset().unwrap_or(about.data_page_offset());
    let start = u64::try_from(start).map_err(|_| damaged())?;
    let size = u64::try_from(about.compressed_size()).map_err(|_| damaged())?;
    let end = start.checked_add(size).filter(|end| *end <= length).ok_or_else(damaged)?;
    let mut at = start;
    while at < end {
        let mut reader = BufReader::with_capacity(256, file);
        reader.seek(SeekFrom::Start(at)).map_err(|_| damaged())?;
        let mut left = reader.take(end - at);
        let (mut unpacked, mut packed, mut values, mut words) = (-1, -1, 0, 0);
        thrift::numbers(&mut left, &mut |path, value| match path {
            [2] => unpacked = value,
            [3] => packed = value,
            [5 | 8, 1] => values = value,
            [7, 1] => words = value,
            _ => {}
        })
        .map_err(|_| damaged())?;
        let head = end - at - left.limit();
        let valid = (0..=LARGEST_PAGE).contains(&unpacked)
            && packed >= 0
            && packed as u64 <= left.limit()
            && (0..=group.num_rows()).contains(&values)
            // Every word of a dictionary takes at least a byte.
            && (0..=unpacked).contains(&words);
        if !valid {
            return Err(damaged());
        }
        at += head + packed as u64;
    }
    Ok(())
}
