//! A folder for what the measurements write.

use std::{
    env, fs, io,
    path::{Path, PathBuf},
    process,
};

/// A folder that goes with this value.
pub(crate) struct Scratch(PathBuf);

impl Scratch {
    /// A new one among the system's temporary files.
    pub(crate) fn new() -> io::Result<Self> {
        let path = env::temp_dir().join(format!("wholestring-bench-{}", process::id()));
        fs::create_dir(&path)?;
        Ok(Self(path))
    }

    pub(crate) fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        // What cannot be removed stays among the temporary files.
        let _ = fs::remove_dir_all(&self.0);
    }
}
