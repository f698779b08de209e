//! `checkpoint.bin`: the data that an unfinished run needs to continue.
//!
//! Contents: twelve bytes with a mark and the version of this layout; the version of the program
//! that wrote it, and the digest of its engine's sources; the content in
//! [postcard](https://postcard.jamesmunns.com)'s format; its length and its checksum. Numbers keep
//! every bit. Only the same version of the program reads a checkpoint, and only a build of the same
//! engine, because a run depends on the sources of the engine.

use std::{
    fs, io,
    io::Write,
    path::{Path, PathBuf},
};

use serde::{Serialize, de::DeserializeOwned};
use wholestring::internals::ENGINE_BUILD;

use crate::{
    ResultsError, ResultsFolder,
    file::{partial_name, write_whole},
    frames,
    names::{CHECKPOINT, TIME_TABLE},
    parts::Parts,
};

/// Mark at the beginning of every checkpoint.
const MARK: &[u8; 8] = b"wholestr";

/// Version of the layout around the content.
const LAYOUT: u32 = 12;

/// Version of the program; all of its crates share it.
const PROGRAM: &str = env!("CARGO_PKG_VERSION");

/// Digits of the digest of the engine's sources.
const BUILD_DIGITS: usize = ENGINE_BUILD.len();

impl ResultsFolder {
    fn checkpoint_path(&self) -> PathBuf {
        self.path().join(CHECKPOINT)
    }

    /// Writes `checkpoint.bin`, whole or not at all: the previous one remains until the new one is
    /// complete. The content goes to the disk as it is serialized, so that it is never held twice
    /// in memory.
    pub fn write_checkpoint(&self, content: &impl Serialize) -> Result<(), ResultsError> {
        write_whole(&self.checkpoint_path(), |writer| wrap(content, writer))
    }

    /// Reads back the content that [`Self::write_checkpoint`] wrote; `None` where there is no
    /// checkpoint.
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

    /// Whether there is a checkpoint, valid or not.
    pub fn has_checkpoint(&self) -> bool {
        self.checkpoint_path().exists()
    }

    /// Removes the checkpoint, the parts of tables that belong to it, and remains of either from a
    /// killed program: the run is finished, or starts again.
    pub fn remove_checkpoint(&self) -> Result<(), ResultsError> {
        let path = self.checkpoint_path();
        for path in [partial_name(&path), path] {
            if let Err(source) = fs::remove_file(&path)
                && source.kind() != io::ErrorKind::NotFound
            {
                return Err(ResultsError::Write { path, source });
            }
        }
        // After the checkpoint, because it needs its parts as long as it exists.
        [frames::TABLE, TIME_TABLE]
            .into_iter()
            .try_for_each(|table| Parts { folder: self.path(), table }.remove(0))
    }
}

/// Returns the bytes of a checkpoint, to be stored anywhere.
///
/// # Errors
/// Content that cannot be serialized; no run produces such content.
pub fn checkpoint_bytes(content: &impl Serialize) -> Result<Vec<u8>, ResultsError> {
    let mut bytes = Vec::new();
    wrap(content, &mut bytes).map_err(|source| ResultsError::Write { path: memory(), source })?;
    Ok(bytes)
}

/// Reads back the content of [`checkpoint_bytes`].
///
/// # Errors
/// Bytes that are damaged, or that another version of the program wrote.
pub fn read_checkpoint_bytes<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, ResultsError> {
    unwrap(bytes, &memory())
}

/// Name in errors of a checkpoint that is not in a file.
fn memory() -> PathBuf {
    PathBuf::from("the checkpoint")
}

fn wrap(content: &impl Serialize, mut writer: impl Write) -> io::Result<()> {
    writer.write_all(MARK)?;
    writer.write_all(&LAYOUT.to_le_bytes())?;
    writer.write_all(&[PROGRAM.len() as u8])?;
    writer.write_all(PROGRAM.as_bytes())?;
    writer.write_all(ENGINE_BUILD.as_bytes())?;
    let mut summed = Summed::new(&mut writer);
    // The disk's own error, where there is one, is more specific than that it could not be written.
    if let Err(error) = postcard::to_io(content, &mut summed) {
        return Err(summed.failed.unwrap_or_else(|| io::Error::other(error)));
    }
    let (length, checksum) = summed.end();
    writer.write_all(&length.to_le_bytes())?;
    writer.write_all(&checksum.to_le_bytes())
}

