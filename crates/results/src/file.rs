//! Writing a file whole or not at all.

use std::{
    fs::{self, File, OpenOptions},
    io::{self, BufWriter, Read, Write},
    path::{Path, PathBuf},
};

use crate::ResultsError;

/// Bytes that are collected before they are written to the system, because a checkpoint has
/// millions.
const BUFFER: usize = 1 << 18;

/// Writes `path` through a temporary file in the same folder that is renamed once it is complete,
/// so that a reader (or a crash) never meets half a file.
pub(crate) fn write_whole(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
) -> Result<(), ResultsError> {
    // Without it a full disk may go unnoticed until after the rename.
    write_then(path, write, File::sync_all)
}

/// [`write_whole`] that does not wait for the disk: for files that a sweep writes by the thousand
/// and can make again in milliseconds. After a power failure the file may be empty.
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
        // Removes the temporary file of this attempt; the first error is the one to report.
        let _ = fs::remove_file(&partial);
        ResultsError::Write { path: path.to_owned(), source }
    })
}

/// Writes a file whole or not at all; a file of that name is replaced. A device or a pipe is
/// written to directly.
///
/// # Errors
/// A file that cannot be written; a previous file is then unchanged.
pub fn write_file(path: &Path, bytes: &[u8]) -> Result<(), ResultsError> {
    let is_special = path.metadata().is_ok_and(|there| !there.is_file() && !there.is_dir());
    if is_special {
        let written = OpenOptions::new().write(true).open(path);
        let written = written.and_then(|mut file| file.write_all(bytes));
        return written.map_err(|source| ResultsError::Write { path: path.to_owned(), source });
    }
    // Where the name is a link, the file it points to is replaced and the link remains.
    let target = if path.is_symlink() { fs::canonicalize(path).ok() } else { None };
    write_whole(target.as_deref().unwrap_or(path), |writer| writer.write_all(bytes))
}

/// Writes new files, all of them or none. A file that is there is not replaced.
///
/// # Errors
/// The path of the first file that is there already or cannot be written, and the reason.
pub fn write_new_files(files: &[(PathBuf, &[u8])]) -> Result<(), (PathBuf, io::Error)> {
    let mut partials = Partials(Vec::new());
    for (path, bytes) in files {
        let partial = partial_name(path);
        let mut write = || {
            if path.try_exists()? {
                return Err(io::ErrorKind::AlreadyExists.into());
            }
            let mut file = File::create(&partial)?;
            partials.0.push(partial.clone());
            file.write_all(bytes)?;
            file.sync_all()
        };
        write().map_err(|error| (path.clone(), error))?;
    }
    let mut named = Partials(Vec::new());
    for (path, _) in files {
        let partial = partial_name(path);
        let linked = match fs::hard_link(&partial, path) {
            Err(error) if error.kind() != io::ErrorKind::AlreadyExists => {
                // A disk without hard links.
                fs::rename(&partial, path)
            }
            linked => linked,
        };
        linked.map_err(|error| (path.clone(), error))?;
        named.0.push(path.clone());
    }
    named.0.clear();
    Ok(())
}

/// Files that are removed when this is dropped.
struct Partials(Vec<PathBuf>);

impl Drop for Partials {
    fn drop(&mut self) {
        for path in &self.0 {
            // Renamed ones no longer exist.
            let _ = fs::remove_file(path);
        }
    }
}

/// Reads a file of at most this many bytes.
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

/// Temporary name used by [`write_whole`] until the file is complete; a killed program leaves it.
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
    fn new_files_are_written_together_or_not_at_all() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        let count = || fs::read_dir(folder.path()).unwrap().count();
        let files = [(at("a.toml"), &b"case"[..]), (at("a-measured.csv"), b"rows")];
        write_new_files(&files).unwrap();
        assert_eq!((fs::read(at("a.toml")).unwrap(), count()), (b"case".to_vec(), 2));
        // The second file exists, and the first is not written either.
        let (path, error) = write_new_files(&[(at("b.toml"), b"x"), files[1].clone()]).unwrap_err();
        assert_eq!((path, error.kind()), (at("a-measured.csv"), io::ErrorKind::AlreadyExists));
        let (path, _) =
            write_new_files(&[(at("c.toml"), b"x"), (at("none/c.csv"), b"y")]).unwrap_err();
        assert_eq!(path, at("none/c.csv"));
        assert_eq!((fs::read(at("a-measured.csv")).unwrap(), count()), (b"rows".to_vec(), 2));
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_device_is_an_error_and_a_link_stays_a_link() {
        let error = write_file(Path::new("/dev/full"), b"bytes").unwrap_err();
        assert_eq!(error.to_string(), "cannot write /dev/full: the disk is full");
        write_file(Path::new("/dev/null"), b"bytes").unwrap();
        let folder = tempfile::tempdir().unwrap();
        let [file, link] = ["file", "link"].map(|name| folder.path().join(name));
        fs::write(&file, "old").unwrap();
        std::os::unix::fs::symlink(&file, &link).unwrap();
        write_file(&link, b"new").unwrap();
        assert_eq!(fs::read_to_string(&file).unwrap(), "new");
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
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
