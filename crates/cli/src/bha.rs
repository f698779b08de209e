//! `wholestring bha`: static analysis of the bottom-hole assembly.

use std::num::NonZeroUsize;

use clap::Args;
use wholestring::{
    operation::OperationKind,
    statics::assembly::{Contact, Touching},
};
use wholestring_results::{BhaPoint, BhaState, BhaSummary, BhaVaried, Unchecked};
use wholestring_runner::{
    bha::{number, quantity, tendency},
    job::{BhaOptions, Job, Work, operation},
};
use wholestring_units::{Dimension, UnitSet, without_trailing_zeros};

use crate::{
    screen::Table,
    shared_args::{CaseArgs, OutputArgs, ScreenOptions},
};

// Arguments of `wholestring bha`.

#[derive(Debug, Args)]
// Not a doc comment, which would read `<case name>` as HTML.
#[command(mut_arg("output", |arg| {
    arg.help("Folder for the results [default: out/<case name> bha]")
}))]
pub(crate) struct BhaArgs {
    #[command(flatten)]
    pub(crate) case: CaseArgs,

    /// Operation: drill, slide, trip_out, ... [default: the case's first one that drills]
    #[arg(long, value_name = "KIND", value_parser = operation)]
    pub(crate) operation: Option<OperationKind>,

    /// Tool faces of the bend, such as `90deg` or `0deg..360deg/15deg` (a range always includes its
    /// end) [default: a revolution in steps of 15 deg]
    #[arg(long, value_name = "ANGLES")]
    toolface: Option<String>,

    /// Weights on bit, such as `20kN..120kN/20kN` [default: seven values up to 1.5 times the
    /// operation's]
    #[arg(long, value_name = "FORCES")]
    pub(crate) weight: Option<String>,

    /// Inclinations of a straight hole, such as `5deg..90deg/5deg` [default: 5deg..90deg/5deg]
    #[arg(long, value_name = "ANGLES")]
    pub(crate) inclination: Option<String>,

    /// Build rate of the holes of --inclination, such as `2deg/30m`; negative to drop [default: 0,
    /// straight]
    #[arg(long, value_name = "RATE", allow_hyphen_values = true)]
    pub(crate) build: Option<String>,

    /// Solve the whole string instead of the assembly and 100 m of pipe above it
    #[arg(long)]
    pub(crate) whole: bool,

    /// Number of parallel jobs, a point each [default: one per core]
    #[arg(short, long, value_name = "N")]
    pub(crate) jobs: Option<NonZeroUsize>,

    #[command(flatten)]
    pub(crate) output: OutputArgs,

    /// Units on the screen [default: the case's]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,

    /// Also write the tables as CSV
    #[arg(long)]
    pub(crate) csv: bool,

    /// Print nothing but errors
    #[arg(short, long)]
    pub(crate) quiet: bool,

    /// Exit with status 4 if a check of the results is an error
    #[arg(long)]
    pub(crate) strict: bool,
}

impl BhaArgs {
    /// The job of these arguments.
    pub(crate) fn job(&self) -> Job {
        let work = Work::Bha(BhaOptions {
            operation: self.operation,
            whole: self.whole,
            toolface: self.toolface.clone(),
            weight: self.weight.clone(),
            inclination: self.inclination.clone(),
            build: self.build.clone(),
            csv: self.csv,
        });
        let (output, units, jobs) = (self.output.output(), self.units, self.jobs);
        Job { output, units, jobs, ..self.case.job(work) }
    }

    /// Options of the screen.
    pub(crate) fn screen(&self) -> ScreenOptions {
        ScreenOptions { quiet: self.quiet, strict: self.strict, json: false }
    }
}

// Output of a static BHA analysis on the screen.

/// Largest number of points of a sweep on the screen.
const MOST: usize = 7;

