//! The inputs of a job, read at the time of its request, so that later changes of the files do not
//! affect it.

use std::{collections::BTreeMap, fmt, path::PathBuf, sync::Arc};

use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_case::{Case, Override, Template, Variation, read_values};
use wholestring_runner::{
    Keep,
    bha::Sweeps,
    calibrate::{self, CheckDynamics, Fit},
    plan::Overlay,
    study,
};
use wholestring_units::Dimension;

use super::{
    error::JobError,
    work::{JobRequest, Work},
};
use crate::workspace::Workspace;

/// The inputs of a job.
pub(super) struct Prepared {
    /// Name of the case or the study.
    pub(super) title: String,
    /// Path of its file in the folder.
    pub(super) path: String,
    pub(super) overrides: Vec<Override>,
    pub(super) task: Task,
}

impl fmt::Debug for Prepared {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Prepared").field("path", &self.path).finish_non_exhaustive()
    }
}

/// A command with its inputs.
pub(super) enum Task {
    Run { case: Box<Case>, csv: bool },
    Plan { template: Template, case: Box<Case>, overlay: Option<Overlay> },
    Reach { template: Template, case: Box<Case>, inputs: Box<ReachAsked> },
    Bha { case: Box<Case>, operation: Option<OperationKind>, whole: bool, sweeps: Sweeps },
    Modes { case: Box<Case>, operation: Option<String> },
    Calibrate { template: Template, case: Box<Case>, inputs: Box<CalibrateAsked> },
    Sweep { template: Arc<Template>, variations: Vec<Variation>, keep: Option<Keep> },
    Study { study: wholestring_runner::study::Study, cases: BTreeMap<String, Arc<Template>> },
    BitTest { case: Box<Case> },
}

/// Inputs of a reach.
pub(super) struct ReachAsked {
    pub(super) from_m: Option<f64>,
    pub(super) to_m: Option<f64>,
    pub(super) frictions: Vec<f64>,
    pub(super) operations: Vec<OperationKind>,
    pub(super) helix_side_force: bool,
}

/// Inputs of a calibration.
pub(super) struct CalibrateAsked {
    /// Name of the case file, without its extension.
    pub(super) file: String,
    /// Path of the readings in the folder.
    pub(super) data: PathBuf,
    pub(super) content: Vec<u8>,
    pub(super) fit: Fit,
    pub(super) check: Option<CheckDynamics>,
}

fn bad(message: impl Into<String>) -> JobError {
    JobError::BadInput(message.into())
}

fn operation(name: &str) -> Result<OperationKind, JobError> {
    OperationKind::from_name(name).ok_or_else(|| {
        let names = OperationKind::ALL.map(OperationKind::name).join(", ");
        bad(format!("`{name}` is no operation: expected one of {names}"))
    })
}

/// The single value of an option; none if the option is missing.
fn one(option: &str, text: Option<&str>, dimension: Dimension) -> Result<Option<f64>, JobError> {
    match values(option, text, dimension)?.as_deref() {
        None => Ok(None),
        Some([value]) => Ok(Some(*value)),
        Some(_) => Err(bad(format!("{option} takes one value"))),
    }
}

fn values(
    option: &str,
    text: Option<&str>,
    dimension: Dimension,
) -> Result<Option<Vec<f64>>, JobError> {
    let text = text.map(str::trim).filter(|text| !text.is_empty());
    Ok(text.map(|text| read_values(option, text, dimension)).transpose()?)
}

/// `["soft", "stiff"]`: models that replace the case's.
fn models(names: &[String]) -> Result<Option<Override>, JobError> {
    if names.is_empty() {
        return Ok(None);
    }
    for name in names {
        if ModelKind::named(name).is_none() {
            let known = ModelKind::NAMES.join(", ");
            return Err(bad(format!("`{name}` is no model: expected one of {known}")));
        }
    }
    let names: Vec<String> = names.iter().map(|name| format!("\"{name}\"")).collect();
    let change = format!("model=[{}]", names.join(", ")).parse::<Override>();
    change.map(Some).map_err(|error| bad(error.to_string()))
}

fn keep(word: Option<&str>) -> Result<Option<Keep>, JobError> {
    match word {
        None => Ok(None),
        Some("summary") => Ok(Some(Keep::Summary)),
        Some("tables") => Ok(Some(Keep::Tables)),
        Some("all") => Ok(Some(Keep::All)),
        Some(word) => Err(bad(format!("`{word}` cannot be kept: expected summary, tables or all"))),
    }
}

