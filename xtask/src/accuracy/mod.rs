//! Errors of the accuracies of the automatic mesh: runs of several cases compared with converged
//! ones, as a table.

mod cases;
mod table;

use std::{
    env, fs,
    path::{Path, PathBuf},
    process::{Command, Stdio},
    sync::Mutex,
    thread,
};

use serde_json::Value;

use self::cases::{CASES, Case, MESHES, Mesh, RINGING};
use crate::{
    book,
    command::{Failure, cargo, printed, run},
    finding::Finding,
    folders::{root, target},
};

const PAGE: &str = "docs/src/theory/mesh.md";
const NAME: &str = "accuracy";

/// A run of a case: mesh and seed.
struct Run {
    mesh: &'static Mesh,
    seed: u32,
    folder: PathBuf,
}

/// Measures and prints all cases, or those whose titles contain one of the words; on request writes
/// the table of all into the book.
pub(crate) fn measure(write: bool, words: &[&str]) -> Result<Finding, Failure> {
    if let Some(option) = words.iter().find(|word| word.starts_with('-')) {
        return Err(Failure::new(format!("`{option}` is not known: see `cargo xtask --help`")));
    }
    let chosen = |title: &str| words.is_empty() || words.iter().any(|word| title.contains(word));
    run(
        cargo().args(["build", "--release", "--quiet", "--package", "wholestring-cli"]).args([
            "--bin",
            "wholestring",
            "--example",
            "natural_frequencies",
        ]),
        "wholestring must compile",
    )?;
    let mut text = table::head();
    for case in CASES.iter().filter(|case| chosen(case.title)) {
        println!("{}", case.title);
        text += &table::rows(case, &solved(case)?)?;
    }
    if words.is_empty() {
        let answers: Result<Vec<Value>, _> = MESHES.iter().map(frequencies).collect();
        text += &table::frequency_rows(&answers?)?;
    }
    println!("\n{text}");
    if write {
        book::write(&root().join(PAGE), NAME, &text)?;
    }
    Ok(Finding::Done)
}

/// Results of the runs of a case, for each mesh and each seed; as many in parallel as there are
/// cores.
fn solved(case: &Case) -> Result<Vec<Vec<Value>>, Failure> {
    let folder = target().join(NAME);
    let number = CASES.iter().position(|one| one.title == case.title).unwrap_or_default();
    let runs = MESHES.iter().enumerate().flat_map(|(mesh_number, mesh)| {
        let folder = &folder;
        (1..=case.seeds).map(move |seed| {
            let folder = folder.join(format!("{number}-{mesh_number}-{seed}"));
            Run { mesh, seed, folder }
        })
    });
    let runs: Vec<Run> = runs.collect();
    let waiting = Mutex::new(runs.iter());
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let work = || loop {
        let next = waiting.lock().map_or(None, |mut left| left.next());
        let Some(one) = next else {
            return Ok(());
        };
        solve(case, one)?;
    };
    thread::scope(|scope| {
        // If the system refuses a thread, the existing ones do all of the work.
        let begin = |_| thread::Builder::new().spawn_scoped(scope, work).ok();
        let workers: Vec<_> = (1..cores).map_while(begin).collect();
        let own = work();
        let others = workers.into_iter().map(|one| one.join().expect("solving does not panic"));
        others.fold(own, |all, one| all.and(one))
    })?;
    let answers: Result<Vec<Value>, Failure> = runs.iter().map(|one| answer(&one.folder)).collect();
    Ok(answers?.chunks(case.seeds as usize).map(<[Value]>::to_vec).collect())
}

fn solve(case: &Case, one: &Run) -> Result<(), Failure> {
    let program = target().join(format!("release/wholestring{}", env::consts::EXE_SUFFIX));
    let mut command = Command::new(program);
    command.current_dir(root()).args(["run", case.file, "--quiet", "--overwrite", "-o"]);
    command.arg(&one.folder).stdout(Stdio::null());
    for setting in case.settings.iter().chain(one.mesh.settings) {
        command.args(["--set", setting]);
    }
    command.args(["--set", &format!("dynamics.seed={}", one.seed)]);
    run(&mut command, "the case must run")
}

/// The operation's part of the summary that a run left.
fn answer(folder: &Path) -> Result<Value, Failure> {
    let path = folder.join("summary.json");
    let failed = |reason: String| Failure::new(format!("{}: {reason}", path.display()));
    let text = fs::read_to_string(&path).map_err(|error| failed(error.to_string()))?;
    let summary: Value = serde_json::from_str(&text).map_err(|error| failed(error.to_string()))?;
    let operations = summary["operations"].as_array();
    let dynamic = operations.and_then(|all| all.iter().find(|one| one["model"] == "dynamic"));
    dynamic.cloned().ok_or_else(|| failed("it has no dynamic run".to_owned()))
}

/// Natural frequencies of a mesh.
fn frequencies(mesh: &Mesh) -> Result<Value, Failure> {
    let name = format!("release/examples/natural_frequencies{}", env::consts::EXE_SUFFIX);
    let mut command = Command::new(target().join(name));
    command.current_dir(root()).arg(RINGING.file).args(RINGING.settings).args(mesh.settings);
    serde_json::from_str(&printed(&mut command, "it must give its frequencies")?)
        .map_err(|error| Failure::new(format!("{command:?}: {error}")))
}

/// Checks that the table in the book has the cases, quantities and meshes that the command would
/// write, and that their files exist. Its numbers are those of the machine that made it.
pub(crate) fn check_table() -> Result<Finding, Failure> {
    if let Some(case) = CASES.iter().find(|case| !root().join(case.file).is_file()) {
        return Err(Failure::new(format!("{} is not there", case.file)));
    }
    let page = root().join(PAGE);
    let text = fs::read_to_string(&page)
        .map_err(|error| Failure::new(format!("{}: {error}", page.display())))?;
    let [_, written, _] = book::parts(&text, NAME)?;
    table::check(written)?;
    Ok(Finding::Done)
}
