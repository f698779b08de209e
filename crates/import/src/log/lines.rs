//! Lines of a text that may exceed memory.

use std::io::{self, BufRead, BufReader, Read};

use crate::{
    error::{ImportError, ImportErrorKind},
    input::{Input, unreadable},
};

/// Maximum bytes of a line: thousands of columns fit, a file without line ends does not.
pub(crate) const LONGEST_LINE: usize = 1 << 20;

/// Lines without their line ends, of any kind, as UTF-8.
pub(crate) struct Lines<'a> {
    file: String,
    reader: Box<dyn BufRead + 'a>,
    end: u8,
    line: u64,
    cut: bool,
}

impl<'a> Lines<'a> {
    /// Reads a file from its beginning. Byte order marks are skipped; UTF-16 is decoded.
    pub(crate) fn new(mut input: Input<'a>) -> Result<Self, ImportError> {
        let head = input.head()?;
        let (mark, big) = match head {
            [0xef, 0xbb, 0xbf, ..] => (3, None),
            [0xff, 0xfe, ..] => (2, Some(false)),
            [0xfe, 0xff, ..] => (2, Some(true)),
            // Without a mark, every other byte of ASCII text is zero.
            [first, 0, _, 0, ..] if *first != 0 => (0, Some(false)),
            [0, second, 0, _, ..] if *second != 0 => (0, Some(true)),
            _ => (0, None),
        };
        let has = |byte: u8| head.contains(&byte);
        let end = if has(b'\r') && !has(b'\n') { b'\r' } else { b'\n' };
        let (file, mut reader) = input.into_parts();
        reader.consume(mark);
        let reader: Box<dyn BufRead + 'a> = match big {
            None => Box::new(reader),
            Some(big) => Box::new(BufReader::new(Utf16::new(reader, big))),
        };
        Ok(Self { file, reader, end, line: 0, cut: false })
    }

    /// Appends the next line; returns false at the end.
    pub(crate) fn next(&mut self, into: &mut Vec<u8>) -> Result<bool, ImportError> {
        let before = into.len();
        self.line += 1;
        let mut limited = (&mut self.reader).take(LONGEST_LINE as u64 + 1);
        let read = limited.read_until(self.end, into);
        let read = read.map_err(|error| unreadable(&self.file, &error))?;
        if read > LONGEST_LINE {
            return Err(self.error(ImportErrorKind::TooMuch {
                found: format!("a line of more than {} MB", LONGEST_LINE >> 20),
                most: format!("{} MB a line", LONGEST_LINE >> 20),
            }));
        }
        self.cut = into.last() != Some(&self.end);
        if !self.cut {
            into.pop();
            if into.len() > before && into.last() == Some(&b'\r') {
                into.pop();
            }
        }
        Ok(read > 0)
    }

    /// Number of the line that was read last, from 1.
    pub(crate) fn line(&self) -> u64 {
        self.line
    }

    /// Whether the file ended within the line that was read last.
    pub(crate) fn cut(&self) -> bool {
        self.cut
    }

    /// The file's name.
    pub(crate) fn file(&self) -> &str {
        &self.file
    }

    /// An error in the line that was read last.
    pub(crate) fn error(&self, kind: ImportErrorKind) -> ImportError {
        ImportError::new(&self.file, Some(format!("line {}", self.line)), kind)
    }
}

/// Decodes a line; if it is not UTF-8, each byte becomes one character.
pub(crate) fn text(line: &[u8]) -> String {
    match std::str::from_utf8(line) {
        Ok(text) => text.to_owned(),
        Err(_) => wholestring_tabular::single_bytes(line),
    }
}

/// Converts UTF-16 to UTF-8; invalid code units become the replacement character.
struct Utf16<R> {
    inner: R,
    big: bool,
    /// The first half of a surrogate pair.
    high: Option<u16>,
    ready: Vec<u8>,
    returned: usize,
}

impl<R: Read> Utf16<R> {
    fn new(inner: R, big: bool) -> Self {
        Self { inner, big, high: None, ready: Vec::new(), returned: 0 }
    }

    fn decode(&mut self) -> io::Result<()> {
        let mut bytes = Vec::with_capacity(8192);
        (&mut self.inner).take(8192).read_to_end(&mut bytes)?;
        self.ready.clear();
        self.returned = 0;
        let ends = bytes.len() < 8192;
        let mut units: Vec<u16> = self.high.take().into_iter().collect();
        units.extend(bytes.chunks_exact(2).map(|pair| match self.big {
            true => u16::from_be_bytes([pair[0], pair[1]]),
            false => u16::from_le_bytes([pair[0], pair[1]]),
        }));
        if !ends && units.last().is_some_and(|unit| (0xd800..0xdc00).contains(unit)) {
            self.high = units.pop();
        }
        let text: String = char::decode_utf16(units)
            .map(|unit| unit.unwrap_or(char::REPLACEMENT_CHARACTER))
            .collect();
        self.ready.extend_from_slice(text.as_bytes());
        Ok(())
    }
}

impl<R: Read> Read for Utf16<R> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        if self.returned == self.ready.len() {
            self.decode()?;
        }
        let count = into.len().min(self.ready.len() - self.returned);
        into[..count].copy_from_slice(&self.ready[self.returned..self.returned + count]);
        self.returned += count;
        Ok(count)
    }
}
