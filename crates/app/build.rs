//! Lists the files of the bundle, each to be embedded.

use std::{env, fs, io, path::Path};

fn main() -> io::Result<()> {
    let assets = Path::new(&env::var("CARGO_MANIFEST_DIR").unwrap_or_default()).join("assets");
    println!("cargo::rerun-if-changed={}", assets.display());
    let mut files =
        fs::read_dir(&assets)?.map(|entry| Ok(entry?.path())).collect::<io::Result<Vec<_>>>()?;
    files.sort();
    let lines = files.iter().filter(|path| path.is_file()).filter_map(|path| {
        let name = path.file_name()?.to_str()?;
        Some(format!("({name:?}, include_bytes!({:?})),\n", path.to_str()?))
    });
    let list = format!("&[\n{}]\n", lines.collect::<String>());
    fs::write(Path::new(&env::var("OUT_DIR").unwrap_or_default()).join("assets.rs"), list)
}
