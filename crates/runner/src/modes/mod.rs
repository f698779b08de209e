//! Linear vibration about static equilibrium: natural frequencies, critical speeds and the response
//! to a rotating force.

mod stability;
mod tables;

pub use wholestring_report::stability_sentences;

use std::{num::NonZeroUsize, path::PathBuf, time::Duration};

use wholestring::{
    operation::{Operation, OperationKind},
    statics::soft::{self, SoftSettings},
};
use wholestring_case::Case;
use wholestring_judge::{Disturbed, NoAnswer, Quantity, Rounding};
use wholestring_report::Modes;
use wholestring_results::{
    CriticalSpeed, MODES_VERSION, ModeFound, ModesRows, ModesSummary, Occupant, Spot, Texts, digest,
};
use wholestring_units::{Dimension, UnitSet};
use wholestring_vibration::modal::{
    Campbell, Family, Forcing, ModalError, Mode, Place, SmallMotions,
};

use crate::{
    cancellation::CancellationToken, claim::Claim, clock::Instant, error::Error,
    observer::Observer, output::Output, results_kind::Results,
};

// Request of a linear vibration analysis, and its outcome.

/// Number of rotary speeds of the diagram and of the response to a force.
const SPEEDS: usize = 41;
const ANSWERS: usize = 191;

/// Request to analyse the linear vibration of a case.
#[derive(Debug)]
pub struct Request<'a> {
    /// The case.
    pub case: &'a Case,
    /// The operation whose static equilibrium is used; by default the first of the case.
    pub operation: Option<OperationKind>,
    /// Units of the pictures and the page; by default those of the case.
    pub units: Option<UnitSet>,
    /// Destination of the results.
    pub output: Output,
    /// Whether to also write PNG images.
    pub png: bool,
    /// Number of parallel jobs, a line of the map of torsional stability each; one per core by
    /// default.
    pub jobs: Option<NonZeroUsize>,
}

/// Outcome of a linear vibration analysis.
#[derive(Debug)]
pub struct Outcome {
    /// Results, as in `summary.json`.
    pub summary: ModesSummary,
    /// Folder of the results.
    pub folder: PathBuf,
    /// Wall-clock time, without writing.
    pub took: Duration,
    /// Whether it was interrupted; the summary names the missing parts.
    pub interrupted: bool,
}

/// Analyses the linear vibration of a case, and writes tables, pictures and page. After a
/// cancellation, the results so far are kept once the natural modes are found.
///
/// # Errors
/// An operation that is not in the case, a string without static equilibrium, a folder that cannot
/// take the results, or a cancellation before the natural modes are found.
pub fn run(
    request: &Request<'_>,
    observer: &dyn Observer,
    cancellation: &CancellationToken,
) -> Result<Outcome, Error> {
    let case = request.case;
    let operation = operation(case, request.operation)?;
    let name = format!("{} modes", case.name);
    let occupant = Occupant {
        kind: "modes".into(),
        name,
        identity: digest(&(case.identity(), operation.kind.name(), &case.modes)),
    };
    let claimed = Claim::new(occupant, &request.output, observer).folder()?;
    let folder = &claimed.folder;
    let begun = Instant::now();
    let (mut summary, tables) = find(case, operation, cancellation)?;
    let map = stability::find(case, operation, request.jobs, cancellation);
    let map = match (map, cancellation.is_cancelled()) {
        // The map is incomplete.
        (_, true) => {
            summary.missing.push("the map of torsional stability".to_owned());
            None
        }
        (Ok(found), false) => {
            summary.torsional_stability = Some(found.summary.clone());
            Some(found)
        }
        (Err(reason), false) => {
            summary.no_torsional_stability = Some(reason);
            None
        }
    };
    let took = begun.elapsed();
    tables::write(folder, &summary, &tables)?;
    tables::write_stability(folder, map.as_ref())?;
    let units = request.units.unwrap_or(case.units);
    Modes::gather(folder.path(), Some(units))?.write(folder, request.png)?;
    let interrupted = !summary.missing.is_empty();
    Ok(Outcome { summary, folder: folder.path().to_owned(), took, interrupted })
}

fn operation(case: &Case, kind: Option<OperationKind>) -> Result<&Operation, Error> {
    let named = |operation: &&Operation| kind.is_none_or(|kind| operation.kind == kind);
    case.operations.iter().find(named).ok_or_else(|| {
        let names =
            case.operations.iter().map(|operation| operation.kind.name()).collect::<Vec<_>>();
        let name = kind.map_or("", OperationKind::name);
        Error::BadInput(format!("the case has no operation `{name}`: it has {}", names.join(", ")))
    })
}

