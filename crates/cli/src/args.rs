//! The command line as the user writes it.

use std::{num::NonZeroUsize, path::PathBuf, time::Duration};

use clap::{Args, Parser, Subcommand, ValueEnum};
use wholestring::well::Interpolation;
use wholestring_case::Override;
use wholestring_runner::{BatchOptions, Existing, Keep, Output, Shard};
use wholestring_units::{Dimension, Unit, UnitSet};

use crate::{calibrate_args::CalibrateArgs, failure::Failure};

/// Torque, drag and dynamics of a whole drill string in a deviated well.
#[derive(Debug, Parser)]
#[command(name = "wholestring", version, max_term_width = 100, after_help = EXIT_STATUS)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Command,
}

const EXIT_STATUS: &str = "\
Exit status: 0 done; 2 bad input; 3 the run failed; 4 an error was found, with --strict; 130 \
interrupted.";

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Is the case sound? One line, or diagnostics
    Check(CheckArgs),
    /// Solve a case and write its results
    Run(RunArgs),
    /// Solve a case for all combinations of some values
    Sweep(SweepArgs),
    /// Try the bit alone on its rock under every weight at every speed
    BitTest(BitTestArgs),
    /// The bottom-hole assembly at rest: side force of the bit, contacts, bending, sag
    Bha(BhaArgs),
    /// Find friction factors and block weight from weights and torques that were read
    Calibrate(CalibrateArgs),
    /// Find natural frequencies, critical speeds and the answer to a force that turns
    Modes(ModesArgs),
    /// Torque and drag at every depth of the bit, with low, expected and high friction
    Plan(PlanArgs),
    /// How far the well can go in its last direction, and what stops it
    Reach(ReachArgs),
    /// Solve the cases of a study and make its figures and tables
    Study(StudyArgs),
    /// Make the page of results again
    Report(ReportArgs),
    /// Draw what results hold as SVG files; a second run on the same axes
    Plot(PlotArgs),
    /// Position and dogleg severity along a survey
    Survey(SurveyArgs),
    /// Measure this machine's speed at this work
    Bench(BenchArgs),
    /// List the pipes, collars and casings that a case can name
    Catalogue(CatalogueArgs),
    /// Write a commented case to begin with
    New(NewArgs),
    /// Print the JSON schema of the case file
    Schema,
    /// Print a script that completes commands and options in a shell
    Completions(CompletionsArgs),
    /// Print the manual page
    Man,
}

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

#[derive(Debug, Args)]
pub(crate) struct CheckArgs {
    #[command(flatten)]
    pub(crate) case: CaseArgs,
}

#[derive(Debug, Args)]
pub(crate) struct RunArgs {
    #[command(flatten)]
    pub(crate) case: CaseArgs,

    // Not a doc comment, which would read `<case name>` as HTML.
    #[arg(
        short,
        long,
        value_name = "DIR",
        help = "Folder for the results [default: out/<case name>]"
    )]
    pub(crate) output: Option<PathBuf>,

    /// Continue with the run in this folder from its checkpoint
    #[arg(long, value_name = "DIR", conflicts_with_all = ["output", "overwrite"])]
    pub(crate) resume: Option<PathBuf>,

    /// Replace what lies in the folder: the results of another case, or an unfinished run
    #[arg(long)]
    pub(crate) overwrite: bool,

    /// Time on the clock between checkpoints, such as 5min [default: the case's, 30 s]
    #[arg(long, value_name = "TIME", value_parser = interval)]
    pub(crate) checkpoint: Option<Duration>,

    /// Run the case again with every element halved, in the folder `halved` beside its results, and
    /// print what that changes
    #[arg(long, conflicts_with_all = ["resume", "json"])]
    pub(crate) converge: bool,

    /// Threads that work on solid rock under the bit; the answer is the same
    /// [default: one per core]
    #[arg(short, long, value_name = "N")]
    pub(crate) jobs: Option<NonZeroUsize>,

    /// Units on the screen [default: the case's]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,

    /// End with status 4 where an error is found in an answer
    #[arg(long)]
    pub(crate) strict: bool,

    /// Write the tables as CSV too
    #[arg(long)]
    pub(crate) csv: bool,

    /// Print the summary as JSON in place of the table
    #[arg(long)]
    pub(crate) json: bool,

    /// Print nothing but errors
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

