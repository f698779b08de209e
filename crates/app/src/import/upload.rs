//! Uploads: stored on disk, not in memory, and deleted after reading.

use std::{
    fs::File,
    io::{self, Seek, Write},
};

/// Maximum number of files of one import.
const MOST: usize = 40;

/// Maximum length of names shown.
const LONGEST_NAME: usize = 120;

/// An uploaded file.
#[derive(Debug)]
pub(crate) struct Upload {
    /// Its name, without a path.
    pub(super) name: String,
    file: File,
}

impl Upload {
    /// A new reader from its beginning.
    pub(super) fn reader(&self) -> io::Result<File> {
        let mut reader = self.file.try_clone()?;
        reader.rewind()?;
        Ok(reader)
    }

    /// Appends received bytes.
    ///
    /// # Errors
    /// A full disk.
    pub(crate) fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.file.write_all(bytes)
    }
}

/// Files of one import.
#[derive(Debug, Default)]
pub(crate) struct Uploads(pub(super) Vec<Upload>);

impl Uploads {
    /// Begins a file with this name.
    ///
    /// # Errors
    /// Too many files, or two of one name.
    pub(crate) fn begin(&mut self, name: &str, file: File) -> Result<&mut Upload, String> {
        if self.0.len() == MOST {
            return Err(format!("more than {MOST} files are not imported at once"));
        }
        let name = name.rsplit(['/', '\\']).next().unwrap_or(name);
        let name: String =
            name.chars().filter(|letter| !letter.is_control()).take(LONGEST_NAME).collect();
        if name.is_empty() {
            return Err("a file has no name".to_owned());
        }
        if self.0.iter().any(|upload| upload.name == name) {
            return Err(format!("two files are called `{name}`"));
        }
        self.0.push(Upload { name, file });
        let last = self.0.len() - 1;
        Ok(&mut self.0[last])
    }

    /// Whether there are none.
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}
