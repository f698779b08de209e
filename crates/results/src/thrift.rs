//! Numbers in Thrift's compact protocol, in which Parquet writes its footer and the heads of its
//! pages.
//!
//! Only the subset that is needed to check a file's claims before it is read. Integers are variable
//! in length and folded (zigzag); a field begins with its kind and its distance from the field
//! before.

use std::io::{self, Read};

/// Largest depth of nested structures. Parquet's own are six deep.
const DEEPEST: usize = 16;

/// Kinds of values.
const TRUE: u8 = 1;
const FALSE: u8 = 2;
const BYTE: u8 = 3;
const INT_16: u8 = 4;
const INT_64: u8 = 6;
const DOUBLE: u8 = 7;
const BINARY: u8 = 8;
const LIST: u8 = 9;
const SET: u8 = 10;
const MAP: u8 = 11;
const STRUCTURE: u8 = 12;

/// Reads one structure, and calls `visit` with each whole number in it and the ids of the fields
/// that lead there.
///
/// # Errors
/// Bytes that are not such a structure, or nested deeper than any of Parquet's.
pub(crate) fn numbers(from: impl Read, visit: &mut dyn FnMut(&[i16], i64)) -> io::Result<()> {
    let mut walk = Walk { from, visit, path: Vec::new() };
    walk.structure(0)
}

struct Walk<'a, R> {
    from: R,
    visit: &'a mut dyn FnMut(&[i16], i64),
    path: Vec<i16>,
}

impl<R: Read> Walk<'_, R> {
    fn structure(&mut self, depth: usize) -> io::Result<()> {
        if depth > DEEPEST {
            return Err(malformed());
        }
        let mut id = 0_i16;
        loop {
            let head = self.byte()?;
            if head == 0 {
                return Ok(());
            }
            id = match head >> 4 {
                0 => self.integer()? as i16,
                further => id.wrapping_add(i16::from(further)),
            };
            self.path.push(id);
            self.value(head & 15, depth)?;
            self.path.pop();
        }
    }

    fn value(&mut self, kind: u8, depth: usize) -> io::Result<()> {
        match kind {
            TRUE | FALSE => Ok(()),
            BYTE => self.byte().map(drop),
            INT_16..=INT_64 => {
                let value = self.integer()?;
                (self.visit)(&self.path, value);
                Ok(())
            }
            DOUBLE => self.skip(8),
            BINARY => {
                let length = self.unsigned()?;
                self.skip(length)
            }
            LIST | SET => {
                let head = self.byte()?;
                let count = match head >> 4 {
                    15 => self.unsigned()?,
                    count => u64::from(count),
                };
                (0..count).try_for_each(|_| self.element(head & 15, depth))
            }
            MAP => {
                let count = self.unsigned()?;
                if count == 0 {
                    return Ok(());
                }
                let kinds = self.byte()?;
                (0..count).try_for_each(|_| {
                    self.element(kinds >> 4, depth)?;
                    self.element(kinds & 15, depth)
                })
            }
            STRUCTURE => self.structure(depth + 1),
            _ => Err(malformed()),
        }
    }

    /// A value in a list, where a boolean is a byte.
    fn element(&mut self, kind: u8, depth: usize) -> io::Result<()> {
        match kind {
            TRUE | FALSE => self.byte().map(drop),
            LIST | SET | MAP if depth >= DEEPEST => Err(malformed()),
            LIST | SET | MAP => self.value(kind, depth + 1),
            kind => self.value(kind, depth),
        }
    }

    fn byte(&mut self) -> io::Result<u8> {
        let mut byte = [0];
        self.from.read_exact(&mut byte)?;
        Ok(byte[0])
    }

    fn unsigned(&mut self) -> io::Result<u64> {
        let mut value = 0;
        for shift in (0..64).step_by(7) {
            let byte = self.byte()?;
            value |= u64::from(byte & 0x7f) << shift;
            if byte & 0x80 == 0 {
                return Ok(value);
            }
        }
        Err(malformed())
    }

    fn integer(&mut self) -> io::Result<i64> {
        let folded = self.unsigned()?;
        Ok((folded >> 1) as i64 ^ -((folded & 1) as i64))
    }

    fn skip(&mut self, bytes: u64) -> io::Result<()> {
        let skipped = io::copy(&mut self.from.by_ref().take(bytes), &mut io::sink())?;
        if skipped < bytes {
            return Err(io::ErrorKind::UnexpectedEof.into());
        }
        Ok(())
    }
}

fn malformed() -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, "it is malformed")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn visited(bytes: &[u8]) -> io::Result<Vec<(Vec<i16>, i64)>> {
        let mut all = Vec::new();
        numbers(bytes, &mut |path, value| all.push((path.to_vec(), value)))?;
        Ok(all)
    }

    #[test]
    fn fields_lists_and_structures_are_gone_through() {
        // 1: i32 -3; 3: binary "ab"; 4: list of two i32, 1 and 150; 20: a structure with 1: i64 64
        // and 2: true.
        let bytes = [
            0x15, 5, 0x28, 2, b'a', b'b', 0x19, 0x25, 2, 0xac, 2, 0x0c, 40, 0x16, 0x80, 1, 0x11, 0,
            0,
        ];
        let expected = [(vec![1], -3), (vec![4], 1), (vec![4], 150), (vec![20, 1], 64)];
        assert_eq!(visited(&bytes).unwrap(), expected);
        for cut in 0..bytes.len() {
            assert!(visited(&bytes[..cut]).is_err(), "{cut}");
        }
    }

    /// Structures within structures without end would overflow the stack.
    #[test]
    fn what_is_too_deep_is_refused() {
        assert!(visited(&[0x1c; 100_000]).is_err());
        assert!(visited(&[0x19; 100_000]).is_err());
    }
}
