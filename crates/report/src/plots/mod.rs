//! The pictures of a run, or of two on the same axes: those of the page, as figures for paper.

mod bottom;
mod buckling;
pub(crate) mod catalogue;
mod contact;
mod display;
mod drill_off;
mod found;
mod histories;
mod near;
mod run;
mod spectra;
mod styles;
mod tracks;

pub(crate) use self::contact::{ContactMap, contact_figure};
pub(crate) use self::{
    bottom::bottoms_figure,
    display::{DisplayUnits, SETS},
    run::named,
    styles::models,
};
pub use self::{
    catalogue::shown_dimension,
    run::{Plot, Run, common_operations},
};
use self::{run::Context, styles::CurveStyles};
use crate::{Fact, Report, figure::Figure};
use wholestring::operation::OperationKind;

/// Every picture of one run, or of two on the same axes, in a set of units (`si`, `metric` or
/// `field`).
///
/// Operations of one run are on the same tracks; those of two runs have pictures of their own, for
/// the operations that both solved. Empty pictures are left out.
///
/// # Panics
/// If there is no run.
pub fn plots(runs: &[Run<'_>], units: &str) -> Vec<Plot> {
    let display = DisplayUnits::new(&runs[0].report.head.dimensions, units);
    let operations = common_operations(runs);
    let several = operations.len() > 1;
    let suffix = |operation: OperationKind| match several {
        true => format!("-{}", operation.words().replace(' ', "-")),
        false => String::new(),
    };
    let mut plots = Vec::new();
    if runs.len() > 1 {
        for operation in operations.iter().copied() {
            let one = [operation];
            let styles = CurveStyles::new(runs, &one);
            let subtitle = common_facts(runs, display, Some(operation));
            let suffix = suffix(operation);
            plots.extend(tracks::plots(runs, &styles, display, &subtitle, &suffix));
        }
    } else {
        let styles = CurveStyles::new(runs, &operations);
        let subtitle = common_facts(runs, display, None);
        plots.extend(tracks::plots(runs, &styles, display, &subtitle, ""));
    }
    for operation in operations.iter().copied() {
        let (suffix, subtitle) = (suffix(operation), common_facts(runs, display, Some(operation)));
        let context = Context { runs, operation, display, subtitle: &subtitle, suffix: &suffix };
        for draw in
            [histories::plots, drill_off::plots, bottom::plots, contact::plots, spectra::plots]
        {
            plots.extend(draw(context));
        }
    }
    plots
}

/// The profile of one run alone: its tracks against measured depth, all models and operations on
/// the same; `None` where nothing was solved.
pub fn profile(report: &Report, units: &str) -> Option<Figure> {
    let runs = [Run { name: "", report }];
    let display = DisplayUnits::new(&report.head.dimensions, units);
    let operations = common_operations(&runs);
    let styles = CurveStyles::new(&runs, &operations);
    let subtitle = common_facts(&runs, display, None);
    let plots = tracks::plots(&runs, &styles, display, &subtitle, "");
    plots.into_iter().next().map(|plot| plot.figure)
}

/// The operation, or all, and the facts common to every run.
fn common_facts(
    runs: &[Run<'_>],
    display: DisplayUnits<'_>,
    operation: Option<OperationKind>,
) -> String {
    let done = match operation {
        Some(operation) => operation.words().to_owned(),
        None => {
            let operations = common_operations(runs);
            let names = operations.into_iter().map(OperationKind::words);
            names.collect::<Vec<_>>().join(", ")
        }
    };
    let facts = runs[0].report.head.facts.iter();
    let alike = facts.filter(|fact| runs.iter().all(|run| run.report.head.facts.contains(fact)));
    let alike: Vec<Fact> =
        alike.filter(|fact| !fact.label.starts_with("Operation")).cloned().collect();
    [done, subtitle(&alike, display)].join("; ")
}

/// The facts needed with a picture.
pub(crate) fn subtitle(facts: &[Fact], display: DisplayUnits<'_>) -> String {
    const SHOWN_FACTS: [&str; 8] = [
        "Operation",
        "Operations",
        "Bit depth",
        "Rotary speed",
        "Weight on bit",
        "Rock strength",
        "Friction factor",
        "Mud density",
    ];
    let parts =
        facts.iter().filter(|fact| SHOWN_FACTS.contains(&fact.label.as_str())).filter_map(|fact| {
            let text = display.fact(fact)?;
            // The operation needs no label.
            let done = fact.label.starts_with("Operation");
            let words = text.split_once(' ').filter(|_| done);
            Some(words.map_or(text.clone(), |(_, done)| done.to_owned()))
        });
    parts.collect::<Vec<_>>().join("; ")
}
