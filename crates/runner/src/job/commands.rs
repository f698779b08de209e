//! The nine commands: their inputs and options once read, each is ready to be executed.

use std::{collections::BTreeMap, num::NonZeroUsize, path::Path, sync::Arc, time::Duration};

use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_case::{Case, Override, Template, Variation};
use wholestring_units::UnitSet;

use super::{
    files::CaseInput,
    input::{Input, Reader},
    options,
    outcome::JobOutcome,
    work::{BhaOptions, CalibrateOptions, CasesOptions, ReachOptions, StudyOptions, SweepOptions},
};
use crate::{
    batch::BatchOptions, bha as assembly, bit_test as bit, calibrate as calibration,
    cancellation::CancellationToken, error::Error, keep::Keep, modes as vibration,
    observer::Observer, output::Output, plan as planning, reach as reaching, run as running,
    shard::Shard, study as studies, sweep as sweeping,
};

/// Executes a command.
pub(super) type Execute = Box<
    dyn Fn(Output, &dyn Observer, &CancellationToken) -> Result<JobOutcome, Error> + Send + Sync,
>;

/// A command that is ready to be executed.
pub(super) struct Ready {
    /// Name of the case or the study.
    pub(super) title: String,
    pub(super) case: Option<Arc<Case>>,
    pub(super) execute: Execute,
}

impl Ready {
    fn of_case(case: &Arc<Case>, execute: Execute) -> Self {
        Self { title: case.name.clone(), case: Some(case.clone()), execute }
    }
}

/// Settings of all commands.
#[derive(Clone, Copy)]
pub(super) struct Settings {
    pub(super) units: Option<UnitSet>,
    pub(super) jobs: Option<NonZeroUsize>,
    pub(super) checkpoint_every: Option<Duration>,
}

/// Share of the cases, and whether their tables are also CSV.
#[derive(Clone, Copy)]
struct Share {
    shard: Shard,
    csv: bool,
}

impl Share {
    fn read(options: &CasesOptions) -> Result<Self, Error> {
        if options.csv && options.keep == Some(Keep::Summary) {
            let reason =
                "`csv` writes tables, and `keep = summary` keeps none: leave out one of them";
            return Err(Error::BadInput(reason.to_owned()));
        }
        Ok(Self { shard: options::shard(options.shard.as_ref())?, csv: options.csv })
    }

    fn batch(self, output: Output, settings: Settings) -> BatchOptions {
        let Settings { jobs, checkpoint_every, .. } = settings;
        BatchOptions { output, jobs, shard: self.shard, checkpoint_every, csv: self.csv }
    }
}

pub(super) fn run(
    reader: &mut Reader<'_>,
    case: &Path,
    models: &[ModelKind],
    csv: bool,
    settings: Settings,
) -> Result<Ready, Error> {
    let Input { case, .. } = reader.case(case, models_key(models)?)?;
    let Settings { units, jobs, checkpoint_every } = settings;
    Ok(Ready::of_case(
        &case.clone(),
        Box::new(move |output, observer, token| {
            let case = &*case;
            let request = running::Request { case, output, units, jobs, checkpoint_every, csv };
            Ok(JobOutcome::Run(running::run(&request, observer, token)?))
        }),
    ))
}

/// Models that replace the case's, as a change of its key.
fn models_key(kinds: &[ModelKind]) -> Result<Option<Override>, Error> {
    if kinds.is_empty() {
        return Ok(None);
    }
    let names: Vec<String> = kinds.iter().map(|kind| format!("\"{kind}\"")).collect();
    let change = format!("model=[{}]", names.join(", ")).parse();
    change.map(Some).map_err(Error::bad_input)
}

