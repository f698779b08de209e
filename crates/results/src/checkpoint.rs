//! `checkpoint.bin`: what an unfinished run needs to go on.
//!
//! Twelve bytes of a mark and the version of this layout; the version of the program that wrote it;
//! length and checksum of the content; the content in [postcard](https://postcard.jamesmunns.com)'s
//! format. Numbers keep every bit. Only the version of the program that wrote a checkpoint reads it: what
//! changes in a run is what the engine is made of.

use std::{
    fs, io,
    io::Write,
    path::{Path, PathBuf},
};

use serde::{Serialize, de::DeserializeOwned};

use crate::{
    ResultsError, ResultsFolder,
    file::{partial_name, write_whole},
    frames,
};

pub(crate) const NAME: &str = "checkpoint.bin";

/// What every checkpoint begins with.
const MARK: &[u8; 8] = b"wholestr";

/// Version of the layout around the content.
const LAYOUT: u32 = 1;

/// Version of the program; all of its crates share it.
const PROGRAM: &str = env!("CARGO_PKG_VERSION");

impl ResultsFolder {
    fn checkpoint_path(&self) -> PathBuf {
        self.path().join(NAME)
    }

    /// Writes `checkpoint.bin`, whole or not at all: whatever happens meanwhile, the last one is there.
    pub fn write_checkpoint(&self, content: &impl Serialize) -> Result<(), ResultsError> {
        let path = self.checkpoint_path();
        let content = postcard::to_allocvec(content).map_err(|error| ResultsError::Write {
            path: path.clone(),
            source: io::Error::other(error),
        })?;
        write_whole(&path, |writer| {
            writer.write_all(MARK)?;
            writer.write_all(&LAYOUT.to_le_bytes())?;
            writer.write_all(&[PROGRAM.len() as u8])?;
            writer.write_all(PROGRAM.as_bytes())?;
            writer.write_all(&(content.len() as u64).to_le_bytes())?;
            writer.write_all(&checksum(&content).to_le_bytes())?;
            writer.write_all(&content)
        })
    }

    /// Reads back what [`Self::write_checkpoint`] wrote; none where there is no checkpoint.
    ///
    /// # Errors
    /// A file that cannot be read, that is damaged, or that another version of the program wrote.
    pub fn read_checkpoint<T: DeserializeOwned>(&self) -> Result<Option<T>, ResultsError> {
        let path = self.checkpoint_path();
        match fs::read(&path) {
            Ok(bytes) => unwrap(&bytes, &path).map(Some),
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
            Err(source) => Err(ResultsError::Read { path, source }),
        }
    }

    /// Whether there is a checkpoint, sound or not.
    pub fn has_checkpoint(&self) -> bool {
        self.checkpoint_path().exists()
    }

    /// Removes the checkpoint, the parts of `frames.parquet` that belong to it, and what a killed program left of
    /// either: the run is finished, or begins anew.
    pub fn remove_checkpoint(&self) -> Result<(), ResultsError> {
        let path = self.checkpoint_path();
        for path in [partial_name(&path), path] {
            if let Err(source) = fs::remove_file(&path)
                && source.kind() != io::ErrorKind::NotFound
            {
                return Err(ResultsError::Write { path, source });
            }
        }
        // After it: a checkpoint has its parts as long as it is there.
        frames::remove_parts(self.path(), 0)
    }
}