fn unwrap<T: DeserializeOwned>(bytes: &[u8], path: &Path) -> Result<T, ResultsError> {
    let bad = |reason: String| ResultsError::Checkpoint { path: path.to_owned(), reason };
    let damaged = || bad("it is damaged".into());
    let mut rest = bytes;
    if take::<8>(&mut rest).as_ref() != Some(MARK) {
        return Err(bad("it does not begin like one".into()));
    }
    let layout = take(&mut rest).map(u32::from_le_bytes);
    let length = take(&mut rest).map(u8::from_le_bytes);
    let program = length.and_then(|length| rest.split_off(..usize::from(length)));
    let program = program.map(String::from_utf8_lossy).ok_or_else(damaged)?;
    // An invalid version is not shown.
    if !program.bytes().all(|byte| byte.is_ascii_graphic()) {
        return Err(damaged());
    }
    if layout != Some(LAYOUT) || program != PROGRAM {
        let layout = layout.filter(|_| program == PROGRAM).map_or_else(String::new, |layout| {
            format!(": its layout is {layout}, this program reads {LAYOUT}")
        });
        return Err(bad(format!("wholestring {program} wrote it, this is {PROGRAM}{layout}")));
    }
    let build = take::<BUILD_DIGITS>(&mut rest).ok_or_else(damaged)?;
    if build != ENGINE_BUILD.as_bytes() {
        if !build.iter().all(u8::is_ascii_hexdigit) {
            return Err(damaged());
        }
        let build = String::from_utf8_lossy(&build).into_owned();
        return Err(bad(format!(
            "another build of wholestring {PROGRAM} wrote it (its engine is {build}, this one is \
             {ENGINE_BUILD}): finish the run with that build, or begin it again"
        )));
    }
    let end = rest.len().checked_sub(16).ok_or_else(damaged)?;
    let (content, mut end) = rest.split_at(end);
    let mut summed = Summed::new(io::sink());
    summed.write_all(content).map_err(|_| damaged())?;
    let (length, checksum) = summed.end();
    if take(&mut end) != Some(length.to_le_bytes())
        || take(&mut end) != Some(checksum.to_le_bytes())
    {
        return Err(damaged());
    }
    postcard::from_bytes(content).map_err(|_| damaged())
}

fn take<const N: usize>(rest: &mut &[u8]) -> Option<[u8; N]> {
    rest.split_off(..N)?.try_into().ok()
}

/// A writer that counts its bytes and computes their checksum: FNV-1a over words of eight bytes. It
/// detects damage, not forgery.
struct Summed<W> {
    writer: W,
    length: u64,
    sum: u64,
    /// The last bytes, which do not fill a word yet.
    word: [u8; 8],
    /// Reason why the writer stopped accepting bytes.
    failed: Option<io::Error>,
}

impl<W: Write> Summed<W> {
    fn new(writer: W) -> Self {
        Self { writer, length: 0, sum: 0xcbf2_9ce4_8422_2325, word: [0; 8], failed: None }
    }

    fn add(&mut self, bytes: &[u8]) {
        for byte in bytes {
            let place = (self.length % 8) as usize;
            self.word[place] = *byte;
            self.length += 1;
            if place == 7 {
                self.close_word();
            }
        }
    }

    fn close_word(&mut self) {
        let word = u64::from_le_bytes(std::mem::take(&mut self.word));
        self.sum = (self.sum ^ word).wrapping_mul(0x0000_0100_0000_01b3).rotate_left(29);
    }

    /// Length and checksum of all bytes written.
    fn end(mut self) -> (u64, u64) {
        if !self.length.is_multiple_of(8) {
            self.close_word();
        }
        (self.length, self.sum)
    }
}

impl<W: Write> Write for Summed<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self.writer.write(bytes) {
            Ok(taken) => {
                self.add(&bytes[..taken]);
                Ok(taken)
            }
            Err(error) => {
                // The caller gets the kind; the error itself is stored for the final report.
                let kind = error.kind();
                self.failed = Some(error);
                Err(kind.into())
            }
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        self.writer.flush()
    }
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

    /// Any changed or missing bit is detected.
    #[test]
    fn damage_is_found() {
        let (_place, folder) = written();
        let path = folder.checkpoint_path();
        let valid = fs::read(&path).unwrap();
        assert_eq!(unwrap::<Content>(&valid, &path).unwrap(), content());
        for place in 0..valid.len() {
            let mut bytes = valid.clone();
            bytes[place] ^= 1 << (place % 8);
            assert!(unwrap::<Content>(&bytes, &path).is_err(), "byte {place}");
            assert!(unwrap::<Content>(&valid[..place], &path).is_err());
        }
        fs::write(&path, &valid[..valid.len() - 1]).unwrap();
        assert_eq!(message(&folder), "PATH is no checkpoint that can be resumed: it is damaged");
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
                "PATH is no checkpoint that can be resumed: wholestring {other} wrote it, this is \
                 {PROGRAM}"
            )
        );
    }
    /// Two builds of one version may compute different results; the digest of the engine's sources
    /// distinguishes their checkpoints.
    #[test]
    fn another_builds_checkpoint_is_refused() {
        let (_place, folder) = written();
        let path = folder.checkpoint_path();
        let mut bytes = fs::read(&path).unwrap();
        let place = MARK.len() + 5 + PROGRAM.len();
        bytes[place..place + BUILD_DIGITS].copy_from_slice(b"0123456789abcdef");
        fs::write(&path, bytes).unwrap();
        assert_eq!(
            message(&folder),
            format!(
                "PATH is no checkpoint that can be resumed: another build of wholestring {PROGRAM} \
                 wrote it (its engine is 0123456789abcdef, this one is {ENGINE_BUILD}): finish the \
                 run with that build, or begin it again"
            )
        );
    }
}
