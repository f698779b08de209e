//! `wholestring run`: solves a case, prints one table and writes the results.

use std::{
    path::{Path, PathBuf},
    time::Instant,
};

use wholestring::{
    dynamics::Simulation,
    operation::Operation,
    outcome::ModelKind,
    statics::soft::{self, SoftSettings},
};
use wholestring_case::Case;
use wholestring_results::{ResultsFolder, Status};

use crate::{
    args::RunArgs,
    comparison,
    failure::Failure,
    frames::Frames,
    indicators,
    interrupt::Interrupt,
    load,
    progress::Progress,
    record::{self, Record},
    rig, say,
};

pub(crate) fn run(args: &RunArgs) -> Result<(), Failure> {
    let case = load(&args.case, args.quiet)?;
    let units = args.units.unwrap_or(case.units);
    let output = args
        .output
        .clone()
        .unwrap_or_else(|| default_output(&case.name));
    // Before anything is solved, so that a long run does not end on a folder it may not write to.
    let folder = ResultsFolder::create(output)?;
    let interrupt = Interrupt::listen();
    let mut record = Record::new(&case, units);
    record.frames = Frames::begin(&case, &folder)?;
    let solved = solve(&case, args, &interrupt, &mut record, &folder);
    // However it ended: an interrupted run keeps the frames that it has.
    let frames = record.frames.take().map_or(Ok(()), Frames::finish);
    if !args.quiet && !record.summary.operations.is_empty() {
        let width = terminal_size::terminal_size().map(|(width, _)| usize::from(width.0));
        let title = format!("{}: {}", case.name, record::subtitle(&case, units));
        let table = comparison::table(&record.summary, units, width);
        let notes = comparison::notes(&record.summary);
        let indicators = indicators::notes(&record.summary, units);
        let warnings = rig::warnings(&record.summary, &case.model.rig, units);
        let place = folder.path().display();
        say(&format!(
            "{title}

{table}
{notes}{indicators}{warnings}Results in {place}
"
        ))?;
    }
    solved?;
    Ok(frames?)
}

/// Solves operation after operation, each with every model, and writes after each, so that whatever
/// comes between keeps what was solved.
fn solve(
    case: &Case,
    args: &RunArgs,
    interrupt: &Interrupt,
    record: &mut Record,
    folder: &ResultsFolder,
) -> Result<(), Failure> {
    for operation in &case.operations {
        for model in &case.models {
            if interrupt.asked() {
                return Err(interrupted(folder.path()));
            }
            let stopped = match model {
                ModelKind::Soft => solve_soft(case, operation, record),
                ModelKind::Dynamic => solve_dynamic(case, operation, args.quiet, interrupt, record),
            };
            record.write(folder, args.csv)?;
            match stopped {
                Status::Complete => {}
                Status::Interrupted => return Err(interrupted(folder.path())),
                Status::Failed(reason) => {
                    return Err(Failure::Failed(format!(
                        "error: {}: {reason}\nwhat was computed until then is in {}",
                        operation.kind.name(),
                        folder.path().display()
                    )));
                }
            }
        }
    }
    Ok(())
}

fn solve_soft(case: &Case, operation: &Operation, record: &mut Record) -> Status {
    match soft::solve(&case.model, operation, &SoftSettings::default()) {
        Ok(profile) => {
            record.add_soft(operation, &profile);
            Status::Complete
        }
        Err(error) => unsolvable("soft string", &error),
    }
}

/// Simulated time between two looks at Ctrl-C and two movements of the progress bar, s: a fraction of
/// a second even where a run is slower than real time.
const LOOK_INTERVAL_S: f64 = 0.2;

fn solve_dynamic(
    case: &Case,
    operation: &Operation,
    quiet: bool,
    interrupt: &Interrupt,
    record: &mut Record,
) -> Status {
    let start = Instant::now();
    let mut simulation = match Simulation::new(&case.model, operation, &case.dynamics) {
        Ok(simulation) => simulation,
        Err(error) => return unsolvable("dynamic model", &error),
    };
    // Laying the string takes seconds. Whoever has asked by now has nothing of this operation to keep.
    if interrupt.asked() {
        return Status::Interrupted;
    }
    let end_s = simulation.end_time_s();
    let progress = Progress::new(operation.kind.name(), end_s, quiet);
    // The run goes on by whole samples.
    let sample_s = simulation.sample_interval_s();
    let enough_s = end_s - 0.5 * sample_s;
    let frame_samples = record
        .frames
        .as_ref()
        .map(|frames| frames.samples(sample_s));
    let look_samples = ((LOOK_INTERVAL_S / sample_s).round() as u64).max(1);
    let mut samples = 0;
    let status = loop {
        let time_s = simulation.time_s();
        progress.reach(time_s);
        if time_s >= enough_s {
            break Status::Complete;
        }
        if interrupt.asked() {
            break Status::Interrupted;
        }
        let missing = ((end_s - time_s) / sample_s).round() as u64;
        let to_frame = frame_samples.map_or(u64::MAX, |every| every - samples % every);
        let next = look_samples.min(missing.max(1)).min(to_frame);
        if let Err(diverged) = simulation.advance(next as f64 * sample_s) {
            break Status::Failed(diverged.to_string());
        }
        samples += next;
        if next == to_frame
            && let Some(frames) = &mut record.frames
            && let Err(error) = frames.take(operation, &simulation)
        {
            break Status::Failed(error.to_string());
        }
    };
    progress.finish();
    record.add_dynamic(
        operation,
        &simulation.outcome(),
        status.clone(),
        start.elapsed(),
    );
    status
}

