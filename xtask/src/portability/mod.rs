//! The program on other systems and processors: checks that its tests pass there, and that its
//! numbers equal those of this machine.

mod compare;
mod numbers;
mod systems;
mod windows;

use crate::{
    command::{Failure, cargo, program, run, run_counted},
    count::Count,
    finding::Finding,
    folders::target,
};
use systems::{SYSTEMS, System};

/// Variable with the command that the command-line tests start instead of the program that was
/// built with them: one word per line.
const IN_ITS_PLACE: &str = "WHOLESTRING_IN_ITS_PLACE";

/// Tests systems by name, or all of them.
pub(crate) fn try_out(names: &[&str]) -> Result<Finding, Failure> {
    let known = || SYSTEMS.iter().map(|system| system.name).collect::<Vec<_>>().join(", ");
    let named = |name: &&str| {
        let found = SYSTEMS.iter().find(|system| system.name == *name);
        found.ok_or_else(|| Failure::new(format!("`{name}` is not one of {}", known())))
    };
    let systems: Vec<&System> = match names {
        [] => SYSTEMS.iter().collect(),
        _ => names.iter().map(named).collect::<Result<_, _>>()?,
    };
    for system in &systems {
        let lacking = system.lacking();
        if !lacking.is_empty() {
            let first = format!("{} cannot be tried here:", system.name);
            return Err(Failure::new(format!("{first}\n  {}", lacking.join("\n  "))));
        }
    }
    let native = program("--bin", "wholestring")?;
    let folder = target().join("portability");
    let here = numbers::of(&folder.join("here"), &|arguments| {
        let mut command = numbers::command(&[native.get_program().into()]);
        command.args(arguments);
        command
    })?;
    let (mut count, mut wrong) = (Count::default(), Vec::new());
    for system in systems {
        println!("{}: {}", system.name, system.about);
        match tried(system, &here, native.get_program()) {
            Ok(tests) => count += tests,
            Err(failure) => {
                println!("{}: {}", system.name, failure.reason);
                count += failure.count;
                wrong.push(system.name);
            }
        }
    }
    match wrong.is_empty() {
        true => Ok(Finding::Tested(count)),
        false => Err(Failure { reason: format!("not as here: {}", wrong.join(", ")), count }),
    }
}

/// Builds for a system, compares its numbers, and runs the command-line tests there.
fn tried(
    system: &System,
    here: &numbers::Numbers,
    native: &std::ffi::OsStr,
) -> Result<Count, Failure> {
    let folder = target().join("portability").join(system.name);
    let program = match system.target {
        None => native.into(),
        Some(triple) => {
            let mut build = cargo();
            build.args([
                "build",
                "--quiet",
                "--workspace",
                "--bin",
                "wholestring",
                "--target",
                triple,
            ]);
            run(build.envs(system.building()), "the program must compile for the system")?;
            target().join(triple).join("debug").join(system.file_name())
        }
    };
    if system.is_windows() {
        windows::prepare(&windows::prefix())?;
    }
    let mut words = system.runner();
    words.push(program.into());
    let there = numbers::of(&folder, &|arguments| {
        let mut command = numbers::command(&words);
        command.envs(system.running()).args(arguments);
        command
    })?;
    if !compare::report(here, &there, system.may_differ) {
        return Err(Failure::new("its numbers differ from those of this machine"));
    }
    if !system.is_tested {
        return Ok(Count::default());
    }
    let mut test = cargo();
    test.args(["test", "--workspace", "--test", "cli", "--no-fail-fast"]);
    if system.is_windows() {
        // Tests and program both run on the system: files, signals and clocks behave as they do
        // there.
        test.args(["--target", system.target.unwrap_or_default()]);
        test.envs(system.building()).envs(system.running());
    } else {
        let line = words.iter().map(|word| word.to_string_lossy()).collect::<Vec<_>>().join("\n");
        test.env(IN_ITS_PLACE, line);
        // They are benchmarks, and query this processor's features.
        test.args(["--", "--skip", "bench::"]);
    }
    run_counted(&mut test)
}