/// Bit, contacts, sag and largest stress, the variations, and warnings.
pub(crate) fn text(summary: &BhaSummary, units: UnitSet) -> String {
    let mut text = format!("{}\n\n", head(summary, units));
    text += &bit(&summary.state, units);
    text.push('\n');
    text += &contacts(&summary.state, units);
    text.push('\n');
    text += &sag(&summary.state, units);
    text += &largest(&summary.state, units);
    for varied in BhaVaried::ALL {
        text += &sweep(summary, varied, units);
    }
    text += &holding(summary, units);
    if let Some(differ_N) = summary.points_differ_N() {
        text += &format!(
            "note: variations are solved without the shorter elements at contacts that the state \
             above has; at its own weight and tool face the side force differs by {}\n",
            quantity(differ_N, Dimension::Force, units)
        );
    }
    for check in summary.open_checks() {
        text += &format!("{}: {}\n", check.severity.name(), check.sentence_in(units));
    }
    for warning in summary.warnings() {
        text += &format!("warning: {warning}\n");
    }
    for phrase in Unchecked::phrases(&summary.unchecked) {
        text += &format!("not checked: {phrase}\n");
    }
    text
}

fn head(summary: &BhaSummary, units: UnitSet) -> String {
    let mut head = format!(
        "{}: static BHA analysis, {}, bit at {}, inclination {}",
        summary.case,
        summary.operation,
        quantity(summary.bit_depth_m, Dimension::Length, units),
        quantity(summary.inclination_rad, Dimension::Angle, units),
    );
    if summary.weight_on_bit_N > 0.0 {
        let weight = quantity(summary.weight_on_bit_N, Dimension::Force, units);
        head += &format!(", weight on bit {weight}");
    }
    if let Some(toolface_rad) = summary.toolface_rad {
        let toolface = quantity(toolface_rad, Dimension::Angle, units);
        head += &format!(", tool face {toolface}");
    }
    head
}

fn unit_of(label: &str, dimension: Dimension, units: UnitSet) -> String {
    format!("{label}, {}", dimension.unit_in(units).symbol)
}

fn bit(state: &BhaState, units: UnitSet) -> String {
    let mut table = Table::new(
        "Bit",
        1,
        &["", "high side (builds)", "right (turns right)", "halving the elements changes"],
    );
    let errors = state.errors;
    let rows = [
        (
            "side force",
            Dimension::Force,
            state.side_force_N,
            errors.map(|errors| errors.side_force_N),
        ),
        ("tilt", Dimension::Angle, state.tilt_rad, errors.map(|errors| errors.tilt_rad)),
    ];
    for (label, dimension, [high, right], error) in rows {
        table.row(vec![
            unit_of(label, dimension, units),
            number(high, dimension, units),
            number(right, dimension, units),
            error.map_or("–".into(), |error| small(error, dimension, units)),
        ]);
    }
    table.text()
}

fn contacts(state: &BhaState, units: UnitSet) -> String {
    let headings = [
        "component".to_owned(),
        "with".to_owned(),
        unit_of("from the bit", Dimension::Length, units),
        unit_of("MD", Dimension::Length, units),
        unit_of("force", Dimension::Force, units),
        unit_of("high side", Dimension::Force, units),
        unit_of("right", Dimension::Force, units),
        unit_of("side", Dimension::Angle, units),
    ];
    let mut table = Table::new("Contacts", 2, &headings.each_ref().map(String::as_str));
    // The lowest joint of jointed pipe.
    let is_joint = |contact: &Contact| contact.touching == Touching::Joint;
    let joint = state.contacts.iter().position(is_joint);
    let count = joint.map_or(state.contacts.len(), |joint| joint + 1);
    for contact in &state.contacts[..count] {
        let [low_m, high_m] = contact.from_bit_m;
        let mut place = number(low_m, Dimension::Length, units);
        if high_m > low_m {
            place = format!("{place} to {}", number(high_m, Dimension::Length, units));
        }
        table.row(vec![
            contact.name.clone(),
            contact.touching.name().to_owned(),
            place,
            number(contact.md_m, Dimension::Length, units),
            number(contact.size_N(), Dimension::Force, units),
            number(contact.force_N[0], Dimension::Force, units),
            number(contact.force_N[1], Dimension::Force, units),
            number(contact.side_rad, Dimension::Angle, units),
        ]);
    }
    let more = match state.contacts.len() - count {
        0 => String::new(),
        more => format!("and {more} farther up, which are in bha_contacts\n"),
    };
    format!("{}{more}", table.text())
}

