//! Runs whose pictures are drawn, and their common facts.

use wholestring::operation::OperationKind;

use super::display::DisplayUnits;
use crate::{
    Report, TimeRun,
    figure::{Axis, Figure, Ink, Key, Layout, Panel, Sample, Stroke},
};

/// A run whose pictures are drawn.
#[derive(Debug, Clone, Copy)]
pub struct Run<'a> {
    /// Its name in a legend, where there are two.
    pub name: &'a str,
    /// Its report.
    pub report: &'a Report,
}

/// A figure with the name of its file.
#[derive(Debug, Clone, PartialEq)]
pub struct Plot {
    /// Name of its file, without an ending.
    pub name: String,
    /// The figure.
    pub figure: Figure,
}

/// The figures that exist, each with its name.
pub(crate) fn named<const N: usize>(names: [&str; N], figures: [Option<Figure>; N]) -> Vec<Plot> {
    let both = names.into_iter().zip(figures);
    both.filter_map(|(name, figure)| Some(Plot { name: name.into(), figure: figure? })).collect()
}

/// Common data of the figures of an operation.
#[derive(Clone, Copy)]
pub(super) struct Context<'a> {
    pub(super) runs: &'a [Run<'a>],
    pub(super) operation: OperationKind,
    pub(super) display: DisplayUnits<'a>,
    pub(super) subtitle: &'a str,
    /// Suffix of the names of its files.
    pub(super) suffix: &'a str,
}

impl<'a> Context<'a> {
    /// Time results of the runs, each with the place of the run among them.
    pub(super) fn timed(&self) -> impl Iterator<Item = (usize, &'a TimeRun)> {
        let operation = self.operation;
        self.runs.iter().enumerate().filter_map(move |(place, run)| {
            let mut timed = run.report.runs.iter();
            Some((place, timed.find(|timed| timed.operation == operation)?))
        })
    }

    /// A figure under the operation's title, with a key for each run.
    pub(super) fn figure(&self, layout: Layout, shared: Axis, panels: Vec<Panel>) -> Figure {
        Figure {
            title: title(self.runs),
            subtitle: self.subtitle.to_owned(),
            keys: self.run_keys(),
            layout,
            shared,
            panels,
            hole: Vec::new(),
        }
    }

    /// Keys of the colours of runs; none for one run.
    pub(super) fn run_keys(&self) -> Vec<Key> {
        if self.runs.len() == 1 {
            return Vec::new();
        }
        let keys = self.runs.iter().enumerate();
        keys.map(|(index, run)| Key {
            name: run.name.to_owned(),
            sample: Sample::Line(Ink::Line(index), Stroke::Solid),
        })
        .collect()
    }

    pub(super) fn plot(&self, name: &str, figure: Figure) -> Plot {
        Plot { name: format!("{name}{}", self.suffix), figure }
    }
}

/// The operations that all runs solved, in the order of the first.
pub fn common_operations(runs: &[Run<'_>]) -> Vec<OperationKind> {
    let mut common: Vec<OperationKind> = Vec::new();
    for solved in runs.iter().take(1).flat_map(|run| &run.report.solved) {
        let operation = solved.operation;
        let has =
            |run: &Run<'_>| run.report.solved.iter().any(|solved| solved.operation == operation);
        if !common.contains(&operation) && runs.iter().all(has) {
            common.push(operation);
        }
    }
    common
}

/// The name of the case, where all runs are of the same.
pub(super) fn title(runs: &[Run<'_>]) -> String {
    let title = &runs[0].report.head.title;
    let same = runs.iter().all(|run| run.report.head.title == *title);
    if same { title.clone() } else { String::new() }
}
