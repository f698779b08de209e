//! A job whose inputs are read and whose options are checked.

use std::{
    collections::BTreeMap,
    fmt,
    num::NonZeroUsize,
    path::{Path, PathBuf},
    sync::Arc,
    time::Duration,
};

use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_case::{Case, Override, Report, Template, Variation};
use wholestring_study::Study;
use wholestring_units::UnitSet;

use super::{
    Job,
    files::{CaseInput, DataInput, JobFiles},
    options,
    outcome::JobOutcome,
    work::{CalibrateOptions, Work},
};
use crate::{
    batch::BatchOptions,
    bha, bit_test,
    calibrate::{self, CheckDynamics, Fit},
    cancellation::CancellationToken,
    error::Error,
    keep::Keep,
    modes,
    observer::Observer,
    output::Output,
    plan::{self, Overlay},
    reach, run,
    shard::Shard,
    study, sweep,
};

/// A job whose inputs are read and whose options are checked.
pub struct PreparedJob {
    title: String,
    units: Option<UnitSet>,
    jobs: Option<NonZeroUsize>,
    checkpoint_every: Option<Duration>,
    warnings: Vec<Report>,
    task: Task,
}

impl fmt::Debug for PreparedJob {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.debug_struct("PreparedJob").field("title", &self.title).finish_non_exhaustive()
    }
}

/// A case with the changes that made it.
struct Input {
    file: String,
    template: Arc<Template>,
    changes: Vec<Override>,
    case: Arc<Case>,
}

/// A command with its inputs.
enum Task {
    Run {
        input: Input,
        csv: bool,
    },
    Plan {
        input: Input,
        overlay: Option<Overlay>,
        png: bool,
    },
    Reach {
        input: Input,
        inputs: Reach,
    },
    Bha {
        input: Input,
        operation: Option<OperationKind>,
        whole: bool,
        sweeps: bha::Sweeps,
        csv: bool,
    },
    Modes {
        input: Input,
        operation: Option<OperationKind>,
        png: bool,
    },
    Calibrate {
        inputs: Vec<Input>,
        data: DataInput,
        fit: Fit,
        check: Option<CheckDynamics>,
        png: bool,
    },
    Sweep {
        template: Arc<Template>,
        changes: Vec<Override>,
        variations: Vec<Variation>,
        together: bool,
        keep: Option<Keep>,
        share: Share,
    },
    Study {
        study: Study,
        cases: BTreeMap<String, Arc<Template>>,
        changes: Vec<Override>,
        keep: Option<Keep>,
        png: bool,
        share: Share,
    },
    BitTest {
        input: Input,
        share: Share,
    },
}

/// Depths, friction and operations of a reach.
struct Reach {
    depths_m: [Option<f64>; 2],
    frictions: Vec<f64>,
    operations: Vec<OperationKind>,
    helix_side_force: bool,
    stop_at_helix: bool,
    png: bool,
}

/// Share of the cases, and whether their tables are also CSV.
#[derive(Clone, Copy)]
struct Share {
    shard: Shard,
    csv: bool,
}

impl Share {
    fn read(shard: Option<&String>, csv: bool, keep: Option<Keep>) -> Result<Self, Error> {
        if csv && keep == Some(Keep::Summary) {
            let reason =
                "`csv` writes tables, and `keep = summary` keeps none: leave out one of them";
            return Err(Error::BadInput(reason.to_owned()));
        }
        Ok(Self { shard: options::shard(shard)?, csv })
    }
}

/// Models that replace the case's, as a change of its key.
fn models(kinds: &[ModelKind]) -> Result<Option<Override>, Error> {
    if kinds.is_empty() {
        return Ok(None);
    }
    let names: Vec<String> = kinds.iter().map(|kind| format!("\"{kind}\"")).collect();
    let change = format!("model=[{}]", names.join(", ")).parse();
    change.map(Some).map_err(Error::bad_input)
}

