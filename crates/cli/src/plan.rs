//! `wholestring plan`: torque and drag at every bit depth, with low, expected and high friction.

use std::{num::NonZeroUsize, path::PathBuf};

use clap::Args;
use wholestring::well::FrictionLevel;
use wholestring_results::{PlanPoint, PlanSummary, Severity};
use wholestring_runner::{
    job::{Job, Work},
    plan::{governing_sentences, notes, scatter},
};
use wholestring_units::{Dimension, UnitSet};

use crate::{
    checks,
    screen::Table,
    shared_args::{CaseArgs, CheckpointArgs, PageArgs, output},
};

// Arguments of `wholestring plan`.

#[derive(Debug, Args)]
#[command(mut_arg("units", |arg| {
    arg.help("Units on the screen, the page and in the workbook [default: the case's]")
}))]
pub(crate) struct PlanArgs {
    #[command(flatten)]
    pub(crate) case: CaseArgs,

    // Not a doc comment, which would read `<case name>` as HTML.
    #[arg(
        short,
        long,
        value_name = "DIR",
        help = "Folder for the results [default: out/<case name> plan]"
    )]
    pub(crate) output: Option<PathBuf>,

    /// Continue an interrupted plan; finished points are skipped
    #[arg(long)]
    pub(crate) resume: bool,

    /// Overwrite existing results in the folder: another plan or an unfinished one
    #[arg(long, conflicts_with = "resume")]
    pub(crate) overwrite: bool,

    /// Overlay curves from another program: a CSV or Excel file of hook loads and torques against
    /// bit depth, in the format of measured values
    #[arg(long, value_name = "FILE")]
    pub(crate) overlay: Option<PathBuf>,

    /// Number of parallel jobs [default: one per core]
    #[arg(short, long, value_name = "N")]
    pub(crate) jobs: Option<NonZeroUsize>,

    #[command(flatten)]
    pub(crate) checkpoint: CheckpointArgs,

    #[command(flatten)]
    pub(crate) page: PageArgs,
}

impl PlanArgs {
    /// The job of these arguments.
    pub(crate) fn job(&self) -> Job {
        let work = Work::Plan { overlay: self.overlay.clone(), png: self.page.png };
        Job {
            output: output(self.output.as_ref(), self.resume, self.overwrite),
            units: self.page.units,
            jobs: self.jobs,
            checkpoint: self.checkpoint.every.clone(),
            ..self.case.job(work)
        }
    }
}

// Output of a plan on the screen.

/// Every operation at the deepest depth, and the points without a result.
pub(crate) fn text(summary: &PlanSummary, units: UnitSet) -> String {
    let [length, force, torque] = [Dimension::Length, Dimension::Force, Dimension::Torque]
        .map(|dimension| dimension.unit_in(units));
    let Some(deepest_m) = summary.points.iter().map(|point| point.bit_depth_m).reduce(f64::max)
    else {
        return String::new();
    };
    let title = format!(
        "{}: the bit at {} {}, the deepest of {} depths; low, expected and high friction",
        summary.case,
        (10.0 * length.from_si(deepest_m)).round() / 10.0,
        length.symbol,
        summary.bit_depths_m.len(),
    );
    let mut headings =
        vec!["operation".to_owned(), "model".to_owned(), "most severe check".to_owned()];
    for (name, symbol) in [("hook load", force.symbol), ("torque", torque.symbol)] {
        headings.push(format!("{name} low, {symbol}"));
        headings.extend(FrictionLevel::ALL[1..].iter().map(|level| level.name().to_owned()));
    }
    let headings: Vec<&str> = headings.iter().map(String::as_str).collect();
    let mut table = Table::new(&title, 3, &headings);
    for model in summary.models.iter().copied() {
        for operation in summary.operations.iter().copied() {
            let points = FrictionLevel::ALL.map(|level| {
                let mut curve = summary.curve(model, operation, level);
                curve.find(|curve| curve.bit_depth_m == deepest_m)
            });
            let number =
                |point: Option<&PlanPoint>, value: fn(&PlanPoint) -> Option<f64>, worth: f64| {
                    let value = point.and_then(value);
                    value.map_or_else(|| "–".to_owned(), |value| format!("{:.1}", value / worth))
                };
            let mut row =
                vec![operation.words().to_owned(), model.name().to_owned(), worst(&points)];
            let hook = |point: &PlanPoint| Some(point.scalars?.hook_load_N);
            let turns = |point: &PlanPoint| Some(point.scalars?.surface_torque_N_m);
            row.extend(points.map(|point| number(point, hook, force.factor)));
            row.extend(points.map(|point| number(point, turns, torque.factor)));
            table.row(row);
        }
    }
    let mut text = table.text() + &peaks(summary, units);
    if !summary.governing.is_empty() {
        text += "governing limits, of all models, depths and frictions:\n";
    }
    for sentence in governing_sentences(summary, units) {
        text += &format!("  {sentence}\n");
    }
    let mut open: Vec<_> = summary
        .checks
        .iter()
        .filter(|row| row.check.severity >= Severity::Warning)
        .filter(|row| !summary.governing.contains(row))
        .collect();
    open.sort_by_key(|row| std::cmp::Reverse(row.check.severity));
    for row in open {
        let name = format!(
            "{} ({}), {} friction, bit at {:.0} {}",
            row.operation.words(),
            row.model,
            row.friction,
            length.from_si(row.bit_depth_m),
            length.symbol
        );
        text += &checks::line(&name, &row.check, units, (None, false));
    }
    for phrase in &summary.unchecked {
        text += &format!("not checked: {}\n", summary.texts.in_units(phrase, units));
    }
    for phrase in &summary.not_counted {
        let phrase = summary.texts.in_units(phrase, units);
        text += &format!("not counted in fatigue and casing wear: {phrase}\n");
    }
    for model in summary.models.iter().copied().filter(|_| !summary.measured.is_empty()) {
        let (between, all) = summary.measured_between(model);
        text += &format!(
            "measured: {between} of {all} readings that depend on friction are between low and high \
             friction ({model} string)\n"
        );
    }
    let differences = summary.overlay.iter().flat_map(|overlay| &overlay.differences);
    for difference in differences {
        let unit = if difference.is_torque { torque } else { force };
        text += &format!(
            "{}: ours less theirs, {} {}, {} string: {:.1} {unit} in the mean of {} depths, {:.1} at most, the bit \
             at {:.0} {}\n",
            summary.overlay.as_ref().map_or("", |overlay| &overlay.file),
            difference.operation,
            if difference.is_torque { "torque" } else { "hook load" },
            difference.model,
            unit.from_si(difference.mean),
            difference.count,
            unit.from_si(difference.largest),
            length.from_si(difference.largest_at_m),
            length.symbol,
            unit = unit.symbol,
        );
    }
    let lacking = summary.points.iter().filter(|point| point.message.is_some()).count();
    if lacking > 0 {
        text += &format!(
            "{lacking} of {} points have no answer: see plan_broomstick.csv for the reasons\n",
            summary.points.len()
        );
    }
    if let Some(uncertain) = &summary.uncertain {
        for sentence in notes(uncertain).into_iter().chain(scatter(uncertain, units)) {
            text += &format!("{sentence}\n");
        }
    }
    if summary.missing > 0 {
        text += &format!("{} points are missing: the plan was interrupted\n", summary.missing);
    }
    text
}

