//! `wholestring plot`: the pictures of a run, of two on the same axes, of a sweep, or of a bit test, as files.

use std::path::{Path, PathBuf};

use wholestring_report::{
    Plot, Report, Run, Spectrum, bit_test_plots, common_operations, figure::Figure, plots,
    sweep_plots,
};
use wholestring_results::{ResultsFolder, Summary};
use wholestring_units::UnitSet;

use crate::{
    args::PlotArgs,
    bit_test::page as bit_test,
    failure::Failure,
    folder_name::file_name,
    report::{Tables, gather, lacking, spectra::spectra, table},
    say,
    sweep::report as sweep,
};

/// Dots per inch that printers and journals ask for.
const DOTS_PER_INCH: f64 = 300.0;

pub(crate) fn plot(args: &PlotArgs) -> Result<(), Failure> {
    let are_sweeps = sweeps(&args.folders);
    let bit_tests = args.folders.iter().filter(|of| bit_test::is_bit_test(of));
    let are_bit_tests = bit_tests.count() > 0;
    let plots = match (&args.folders[..], &are_sweeps[..]) {
        ([folder], _) if are_bit_tests => {
            let test = bit_test::gather(folder, args.units).map_err(bad)?;
            bit_test_plots(&test, &test.units)
        }
        _ if are_bit_tests => {
            return Err(bad("a bit test cannot be overlaid with anything"));
        }
        ([folder], [true]) => {
            let sweep = sweep::gather(folder, args.units).map_err(bad)?;
            sweep_plots(&sweep, &sweep.units)
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
            return Err(bad(
                "two sweeps cannot be overlaid: vary in one what tells them apart",
            ));
        }
        (folders, _) => {
            let runs = folders.iter().map(|folder| Drawn::read(folder, args.units));
            drawn(&runs.collect::<Result<Vec<_>, _>>()?)?
        }
    };
    if plots.is_empty() {
        let place = args.folders[0].display();
        return Err(bad(format!("nothing was solved in {place}")));
    }
    let output = args
        .output
        .clone()
        .unwrap_or_else(|| default(&args.folders));
    let folder = ResultsFolder::create(output)?;
    for plot in &plots {
        write_picture(&folder, &plot.name, &plot.figure, args.png)?;
    }
    let place = folder.path().display();
    say(&format!("{} pictures in {place}\n", plots.len()))
}

/// Which of the folders are sweeps.
fn sweeps(folders: &[PathBuf]) -> Vec<bool> {
    let folders = folders.iter();
    folders
        .map(|folder| sweep::is_sweep(folder) && !folder.join("summary.json").is_file())
        .collect()
}

/// Where pictures go by themselves: those of two runs do not take the place of the first one's own.
fn default(folders: &[PathBuf]) -> PathBuf {
    let name = match folders.get(1).and_then(|second| second.file_name()) {
        Some(second) => format!("plots-{}", file_name(&second.to_string_lossy())),
        None if folders.len() > 1 => "plots-both".to_owned(),
        None => "plots".to_owned(),
    };
    folders[0].join(name)
}

/// Writes a picture as SVG, and as PNG if that is asked for.
pub(crate) fn write_picture(
    folder: &ResultsFolder,
    name: &str,
    figure: &Figure,
    png: bool,
) -> Result<(), Failure> {
    let drawing = figure.drawing();
    folder.write_file(&format!("{name}.svg"), drawing.svg().as_bytes())?;
    let painted = format!("{name}.png");
    if png {
        folder.write_file(&painted, &drawing.png(DOTS_PER_INCH))?;
    } else {
        // One that was painted before is not of what was drawn now.
        folder.remove(&painted)?;
    }
    Ok(())
}

/// A run that is to be drawn.
struct Drawn {
    folder: PathBuf,
    report: Report,
    spectra: Vec<Spectrum>,
}

fn bad(reason: impl std::fmt::Display) -> Failure {
    Failure::BadInput(format!("error: {reason}"))
}

impl Drawn {
    fn read(folder: &Path, units: Option<UnitSet>) -> Result<Self, Failure> {
        let place = folder.display();
        let path = folder.join("summary.json");
        if !path.is_file() {
            return Err(bad(format!(
                "{place} is no folder of a run, a sweep or a bit test: it holds neither summary.json nor sweep.csv"
            )));
        }
        let summary = Summary::read(&path).map_err(bad)?;
        if summary.operations.is_empty() {
            return Err(bad(format!("nothing was solved in {place}")));
        }
        if let Some(lacking) = lacking(folder).map_err(bad)? {
            return Err(bad(lacking));
        }
        let tables = Tables::read(folder).map_err(bad)?;
        Ok(Self {
            folder: folder.to_owned(),
            report: gather(&tables, &summary, units).map_err(bad)?,
            spectra: spectra(&table(folder, "spectra").map_err(bad)?),
        })
    }
}

/// Every picture of one run or two.
fn drawn(runs: &[Drawn]) -> Result<Vec<Plot>, Failure> {
    let first = &runs[0].report;
    let alike = runs[1..].iter().any(|run| run.report.title == first.title);
    let names: Vec<String> = runs
        .iter()
        .map(|run| match alike {
            // Two runs of one case are told apart by where they lie.
            true => run.folder.display().to_string(),
            false => run.report.title.clone(),
        })
        .collect();
    let runs: Vec<Run<'_>> = runs
        .iter()
        .zip(&names)
        .map(|(run, name)| Run {
            name,
            report: &run.report,
            spectra: &run.spectra,
        })
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