pub(super) fn plan(
    reader: &mut Reader<'_>,
    case: &Path,
    overlay: Option<&Path>,
    png: bool,
    settings: Settings,
) -> Result<Ready, Error> {
    let overlay = overlay.map(|name| reader.files.data(name, "curves")).transpose()?;
    let overlay = overlay
        .map(|data| planning::Overlay::of_bytes(&data.path.display().to_string(), &data.bytes));
    let overlay = overlay.transpose()?;
    let Input { template, changes, case, .. } = reader.case(case, None)?;
    let Settings { units, jobs, checkpoint_every } = settings;
    Ok(Ready::of_case(
        &case.clone(),
        Box::new(move |output, observer, token| {
            let request = planning::Request {
                case: &case,
                template: &template,
                overrides: &changes,
                units,
                output,
                jobs,
                checkpoint_every,
                overlay: overlay.clone(),
                png,
            };
            Ok(JobOutcome::Plan(Box::new(planning::run(&request, observer, token)?)))
        }),
    ))
}

pub(super) fn reach(
    reader: &mut Reader<'_>,
    case: &Path,
    options: &ReachOptions,
    settings: Settings,
) -> Result<Ready, Error> {
    let [from_m, to_m] = options::depths(options)?;
    let options = options.clone();
    let Input { template, changes, case, .. } = reader.case(case, None)?;
    let Settings { units, jobs, .. } = settings;
    Ok(Ready::of_case(
        &case.clone(),
        Box::new(move |output, observer, token| {
            let request = reaching::Request {
                case: &case,
                template: &template,
                overrides: &changes,
                from_m,
                to_m,
                frictions: options.frictions.clone(),
                operations: options.operations.clone(),
                helix_side_force: !options.no_helix_friction,
                stop_at_helix: options.stop_at_helix,
                units,
                output,
                png: options.png,
                jobs,
            };
            Ok(JobOutcome::Reach(reaching::run(&request, observer, token)?))
        }),
    ))
}

pub(super) fn bha(
    reader: &mut Reader<'_>,
    case: &Path,
    options: &BhaOptions,
    settings: Settings,
) -> Result<Ready, Error> {
    let sweeps = options::sweeps(options)?;
    let (operation, whole, csv) = (options.operation, options.whole, options.csv);
    let Input { case, .. } = reader.case(case, None)?;
    let Settings { units, jobs, .. } = settings;
    Ok(Ready::of_case(
        &case.clone(),
        Box::new(move |output, observer, token| {
            let (case, sweeps) = (&*case, sweeps.clone());
            let request =
                assembly::Request { case, operation, whole, sweeps, units, output, csv, jobs };
            Ok(JobOutcome::Bha(assembly::run(&request, observer, token)?))
        }),
    ))
}

pub(super) fn modes(
    reader: &mut Reader<'_>,
    case: &Path,
    operation: Option<OperationKind>,
    png: bool,
    settings: Settings,
) -> Result<Ready, Error> {
    let Input { case, .. } = reader.case(case, None)?;
    let Settings { units, jobs, .. } = settings;
    Ok(Ready::of_case(
        &case.clone(),
        Box::new(move |output, observer, token| {
            let case = &*case;
            let request = vibration::Request { case, operation, units, output, png, jobs };
            Ok(JobOutcome::Modes(vibration::run(&request, observer, token)?))
        }),
    ))
}

pub(super) fn calibrate(
    reader: &mut Reader<'_>,
    case: &Path,
    options: &CalibrateOptions,
    settings: Settings,
) -> Result<Ready, Error> {
    let fit = options::fit(options)?;
    let check = options::dynamic_check(options, settings.jobs)?;
    let others = options.other_cases.iter().map(|case| reader.case(case, None));
    let others: Vec<Input> = others.collect::<Result<_, Error>>()?;
    let first = reader.case(case, None)?;
    let data = reader.files.data(&options.data, "readings")?;
    let (units, png) = (settings.units, options.png);
    Ok(Ready::of_case(
        &first.case.clone(),
        Box::new(move |output, observer, token| {
            let inputs = std::iter::once(&first).chain(&others);
            let cases = inputs.map(|input| calibration::NamedCase {
                file: input.file.clone(),
                template: &input.template,
                overrides: &input.changes,
                case: &input.case,
            });
            let request = calibration::Request {
                cases: &cases.collect::<Vec<_>>(),
                data: &data.path,
                content: Some(&data.bytes),
                fit: fit.clone(),
                check: check.clone(),
                units,
                output,
                png,
            };
            Ok(JobOutcome::Calibrate(calibration::run(&request, observer, token)?))
        }),
    ))
}