/// Peak loads of a string that starts moving; empty unless requested.
fn peaks(summary: &PlanSummary, units: UnitSet) -> String {
    if summary.peaks.is_empty() {
        return String::new();
    }
    let headings =
        ["event", "quantity", "friction", "bit at", "at rest", "peak", "after, s", "comes to"];
    let mut table =
        Table::new("Peaks of a string that hangs at rest, by the dynamics", 3, &headings);
    let mut reasons = String::new();
    for event_peaks in &summary.peaks {
        let event = event_peaks.event.replace('_', " ");
        let depth = Dimension::Length.unit_in(units);
        let bit = format!("{:.0} {}", depth.from_si(event_peaks.bit_depth_m), depth.symbol);
        let quantities = [
            ("hook load", Dimension::Force, event_peaks.hook_load_N),
            ("torque", Dimension::Torque, event_peaks.surface_torque_N_m),
            ("pump pressure", Dimension::Pressure, event_peaks.pump_pressure_Pa),
        ];
        for (name, dimension, peak) in quantities {
            let Some(peak) = peak else { continue };
            let unit = dimension.unit_in(units);
            // Without negative zero.
            let number = |si: f64| format!("{:.1}", (10.0 * unit.from_si(si)).round() / 10.0 + 0.0);
            table.row(vec![
                event.clone(),
                format!("{name}, {}", unit.symbol),
                event_peaks.friction.name().to_owned(),
                bit.clone(),
                number(peak.at_rest),
                number(peak.peak),
                format!("{:.2}", peak.time_s),
                number(peak.steady),
            ]);
        }
        if let Some(gel) = event_peaks.gel {
            let unit = Dimension::Pressure.unit_in(units);
            let pressure = unit.from_si(gel.bore_Pa + gel.annulus_Pa);
            reasons += &format!(
                "{event}, the bit at {bit}: the gel breaks at {pressure:.1} {}\n",
                unit.symbol
            );
        }
        if let Some(message) = &event_peaks.message {
            reasons += &format!(
                "{event}, {} friction, the bit at {bit}: {message}\n",
                event_peaks.friction
            );
        }
    }
    table.text() + &reasons
}

/// The most severe check at any friction.
fn worst(points: &[Option<&PlanPoint>]) -> String {
    let found = points.iter().flatten().filter_map(|point| point.worst.as_ref());
    let worst = found.reduce(|a, b| if b.cmp_severity(a).is_gt() { b } else { a });
    worst.map_or_else(String::new, |worst| {
        format!("{}: {}", worst.severity.name(), worst.kind.label().to_lowercase())
    })
}