impl Prepared {
    /// Reads and checks the inputs of a job.
    ///
    /// # Errors
    /// A missing or invalid case or study, and invalid options.
    pub(super) fn of(request: &JobRequest, workspace: &Workspace) -> Result<Self, JobError> {
        let set = request.set.iter().map(|(key, value)| format!("{key}={value}").parse());
        let set = set.map(|set| {
            set.map_err(|error: wholestring_case::OverrideError| bad(error.to_string()))
        });
        let mut overrides: Vec<Override> = set.collect::<Result<_, _>>()?;
        if let Work::Study { study } = &request.work {
            return Self::of_study(study, overrides, workspace);
        }
        let Some(id) = &request.case else { return Err(bad("no case is named")) };
        if let Work::Run { models: names, .. } = &request.work {
            overrides.extend(models(names)?);
        }
        let file = workspace.case(id)?;
        let text = file.read()?.text;
        let template = Template::with_files(&file.shown, &text, workspace.own_beside(&file.path));
        let case = Box::new(template.case(&overrides)?);
        let title = case.name.clone();
        let task = match &request.work {
            Work::Run { csv, .. } => Task::Run { case, csv: *csv },
            Work::Plan { overlay } => {
                let overlay = overlay.as_ref().map(|id| overlay_of(id, workspace)).transpose()?;
                Task::Plan { template, case, overlay }
            }
            Work::Reach { from, to, frictions, operations, no_helix_friction } => {
                let operations = operations.iter().map(|name| operation(name));
                let inputs = ReachAsked {
                    from_m: one("from", from.as_deref(), Dimension::Length)?,
                    to_m: one("to", to.as_deref(), Dimension::Length)?,
                    frictions: frictions.clone(),
                    operations: operations.collect::<Result<_, _>>()?,
                    helix_side_force: !no_helix_friction,
                };
                Task::Reach { template, case, inputs: Box::new(inputs) }
            }
            Work::Bha { operation: name, whole, toolface, weight, inclination, build } => {
                let sweeps = Sweeps {
                    toolfaces_rad: values("toolface", toolface.as_deref(), Dimension::Angle)?,
                    weights_N: values("weight", weight.as_deref(), Dimension::Force)?,
                    inclinations_rad: values(
                        "inclination",
                        inclination.as_deref(),
                        Dimension::Angle,
                    )?,
                    build_rate_rad_per_m: one(
                        "build",
                        build.as_deref(),
                        Dimension::DoglegSeverity,
                    )?
                    .unwrap_or(0.0),
                };
                let operation = name.as_deref().map(operation).transpose()?;
                Task::Bha { case, operation, whole: *whole, sweeps }
            }
            Work::Modes { operation } => Task::Modes { case, operation: operation.clone() },
            Work::Calibrate { .. } => {
                let stem = file.path.file_stem().unwrap_or_default().to_string_lossy();
                let inputs = calibration(&request.work, &stem, workspace)?;
                Task::Calibrate { template, case, inputs: Box::new(inputs) }
            }
            Work::Sweep { vary, keep: word } => {
                let variations = Variation::read_all(vary)?;
                if variations.is_empty() {
                    return Err(bad("nothing is varied: give a key with its values"));
                }
                let keep = keep(word.as_deref())?;
                Task::Sweep { template: Arc::new(template), variations, keep }
            }
            Work::BitTest {} => Task::BitTest { case },
            Work::Study { .. } => return Err(bad("a study names its own cases")),
        };
        Ok(Self { title, path: file.shown, overrides, task })
    }

    fn of_study(
        id: &str,
        overrides: Vec<Override>,
        workspace: &Workspace,
    ) -> Result<Self, JobError> {
        let file = Workspace::one_of(workspace.studies(), id, "study")?;
        let study = study::parse(&file.shown, &file.read()?)?;
        let folder = file.path.parent().unwrap_or(workspace.root());
        let template = |name: &str| {
            let path = workspace.inside(&folder.join(name));
            let path = path.map_err(|error| bad(format!("the case `{name}`: {error}")))?;
            let bytes = wholestring_case::read_file(&path);
            let bytes = bytes.map_err(|error| bad(format!("the case `{name}`: {error}")))?;
            let text = String::from_utf8_lossy(&bytes);
            let files = workspace.own_beside(&path);
            Ok((name.to_owned(), Arc::new(Template::with_files(name, &text, files))))
        };
        let cases = study::case_files(&study).into_iter().map(template);
        let cases = cases.collect::<Result<_, JobError>>()?;
        let (title, path) = (study.name.clone(), file.shown);
        Ok(Self { title, path, overrides, task: Task::Study { study, cases } })
    }
}

fn overlay_of(id: &str, workspace: &Workspace) -> Result<Overlay, JobError> {
    let file = Workspace::one_of(workspace.readings(), id, "file of readings")?;
    let overlay = Overlay::of_bytes(&file.shown, &file.read()?);
    overlay.map_err(|error| bad(error.to_string()))
}

fn calibration(work: &Work, stem: &str, workspace: &Workspace) -> Result<CalibrateAsked, JobError> {
    let Work::Calibrate {
        data,
        one_factor,
        by_section,
        friction_around,
        block_weight,
        bit_torque,
        hold,
        model,
        check_dynamics,
    } = work
    else {
        return Err(bad("it is no calibration"));
    };
    let file = Workspace::one_of(workspace.readings(), data, "file of readings")?;
    let held = hold.iter().map(|text| calibrate::option::held(text));
    let model = match model.as_deref() {
        None | Some("soft") => ModelKind::Soft,
        Some("stiff") => ModelKind::Stiff,
        Some(name) => {
            return Err(bad(format!("`{name}` makes no predictions: expected soft or stiff")));
        }
    };
    Ok(CalibrateAsked {
        file: stem.to_owned(),
        data: PathBuf::from(&file.shown),
        content: file.read()?,
        fit: Fit {
            one_factor: *one_factor,
            by_section: *by_section,
            friction_around: *friction_around,
            block_weight: *block_weight,
            bit_torque: *bit_torque,
            hold: held.collect::<Result<_, _>>().map_err(bad)?,
            errors: [None; 3],
            outlier_beyond: 3.0,
            without_outliers: false,
            band_confidence: 0.9,
            model,
        },
        check: check_dynamics.then(|| CheckDynamics { bit_depths_m: Vec::new(), jobs: None }),
    })
}