/// The inputs of a sweep.
pub(super) struct SweepInput {
    template: Arc<Template>,
    changes: Vec<Override>,
    variations: Vec<Variation>,
    together: bool,
    keep: Option<Keep>,
    share: Share,
    settings: Settings,
}

impl SweepInput {
    pub(super) fn read(
        reader: &Reader<'_>,
        case: &Path,
        options: &SweepOptions,
        settings: Settings,
    ) -> Result<Self, Error> {
        let share = Share::read(&options.cases)?;
        let variations = options::variations(&options.vary)?;
        let (together, keep) = (options.together, options.cases.keep);
        let CaseInput { template, mut changes, .. } = reader.files.case(case)?;
        changes.extend(reader.set.iter().cloned());
        Ok(Self { template, changes, variations, together, keep, share, settings })
    }

    pub(super) fn request(&self, output: Output) -> sweeping::Request<'_> {
        sweeping::Request {
            template: &self.template,
            overrides: &self.changes,
            variations: &self.variations,
            together: self.together,
            keep: self.keep,
            batch: self.share.batch(output, self.settings),
        }
    }
}

pub(super) fn sweep(
    reader: &mut Reader<'_>,
    case: &Path,
    options: &SweepOptions,
    settings: Settings,
) -> Result<Ready, Error> {
    let sweep = SweepInput::read(reader, case, options, settings)?;
    // The case itself may be valid with the varied values only.
    let title = sweep.template.case(&sweep.changes);
    let title = title.map_or_else(|_| sweep.template.name().to_owned(), |case| case.name);
    let execute: Execute = Box::new(move |output, observer, token| {
        Ok(JobOutcome::Sweep(sweeping::run(&sweep.request(output), observer, token)?))
    });
    Ok(Ready { title, case: None, execute })
}

pub(super) fn study(
    reader: &mut Reader<'_>,
    options: &StudyOptions,
    settings: Settings,
) -> Result<Ready, Error> {
    let share = Share::read(&options.cases)?;
    let (keep, png) = (options.cases.keep, options.png);
    let study = reader.files.study(&options.study)?;
    if !study.warnings.is_empty() {
        reader.warnings.push(study.warnings.clone());
    }
    let read = |name: &str| -> Result<(String, Arc<Template>), Error> {
        let template = reader.files.study_case(&options.study, name)?;
        Ok((name.to_owned(), Arc::new(template)))
    };
    let cases = studies::case_files(&study).into_iter().map(read);
    let cases: BTreeMap<_, _> = cases.collect::<Result<_, Error>>()?;
    let overrides = reader.set.to_vec();
    let title = study.name.clone();
    let execute: Execute = Box::new(move |output, observer, token| {
        let request = studies::Request {
            study: &study,
            cases: &cases,
            overrides: &overrides,
            keep,
            png,
            batch: share.batch(output, settings),
        };
        Ok(JobOutcome::Study(studies::run(&request, observer, token)?))
    });
    Ok(Ready { title, case: None, execute })
}

pub(super) fn bit_test(
    reader: &mut Reader<'_>,
    case: &Path,
    shard: Option<&String>,
    csv: bool,
    settings: Settings,
) -> Result<Ready, Error> {
    let share = Share { shard: options::shard(shard)?, csv };
    let Input { case, .. } = reader.case(case, None)?;
    let units = settings.units;
    Ok(Ready::of_case(
        &case.clone(),
        Box::new(move |output, observer, token| {
            let batch = share.batch(output, settings);
            let request = bit::Request { case: &case, units, batch };
            Ok(JobOutcome::BitTest(bit::run(&request, observer, token)?))
        }),
    ))
}
