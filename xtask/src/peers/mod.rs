//! The same work in wholestring and in alternative programs, one after the other on one core, as
//! two tables.

mod tables;

use std::{
    env, fs,
    path::{Path, PathBuf},
    process::Command,
};

use serde_json::Value;

use crate::{
    book,
    command::{Failure, cargo, printed, run},
    finding::Finding,
    folders::{root, target},
    python,
};

/// Oldest Python for which all of the pinned packages are available.
const OLDEST: &str = "3.11";
const FOLDER: &str = "benchmarks/peers";
const REQUIREMENTS: &str = "benchmarks/peers/requirements.txt";
const PAGE: &str = "docs/src/speed.md";
/// Whether all pinned packages are installed in their versions.
const CHECK: &str = "
from importlib.metadata import version
for line in open('benchmarks/peers/requirements.txt'):
    name, pinned = line.strip().split('==')
    assert version(name) == pinned
";
/// Number of runs of each program, in turn; the shortest time counts, because disturbances only add
/// time.
const REPEATS: usize = 3;
/// Scripts of the dynamics; the others are compared with the first.
const DYNAMICS: [&[&str]; 4] = [
    &["wholestring_run.py"],
    &["pyelastica_rod.py", "--inertia", "raised"],
    &["pyelastica_rod.py"],
    &["exudyn_beams.py"],
];

/// Measures and prints; on request writes the tables into the book.
pub(crate) fn side_by_side(write: bool) -> Result<Finding, Failure> {
    let Some(python) = python::python(OLDEST) else {
        return Err(Failure::new(format!("there is no Python {OLDEST} or newer here")));
    };
    let folder = target().join("peers");
    let python = python::environment(python, &folder, CHECK, &["-r", REQUIREMENTS]);
    let python = python.ok_or_else(|| {
        Failure::new(format!("`pip install -r {REQUIREMENTS}` fails in {}", folder.display()))
    })?;
    run(
        cargo().args(["build", "--release", "--quiet", "--package", "wholestring-cli"]),
        "wholestring must compile",
    )?;
    let dynamics = tables::dynamics(&dynamics(&python)?)?;
    let bench = ["bench", "--quiet", "--package", "wholestring", "--bench", "soft_string"];
    let ours = answer(cargo().args(bench))?;
    let theirs = answer(&mut script(&python, &["welleng_soft_string.py"]))?;
    let statics = tables::statics(&ours, &theirs)?;
    let text = format!("On one core of {}.\n\n{dynamics}\n{statics}", processor());
    println!("\n{text}");
    if write {
        book::write(&root().join(PAGE), "peers", &text)?;
    }
    Ok(Finding::Done)
}

/// The report of each program's script, from its quickest run.
fn dynamics(python: &Path) -> Result<Vec<Value>, Failure> {
    let program = target().join(format!("release/wholestring{}", env::consts::EXE_SUFFIX));
    let mut quickest: Vec<Option<Value>> = vec![None; DYNAMICS.len()];
    for turn in 1..=REPEATS {
        for (words, least) in DYNAMICS.iter().zip(&mut quickest) {
            println!("[{turn}/{REPEATS}] {}", words.join(" "));
            let mut script = script(python, words);
            if words[0].starts_with("wholestring") {
                script.arg(&program);
            }
            let measured = answer(&mut script)?;
            let cpu_s = |measured: &Value| measured["cpu_s"].as_f64().unwrap_or(f64::INFINITY);
            if least.as_ref().is_none_or(|least| cpu_s(&measured) < cpu_s(least)) {
                *least = Some(measured);
            }
        }
    }
    Ok(quickest.into_iter().flatten().collect())
}

/// A script of the benchmark, on one thread regardless of its libraries' defaults.
fn script(python: &Path, words: &[&str]) -> Command {
    let mut command = Command::new(python);
    let path = PathBuf::from(FOLDER).join(words[0]);
    command.current_dir(root()).arg(path).args(&words[1..]);
    // Their compiled caches are stored in the build folder.
    command.env("NUMBA_CACHE_DIR", absolute(&target()).join("peers/numba"));
    command.env("PYTHONDONTWRITEBYTECODE", "1");
    for name in ["OMP_NUM_THREADS", "NUMBA_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"]
    {
        command.env(name, "1");
    }
    command
}

fn absolute(path: &Path) -> PathBuf {
    path.canonicalize().unwrap_or_else(|_| path.to_path_buf())
}

/// The last line that a program prints, as JSON.
fn answer(command: &mut Command) -> Result<Value, Failure> {
    let name = format!("{command:?}");
    let text = printed(command, "it must give its answer")?;
    let line = text.lines().rfind(|line| line.starts_with('{')).unwrap_or_default();
    serde_json::from_str(line).map_err(|error| Failure::new(format!("{name}: {error}: {line}")))
}

/// The system's name of the processor.
fn processor() -> String {
    let listed = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = listed.lines().find_map(|line| line.strip_prefix("model name")?.split(':').nth(1));
    let name = name.map_or_else(|| env::consts::ARCH.to_owned(), |name| name.trim().to_owned());
    let wide = if listed.contains("avx512f") { ", with AVX-512" } else { "" };
    format!("{name}{wide}")
}
