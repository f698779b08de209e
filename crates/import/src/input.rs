//! A file that is imported.

use std::io::{BufRead, BufReader, Cursor, Read};

use crate::error::{ImportError, ImportErrorKind};

/// Bytes at the beginning of a file by which it is recognised.
const HEAD: usize = 1 << 16;

/// A file: its name in messages, and its bytes as they are read.
pub struct Input<'a> {
    name: String,
    reader: BufReader<Box<dyn Read + Send + 'a>>,
}

impl std::fmt::Debug for Input<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Input").field("name", &self.name).finish_non_exhaustive()
    }
}

impl<'a> Input<'a> {
    /// A file that is read as it is needed.
    pub fn new(name: impl Into<String>, bytes: impl Read + Send + 'a) -> Self {
        Self { name: name.into(), reader: BufReader::with_capacity(HEAD, Box::new(bytes)) }
    }

    /// A file in memory.
    pub fn of_bytes(name: impl Into<String>, bytes: &'a [u8]) -> Self {
        Self::new(name, Cursor::new(bytes))
    }

    /// Its name in messages.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its first bytes, which are read again after this: at most 64 KiB.
    ///
    /// # Errors
    /// It cannot be read.
    pub(crate) fn head(&mut self) -> Result<&[u8], ImportError> {
        let name = self.name.clone();
        let head = self.reader.fill_buf();
        head.map_err(|error| unreadable(&name, &error))
    }

    /// All its bytes, at most so many.
    ///
    /// # Errors
    /// It cannot be read, or is longer.
    pub(crate) fn bytes(self, most: usize) -> Result<Vec<u8>, ImportError> {
        let mut bytes = Vec::new();
        let read = self.reader.take(most as u64 + 1).read_to_end(&mut bytes);
        read.map_err(|error| unreadable(&self.name, &error))?;
        if bytes.len() > most {
            let most = format!("{} MB", most >> 20);
            let kind =
                ImportErrorKind::TooMuch { found: format!("more than {most}"), most: most.clone() };
            return Err(ImportError::new(&self.name, None, kind));
        }
        Ok(bytes)
    }

    /// Its name, and what reads it from its beginning.
    pub(crate) fn into_parts(self) -> (String, impl BufRead + Send + 'a) {
        (self.name, self.reader)
    }
}

/// The error of a file that the system does not give.
pub(crate) fn unreadable(name: &str, error: &std::io::Error) -> ImportError {
    ImportError::new(name, None, ImportErrorKind::Unreadable { reason: error.to_string() })
}
