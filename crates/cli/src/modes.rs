//! `wholestring modes`: natural frequencies, critical speeds and the response to a rotating force.

use std::f64::consts::TAU;

use clap::Args;
use wholestring::operation::OperationKind;
use wholestring_results::{CriticalSpeed, ModesSummary, Spot};
use wholestring_runner::{
    job::{Job, Work, operation},
    modes::stability_sentences,
};
use wholestring_units::{Dimension, UnitSet};

use crate::{
    screen::Table,
    shared_args::{CaseArgs, OutputArgs, PageArgs},
};

// Arguments of `wholestring modes`.

#[derive(Debug, Args)]
// Not a doc comment, which would read `<case name>` as HTML.
#[command(mut_arg("output", |arg| {
    arg.help("Folder for the results [default: out/<case name> modes]")
}))]
pub(crate) struct ModesArgs {
    #[command(flatten)]
    pub(crate) case: CaseArgs,

    /// Operation whose static equilibrium the vibration is about, such as `drill` [default: the
    /// case's first]
    #[arg(long, value_name = "OPERATION", value_parser = operation)]
    pub(crate) operation: Option<OperationKind>,

    #[command(flatten)]
    pub(crate) output: OutputArgs,

    #[command(flatten)]
    pub(crate) page: PageArgs,
}

impl ModesArgs {
    /// The job of these arguments.
    pub(crate) fn job(&self) -> Job {
        let work = Work::Modes { operation: self.operation, png: self.page.png };
        Job { output: self.output.output(), units: self.page.units, ..self.case.job(work) }
    }
}

// Output of a modal analysis on the screen.

/// Fraction of the operation's rotary speed within which critical speeds are shown.
const NEAR: f64 = 0.3;

/// Whether a critical speed is near the operation's rotary speed; always true if the string does
/// not rotate.
fn is_near(summary: &ModesSummary, critical: &CriticalSpeed) -> bool {
    let speed = summary.rotary_speed_rad_per_s;
    speed == 0.0 || (critical.rotary_speed_rad_per_s - speed).abs() <= NEAR * speed
}

/// The modes and the critical speeds as tables, and warnings.
pub(crate) fn text(summary: &ModesSummary, units: UnitSet) -> String {
    let speed = Dimension::RotarySpeed.unit_in(units);
    let length = Dimension::Length.unit_in(units);
    let title = format!(
        "{}: {} at {}, an assembly of {}",
        summary.case,
        summary.operation,
        Dimension::RotarySpeed.format(summary.rotary_speed_rad_per_s, units),
        Dimension::Length.format((10.0 * summary.assembly_length_m).round() / 10.0, units),
    );
    let headings = [
        "mode".to_owned(),
        "whirl".to_owned(),
        "strained most in".to_owned(),
        "frequency, Hz".to_owned(),
        "period, s".to_owned(),
        format!("1x at, {}", speed.symbol),
        format!("strained most at MD, {}", length.symbol),
    ];
    let mut table = Table::new(&title, 3, &headings.each_ref().map(String::as_str));
    let depth = |spot: &Spot| format!("{:.1}", length.from_si(spot.md_m));
    for mode in &summary.modes {
        table.row(vec![
            format!("{} {}", mode.family, mode.number),
            mode.whirl.clone().unwrap_or_default(),
            mode.most_strained.component.clone(),
            format!("{:.4}", mode.frequency_Hz),
            format!("{:.3}", 1.0 / mode.frequency_Hz),
            format!("{:.1}", speed.from_si(TAU * mode.frequency_Hz)),
            depth(&mode.most_strained),
        ]);
    }
    let mut text = table.text();
    let near: Vec<&CriticalSpeed> = summary
        .critical_speeds
        .iter()
        .filter(|critical_speed| is_near(summary, critical_speed))
        .collect();
    if !near.is_empty() {
        let headings = [
            "mode".to_owned(),
            "strained most in".to_owned(),
            format!("critical speed, {}", speed.symbol),
            "order".to_owned(),
            "frequency, Hz".to_owned(),
            format!("strained most at MD, {}", length.symbol),
        ];
        let mut table = Table::new("Critical speeds", 2, &headings.each_ref().map(String::as_str));
        for critical in &near {
            table.row(vec![
                format!("{} {}", critical.family, critical.number),
                critical.most_strained.component.clone(),
                format!("{:.1}", speed.from_si(critical.rotary_speed_rad_per_s)),
                format!("{}", (1e3 * critical.order).round() / 1e3),
                format!("{:.4}", critical.frequency_Hz),
                depth(&critical.most_strained),
            ]);
        }
        text += &format!("\n{}", table.text());
    }
    let others = summary.critical_speeds.len() - near.len();
    if others > 0 {
        text += &format!("{others} critical speeds farther off are in critical_speeds.csv\n");
    }
    text += "\nTorsional stability\n";
    let sentences = match (&summary.torsional_stability, &summary.no_torsional_stability) {
        (Some(map), _) => stability_sentences(summary.operation, map, units),
        (None, Some(why)) => vec![format!("no map: {why}")],
        (None, None) => Vec::new(),
    };
    for sentence in sentences {
        text += &format!("  {sentence}\n");
    }
    for check in summary.checks.iter().filter(|check| !check.is_ok()) {
        text += &format!("{}: {}\n", check.severity.name(), check.sentence_in(units));
    }
    if !summary.stable {
        text += "Unstable modes have no frequency.\n";
    }
    text
}
