//! Static analysis of the bottom-hole assembly: side force and tilt of the bit, contacts, bending
//! and sag; also at other tool faces, weights and inclinations.

mod points;

pub use points::Sweeps;
pub use wholestring_report::{
    bha_number as number, bha_quantity as quantity, bha_tendency as tendency,
};

use std::{
    f64::consts::TAU,
    num::NonZeroUsize,
    path::{Path, PathBuf},
};

use serde_json::json;
use wholestring::{
    operation::{Operation, OperationKind},
    statics::{
        assembly::{self, Assembly, AssemblyNode, AssemblySettings, Contact, Extent, zeros},
        soft,
    },
};
use wholestring_case::Case;
use wholestring_judge::{Checks, Judge, NoAnswer};
use wholestring_report::{Bha, Plot, bha_html, bha_plots};
use wholestring_results::{
    BHA_VERSION, BhaPart, BhaPoint, BhaState, BhaSummary, BhaVaried, Occupant, ResultsError,
    ResultsFolder, Row as _, bha_table, digest,
};
use wholestring_units::UnitSet;

use self::points::Base;
use crate::{
    cancellation::CancellationToken, claim::Claim, clock::Instant, error::Error,
    observer::Observer, output::Output, page::table, parallel::jobs, results_kind::Results,
};

// Request of a static BHA analysis, and its outcome.

/// Names of the other tables, without their extension.
const CONTACTS: &str = "bha_contacts";
const SWEEP: &str = "bha_sweep";

/// Request to solve the assembly of a case.
#[derive(Debug)]
pub struct Request<'a> {
    /// The case.
    pub case: &'a Case,
    /// The operation; by default the first that drills, or else the first.
    pub operation: Option<OperationKind>,
    /// Whether the whole string is solved instead of the assembly and 100 m of pipe above it.
    pub whole: bool,
    /// Variations.
    pub sweeps: Sweeps,
    /// Units of the pictures and the page; by default those of the case.
    pub units: Option<UnitSet>,
    /// Destination of the results.
    pub output: Output,
    /// Whether to also write the tables as CSV.
    pub csv: bool,
    /// Number of parallel jobs, a point each; one per core by default.
    pub jobs: Option<NonZeroUsize>,
}

impl<'a> Request<'a> {
    /// Request with default options.
    pub fn new(case: &'a Case) -> Self {
        Self {
            case,
            operation: None,
            whole: false,
            sweeps: Sweeps::default(),
            units: None,
            output: Output::default(),
            csv: false,
            jobs: None,
        }
    }
}

/// Outcome of a static BHA analysis.
#[derive(Debug)]
pub struct Outcome {
    /// Results, as in `summary.json`.
    pub summary: BhaSummary,
    /// Folder of the results.
    pub folder: PathBuf,
    /// Wall-clock time of the assembly itself, s, and of everything.
    pub took_s: [f64; 2],
    /// Whether it was interrupted, so that points of a variation are missing.
    pub interrupted: bool,
}

/// The same results in memory.
#[derive(Debug, Clone, PartialEq)]
pub struct AtRest {
    /// Results, as in `summary.json`.
    pub summary: BhaSummary,
    /// Nodes of the solved length, from the bit up.
    pub nodes: Vec<AssemblyNode>,
    /// Wall-clock time of the assembly itself, s.
    pub alone_s: f64,
}

/// Solves the assembly of a case without writing files. If it is cancelled during a variation, the
/// solved points are kept.
///
/// # Errors
/// An operation that is not in the case, a variation that does not apply to the case, an assembly
/// without an equilibrium, or a cancellation before the equilibrium was found.
pub fn at_rest(request: &Request<'_>, cancellation: &CancellationToken) -> Result<AtRest, Error> {
    solve(request, operation(request.case, request.operation)?, cancellation)
}

