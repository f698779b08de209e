//! Writing a file whole or not at all.

use std::{
    fs::{self, File},
    io::{self, BufWriter, Read, Write},
    path::{Path, PathBuf},
};

use crate::ResultsError;

/// Bytes that gather before they go to the system: a checkpoint has millions.
const BUFFER: usize = 1 << 18;

/// Writes `path` through a file beside it that takes its name once it is complete, so that a reader
/// (or a crash) never meets half a file.
pub(crate) fn write_whole(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
) -> Result<(), ResultsError> {
    // Without it a full disk may go unnoticed until after the rename.
    write_then(path, write, File::sync_all)
}

/// [`write_whole`] that does not wait for the disk: for files that a sweep writes by the thousand
/// and makes again in milliseconds. After a power failure the file may be empty.
pub(crate) fn write_unsynced(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
) -> Result<(), ResultsError> {
    write_then(path, write, |_| Ok(()))
}

fn write_then(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
    sync: impl FnOnce(&File) -> io::Result<()>,
) -> Result<(), ResultsError> {
    let partial = partial_name(path);
    let result = (|| {
        let mut writer = BufWriter::with_capacity(BUFFER, File::create(&partial)?);
        write(&mut writer)?;
        writer.flush()?;
        sync(writer.get_ref())?;
        drop(writer);
        fs::rename(&partial, path)
    })();
    result.map_err(|source| {
        // The attempt's own remains; the first error is the one worth reporting.
        let _ = fs::remove_file(&partial);
        ResultsError::Write { path: path.to_owned(), source }
    })
}

/// Reads a file that holds no more than so many bytes.
pub(crate) fn read_at_most(path: &Path, most: u64) -> Result<Vec<u8>, ResultsError> {
    let unreadable = |source| ResultsError::Read { path: path.to_owned(), source };
    let file = File::open(path).map_err(unreadable)?;
    let mut bytes = Vec::new();
    let read = file.take(most + 1).read_to_end(&mut bytes);
    read.map_err(unreadable)?;
    if bytes.len() as u64 > most {
        let reason = format!("it holds more than {} MB", most >> 20);
        return Err(ResultsError::format(path, reason));
    }
    Ok(bytes)
}

/// Where [`write_whole`] writes before the file takes its name; a killed program leaves it.
pub(crate) fn partial_name(path: &Path) -> PathBuf {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(".partial");
    path.with_file_name(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failed_write_leaves_the_old_file_and_no_remains() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        fs::write(&path, "old").unwrap();
        let error = write_whole(&path, |writer| {
            writer.write_all(b"half of")?;
            Err(io::ErrorKind::StorageFull.into())
        })
        .unwrap_err();
        assert_eq!(error.to_string(), format!("cannot write {}: the disk is full", path.display()));
        assert_eq!(fs::read_to_string(&path).unwrap(), "old");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn a_write_replaces_the_old_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        for text in ["a longer first text", "second"] {
            write_whole(&path, |writer| writer.write_all(text.as_bytes())).unwrap();
            assert_eq!(fs::read_to_string(&path).unwrap(), text);
        }
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }
}
