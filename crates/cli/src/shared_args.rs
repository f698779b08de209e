//! Arguments that several commands share.

use std::{num::NonZeroUsize, path::PathBuf};

use clap::{Args, ValueEnum};
use wholestring_case::Override;
use wholestring_runner::{
    Existing, Keep, Output,
    job::{CasesOptions, Job, Work},
};
use wholestring_units::UnitSet;

// A case, and overrides of its keys on the command line.

#[derive(Debug, Args)]
pub(crate) struct CaseArgs {
    /// Case file
    #[arg(value_name = "CASE.toml")]
    pub(crate) case: PathBuf,

    /// Set a key of the case, such as `well.hole.0.friction=0.1`; short keys: friction, bit_depth,
    /// rpm, wob. Repeatable
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub(crate) overrides: Vec<Override>,
}

impl CaseArgs {
    /// A job for the case, with default settings.
    pub(crate) fn job(&self, work: Work) -> Job {
        Job { set: self.overrides.clone(), ..Job::new(Some(self.case.clone()), work) }
    }
}

// Output folder of commands that write their results in one step.

#[derive(Debug, Args)]
pub(crate) struct OutputArgs {
    /// Folder for the results [default: depends on the command]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,

    /// Overwrite existing results in the folder
    #[arg(long)]
    overwrite: bool,
}

impl OutputArgs {
    /// The destination of these arguments.
    pub(crate) fn output(&self) -> Output {
        output(self.output.as_ref(), false, self.overwrite)
    }
}

/// A folder for results, with the treatment of existing results in it.
pub(crate) fn output(folder: Option<&PathBuf>, resume: bool, overwrite: bool) -> Output {
    let existing = match (resume, overwrite) {
        (true, _) => Existing::Resume,
        (_, true) => Existing::Overwrite,
        _ => Existing::Protect,
    };
    Output { folder: folder.cloned(), existing, ..Output::default() }
}

// Batches of cases or points, and their output folder.

/// Arguments of a batch of cases.
#[derive(Debug, Args)]
pub(crate) struct BatchArgs {
    /// Number of parallel jobs, a case each [default: one per core]
    #[arg(short, long, value_name = "N")]
    pub(crate) jobs: Option<NonZeroUsize>,

    /// Solve only the I-th of N equal shares of the cases
    #[arg(long, value_name = "I/N")]
    pub(crate) shard: Option<String>,

    /// Skip the finished cases in the folder and continue unfinished ones from their checkpoints
    #[arg(long)]
    pub(crate) resume: bool,

    /// Overwrite existing results in the folder: other cases or unfinished ones
    #[arg(long, conflicts_with = "resume")]
    pub(crate) overwrite: bool,

    // Not a doc comment, which would read `<case name>` as HTML.
    #[arg(short, long, value_name = "DIR", help = "Folder for the results [default: out/<name>]")]
    pub(crate) output: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) checkpoint: CheckpointArgs,

    /// Also write the tables as CSV
    #[arg(long)]
    pub(crate) csv: bool,

    /// Print nothing but errors
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

impl BatchArgs {
    /// The job with the settings of these arguments.
    pub(crate) fn applied_to(&self, job: Job) -> Job {
        Job {
            output: output(self.output.as_ref(), self.resume, self.overwrite),
            jobs: self.jobs,
            checkpoint: self.checkpoint.every.clone(),
            ..job
        }
    }

    /// Options of the screen.
    pub(crate) fn screen(&self, strict: bool) -> ScreenOptions {
        ScreenOptions { quiet: self.quiet, strict, json: false }
    }
}

// Results to keep of each of many cases.

/// Results to keep of each case.
#[derive(Debug, Args)]
pub(crate) struct KeptArgs {
    /// Results to keep of each case [default: tables for the dynamic model, for --csv and where a
    /// figure needs them; otherwise the summary]
    #[arg(long, value_enum, value_name = "WHAT")]
    keep: Option<KeepArg>,
}

/// Results to keep of a case; each level includes the preceding ones.
#[derive(Debug, Clone, Copy, ValueEnum)]
enum KeepArg {
    /// `summary.json`
    Summary,
    /// Tables in addition.
    Tables,
    /// All results of a run, including the page and the picture.
    All,
}

impl KeptArgs {
    /// The options of the cases of a batch.
    pub(crate) fn of_cases(&self, batch: &BatchArgs) -> CasesOptions {
        let keep = self.keep.map(|keep| match keep {
            KeepArg::Summary => Keep::Summary,
            KeepArg::Tables => Keep::Tables,
            KeepArg::All => Keep::All,
        });
        CasesOptions { keep, shard: batch.shard.clone(), csv: batch.csv }
    }
}

// Interval between checkpoints.

#[derive(Debug, Args)]
pub(crate) struct CheckpointArgs {
    /// Wall-clock time between checkpoints, such as 5min [default: the case's, 30 s]
    #[arg(long = "checkpoint", value_name = "TIME")]
    pub(crate) every: Option<String>,
}

// Arguments of commands that write a page.

#[derive(Debug, Args)]
pub(crate) struct PageArgs {
    /// Also write PNG images, with 300 dots per inch
    #[arg(long)]
    pub(crate) png: bool,

    /// Units on the screen and the page [default: the case's]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,

    /// Print nothing but errors
    #[arg(short, long)]
    pub(crate) quiet: bool,

    /// Exit with status 4 if a check of the results is an error
    #[arg(long)]
    pub(crate) strict: bool,
}

impl PageArgs {
    /// Options of the screen.
    pub(crate) fn screen(&self) -> ScreenOptions {
        ScreenOptions { quiet: self.quiet, strict: self.strict, json: false }
    }
}

// Options of the screen.

/// Options of the screen.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct ScreenOptions {
    /// Prints nothing but errors.
    pub(crate) quiet: bool,
    /// Fails if a check of the results is an error.
    pub(crate) strict: bool,
    /// Prints the summary of a run as JSON in place of the table.
    pub(crate) json: bool,
}