fn unsolvable(model: &str, error: &dyn std::error::Error) -> Status {
    Status::Failed(format!("the {model} has no answer: {error}"))
}

fn interrupted(folder: &Path) -> Failure {
    Failure::Interrupted(format!(
        "interrupted: what was computed is in {}",
        folder.display()
    ))
}

/// `out/<case name>`, without what some system does not take in a file's name.
fn default_output(name: &str) -> PathBuf {
    const LONGEST: usize = 100;
    let sound: String = name
        .chars()
        .map(|letter| match letter {
            '<' | '>' | ':' | '"' | '/' | '\\' | '|' | '?' | '*' => '-',
            letter if letter.is_control() => '-',
            letter => letter,
        })
        .take(LONGEST)
        .collect();
    // Windows drops dots and blanks at the end, and `.` and `..` are folders already.
    let mut folder = sound.trim_start().trim_end_matches(['.', ' ']).to_owned();
    if folder.is_empty() || is_device(&folder) {
        folder.insert(0, '_');
    }
    Path::new("out").join(folder)
}

/// Whether Windows takes the name for a device, whatever follows its first dot.
fn is_device(name: &str) -> bool {
    let stem = name
        .split('.')
        .next()
        .unwrap_or(name)
        .trim_end()
        .to_ascii_uppercase();
    let numbered = |prefix: &str| {
        stem.strip_prefix(prefix)
            .is_some_and(|rest| rest.len() == 1 && rest.bytes().all(|byte| byte.is_ascii_digit()))
    };
    matches!(stem.as_str(), "CON" | "PRN" | "AUX" | "NUL") || numbered("COM") || numbered("LPT")
}

#[cfg(test)]
mod tests {
    use wholestring_units::UnitSet;

    use super::*;

    /// A model that the CLI's own test data describe.
    fn slant() -> Case {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/slant.toml");
        wholestring_case::load(&path, &[]).expect("a sound case")
    }

    #[test]
    fn who_interrupts_the_laying_does_not_wait_for_the_run() {
        let case = slant();
        let mut record = Record::new(&case, UnitSet::Si);
        let status = solve_dynamic(
            &case,
            &case.operations[0],
            true,
            &Interrupt::already_asked(),
            &mut record,
        );
        assert_eq!(status, Status::Interrupted);
        assert!(record.summary.operations.is_empty());
    }

    /// An operation without an answer ends like one that diverged: what was solved before is kept, and
    /// the message says where.
    #[test]
    fn an_operation_without_answer_keeps_what_was_solved() {
        let mut case = slant();
        // Deeper than the string is long, which no case file gets past its checks.
        case.operations[1].bit_depth_m += 100.0;
        let place = std::env::temp_dir().join(format!("wholestring-{}", std::process::id()));
        let folder = ResultsFolder::create(&place).expect("a folder");
        for (model, kept) in [(ModelKind::Soft, 1), (ModelKind::Dynamic, 0)] {
            case.models = vec![model];
            // What an earlier run left does not pass for this one's.
            if model == ModelKind::Dynamic {
                case.operations.remove(0);
            }
            let mut record = Record::new(&case, UnitSet::Si);
            let asked = Interrupt::never();
            let failure = solve(&case, &arguments(), &asked, &mut record, &folder).unwrap_err();
            assert_eq!(failure.status(), 3);
            let message = failure.to_string();
            assert!(message.contains("has no answer: "), "{message}");
            let end = format!("what was computed until then is in {}", place.display());
            assert!(message.ends_with(&end), "{message}");
            let summary = place.join("summary.json");
            let summary = wholestring_results::Summary::read(&summary).expect("a summary");
            assert_eq!(summary.operations.len(), kept);
        }
        std::fs::remove_dir_all(&place).expect("our own folder");
    }

    fn arguments() -> RunArgs {
        RunArgs {
            case: crate::args::CaseArgs {
                case: "slant.toml".into(),
                overrides: Vec::new(),
            },
            output: None,
            units: None,
            csv: false,
            quiet: true,
        }
    }

    #[test]
    fn case_names_make_folders_on_every_system() {
        for (name, folder) in [
            ("NP13-X1042 at total depth", "NP13-X1042 at total depth"),
            ("a/b\\c: 12-1/4\" <x>", "a-b-c- 12-1-4- -x-"),
            ("..", "_"),
            ("", "_"),
            (" well. ", "well"),
            ("nul", "_nul"),
            ("Com1.5 m", "_Com1.5 m"),
            ("common", "common"),
            ("Bohrung Süd\n", "Bohrung Süd-"),
        ] {
            assert_eq!(
                default_output(name),
                Path::new("out").join(folder),
                "{name}"
            );
        }
        assert_eq!(default_output(&"é".repeat(500)).as_os_str().len(), 4 + 200);
    }
}