fn unwrap<T: DeserializeOwned>(bytes: &[u8], path: &Path) -> Result<T, ResultsError> {
    let bad = |reason: String| ResultsError::Checkpoint {
        path: path.to_owned(),
        reason,
    };
    let damaged = || bad("it is damaged".into());
    let mut rest = bytes;
    if take::<8>(&mut rest).as_ref() != Some(MARK) {
        return Err(bad("it does not begin like one".into()));
    }
    let layout = take(&mut rest).map(u32::from_le_bytes);
    let length = take(&mut rest).map(u8::from_le_bytes);
    let program = length.and_then(|length| rest.split_off(..usize::from(length)));
    let program = program.map(String::from_utf8_lossy).ok_or_else(damaged)?;
    if layout != Some(LAYOUT) || program != PROGRAM {
        return Err(bad(format!(
            "wholestring {program} wrote it, this is {PROGRAM}"
        )));
    }
    let length = take(&mut rest).map(u64::from_le_bytes);
    let expected = take(&mut rest).map(u64::from_le_bytes);
    if length != Some(rest.len() as u64) || expected != Some(checksum(rest)) {
        return Err(damaged());
    }
    postcard::from_bytes(rest).map_err(|_| damaged())
}

fn take<const N: usize>(rest: &mut &[u8]) -> Option<[u8; N]> {
    rest.split_off(..N)?.try_into().ok()
}

/// FNV-1a over words of eight bytes: it is there to find damage, not forgery.
fn checksum(bytes: &[u8]) -> u64 {
    const BASIS: u64 = 0xcbf2_9ce4_8422_2325;
    const PRIME: u64 = 0x0000_0100_0000_01b3;
    bytes.chunks(8).fold(BASIS, |sum, chunk| {
        let mut word = [0; 8];
        word[..chunk.len()].copy_from_slice(chunk);
        (sum ^ u64::from_le_bytes(word))
            .wrapping_mul(PRIME)
            .rotate_left(29)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    type Content = (Vec<f64>, String, Option<u64>);

    fn content() -> Content {
        let numbers = (0..100).map(|i| f64::from(i).sqrt()).collect();
        (numbers, "a word".into(), Some(7))
    }

    fn written() -> (tempfile::TempDir, ResultsFolder) {
        let place = tempfile::tempdir().unwrap();
        let folder = ResultsFolder::create(place.path()).unwrap();
        folder.write_checkpoint(&content()).unwrap();
        (place, folder)
    }

    fn message(folder: &ResultsFolder) -> String {
        let error = folder.read_checkpoint::<Content>().unwrap_err().to_string();
        let path = folder.checkpoint_path().display().to_string();
        error.replace(&path, "PATH")
    }

    #[test]
    fn what_was_written_is_read_back_until_it_is_removed() {
        let (_place, folder) = written();
        assert_eq!(folder.read_checkpoint().unwrap(), Some(content()));
        folder.remove_checkpoint().unwrap();
        folder.remove_checkpoint().unwrap();
        assert_eq!(folder.read_checkpoint::<Content>().unwrap(), None);
    }

    /// Not a bit of it can turn over or go without being noticed.
    #[test]
    fn damage_is_found() {
        let (_place, folder) = written();
        let path = folder.checkpoint_path();
        let sound = fs::read(&path).unwrap();
        assert_eq!(unwrap::<Content>(&sound, &path).unwrap(), content());
        for place in 0..sound.len() {
            let mut bytes = sound.clone();
            bytes[place] ^= 1 << (place % 8);
            assert!(unwrap::<Content>(&bytes, &path).is_err(), "byte {place}");
            assert!(unwrap::<Content>(&sound[..place], &path).is_err());
        }
        fs::write(&path, &sound[..sound.len() - 1]).unwrap();
        assert_eq!(
            message(&folder),
            "PATH is no checkpoint that can be resumed: it is damaged"
        );
        fs::write(&path, "something else").unwrap();
        assert_eq!(
            message(&folder),
            "PATH is no checkpoint that can be resumed: it does not begin like one"
        );
    }

    #[test]
    fn another_versions_checkpoint_is_refused() {
        let (_place, folder) = written();
        let path = folder.checkpoint_path();
        let mut bytes = fs::read(&path).unwrap();
        bytes[13] = b'9';
        fs::write(&path, bytes).unwrap();
        let other = format!("9{}", &PROGRAM[1..]);
        assert_eq!(
            message(&folder),
            format!(
                "PATH is no checkpoint that can be resumed: wholestring {other} wrote it, this is {PROGRAM}"
            )
        );
    }
}