impl PreparedJob {
    pub(super) fn read(job: &Job, files: &dyn JobFiles) -> Result<Self, Error> {
        let Job { case: name, work, set, output: _, units, jobs, checkpoint } = job;
        if checkpoint.is_some() && !work.has_checkpoints() {
            return Err(options::refused("checkpoint", format!("{} writes none", work.command())));
        }
        if units.is_some() && matches!(work, Work::Sweep { .. } | Work::Study { .. }) {
            let reason = format!("a {} uses the units of its cases", work.command());
            return Err(options::refused("units", reason));
        }
        let mut read = Reader { files, set, warnings: Vec::new() };
        let no_case = || Error::BadInput("no case is named".to_owned());
        let name = || name.as_deref().ok_or_else(no_case);
        let task = match work {
            Work::Run { models: kinds, csv } => {
                let input = read.case(name()?, models(kinds)?)?;
                Task::Run { input, csv: *csv }
            }
            Work::Plan { overlay, png } => {
                let overlay =
                    overlay.as_deref().map(|name| files.data(name, "curves")).transpose()?;
                let overlay = overlay
                    .map(|data| Overlay::of_bytes(&data.path.display().to_string(), &data.bytes));
                Task::Plan {
                    input: read.case(name()?, None)?,
                    overlay: overlay.transpose()?,
                    png: *png,
                }
            }
            Work::Reach(options) => {
                let inputs = Reach {
                    depths_m: options::depths(options)?,
                    frictions: options.frictions.clone(),
                    operations: options.operations.clone(),
                    helix_side_force: !options.no_helix_friction,
                    stop_at_helix: options.stop_at_helix,
                    png: options.png,
                };
                Task::Reach { input: read.case(name()?, None)?, inputs }
            }
            Work::Bha(options) => Task::Bha {
                sweeps: options::sweeps(options)?,
                input: read.case(name()?, None)?,
                operation: options.operation,
                whole: options.whole,
                csv: options.csv,
            },
            Work::Modes { operation, png } => {
                Task::Modes { input: read.case(name()?, None)?, operation: *operation, png: *png }
            }
            Work::Calibrate(options) => read.calibration(name()?, options, *jobs)?,
            Work::Sweep { vary, together, keep, shard, csv } => {
                let share = Share::read(shard.as_ref(), *csv, *keep)?;
                let variations = Variation::read_all(vary)?;
                if variations.is_empty() {
                    let reason = "nothing is varied: give a key with its values";
                    return Err(Error::BadInput(reason.to_owned()));
                }
                let CaseInput { template, mut changes, .. } = files.case(name()?)?;
                changes.extend(set.iter().cloned());
                let (together, keep) = (*together, *keep);
                Task::Sweep { template, changes, variations, together, keep, share }
            }
            Work::Study { study: name, keep, shard, csv, png } => {
                let share = Share::read(shard.as_ref(), *csv, *keep)?;
                let study = files.study(name)?;
                let template =
                    |case: &str| Ok((case.to_owned(), Arc::new(files.study_case(name, case)?)));
                let cases = study::case_files(&study).into_iter().map(template);
                let cases = cases.collect::<Result<_, Error>>()?;
                if !study.warnings.is_empty() {
                    read.warnings.push(study.warnings.clone());
                }
                Task::Study { study, cases, changes: set.clone(), keep: *keep, png: *png, share }
            }
            Work::BitTest { shard, csv } => {
                let share = Share::read(shard.as_ref(), *csv, None)?;
                Task::BitTest { input: read.case(name()?, None)?, share }
            }
        };
        Ok(Self {
            title: task.title(),
            units: *units,
            jobs: *jobs,
            checkpoint_every: options::checkpoint_interval(checkpoint.as_ref())?,
            warnings: read.warnings,
            task,
        })
    }

    /// Name of the case or the study.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// Warnings of the inputs.
    pub fn warnings(&self) -> &[Report] {
        &self.warnings
    }

    /// The case; of a calibration the first one, and none for a sweep and a study.
    pub fn case(&self) -> Option<&Case> {
        self.task.input().map(|input| &*input.case)
    }

    /// Units of checks, pages and pictures.
    pub fn units(&self) -> UnitSet {
        self.units.or_else(|| Some(self.case()?.units)).unwrap_or_default()
    }

    /// Reports the warnings of the inputs, and executes the job.
    ///
    /// # Errors
    /// As of [`Self::run`].
    pub fn execute(
        &self,
        output: Output,
        observer: &dyn Observer,
        cancellation: &CancellationToken,
    ) -> Result<JobOutcome, Error> {
        self.warnings.iter().for_each(|report| observer.diagnostics(report));
        self.run(output, observer, cancellation)
    }