impl RunArgs {
    /// Where the results go.
    pub(crate) fn output(&self) -> Output {
        Output {
            folder: self.resume.clone().or_else(|| self.output.clone()),
            existing: existing(self.resume.is_some(), self.overwrite),
        }
    }
}

#[derive(Debug, Args)]
pub(crate) struct ReportArgs {
    /// Folder of results
    #[arg(value_name = "DIR")]
    pub(crate) folder: PathBuf,

    /// Units that the page opens with [default: the case's]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,
}

#[derive(Debug, Args)]
pub(crate) struct PlotArgs {
    /// Folder of results, or those of two runs
    #[arg(value_name = "DIR", required = true, num_args = 1..=2)]
    pub(crate) folders: Vec<PathBuf>,

    /// Folder for the pictures [default: plots in the first DIR; of two, plots-SECOND]
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,

    /// Paint each as PNG too, with 300 dots per inch
    #[arg(long)]
    pub(crate) png: bool,

    /// Units on the axes [default: the case's]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,
}

#[derive(Debug, Args)]
pub(crate) struct SweepArgs {
    #[command(flatten)]
    pub(crate) case: CaseArgs,

    /// Values of a key, such as `friction=0.1,0.2,0.3` or `bit_depth=300m..4305m/300m` (a range
    /// always includes its end). Repeatable: every combination is a case, the last key varying
    /// fastest
    #[arg(long, value_name = "KEY=VALUES", required = true)]
    pub(crate) vary: Vec<String>,

    /// End with status 4 where an error is found in an answer
    #[arg(long)]
    pub(crate) strict: bool,

    #[command(flatten)]
    pub(crate) kept: KeptArgs,

    #[command(flatten)]
    pub(crate) batch: BatchArgs,
}

/// What is kept of each case.
#[derive(Debug, Args)]
pub(crate) struct KeptArgs {
    /// What is kept of each case
    /// [default: tables where dynamics solve it, --csv or a figure needs them, else its summary]
    #[arg(long, value_enum, value_name = "WHAT")]
    keep: Option<KeepArg>,
}

/// What is kept of a case, each with what stands before it.
#[derive(Debug, Clone, Copy, ValueEnum)]
enum KeepArg {
    /// Its `summary.json`
    Summary,
    /// Its tables too
    Tables,
    /// All that a run leaves: its page and its picture too
    All,
}

impl KeptArgs {
    /// What they ask to keep, if anything.
    pub(crate) fn keep(&self) -> Option<Keep> {
        self.keep.map(|keep| match keep {
            KeepArg::Summary => Keep::Summary,
            KeepArg::Tables => Keep::Tables,
            KeepArg::All => Keep::All,
        })
    }

    /// Refuses tables as CSV where none are kept.
    pub(crate) fn check(&self, batch: &BatchArgs) -> Result<(), Failure> {
        if batch.csv && self.keep() == Some(Keep::Summary) {
            return Err(Failure::BadInput(
                "error: --csv writes tables, --keep summary keeps none: leave out one of them"
                    .into(),
            ));
        }
        Ok(())
    }
}

#[derive(Debug, Args)]
pub(crate) struct BitTestArgs {
    #[command(flatten)]
    pub(crate) case: CaseArgs,

    /// Units on the screen [default: the case's]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,

    #[command(flatten)]
    pub(crate) batch: BatchArgs,
}

#[derive(Debug, Args)]
pub(crate) struct BhaArgs {
    #[command(flatten)]
    pub(crate) case: CaseArgs,

    /// The operation: drill, slide, trip_out, ... [default: the case's first one that drills]
    #[arg(long, value_name = "KIND")]
    pub(crate) operation: Option<String>,

    /// Tool faces of the bend, such as `90deg` or `0deg..360deg/15deg` (a range always includes its
    /// end) [default: a revolution in steps of 15 deg]
    #[arg(long, value_name = "ANGLES")]
    pub(crate) toolface: Option<String>,

    /// Weights on bit, such as `20kN..120kN/20kN` [default: seven up to 1.5 times the operation's]
    #[arg(long, value_name = "FORCES")]
    pub(crate) weight: Option<String>,

