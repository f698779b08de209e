//! `wholestring reach`: greatest depth of the well, and the limit that stops it.

use std::{num::NonZeroUsize, path::PathBuf};

use clap::Args;
use wholestring::operation::OperationKind;
use wholestring_results::ReachSummary;
use wholestring_runner::{
    job::{Job, ReachOptions, Work, operation},
    reach::{answers, end_of_limit, notes, scatter, uncertain_notes},
};
use wholestring_units::{Dimension, UnitSet};

use crate::{
    screen::Table,
    shared_args::{CaseArgs, PageArgs, output},
};

// Arguments of `wholestring reach`.

#[derive(Debug, Args)]
pub(crate) struct ReachArgs {
    #[command(flatten)]
    pub(crate) case: CaseArgs,

    /// Bit depth to start from, such as `4000m` [default: the end of the survey, or of the hole where that is shallower]
    #[arg(long, value_name = "DEPTH")]
    pub(crate) from: Option<String>,

    /// Deepest bit depth, such as `12km` [default: 15 km, or twice the first depth if that is
    /// deeper]
    #[arg(long, value_name = "DEPTH")]
    pub(crate) to: Option<String>,

    /// Friction factors to solve for, each applied to all hole sections, such as `0.2,0.3,0.4`
    /// [default: the case's]
    #[arg(long, value_name = "FACTORS", value_delimiter = ',', value_parser = friction)]
    pub(crate) friction: Vec<f64>,

    /// Operations, such as `drill,slide` [default: trip_out, rotate_off_bottom, drill, trip_in,
    /// slide and those of the case, if their set points are given]
    #[arg(long, value_name = "KINDS", value_delimiter = ',', value_parser = operation)]
    pub(crate) operation: Vec<OperationKind>,

    /// Ignore the friction from the wall force of a helix, so that nothing locks up
    #[arg(long)]
    no_helix_friction: bool,

    /// Stop at the depth where helical buckling begins; without it the buckled string goes deeper.
    /// Not applied to a vertical hole, where buckling begins early and is harmless
    #[arg(long)]
    stop_at_helix: bool,

    /// Number of parallel jobs, an operation each [default: one per core]
    #[arg(short, long, value_name = "N")]
    pub(crate) jobs: Option<NonZeroUsize>,

    // Not a doc comment, which would read `<case name>` as HTML.
    #[arg(
        short,
        long,
        value_name = "DIR",
        help = "Folder for the results [default: out/<case name> reach]"
    )]
    pub(crate) output: Option<PathBuf>,

    /// Continue an interrupted reach with uncertain inputs; solved samples are skipped
    #[arg(long)]
    pub(crate) resume: bool,

    /// Overwrite existing results in the folder
    #[arg(long, conflicts_with = "resume")]
    pub(crate) overwrite: bool,

    #[command(flatten)]
    pub(crate) page: PageArgs,
}

impl ReachArgs {
    /// The job of these arguments.
    pub(crate) fn job(&self) -> Job {
        let work = Work::Reach(ReachOptions {
            from: self.from.clone(),
            to: self.to.clone(),
            frictions: self.friction.clone(),
            operations: self.operation.clone(),
            no_helix_friction: self.no_helix_friction,
            stop_at_helix: self.stop_at_helix,
            png: self.page.png,
        });
        Job {
            output: output(self.output.as_ref(), self.resume, self.overwrite),
            units: self.page.units,
            jobs: self.jobs,
            ..self.case.job(work)
        }
    }
}

fn friction(text: &str) -> Result<f64, String> {
    text.trim().parse().map_err(|_| "expected a friction factor, such as 0.3".to_owned())
}

// Output of a reach on the screen.

/// The governing limit, each limit with its depth and margins, and warnings.
pub(crate) fn text(summary: &ReachSummary, units: UnitSet) -> String {
    let length = Dimension::Length.unit_in(units);
    let depth = |depth_m: f64| format!("{:.0}", length.from_si(depth_m));
    let mut text = format!("{}: reach\n\n", summary.case);
    for (answer, friction) in answers(summary, units).iter().zip(&summary.frictions) {
        let headings = [
            "operation".to_owned(),
            "limit".to_owned(),
            format!("reached at, {}", length.symbol),
            format!("margin at {}, %", depth(summary.from_m)),
            format!("at {}, %", depth(summary.to_m)),
            format!("worst at MD, {}", length.symbol),
        ];
        let mut table = Table::new(answer, 2, &headings.each_ref().map(String::as_str));
        for limit in &friction.limits {
            table.row(vec![
                limit.operation.words().to_owned(),
                limit.title.clone(),
                end_of_limit(limit, summary, depth),
                percent(limit.margin_at_from),
                percent(limit.margin_at_to),
                limit.at_md_m.map_or_else(|| "–".to_owned(), depth),
            ]);
        }
        text += &table.text();
        text.push('\n');
        for check in summary.checks.iter().filter(|check| check.friction == friction.friction) {
            text += &format!("{}.\n", check.check.sentence_in(units));
        }
        text.push('\n');
    }
    if let Some(uncertain) = &summary.uncertain {
        for sentence in uncertain_notes(uncertain).into_iter().chain(scatter(uncertain, units)) {
            text += &format!("{sentence}\n");
        }
    }
    for note in notes(summary, units) {
        text += &format!("{note}\n");
    }
    text
}

fn percent(margin: Option<f64>) -> String {
    margin.map_or_else(|| "locked up".to_owned(), |margin| format!("{:.1}", 100.0 * margin))
}
