//! `wholestring sweep` and `wholestring study`: many cases in one command.

use std::path::PathBuf;

use clap::Args;
use wholestring_case::Override;
use wholestring_runner::job::{Job, StudyOptions, SweepOptions, Varied, Work};

use crate::shared_args::{BatchArgs, CaseArgs, KeptArgs};

#[derive(Debug, Args)]
pub(crate) struct SweepArgs {
    #[command(flatten)]
    pub(crate) case: CaseArgs,

    /// Values of a key, such as `friction=0.1,0.2,0.3` or `bit_depth=300m..4305m/300m` (a range
    /// always includes its end). Repeatable: every combination is a case, the last key varying
    /// fastest
    #[arg(long, value_name = "KEY=VALUES", required = true)]
    vary: Vec<String>,

    /// Exit with status 4 if a check of the results is an error
    #[arg(long)]
    pub(crate) strict: bool,

    #[command(flatten)]
    kept: KeptArgs,

    #[command(flatten)]
    pub(crate) batch: BatchArgs,
}

impl SweepArgs {
    /// The job of these arguments.
    pub(crate) fn job(&self) -> Job {
        let work = Work::Sweep(SweepOptions {
            vary: self.vary.iter().cloned().map(Varied::Text).collect(),
            together: false,
            cases: self.kept.of_cases(&self.batch),
        });
        self.batch.applied_to(self.case.job(work))
    }
}

// `wholestring study`: solves the cases of a study, and writes its figures and tables.

#[derive(Debug, Args)]
pub(crate) struct StudyArgs {
    /// Study file
    #[arg(value_name = "STUDY.toml")]
    pub(crate) study: PathBuf,

    /// Set a key of every case, such as `mesh.element_length=1.6m`; short keys: friction,
    /// bit_depth, rpm, wob. Repeatable
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub(crate) overrides: Vec<Override>,

    /// Also write PNG images, with 300 dots per inch
    #[arg(long)]
    pub(crate) png: bool,

    /// Exit with status 4 if a check of the results is an error
    #[arg(long)]
    pub(crate) strict: bool,

    #[command(flatten)]
    kept: KeptArgs,

    #[command(flatten)]
    pub(crate) batch: BatchArgs,
}

impl StudyArgs {
    /// The job of these arguments.
    pub(crate) fn job(&self) -> Job {
        let work = Work::Study(StudyOptions {
            study: self.study.clone(),
            cases: self.kept.of_cases(&self.batch),
            png: self.png,
        });
        self.batch.applied_to(Job { set: self.overrides.clone(), ..Job::new(None, work) })
    }
}
