//! The pictures of a run, of two on the same axes, of a sweep, of a bit test, or of small motions.

use std::path::{Path, PathBuf};

use wholestring_report::{
    Plot, Report, Run, Spectrum, bha_plots, bit_test_plots, calibration_plots, common_operations,
    modes_plots, plan_plots, plots, reach_plots, sweep_plots,
};
use wholestring_results::Summary;
use wholestring_units::UnitSet;

use crate::{
    bha::page as bha,
    bit_test::page as bit_test,
    calibrate::page as calibrate,
    error::Error,
    folder_name::file_name,
    modes::page as modes,
    page::{Tables, gather, lacking, spectra::spectra, table},
    plan::page as plan,
    reach::page as reach,
    results_kind::ResultsKind,
    sweep::page as sweep,
};

/// Draws what lies in a folder, or two runs on the same axes, in these units or the case's.
///
/// # Errors
/// Folders whose results cannot be drawn, or not together.
pub fn pictures(folders: &[PathBuf], units: Option<UnitSet>) -> Result<Vec<Plot>, Error> {
    let are_sweeps = sweeps(folders);
    let are_modes = folders.iter().any(|of| modes::is_modes(of));
    let are_bit_tests = folders.iter().any(|of| bit_test::is_bit_test(of));
    let plots = match (folders, &are_sweeps[..]) {
        ([folder], _) if are_bit_tests => {
            let test = bit_test::gather(folder, units).map_err(bad)?;
            bit_test_plots(&test, &test.head.units)
        }
        ([folder], _) if are_modes => {
            let found = modes::gather(folder, units).map_err(bad)?;
            modes_plots(&found, &found.head.units)
        }
        ([folder], _) if calibrate::is_calibration(folder) => {
            let found = calibrate::gather(folder, units).map_err(bad)?;
            calibration_plots(&found, &found.head.units)
        }
        _ if folders.iter().any(|of| calibrate::is_calibration(of)) => {
            return Err(bad("a calibration cannot be overlaid with anything"));
        }
        _ if are_modes => return Err(bad("modes cannot be overlaid with anything")),
        _ if are_bit_tests => {
            return Err(bad("a bit test cannot be overlaid with anything"));
        }
        ([folder], _) if bha::is_bha(folder) => {
            let found = bha::gather(folder, units).map_err(bad)?;
            bha_plots(&found, &found.head.units)
        }
        _ if folders.iter().any(|of| bha::is_bha(of)) => {
            return Err(bad("an assembly at rest cannot be overlaid with anything"));
        }
        ([folder], _) if plan::is_plan(folder) => {
            let found = plan::gather(folder, units).map_err(bad)?;
            plan_plots(&found, &found.head.units)
        }
        _ if folders.iter().any(|of| plan::is_plan(of)) => {
            return Err(bad("a plan cannot be overlaid with anything"));
        }
        ([folder], _) if reach::is_reach(folder) => {
            let found = reach::gather(folder, units).map_err(bad)?;
            reach_plots(&found, &found.head.units)
        }
        _ if folders.iter().any(|of| reach::is_reach(of)) => {
            return Err(bad("a reach cannot be overlaid with anything"));
        }
        ([folder], [true]) => {
            let sweep = sweep::gather(folder, units).map_err(bad)?;
            sweep_plots(&sweep, &sweep.head.units)
        }
        ([first, second], [a, b]) if a != b => {
            let (sweep, run) = if *a { (first, second) } else { (second, first) };
            return Err(bad(format!(
                "nothing to overlay: {} is a sweep, {} is a run",
                sweep.display(),
                run.display()
            )));
        }
        (_, [true, ..]) => {
            return Err(bad("two sweeps cannot be overlaid: vary in one what distinguishes them"));
        }
        ([], _) => return Err(bad("no folder is given")),
        (folders, _) => {
            let runs = folders.iter().map(|folder| Drawn::read(folder, units));
            drawn(&runs.collect::<Result<Vec<_>, _>>()?)?
        }
    };
    if plots.is_empty() {
        let place = folders[0].display();
        return Err(bad(format!("nothing was solved in {place}")));
    }
    Ok(plots)
}

/// Which of the folders are sweeps.
fn sweeps(folders: &[PathBuf]) -> Vec<bool> {
    let folders = folders.iter();
    folders
        .map(|folder| sweep::is_sweep(folder) && !folder.join("summary.json").is_file())
        .collect()
}

/// Where pictures of these folders go by themselves: those of two runs do not take the place of the
/// first one's own.
pub fn pictures_folder(folders: &[PathBuf]) -> PathBuf {
    let name = match folders.get(1).and_then(|second| second.file_name()) {
        Some(second) => format!("plots-{}", file_name(&second.to_string_lossy())),
        None if folders.len() > 1 => "plots-both".to_owned(),
        None => "plots".to_owned(),
    };
    let first = folders.first().map_or(Path::new(""), PathBuf::as_path);
    first.join(name)
}

/// A run that is to be drawn.
struct Drawn {
    folder: PathBuf,
    report: Report,
    spectra: Vec<Spectrum>,
}

fn bad(reason: impl std::fmt::Display) -> Error {
    Error::BadInput(reason.to_string())
}

impl Drawn {
    fn read(folder: &Path, units: Option<UnitSet>) -> Result<Self, Error> {
        let place = folder.display();
        let path = folder.join("summary.json");
        if !path.is_file() {
            return Err(ResultsKind::none(folder));
        }
        let summary = Summary::read(&path).map_err(bad)?;
        if summary.operations.is_empty() {
            return Err(bad(format!("nothing was solved in {place}")));
        }
        if let Some(lacking) = lacking(folder).map_err(bad)? {
            return Err(bad(lacking));
        }
        let tables = Tables::of_folder(folder);
        Ok(Self {
            folder: folder.to_owned(),
            report: gather(&tables, &summary, units).map_err(bad)?,
            spectra: spectra(&table(folder, "spectra").map_err(bad)?),
        })
    }
}

/// Every picture of one run or two.
fn drawn(runs: &[Drawn]) -> Result<Vec<Plot>, Error> {
    let first = &runs[0].report;
    let alike = runs[1..].iter().any(|run| run.report.title == first.title);
    let names: Vec<String> = runs
        .iter()
        .map(|run| match alike {
            // Two runs of one case are distinguished by where they lie.
            true => run.folder.display().to_string(),
            false => run.report.title.clone(),
        })
        .collect();
    let runs: Vec<Run<'_>> = runs
        .iter()
        .zip(&names)
        .map(|(run, name)| Run { name, report: &run.report, spectra: &run.spectra })
        .collect();
    if common_operations(&runs).is_empty() {
        let solved = |run: &Run<'_>| {
            let operations = common_operations(std::slice::from_ref(run));
            operations.join(", ").replace('_', " ")
        };
        return Err(bad(format!(
            "nothing to overlay: {} solved {}, {} solved {}",
            names[0],
            solved(&runs[0]),
            names[1],
            solved(&runs[1])
        )));
    }
    Ok(plots(&runs, &first.units))
}