    /// Executes the job.
    ///
    /// # Errors
    /// A folder that cannot take the results, work without a solution, or a cancellation before
    /// there are results. Later stops are in the outcome.
    pub fn run(
        &self,
        output: Output,
        observer: &dyn Observer,
        cancellation: &CancellationToken,
    ) -> Result<JobOutcome, Error> {
        let (units, jobs, checkpoint_every) = (self.units, self.jobs, self.checkpoint_every);
        let batch = |output, share: &Share| BatchOptions {
            output,
            jobs,
            shard: share.shard,
            checkpoint_every,
            csv: share.csv,
        };
        Ok(match &self.task {
            Task::Run { input, csv } => {
                let csv = *csv;
                let case = &*input.case;
                let request = run::Request { case, output, units, jobs, checkpoint_every, csv };
                JobOutcome::Run(run::run(&request, observer, cancellation)?)
            }
            Task::Plan { input, overlay, png } => {
                let request = plan::Request {
                    case: &input.case,
                    template: &input.template,
                    overrides: &input.changes,
                    units,
                    output,
                    jobs,
                    checkpoint_every,
                    overlay: overlay.clone(),
                    png: *png,
                };
                JobOutcome::Plan(plan::run(&request, observer, cancellation)?)
            }
            Task::Reach { input, inputs } => {
                let request = reach::Request {
                    case: &input.case,
                    template: &input.template,
                    overrides: &input.changes,
                    from_m: inputs.depths_m[0],
                    to_m: inputs.depths_m[1],
                    frictions: inputs.frictions.clone(),
                    operations: inputs.operations.clone(),
                    helix_side_force: inputs.helix_side_force,
                    stop_at_helix: inputs.stop_at_helix,
                    units,
                    output,
                    png: inputs.png,
                    jobs,
                };
                JobOutcome::Reach(reach::run(&request, observer, cancellation)?)
            }
            Task::Bha { input, operation, whole, sweeps, csv } => {
                let request = bha::Request {
                    case: &input.case,
                    operation: *operation,
                    whole: *whole,
                    sweeps: sweeps.clone(),
                    units,
                    output,
                    csv: *csv,
                    jobs,
                };
                JobOutcome::Bha(bha::run(&request, observer, cancellation)?)
            }
            Task::Modes { input, operation, png } => {
                let (case, operation, png) = (&*input.case, *operation, *png);
                let request = modes::Request { case, operation, units, output, png, jobs };
                JobOutcome::Modes(modes::run(&request, observer, cancellation)?)
            }
            Task::Calibrate { inputs, data, fit, check, png } => {
                let cases = inputs.iter().map(|input| calibrate::NamedCase {
                    file: input.file.clone(),
                    template: &input.template,
                    overrides: &input.changes,
                    case: &input.case,
                });
                let request = calibrate::Request {
                    cases: &cases.collect::<Vec<_>>(),
                    data: &data.path,
                    content: Some(&data.bytes),
                    fit: fit.clone(),
                    check: check.clone(),
                    units,
                    output,
                    png: *png,
                };
                JobOutcome::Calibrate(calibrate::run(&request, observer, cancellation)?)
            }
            Task::Sweep { template, changes, variations, together, keep, share } => {
                let request = sweep::Request {
                    template,
                    overrides: changes,
                    variations,
                    together: *together,
                    keep: *keep,
                    batch: batch(output, share),
                };
                JobOutcome::Sweep(sweep::run(&request, observer, cancellation)?)
            }
            Task::Study { study, cases, changes, keep, png, share } => {
                let request = study::Request {
                    study,
                    cases,
                    overrides: changes,
                    keep: *keep,
                    png: *png,
                    batch: batch(output, share),
                };
                JobOutcome::Study(study::run(&request, observer, cancellation)?)
            }
            Task::BitTest { input, share } => {
                let case = &*input.case;
                let request = bit_test::Request { case, units, batch: batch(output, share) };
                JobOutcome::BitTest(bit_test::run(&request, observer, cancellation)?)
            }
        })
    }
}

impl Task {
    /// Its case; of a calibration the first one.
    fn input(&self) -> Option<&Input> {
        match self {
            Self::Run { input, .. }
            | Self::Plan { input, .. }
            | Self::Reach { input, .. }
            | Self::Bha { input, .. }
            | Self::Modes { input, .. }
            | Self::BitTest { input, .. } => Some(input),
            Self::Calibrate { inputs, .. } => inputs.first(),
            Self::Sweep { .. } | Self::Study { .. } => None,
        }
    }

    /// Name of its case or study; of a sweep, whose case may be valid with its varied values only,
    /// that of the file where the case itself is not.
    fn title(&self) -> String {
        match self {
            Self::Sweep { template, changes, .. } => match template.case(changes) {
                Ok(case) => case.name,
                Err(_) => template.name().to_owned(),
            },
            Self::Study { study, .. } => study.name.clone(),
            _ => self.input().map(|input| input.case.name.clone()).unwrap_or_default(),
        }
    }
}

/// Reads the inputs of a job.
struct Reader<'a> {
    files: &'a dyn JobFiles,
    set: &'a [Override],
    warnings: Vec<Report>,
}

impl Reader<'_> {
    /// A case with its own changes, those of the job and one more.
    fn case(&mut self, name: &Path, more: Option<Override>) -> Result<Input, Error> {
        let CaseInput { file, template, mut changes, case } = self.files.case(name)?;
        let case = case.filter(|_| self.set.is_empty() && more.is_none());
        changes.extend(self.set.iter().cloned().chain(more));
        let case = match case {
            Some(case) => case,
            None => {
                let case = template.case(&changes)?;
                if !case.warnings.is_empty() {
                    self.warnings.push(case.warnings.clone());
                }
                Arc::new(case)
            }
        };
        Ok(Input { file, template, changes, case })
    }

    fn calibration(
        &mut self,
        name: &Path,
        options: &CalibrateOptions,
        jobs: Option<NonZeroUsize>,
    ) -> Result<Task, Error> {
        let (fit, check) = (options::fit(options)?, options::dynamic_check(options, jobs)?);
        let names = std::iter::once(name).chain(options.other_cases.iter().map(PathBuf::as_path));
        let inputs = names.map(|name| self.case(name, None)).collect::<Result<_, _>>()?;
        let data = self.files.data(&options.data, "readings")?;
        Ok(Task::Calibrate { inputs, data, fit, check, png: options.png })
    }
}
