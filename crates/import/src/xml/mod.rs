//! XML, read event by event within limits.

mod reader;

pub(crate) use reader::{Element, Event, Xml, check, root};

use std::{
    io::{self, BufRead, BufReader, Read},
    sync::{
        Arc,
        atomic::{AtomicU64, Ordering::Relaxed},
    },
};

// Conversion of XML encodings to UTF-8.

/// Encoding of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Encoding {
    /// UTF-8, passed through unchanged; ASCII is a subset.
    Utf8,
    Utf16 {
        little: bool,
    },
    /// Windows-1252, also for files declared as ISO-8859-1, as in browsers: the two differ only
    /// where ISO-8859-1 has control characters.
    Western,
}

/// Supported encodings by name, in lower case.
const NAMES: &[(&str, Encoding)] = &[
    ("utf-8", Encoding::Utf8),
    ("utf8", Encoding::Utf8),
    ("us-ascii", Encoding::Utf8),
    ("ascii", Encoding::Utf8),
    ("iso-8859-1", Encoding::Western),
    ("iso8859-1", Encoding::Western),
    ("iso_8859-1", Encoding::Western),
    ("latin1", Encoding::Western),
    ("latin-1", Encoding::Western),
    ("windows-1252", Encoding::Western),
    ("cp1252", Encoding::Western),
];

/// Number of bytes that include the XML declaration.
const DECLARATION: usize = 256;

/// Returns a reader of a file's bytes as UTF-8.
///
/// # Errors
/// The file cannot be read, or the name of an unsupported encoding.
pub(crate) fn utf8<'a>(
    mut bytes: Box<dyn BufRead + 'a>,
) -> io::Result<Result<Box<dyn BufRead + 'a>, String>> {
    let head = bytes.fill_buf()?;
    let encoding = match head {
        [0xff, 0xfe, ..] | [b'<', 0, ..] => Encoding::Utf16 { little: true },
        [0xfe, 0xff, ..] | [0, b'<', ..] => Encoding::Utf16 { little: false },
        [0xef, 0xbb, 0xbf, ..] => Encoding::Utf8,
        _ => match declared(head) {
            None => Encoding::Utf8,
            Some(name) => {
                let small = name.to_ascii_lowercase();
                let Some((_, known)) = NAMES.iter().find(|(own, _)| *own == small) else {
                    return Ok(Err(name));
                };
                *known
            }
        },
    };
    if encoding == Encoding::Utf8 {
        return Ok(Ok(bytes));
    }
    let decoded = Decoded { inner: bytes, encoding, pending: Vec::new(), returned: 0 };
    Ok(Ok(Box::new(BufReader::with_capacity(1 << 16, decoded))))
}

/// The encoding declared in `<?xml version="1.0" encoding="ISO-8859-1"?>`.
fn declared(head: &[u8]) -> Option<String> {
    let head = &head[..head.len().min(DECLARATION)];
    let text: String = head.iter().map(|&byte| char::from(byte)).collect();
    let declaration = text.strip_prefix("<?xml")?;
    let declaration = &declaration[..declaration.find("?>")?];
    let (_, value) = declaration.split_once("encoding")?;
    let value = value.trim_start().strip_prefix('=')?.trim_start();
    let quote = value.chars().next().filter(|c| "\"'".contains(*c))?;
    let (name, _) = value[1..].split_once(quote)?;
    Some(name.to_owned())
}

/// Text converted to UTF-8 on reading.
struct Decoded<'a> {
    inner: Box<dyn BufRead + 'a>,
    encoding: Encoding,
    /// UTF-8 that is still to be returned.
    pending: Vec<u8>,
    /// Number of bytes of it that were returned.
    returned: usize,
}

/// Number of characters decoded at once.
const AT_ONCE: usize = 8192;

impl Read for Decoded<'_> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        if self.returned == self.pending.len() {
            self.returned = 0;
            self.pending.clear();
            self.decode()?;
        }
        let from = &self.pending[self.returned..];
        let count = from.len().min(into.len());
        into[..count].copy_from_slice(&from[..count]);
        self.returned += count;
        Ok(count)
    }
}

