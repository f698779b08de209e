//! A file to import.

use std::io::{BufRead, BufReader, Cursor, Read};

use crate::error::{ImportError, ImportErrorKind};

/// Number of bytes at the beginning of a file by which its format is recognised.
const HEAD: usize = 1 << 16;

/// A file: its name in messages and a reader of its bytes.
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
    /// A file that is read on demand.
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

    /// Its first bytes, at most 64 KiB; they are read again later.
    ///
    /// # Errors
    /// It cannot be read.
    pub(crate) fn head(&mut self) -> Result<&[u8], ImportError> {
        let name = self.name.clone();
        let head = self.reader.fill_buf();
        head.map_err(|error| unreadable(&name, &error))
    }

    /// All its bytes, up to `most`.
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

    /// Its name, and a reader from its beginning.
    pub(crate) fn into_parts(self) -> (String, impl BufRead + Send + 'a) {
        (self.name, self.reader)
    }
}

/// The error of a file that cannot be read.
pub(crate) fn unreadable(name: &str, error: &std::io::Error) -> ImportError {
    ImportError::new(name, None, ImportErrorKind::Unreadable { reason: error.to_string() })
}