fn find(
    case: &Case,
    operation: &Operation,
    cancellation: &CancellationToken,
) -> Result<(ModesSummary, ModesRows), Error> {
    let goes_on = || match cancellation.is_cancelled() {
        true => Err(Error::Interrupted),
        false => Ok(()),
    };
    let options = &case.modes;
    let at_rest = case.dynamics.stiff_string();
    let judge = case.judge(case.units);
    let no_answer = |why: NoAnswer| {
        Error::failed(format!(
            "{}: the string has no answer: {}",
            operation.kind,
            judge.reason(&why)
        ))
    };
    let motions =
        SmallMotions::new(&case.model, operation, &at_rest, &case.dynamics).map_err(|error| {
            match error {
                ModalError::Stiff(error) => no_answer(error.into()),
                error => Error::failed(error),
            }
        })?;
    goes_on()?;
    let assembly = motions.assembly(options.assembly_m);
    let lateral =
        assembly.lateral(0.0, options.count, motions.rotary_rad_per_s()).map_err(Error::failed)?;
    let family = |kind| {
        goes_on()?;
        motions.family(kind, options.count).map_err(Error::failed)
    };
    let others = [family(Family::Axial)?, family(Family::Torsional)?].concat();
    let mut missing = Vec::new();
    let campbell = if cancellation.is_cancelled() {
        missing.push("the Campbell diagram with its critical speeds".to_owned());
        Campbell { rotary_rad_per_s: Vec::new(), branches: Vec::new(), critical: Vec::new() }
    } else {
        let over = speeds(options.rotary_rad_per_s, SPEEDS);
        let found = assembly.campbell(options.count, &others, &over, &options.orders);
        found.map_err(Error::failed)?
    };
    let (forcing, words) = forcing(case, &motions, || assembly.middle_of_longest_span_m());
    let answers = if cancellation.is_cancelled() {
        missing.push("the response to the excitation".to_owned());
        Vec::new()
    } else {
        assembly.respond(forcing, &speeds(options.rotary_rad_per_s, ANSWERS))
    };
    let modes: Vec<Mode> = [lateral, others].concat();
    let mut texts = Texts::default();
    let soft = soft::solve(&case.model, operation, &SoftSettings::default());
    let soft = soft.map_err(|error| no_answer(error.into()))?;
    let disturbed = Disturbed {
        keeps_its_shape: motions.keeps_its_shape(),
        leaves_its_tool_face: motions.leaves_its_tool_face(),
    };
    let summary = ModesSummary {
        schema_version: MODES_VERSION,
        case: case.name.clone(),
        settings: settings(case),
        operation: operation.kind,
        rotary_speed_rad_per_s: motions.rotary_rad_per_s(),
        elements: motions.nodes() - 1,
        stable: motions.is_stable(),
        checks: judge.small_motions(&case.model, operation, &soft, disturbed).checks,
        assembly_length_m: assembly.length_m(),
        forcing: texts.worded(words, case.units),
        modes: found(&modes),
        critical_speeds: critical(&campbell),
        torsional_stability: None,
        no_torsional_stability: None,
        missing,
        texts,
    };
    let rows = ModesRows {
        shapes: tables::shapes(&motions, &summary.modes, &modes, assembly.top_node()),
        campbell: tables::campbell(&campbell),
        response: tables::response(&answers),
    };
    Ok((summary, rows))
}

/// The case's settings, and the settings of the analysis.
fn settings(case: &Case) -> serde_json::Value {
    let mut settings = case.settings.clone();
    settings["modes"] = serde_json::json!(case.modes);
    settings
}

/// `number` speeds over a range.
fn speeds([from, to]: [f64; 2], number: usize) -> Vec<f64> {
    (0..number).map(|k| from + (to - from) * k as f64 / (number - 1) as f64).collect()
}

/// Eccentric masses of the string; without any, the case's force.
fn forcing(case: &Case, motions: &SmallMotions, middle_m: impl Fn() -> f64) -> (Forcing, String) {
    if motions.is_eccentric() {
        return (Forcing::Imbalance, "imbalance of the eccentric components".to_owned());
    }
    let from_bit_m = case.modes.force_from_bit_m.unwrap_or_else(middle_m);
    let force_N = case.modes.force_N;
    let words = format!(
        "a rotating force of {}, {} from the bit",
        Quantity::new(Dimension::Force, force_N, Rounding::Five),
        Quantity::new(Dimension::Length, from_bit_m, Rounding::Tenth)
    );
    (Forcing::Force { force_N, from_bit_m }, words)
}

fn spot(place: &Place) -> Spot {
    Spot { md_m: place.md_m, from_bit_m: place.from_bit_m, component: place.component.clone() }
}

fn found(modes: &[Mode]) -> Vec<ModeFound> {
    let number = |index: usize| {
        let before = modes[..=index].iter();
        before.filter(|before| before.family == modes[index].family).count()
    };
    let found = |(index, mode): (usize, &Mode)| ModeFound {
        family: mode.family.name().to_owned(),
        number: number(index),
        frequency_Hz: mode.frequency_Hz,
        whirl: mode.whirl().map(|whirl| whirl.name().to_owned()),
        precession: mode.precession,
        energy: mode.energy,
        most_strained: spot(&mode.most_strained),
    };
    modes.iter().enumerate().map(found).collect()
}

fn critical(campbell: &Campbell) -> Vec<CriticalSpeed> {
    let critical = campbell.critical.iter().map(|critical| {
        let branch = &campbell.branches[critical.branch];
        CriticalSpeed {
            order: critical.order,
            rotary_speed_rad_per_s: critical.rotary_rad_per_s,
            frequency_Hz: critical.frequency_Hz,
            branch: critical.branch,
            family: branch.family.name().to_owned(),
            number: branch.number,
            most_strained: spot(&critical.most_strained),
        }
    });
    critical.collect()
}