impl Decoded<'_> {
    fn decode(&mut self) -> io::Result<()> {
        let mut text = String::new();
        for _ in 0..AT_ONCE {
            let Some(byte) = self.byte()? else { break };
            let character = match self.encoding {
                Encoding::Utf8 | Encoding::Western => Some(western(byte)),
                Encoding::Utf16 { little } => self.utf16(byte, little)?,
            };
            let no_text = || io::Error::new(io::ErrorKind::InvalidData, "it is not UTF-16");
            text.push(character.ok_or_else(no_text)?);
        }
        // The byte order mark is not part of the text.
        let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
        self.pending.extend_from_slice(text.as_bytes());
        Ok(())
    }

    fn byte(&mut self) -> io::Result<Option<u8>> {
        let byte = self.inner.fill_buf()?.first().copied();
        self.inner.consume(usize::from(byte.is_some()));
        Ok(byte)
    }

    /// The character that begins with a byte; `None` if it is incomplete.
    fn utf16(&mut self, first: u8, little: bool) -> io::Result<Option<char>> {
        let Some(one) = self.unit(first, little)? else { return Ok(None) };
        if !(0xd800..0xdc00).contains(&one) {
            return Ok(char::from_u32(u32::from(one)));
        }
        let Some(first) = self.byte()? else { return Ok(None) };
        let Some(two) = self.unit(first, little)? else { return Ok(None) };
        Ok(char::decode_utf16([one, two]).next().and_then(Result::ok))
    }

    fn unit(&mut self, first: u8, little: bool) -> io::Result<Option<u16>> {
        let from_bytes = if little { u16::from_le_bytes } else { u16::from_be_bytes };
        Ok(self.byte()?.map(|second| from_bytes([first, second])))
    }
}

/// The characters of Windows-1252 from 0x80 to 0x9f; five of them are unused.
const WESTERN: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}',
    '\u{90}', '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
];

fn western(byte: u8) -> char {
    match byte {
        0x80..=0x9f => WESTERN[usize::from(byte - 0x80)],
        _ => char::from(byte),
    }
}

// A limit before a parser on the length of a token, and the current line.

/// Amount of input taken by the parser, shared with its caller.
#[derive(Debug, Clone, Default)]
pub(crate) struct Taken {
    /// Bytes since the last token began.
    since: Arc<AtomicU64>,
    /// Number of line ends passed.
    lines: Arc<AtomicU64>,
}

impl Taken {
    /// Marks the end of a token.
    pub(crate) fn token(&self) {
        self.since.store(0, Relaxed);
    }

    /// The line, from 1.
    pub(crate) fn line(&self) -> u64 {
        self.lines.load(Relaxed) + 1
    }
}

/// Limits the bytes of one token, because text without end would exhaust memory.
pub(crate) struct Capped<R> {
    inner: R,
    most: u64,
    taken: Taken,
}

impl<R> Capped<R> {
    pub(crate) fn new(inner: R, most: u64) -> (Self, Taken) {
        let taken = Taken::default();
        (Self { inner, most, taken: taken.clone() }, taken)
    }
}

impl<R: BufRead> Read for Capped<R> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let from = self.fill_buf()?;
        let count = from.len().min(into.len());
        into[..count].copy_from_slice(&from[..count]);
        self.consume(count);
        Ok(count)
    }
}

impl<R: BufRead> BufRead for Capped<R> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.taken.since.load(Relaxed) > self.most {
            let text = format!("a text or tag of more than {} MB", self.most >> 20);
            return Err(io::Error::new(io::ErrorKind::FileTooLarge, text));
        }
        self.inner.fill_buf()
    }

    fn consume(&mut self, count: usize) {
        if let Ok(buffer) = self.inner.fill_buf() {
            let ends = buffer[..count.min(buffer.len())].iter().filter(|b| **b == b'\n').count();
            add(&self.taken.lines, ends);
        }
        add(&self.taken.since, count);
        self.inner.consume(count);
    }
}

/// Only one thread counts, so that no locked operation is needed.
fn add(to: &AtomicU64, count: usize) {
    to.store(to.load(Relaxed) + count as u64, Relaxed);
}

#[cfg(test)]
mod tests;