/// Solves the assembly of a case, and writes its tables, pictures and page. If it is cancelled
/// during a variation, the solved points are kept.
///
/// # Errors
/// An operation that is not in the case, a variation that does not apply to the case, a folder that
/// cannot take the results, an assembly without an equilibrium, or a cancellation before the
/// equilibrium was found.
pub fn run(
    request: &Request<'_>,
    observer: &dyn Observer,
    cancellation: &CancellationToken,
) -> Result<Outcome, Error> {
    let case = request.case;
    let operation = operation(case, request.operation)?;
    let name = format!("{} bha", case.name);
    let occupant = Occupant {
        kind: "assembly".into(),
        name,
        identity: digest(&json!([case.identity(), operation.kind.name()])),
    };
    let claimed = Claim::new(occupant, &request.output, observer).folder()?;
    let start = Instant::now();
    let AtRest { summary, nodes, alone_s } = solve(request, operation, cancellation)?;
    write(&claimed.folder, &summary, &nodes, request)?;
    let units = request.units.unwrap_or(case.units);
    Bha::gather(claimed.folder.path(), Some(units))?.write(&claimed.folder, false)?;
    let took_s = [alone_s, start.elapsed().as_secs_f64()];
    Ok(Outcome {
        interrupted: summary.missing > 0,
        summary,
        folder: claimed.folder.path().to_owned(),
        took_s,
    })
}

fn solve(
    request: &Request<'_>,
    operation: &Operation,
    cancellation: &CancellationToken,
) -> Result<AtRest, Error> {
    let case = request.case;
    let extent = if request.whole { Extent::Whole } else { AssemblySettings::default().extent };
    let settings = AssemblySettings {
        stiff: case.dynamics.stiff_string(),
        extent,
        ..AssemblySettings::default()
    };
    if cancellation.is_cancelled() {
        return Err(Error::Interrupted);
    }
    let start = Instant::now();
    let judge = case.judge(request.units.unwrap_or(case.units));
    let found = assembly::solve(&case.model, operation, &settings).map_err(|error| {
        let reason = judge.reason(&NoAnswer::from(error));
        Error::failed(format!("{}: the assembly has no answer: {reason}", operation.kind))
    })?;
    let alone_s = start.elapsed().as_secs_f64();
    let base = Base {
        model: &case.model,
        operation,
        settings: &AssemblySettings { extent: AssemblySettings::default().extent, ..settings },
        solved_m: found.nodes.last().map_or(0.0, |top| top.from_bit_m),
        units: request.units.unwrap_or(case.units),
        judge: &judge,
        jobs: jobs(request.jobs),
        cancellation,
    };
    let (points, missing) = base.points(&request.sweeps)?;
    let summary = BhaSummary { missing, ..summary(request, operation, &found, points, &judge) };
    Ok(AtRest { summary, nodes: found.nodes, alone_s })
}

fn operation(case: &Case, kind: Option<OperationKind>) -> Result<&Operation, Error> {
    let mut all = case.operations.iter();
    let found = match kind {
        Some(kind) => all.find(|one| one.kind == kind),
        None => all.find(|one| one.kind.on_bottom()).or_else(|| case.operations.first()),
    };
    found.ok_or_else(|| {
        let names: Vec<&str> = case.operations.iter().map(|one| one.kind.name()).collect();
        let kind = kind.map_or("operation", OperationKind::name);
        Error::BadInput(format!("the case has no {kind}: it has {}", names.join(", ")))
    })
}

fn write(
    folder: &ResultsFolder,
    summary: &BhaSummary,
    nodes: &[AssemblyNode],
    request: &Request<'_>,
) -> Result<(), Error> {
    let components = request.case.model.string.components();
    let nodes = bha_table(nodes, |component| &components[component].name);
    folder.write_table(NODES, &nodes, request.csv)?;
    folder.write_table(CONTACTS, &Contact::table(&summary.state.contacts), request.csv)?;
    folder.write_table(SWEEP, &BhaPoint::table(&summary.sweep), request.csv)?;
    summary.write(&folder.path().join("summary.json"))?;
    Ok(())
}

