//! A digest of the engine's sources, which distinguishes checkpoints of two builds of one version.

use std::{
    env, fs, io,
    path::{Path, PathBuf},
};

fn main() -> io::Result<()> {
    println!("cargo:rerun-if-changed=build.rs");
    let mut named: Vec<(String, PathBuf)> = Vec::new();
    for (crate_name, folder) in folders() {
        println!("cargo:rerun-if-changed={}", folder.display());
        let mut files = Vec::new();
        gather(&folder, &mut files)?;
        let names =
            files.into_iter().map(|path| (crate_name.to_owned() + &name(&folder, &path), path));
        named.extend(names);
    }
    named.sort();
    let mut digest = Digest::new();
    for (name, path) in named {
        digest.add(name.as_bytes());
        digest.add(&fs::read(path)?);
    }
    println!("cargo:rustc-env=WHOLESTRING_ENGINE_BUILD={:016x}", digest.0);
    Ok(())
}

/// Folders of the engine's sources, with the names of their crates. The crates below this one name
/// theirs in their build scripts.
fn folders() -> [(&'static str, PathBuf); 3] {
    let folder = |variable: &str| env::var_os(variable).map(PathBuf::from).unwrap_or_default();
    [
        ("core/", folder("CARGO_MANIFEST_DIR").join("src")),
        ("numbers/", folder("DEP_WHOLESTRING_NUMBERS_SOURCES")),
        ("rock/", folder("DEP_WHOLESTRING_ROCK_SOURCES")),
    ]
}

/// Sources below a folder; tests do not change what the engine computes.
fn gather(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let is_test = path.file_stem().is_some_and(|stem| stem == "tests");
        if is_test {
            continue;
        } else if path.is_dir() {
            gather(&path, files)?;
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    Ok(())
}

/// The same on every system.
fn name(root: &Path, path: &Path) -> String {
    let inside = path.strip_prefix(root).unwrap_or(path);
    let parts = inside.components().map(|part| part.as_os_str().to_string_lossy().into_owned());
    parts.collect::<Vec<_>>().join("/")
}

/// FNV-1a of 64 bits, whatever the ends of lines.
struct Digest(u64);

impl Digest {
    fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    fn add(&mut self, bytes: &[u8]) {
        for byte in bytes.iter().filter(|byte| **byte != b'\r') {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }
}
