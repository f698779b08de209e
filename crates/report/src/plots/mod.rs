//! The pictures of a run, or of two on the same axes: what the page shows, as figures for paper.

mod bottom;
pub(crate) mod catalogue;
mod contact;
mod drill_off;
mod found;
mod histories;
mod look;
mod near;
mod shown;
mod spectra;
mod tracks;

use self::look::Looks;
pub(crate) use self::{
    bottom::bottoms_figure,
    look::{models, spoken},
    shown::{SETS, Shown},
};
pub use self::{
    contact::{ContactMap, contact_figure},
    spectra::spectrum_dimension,
};
use crate::{Fact, Report, TimeRun, figure::Figure};

/// A run whose pictures are drawn.
#[derive(Debug, Clone, Copy)]
pub struct Run<'a> {
    /// What a legend calls it, where there is another beside it.
    pub name: &'a str,
    /// What is known of it.
    pub report: &'a Report,
    /// Power spectral densities, as far as it has any.
    pub spectra: &'a [Spectrum],
}

/// A power spectral density of one signal, SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    /// `trip_out`, `drill`, ...
    pub operation: String,
    /// `surface_torque`, or of a node `tension`, ...
    pub signal: String,
    /// Measured depth of the node; nothing of a signal of the whole string.
    pub md_m: Option<f64>,
    /// Unit of the signal: `N`, `N·m`, ...
    pub unit: String,
    /// Frequencies, Hz.
    pub frequency_Hz: Vec<f64>,
    /// Density at each, square of the unit per Hz.
    pub density: Vec<f64>,
}

/// A figure with the name of its file.
#[derive(Debug, Clone, PartialEq)]
pub struct Plot {
    /// Name of its file, without an ending.
    pub name: String,
    /// The figure.
    pub figure: Figure,
}

/// Every picture of one run, or of two on the same axes, in a set of units (`si`, `metric` or `field`).
///
/// Operations of one run stand on the same tracks; those of two runs each have their own pictures, of what both
/// solved. Whatever has nothing to show is left out.
///
/// # Panics
/// If there is no run.
pub fn plots(runs: &[Run<'_>], units: &str) -> Vec<Plot> {
    let shown = Shown::new(&runs[0].report.dimensions, units);
    let operations = common_operations(runs);
    let several = operations.len() > 1;
    let suffix = |operation: &str| match several {
        true => format!("-{}", operation.replace('_', "-")),
        false => String::new(),
    };
    let mut plots = Vec::new();
    if runs.len() > 1 {
        for operation in &operations {
            let one = [*operation];
            let looks = Looks::new(runs, &one);
            let subtitle = asked_of(runs, shown, Some(operation));
            let suffix = suffix(operation);
            plots.extend(tracks::plots(runs, &looks, shown, &subtitle, &suffix));
        }
    } else {
        let looks = Looks::new(runs, &operations);
        let subtitle = asked_of(runs, shown, None);
        plots.extend(tracks::plots(runs, &looks, shown, &subtitle, ""));
    }
    for operation in &operations {
        let suffix = suffix(operation);
        let subtitle = asked_of(runs, shown, Some(operation));
        for draw in [
            histories::plots,
            drill_off::plots,
            bottom::plots,
            contact::plots,
            spectra::plots,
        ] {
            plots.extend(draw(runs, operation, shown, &subtitle, &suffix));
        }
    }
    plots
}

/// The profile of one run alone: its tracks against measured depth, all models and operations on the same; nothing where
/// nothing was solved.
pub fn profile(report: &Report, units: &str) -> Option<Figure> {
    let runs = [Run {
        name: "",
        report,
        spectra: &[],
    }];
    let shown = Shown::new(&report.dimensions, units);
    let operations = common_operations(&runs);
    let looks = Looks::new(&runs, &operations);
    let subtitle = asked_of(&runs, shown, None);
    let plots = tracks::plots(&runs, &looks, shown, &subtitle, "");
    plots.into_iter().next().map(|plot| plot.figure)
}

/// The operations that every one of some runs solved, in the order of the first.
pub fn common_operations<'a>(runs: &[Run<'a>]) -> Vec<&'a str> {
    let mut common: Vec<&str> = Vec::new();
    for solved in runs.iter().take(1).flat_map(|run| &run.report.solved) {
        let name = solved.operation.as_str();
        let has = |run: &Run<'_>| run.report.solved.iter().any(|of| of.operation == name);
        if !common.contains(&name) && runs.iter().all(has) {
            common.push(name);
        }
    }
    common
}

/// What runs did in time in an operation, each with the place of the run among them.
fn timed<'a>(runs: &[Run<'a>], operation: &str) -> impl Iterator<Item = (usize, &'a TimeRun)> {
    let runs = runs.iter().enumerate();
    runs.filter_map(move |(place, run)| {
        let mut timed = run.report.runs.iter();
        Some((place, timed.find(|timed| timed.operation == operation)?))
    })
}

/// The name of the case, where all runs are of the same.
fn title(runs: &[Run<'_>]) -> String {
    let title = &runs[0].report.title;
    let same = runs.iter().all(|run| run.report.title == *title);
    if same { title.clone() } else { String::new() }
}

/// What was done, one operation or what was asked, and what was asked of every run alike.
fn asked_of(runs: &[Run<'_>], shown: Shown<'_>, operation: Option<&str>) -> String {
    let done = match operation {
        Some(operation) => spoken(operation),
        None => {
            let operations = common_operations(runs);
            let names = operations.into_iter().map(spoken);
            names.collect::<Vec<_>>().join(", ")
        }
    };
    let asked = runs[0].report.asked.iter();
    let alike = asked.filter(|fact| runs.iter().all(|run| run.report.asked.contains(fact)));
    let alike: Vec<Fact> = alike
        .filter(|fact| !fact.label.starts_with("Operation"))
        .cloned()
        .collect();
    [done, subtitle(&alike, shown)].join("; ")
}

/// The facts that a picture needs beside it.
pub(crate) fn subtitle(asked: &[Fact], shown: Shown<'_>) -> String {
    const TOLD: [&str; 8] = [
        "Operation",
        "Operations",
        "Bit depth",
        "Rotary speed",
        "Weight on bit",
        "Rock strength",
        "Friction factor",
        "Mud density",
    ];
    let told = asked
        .iter()
        .filter(|fact| TOLD.contains(&fact.label.as_str()))
        .filter_map(|fact| {
            let text = shown.fact(fact)?;
            // What is done needs no name.
            let done = fact.label.starts_with("Operation");
            let said = text.split_once(' ').filter(|_| done);
            Some(said.map_or(text.clone(), |(_, done)| done.to_owned()))
        });
    told.collect::<Vec<_>>().join("; ")
}
