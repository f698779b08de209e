//! Short runs of every kind, and their files.

use std::{collections::BTreeMap, ffi::OsString, fs, path::Path, process::Command};

use crate::{
    command::{Failure, run},
    folders::root,
};

const RUN: &[&str] = &["run", "cases/np13-x1042.toml", "--csv"];
const SHORT: &[&str] =
    &["--set", "dynamics.settle=1 s", "--set", "dynamics.duration=2 s", "--set", "model=dynamic"];

/// A tenth of a second on rock so coarse that an emulator runs the bit in on it in minutes. It uses
/// one thread, because an emulator makes threads wait for each other.
const ON_ROCK: &[&str] = &[
    "-j",
    "1",
    "--set",
    "model=dynamic",
    "--set",
    "rock.element_size=24 mm",
    "--set",
    "dynamics.settle=0.05 s",
    "--set",
    "dynamics.duration=0.05 s",
];

/// Commands of the runs, by the name of the folder.
const RUNS: &[(&str, &[&[&str]])] = &[
    ("soft", &[RUN, &["--set", "model=soft"]]),
    ("stiff", &[RUN, &["--set", "model=stiff"]]),
    ("dynamic", &[RUN, SHORT, &["--set", "records.spectra=[\"surface_torque\"]"]]),
    ("single", &[RUN, SHORT, &["--set", "dynamics.precision=single"]]),
    ("motor", &[&["run", "cases/bent-motor.toml", "--csv"], SHORT]),
    ("rock", &[&["run", "cases/rock-300.toml", "--csv"], ON_ROCK]),
    ("bha", &[&["bha", "cases/bent-motor.toml"]]),
    ("modes", &[&["modes", "cases/slant.toml"]]),
    ("plan", &[&["plan", "cases/slant.toml"]]),
    ("reach", &[&["reach", "cases/horizontal.toml"]]),
];

/// Files by folder and name.
pub(super) type Numbers = BTreeMap<String, Vec<u8>>;

/// A command of these words in the root of the repository.
pub(super) fn command(words: &[OsString]) -> Command {
    let mut command = Command::new(&words[0]);
    command.current_dir(root()).args(&words[1..]);
    command
}

/// Returns the files of the program, started in this way.
pub(super) fn of(
    folder: &Path,
    started: &dyn Fn(&[OsString]) -> Command,
) -> Result<Numbers, Failure> {
    let failed = |error: std::io::Error| Failure::new(format!("{}: {error}", folder.display()));
    if folder.exists() {
        fs::remove_dir_all(folder).map_err(failed)?;
    }
    let mut found = Numbers::new();
    for (name, words) in RUNS {
        let results = folder.join(name);
        let mut arguments: Vec<OsString> = words.concat().iter().map(OsString::from).collect();
        arguments.extend(["--quiet".into(), "--output".into(), results.clone().into()]);
        run(&mut started(&arguments), "it must run to its end")?;
        for entry in fs::read_dir(&results).map_err(failed)? {
            let path = entry.map_err(failed)?.path();
            let file = path.file_name().unwrap_or_default().to_string_lossy();
            // Pages and pictures are drawn from these.
            if [".csv", ".parquet", ".json"].iter().any(|end| file.ends_with(end)) {
                found.insert(format!("{name}/{file}"), fs::read(&path).map_err(failed)?);
            }
        }
    }
    Ok(found)
}