fn summary(
    request: &Request<'_>,
    operation: &Operation,
    found: &Assembly,
    sweep: Vec<BhaPoint>,
    judge: &Judge,
) -> BhaSummary {
    let case = request.case;
    let at_bit = case.model.well.path.at(operation.bit_depth_m);
    let solved_m = found.nodes.last().map_or(0.0, |top| top.from_bit_m);
    let force = |varied: BhaVaried| -> Vec<(f64, [f64; 2])> {
        let points = sweep.iter().filter(|point| point.varied == varied);
        points.filter_map(|point| Some((point.value(), point.found?.side_force_N))).collect()
    };
    let high = |varied: BhaVaried| {
        zeros(&force(varied).iter().map(|(value, force)| (*value, force[0])).collect::<Vec<_>>())
    };
    let soft = soft::solve(&case.model, operation, &case.soft);
    let Checks { checks, unchecked } = judge.assembly(&case.model, operation, found, &soft);
    BhaSummary {
        checks,
        unchecked,
        schema_version: BHA_VERSION,
        case: case.name.clone(),
        settings: case.settings.clone(),
        operation: operation.kind,
        bit_depth_m: operation.bit_depth_m,
        weight_on_bit_N: operation.weight_on_bit_now_N(),
        toolface_rad: case.model.string.toolface_rad(),
        inclination_rad: at_bit.inclination_rad(),
        azimuth_rad: at_bit.azimuth_rad(),
        state: BhaState {
            side_force_N: found.bit_side_force_N,
            tilt_rad: found.bit_tilt_rad,
            length_m: found.length_m,
            solved_m,
            largest_bending_moment_N_m: found.largest_moment_N_m,
            largest_bending_stress_Pa: found.largest_bending_stress_Pa,
            largest_von_mises_stress_Pa: found.largest_von_mises_Pa,
            contacts: found.contacts.clone(),
            sag: found.sag.clone(),
            errors: found.errors,
            elements: found.convergence.elements,
            residual: found.convergence.residual,
            stable: found.convergence.stable,
        },
        parts: parts(case, solved_m),
        build_rate_rad_per_m: request.sweeps.build_rate_rad_per_m,
        mean_side_force_N: mean(&force(BhaVaried::Toolface)),
        holding_inclinations_rad: high(BhaVaried::Inclination),
        holding_weights_N: high(BhaVaried::Weight),
        sweep,
        missing: 0,
    }
}

/// Mean over the tool faces of a whole revolution in equal steps; `None` for any other set of
/// points.
fn mean(points: &[(f64, [f64; 2])]) -> Option<[f64; 2]> {
    let [(first, _), (second, _), .., (last, _)] = points else {
        return None;
    };
    let step = second - first;
    let even = points.windows(2).all(|pair| (pair[1].0 - pair[0].0 - step).abs() < 1e-6);
    let closed = (last - first - TAU).abs() < 1e-6;
    let once = (last + step - first - TAU).abs() < 1e-6;
    if !(even && (closed || once)) {
        return None;
    }
    let points = &points[..points.len() - usize::from(closed)];
    let count = points.len() as f64;
    Some([0, 1].map(|side| points.iter().map(|(_, force)| force[side]).sum::<f64>() / count))
}

fn parts(case: &Case, solved_m: f64) -> Vec<BhaPart> {
    let spans = case.model.string.spans().take_while(|span| span.from_bit_m < solved_m);
    spans
        .map(|span| {
            let component = span.component;
            BhaPart {
                name: component.name.clone(),
                from_bit_m: span.from_bit_m,
                to_bit_m: span.to_bit_m.min(solved_m),
                od_m: component.od_m,
                blades_m: component.blades.map(|blades| [blades.od_m, blades.length_m]),
                joint_od_m: component.joints.map(|joints| joints.od_m),
                bend_m: component.bend.map(|bend| span.from_bit_m + bend.from_lower_end_m),
            }
        })
        .collect()
}

// `report.html` and the pictures of a static BHA analysis, made from the files in its folder.

/// Name of the table of the nodes, which identifies a folder of results.
const NODES: &str = "bha";

/// The picture that is drawn by default.
const VIEWS: &str = "views";

impl Results for Bha {
    const NOUN: &'static str = "a static BHA analysis";
    const TABLE: &'static str = NODES;
    const PICTURES: &'static [&'static str] = &[VIEWS];

    fn check_summary(path: &Path) -> Result<(), ResultsError> {
        BhaSummary::read(path).map(drop)
    }

    fn gather(folder: &Path, units: Option<UnitSet>) -> Result<Self, ResultsError> {
        let summary = BhaSummary::read(&folder.join("summary.json"))?;
        Ok(Self::new(summary, &table(folder, NODES)?, units))
    }

    fn html(&self) -> Option<String> {
        Some(bha_html(self))
    }

    fn plots(&self) -> Vec<Plot> {
        bha_plots(self, &self.head.units)
    }
}