    /// Inclinations of a straight hole, such as `5deg..90deg/5deg` [default: these]
    #[arg(long, value_name = "ANGLES")]
    pub(crate) inclination: Option<String>,

    /// Rate at which the holes of --inclination build down to the bit, such as `2deg/30m`; negative
    /// where they drop [default: 0, straight]
    #[arg(long, value_name = "RATE", allow_hyphen_values = true)]
    pub(crate) build: Option<String>,

    /// Solve the whole string, not only the assembly and 100 m of pipe above it
    #[arg(long)]
    pub(crate) whole: bool,

    /// Points that are solved side by side [default: one per core]
    #[arg(short, long, value_name = "N")]
    pub(crate) jobs: Option<NonZeroUsize>,

    // Not a doc comment, which would read `<case name>` as HTML.
    #[arg(
        short,
        long,
        value_name = "DIR",
        help = "Folder for the results [default: out/<case name> bha]"
    )]
    pub(crate) output: Option<PathBuf>,

    /// Replace what lies in the folder: the results of another case
    #[arg(long)]
    pub(crate) overwrite: bool,

    /// Units on the screen [default: the case's]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,

    /// Write the tables as CSV too
    #[arg(long)]
    pub(crate) csv: bool,

    /// Print nothing but errors
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

impl BhaArgs {
    /// Where the results go.
    pub(crate) fn output(&self) -> Output {
        Output { folder: self.output.clone(), existing: existing(false, self.overwrite) }
    }
}

#[derive(Debug, Args)]
pub(crate) struct ModesArgs {
    #[command(flatten)]
    pub(crate) case: CaseArgs,

    /// Operation whose string at rest it is, such as `drill` [default: the case's first]
    #[arg(long, value_name = "OPERATION")]
    pub(crate) operation: Option<String>,

    // Not a doc comment, which would read `<case name>` as HTML.
    #[arg(
        short,
        long,
        value_name = "DIR",
        help = "Folder for the results [default: out/<case name> modes]"
    )]
    pub(crate) output: Option<PathBuf>,

    /// Replace what lies in the folder
    #[arg(long)]
    pub(crate) overwrite: bool,

    /// Paint each picture as PNG too, with 300 dots per inch
    #[arg(long)]
    pub(crate) png: bool,

    /// Units on the screen and the page [default: the case's]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,

    /// Print nothing but errors
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

#[derive(Debug, Args)]
pub(crate) struct PlanArgs {
    #[command(flatten)]
    pub(crate) case: CaseArgs,

    // Not a doc comment, which would read `<case name>` as HTML.
    #[arg(
        short,
        long,
        value_name = "DIR",
        help = "Folder for the results [default: out/<case name> plan]"
    )]
    pub(crate) output: Option<PathBuf>,

    /// Continue with a plan that was interrupted: leave out what is finished
    #[arg(long)]
    pub(crate) resume: bool,

    /// Replace what lies in the folder: other results, or what was not finished
    #[arg(long, conflicts_with = "resume")]
    pub(crate) overwrite: bool,

    /// What is solved side by side [default: one per core]
    #[arg(short, long, value_name = "N")]
    pub(crate) jobs: Option<NonZeroUsize>,

    /// Time on the clock between checkpoints, such as 5min [default: the case's, 30 s]
    #[arg(long, value_name = "TIME", value_parser = interval)]
    pub(crate) checkpoint: Option<Duration>,

    /// Paint each picture as PNG too, with 300 dots per inch
    #[arg(long)]
    pub(crate) png: bool,

    /// Units on the screen, the page and in the workbook [default: the case's]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,

    /// Print nothing but errors
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

impl PlanArgs {
    /// What becomes of what lies in the folder.
    pub(crate) fn existing(&self) -> Existing {
        existing(self.resume, self.overwrite)
    }
}

#[derive(Debug, Args)]
pub(crate) struct ReachArgs {
    #[command(flatten)]
    pub(crate) case: CaseArgs,

    /// Depth of the bit to begin with, such as `4000m` [default: the end of the survey]
    #[arg(long, value_name = "DEPTH")]
    pub(crate) from: Option<String>,

    /// Deepest bit, such as `12km` [default: 15 km, or twice the first depth where that is deeper]
    #[arg(long, value_name = "DEPTH")]
    pub(crate) to: Option<String>,