fn sag(state: &BhaState, units: UnitSet) -> String {
    if state.sag.is_empty() {
        return "Sag: no component has a survey_sensor; give its distance from the component's \
                lower end under [[string]]\n"
            .to_owned();
    }
    let mut text = String::new();
    for sag in &state.sag {
        let angle = |rad: f64| quantity(rad, Dimension::Angle, units);
        let azimuth = match sag.azimuth_rad {
            Some(azimuth_rad) => format!(", azimuth {}", angle(azimuth_rad)),
            None => String::new(),
        };
        text += &format!(
            "Sag at {} in {}: inclination {}{azimuth}; measured + correction = hole\n",
            quantity(sag.from_bit_m, Dimension::Length, units),
            sag.name,
            angle(sag.inclination_rad),
        );
    }
    text
}

fn largest(state: &BhaState, units: UnitSet) -> String {
    let at = |metres: f64| quantity(metres, Dimension::Length, units);
    let moment = state.largest_bending_moment_N_m;
    let stress = state.largest_von_mises_stress_Pa;
    format!(
        "Largest bending moment {} at {} from the bit, von Mises stress {} at {}\n",
        quantity(moment.value, Dimension::Torque, units),
        at(moment.from_bit_m),
        quantity(stress.value, Dimension::Stress, units),
        at(stress.from_bit_m)
    )
}

fn sweep(summary: &BhaSummary, varied: BhaVaried, units: UnitSet) -> String {
    let points: Vec<&BhaPoint> =
        summary.sweep.iter().filter(|point| point.varied == varied).collect();
    if points.is_empty() {
        return String::new();
    }
    let (title, label, dimension) = match varied {
        BhaVaried::Toolface => ("Other tool faces", "tool face", Dimension::Angle),
        BhaVaried::Weight => ("Other weights", "weight on bit", Dimension::Force),
        BhaVaried::Inclination => ("Other inclinations", "inclination", Dimension::Angle),
    };
    let headings = [
        unit_of(label, dimension, units),
        unit_of("side force, high side", Dimension::Force, units),
        unit_of("right", Dimension::Force, units),
        unit_of("tilt, high side", Dimension::Angle, units),
    ];
    let step = points.len().div_ceil(MOST).max(1);
    let title = match step {
        1 => title.to_owned(),
        _ => format!("{title}: one in {step} of {} points", points.len()),
    };
    let mut table = Table::new(&title, 0, &headings.each_ref().map(String::as_str));
    for point in points.iter().step_by(step) {
        let found = |si: Option<f64>, dimension: Dimension| {
            si.map_or("–".into(), |value| number(value, dimension, units))
        };
        table.row(vec![
            without_trailing_zeros(&number(point.value(), dimension, units)).to_owned(),
            found(point.found.map(|state| state.side_force_N[0]), Dimension::Force),
            found(point.found.map(|state| state.side_force_N[1]), Dimension::Force),
            found(point.found.map(|state| state.tilt_rad[0]), Dimension::Angle),
        ]);
    }
    format!("\n{}", table.text())
}

fn holding(summary: &BhaSummary, units: UnitSet) -> String {
    let lines = tendency(summary, units).into_iter().map(|sentence| format!("{sentence}\n"));
    std::iter::once("\n".to_owned()).chain(lines).collect()
}

/// An error with one significant digit.
fn small(si: f64, dimension: Dimension, units: UnitSet) -> String {
    let value = dimension.unit_in(units).from_si(si);
    if value >= 1e-3 || value == 0.0 {
        number(si, dimension, units)
    } else {
        format!("{value:.0e}")
    }
}