    /// Friction factors of all sections, one after the other, such as `0.2,0.3,0.4` [default: the
    /// case's own]
    #[arg(long, value_name = "FACTORS")]
    pub(crate) friction: Option<String>,

    /// Operations, such as `drill,slide` [default: trip_out, rotate_off_bottom, drill, trip_in, slide
    /// and those of the case, as far as it has their set points]
    #[arg(long, value_name = "KINDS")]
    pub(crate) operation: Option<String>,

    /// Leave out the friction of what a helix presses to the wall: nothing locks up
    #[arg(long)]
    pub(crate) no_helix_friction: bool,

    /// Operations that are solved side by side [default: one per core]
    #[arg(short, long, value_name = "N")]
    pub(crate) jobs: Option<NonZeroUsize>,

    // Not a doc comment, which would read `<case name>` as HTML.
    #[arg(
        short,
        long,
        value_name = "DIR",
        help = "Folder for the results [default: out/<case name> reach]"
    )]
    pub(crate) output: Option<PathBuf>,

    /// Replace what lies in the folder
    #[arg(long)]
    pub(crate) overwrite: bool,

    /// Paint the picture as PNG too, with 300 dots per inch
    #[arg(long)]
    pub(crate) png: bool,

    /// Units on the screen and the page [default: the case's]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,

    /// Print nothing but errors
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

#[derive(Debug, Args)]
pub(crate) struct StudyArgs {
    /// Study file
    #[arg(value_name = "STUDY.toml")]
    pub(crate) study: PathBuf,

    /// Set a key of every case, such as `mesh.element_length=1.6m`; short keys: friction,
    /// bit_depth, rpm, wob. Repeatable
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub(crate) overrides: Vec<Override>,

    /// Paint each figure as PNG too, with 300 dots per inch
    #[arg(long)]
    pub(crate) png: bool,

    /// End with status 4 where an error is found in an answer
    #[arg(long)]
    pub(crate) strict: bool,

    #[command(flatten)]
    pub(crate) kept: KeptArgs,

    #[command(flatten)]
    pub(crate) batch: BatchArgs,
}

/// How many cases are solved.
#[derive(Debug, Args)]
pub(crate) struct BatchArgs {
    /// Cases that are solved side by side [default: one per core]
    #[arg(short, long, value_name = "N")]
    pub(crate) jobs: Option<NonZeroUsize>,

    /// Solve the I-th of N equal shares of the cases only
    #[arg(long, value_name = "I/N")]
    pub(crate) shard: Option<Shard>,

    /// Leave out what is finished in the folder, and continue with what is not from its checkpoints
    #[arg(long)]
    pub(crate) resume: bool,

    /// Replace what lies in the folder: the results of other cases, or what was not finished
    #[arg(long, conflicts_with = "resume")]
    pub(crate) overwrite: bool,

    // Not a doc comment, which would read `<case name>` as HTML.
    #[arg(short, long, value_name = "DIR", help = "Folder for the results [default: out/<name>]")]
    pub(crate) output: Option<PathBuf>,

    /// Time on the clock between checkpoints, such as 5min [default: the case's, 30 s]
    #[arg(long, value_name = "TIME", value_parser = interval)]
    pub(crate) checkpoint: Option<Duration>,

    /// Write the tables as CSV too
    #[arg(long)]
    pub(crate) csv: bool,

    /// Print nothing but errors
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

impl BatchArgs {
    /// What they ask for.
    pub(crate) fn options(&self) -> BatchOptions {
        BatchOptions {
            output: Output {
                folder: self.output.clone(),
                existing: existing(self.resume, self.overwrite),
            },
            jobs: self.jobs,
            shard: self.shard.unwrap_or_default(),
            checkpoint_every: self.checkpoint,
            csv: self.csv,
        }
    }
}

/// What becomes of what lies in the folder.
fn existing(resume: bool, overwrite: bool) -> Existing {
    match (resume, overwrite) {
        (true, _) => Existing::Resume,
        (_, true) => Existing::Overwrite,
        _ => Existing::Protect,
    }
}

#[derive(Debug, Args)]
pub(crate) struct SurveyArgs {
    /// Survey: measured depth, inclination, azimuth; CSV or Excel, units in the header or a row of
    /// their own
    #[arg(value_name = "SURVEY.csv")]
    pub(crate) survey: PathBuf,

    /// File for the result [default: the screen]
    #[arg(short, long, value_name = "OUT.csv")]
    pub(crate) output: Option<PathBuf>,

    /// Unit of the lengths in the survey, such as ft, where the file does not tell it
    #[arg(long, value_name = "UNIT", value_parser = length_unit)]
    pub(crate) unit: Option<&'static Unit>,

    /// Curve between the stations
    #[arg(long, value_enum, default_value_t = PathKind::MinimumCurvature)]
    pub(crate) path: PathKind,

    /// A row at every multiple of this length too, such as 10m
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    pub(crate) step: Option<f64>,
}

#[derive(Debug, Args)]
pub(crate) struct CatalogueArgs {
    /// Size, weight, grade, class or kind, such as `5-1/2`, `S-135`, `premium`, `hwdp`, `casing` or
    /// `rig`; what has all of them is listed
    #[arg(value_name = "WORD")]
    pub(crate) words: Vec<String>,

    /// Tubulars of your own, TOML or CSV, as `catalogue` of a case names them
    #[arg(long, value_name = "FILE")]
    pub(crate) with: Option<PathBuf>,

    /// Units of the table [default: si]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,
}

#[derive(Debug, Args)]
pub(crate) struct NewArgs {
    /// Name of the case, whose file is NAME.toml; one that is there is not written over
    #[arg(value_name = "NAME", default_value = "my-well")]
    pub(crate) name: PathBuf,
}

#[derive(Debug, Args)]
pub(crate) struct BenchArgs {
    /// What to measure [default: all but the sweep]
    #[arg(value_enum, value_name = "PART")]
    pub(crate) parts: Vec<BenchPart>,

    /// Set a key of the case that is measured, NP13-X1042. Repeatable
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub(crate) overrides: Vec<Override>,

    /// Measurements of which the median is shown
    #[arg(long, value_name = "N", default_value = "10")]
    pub(crate) repeat: NonZeroUsize,

    /// Write the numbers to this file too
    #[arg(long, value_name = "FILE")]
    pub(crate) json: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct CompletionsArgs {
    /// The shell
    #[arg(value_enum, value_name = "SHELL")]
    pub(crate) shell: clap_complete::Shell,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum BenchPart {
    /// The inner loop with each instruction set, against the processor's peak
    Kernel,
    /// All that a run does, with each instruction set
    Run,
    /// Memory of a run, on Linux
    Memory,
    /// What each mechanism costs when it is switched on
    Mechanisms,
    /// The solid rock under a bit, with each instruction set
    Rock,
    /// 60 cases for each friction law on all cores: minutes
    Sweep,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum PathKind {
    /// Circular arcs, the industry's standard
    MinimumCurvature,
    /// Continuous curvature, as the dynamics need it
    Spline,
}

impl From<PathKind> for Interpolation {
    fn from(kind: PathKind) -> Self {
        match kind {
            PathKind::MinimumCurvature => Self::MinimumCurvature,
            PathKind::Spline => Self::Spline,
        }
    }
}

/// Shortest step between rows: a well of 10 km is ten million rows of a millimetre.
const SHORTEST_STEP_M: f64 = 0.01;

fn interval(text: &str) -> Result<Duration, String> {
    let seconds = Dimension::Time.parse(text).map_err(|error| error.to_string())?;
    if (0.01..=86_400.0).contains(&seconds) {
        Ok(Duration::from_secs_f64(seconds))
    } else {
        Err("expected 0.01 s to 86400 s".to_owned())
    }
}

fn length_unit(text: &str) -> Result<&'static Unit, String> {
    Dimension::Length.find_unit(text).ok_or_else(|| {
        let units = Dimension::Length.units().iter().map(|unit| unit.symbol);
        format!("expected one of {}", units.collect::<Vec<_>>().join(", "))
    })
}

fn length(text: &str) -> Result<f64, String> {
    let length = Dimension::Length.parse(text).map_err(|error| error.to_string())?;
    if length >= SHORTEST_STEP_M && length.is_finite() {
        Ok(length)
    } else {
        Err(format!("expected at least {SHORTEST_STEP_M} m"))
    }
}
