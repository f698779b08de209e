//! `wholestring calibrate`: friction factors from readings at the surface.

use std::{num::NonZeroUsize, path::PathBuf};

use clap::{Args, ValueEnum};
use wholestring::outcome::ModelKind;
use wholestring_case::Override;
use wholestring_results::{CalibrationSummary, EstimateFound, OutlierComparison};
use wholestring_runner::job::{CalibrateOptions, Job, Work};
use wholestring_units::{Dimension, UnitSet};

use crate::{
    screen::Table,
    shared_args::{OutputArgs, PageArgs},
};

// Arguments of `wholestring calibrate`.

#[derive(Debug, Args)]
// Not a doc comment, which would read `<case name>` as HTML.
#[command(mut_arg("output", |arg| {
    arg.help("Folder for the results [default: out/<case name> calibration]")
}))]
pub(crate) struct CalibrateArgs {
    /// Case files, one for each string that was in the hole. With several, the column `case` of the
    /// readings gives the file or the name of the case
    #[arg(value_name = "CASE.toml", required = true)]
    pub(crate) cases: Vec<PathBuf>,

    /// Readings as CSV or Excel: bit depth, pick-up, slack-off and rotating weight, torque, torque
    /// on bottom, with units in their headings
    #[arg(long, value_name = "FILE")]
    pub(crate) data: PathBuf,

    /// Set a key of every case, such as `mud.density=1.1sg`. Repeatable
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub(crate) overrides: Vec<Override>,

    /// Fit one friction factor for cased and open hole
    #[arg(long)]
    one_factor: bool,

    /// Fit a friction factor for each hole section, such as a liner and the casing above it
    /// separately
    #[arg(long, conflicts_with = "one_factor")]
    by_section: bool,

    /// Fit rotational friction separately from axial friction
    #[arg(long)]
    friction_around: bool,

    /// Fit the block weight although the case gives it
    #[arg(long)]
    block_weight: bool,

    /// Fit the bit torque on bottom
    #[arg(long)]
    bit_torque: bool,

    /// Keep a parameter fixed, such as `friction_cased=0.2` or `block_weight=180kN`.
    /// Repeatable
    #[arg(long, value_name = "NAME=VALUE")]
    hold: Vec<String>,

    /// Standard error of pick-up and slack-off weights, such as 12kN [default: estimated]
    #[arg(long, value_name = "FORCE")]
    weight_error: Option<String>,

    /// Standard error of rotating weights [default: estimated]
    #[arg(long, value_name = "FORCE")]
    rotating_error: Option<String>,

    /// Standard error of torques, such as 500N.m [default: estimated]
    #[arg(long, value_name = "TORQUE")]
    torque_error: Option<String>,

    /// Number of standard errors beyond which a residual is an outlier
    #[arg(long, value_name = "N", default_value = "3")]
    outlier: String,

    /// Exclude the outliers from the fit; by default both fits are shown
    #[arg(long)]
    without_outliers: bool,

    /// Confidence of the bands, %
    #[arg(long, value_name = "PERCENT", default_value = "90")]
    band: String,

    /// Model used for the predictions
    #[arg(long, value_enum, default_value = "soft")]
    pub(crate) model: Model,

    /// Run the dynamic model with the fitted values and compare it with the readings at these bit
    /// depths, such as `6945ft,8391ft` [default: the shallowest, the middle and the deepest]
    #[arg(
        long,
        value_name = "DEPTHS",
        value_delimiter = ',',
        num_args = 0..,
        require_equals = true
    )]
    check_dynamics: Option<Vec<String>>,

    /// Number of parallel jobs for --check-dynamics [default: one per core]
    #[arg(short, long, value_name = "N", requires = "check_dynamics")]
    pub(crate) jobs: Option<NonZeroUsize>,

    #[command(flatten)]
    pub(crate) output: OutputArgs,

    #[command(flatten)]
    pub(crate) page: PageArgs,
}

impl CalibrateArgs {
    /// The job of these arguments.
    pub(crate) fn job(&self) -> Job {
        let work = Work::Calibrate(CalibrateOptions {
            data: self.data.clone(),
            other_cases: self.cases.iter().skip(1).cloned().collect(),
            one_factor: self.one_factor,
            by_section: self.by_section,
            friction_around: self.friction_around,
            block_weight: self.block_weight,
            bit_torque: self.bit_torque,
            hold: self.hold.clone(),
            weight_error: self.weight_error.clone(),
            rotating_error: self.rotating_error.clone(),
            torque_error: self.torque_error.clone(),
            outlier: Some(self.outlier.clone()),
            without_outliers: self.without_outliers,
            band: Some(self.band.clone()),
            model: Some(self.model.into()),
            check_dynamics: self.check_dynamics.is_some(),
            check_depths: self.check_dynamics.clone().unwrap_or_default(),
            png: self.page.png,
        });
        Job {
            set: self.overrides.clone(),
            output: self.output.output(),
            units: self.page.units,
            jobs: self.jobs,
            ..Job::new(self.cases.first().cloned(), work)
        }
    }
}

/// A model that predicts readings.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub(crate) enum Model {
    /// String without bending stiffness
    Soft,
    /// String with bending stiffness; takes minutes
    Stiff,
}

impl From<Model> for ModelKind {
    fn from(model: Model) -> Self {
        match model {
            Model::Soft => Self::Soft,
            Model::Stiff => Self::Stiff,
        }
    }
}

// Output of a calibration on the screen.

/// A factor with four decimals, a weight or torque in the chosen unit.
fn shown(estimate: &EstimateFound, value: f64, units: UnitSet) -> String {
    let dimension = match estimate.parameter.as_str() {
        "block_weight_N" => Dimension::Force,
        "bit_torque_N_m" => Dimension::Torque,
        _ => return format!("{value:.4}"),
    };
    let unit = dimension.unit_in(units);
    format!("{:.2} {}", unit.from_si(value), unit.symbol)
}

/// The estimates as a table, notes and warnings.
pub(crate) fn text(summary: &CalibrationSummary, units: UnitSet) -> String {
    let title =
        format!("{}: {} readings, {} string", summary.title(), summary.readings, summary.model);
    let interval = format!("interval of {:.0} %", 100.0 * summary.confidence);
    let mut table = Table::new(&title, 1, &["number", "value", "standard error", &interval]);
    for estimate in &summary.estimates {
        let show = |value: f64| shown(estimate, value, units);
        let end = |end: Option<f64>| end.map_or("not found".to_owned(), show);
        table.row(vec![
            estimate.words.clone(),
            show(estimate.value),
            estimate.standard_error.map_or("at zero".to_owned(), show),
            format!("{} to {}", end(estimate.interval[0]), end(estimate.interval[1])),
        ]);
    }
    let mut text = table.text();
    if let Some(other) = &summary.comparison {
        text += &comparison(summary, other, units);
    }
    text.extend(summary.warnings.iter().map(|warning| format!("warning: {warning}\n")));
    text += &format!(
        "χ² {:.1}, {} degrees of freedom; {}\n",
        summary.chi2, summary.degrees_of_freedom, summary.status
    );
    if summary.held_out > 0 {
        text += &format!(
            "held out: {} of {} readings within the band\n",
            summary.held_out_within_band, summary.held_out
        );
    }
    if !summary.dynamics.is_empty() {
        text += &dynamics(summary, units);
    }
    text.extend(summary.notes.iter().map(|note| format!("note: {note}\n")));
    text
}

/// The estimates of all readings next to those without the outliers.
fn comparison(summary: &CalibrationSummary, other: &OutlierComparison, units: UnitSet) -> String {
    let mut table =
        Table::new("With and without outliers", 1, &["number", "all readings", "without outliers"]);
    for estimate in &summary.estimates {
        let same = other.estimates.iter().find(|one| one.parameter == estimate.parameter);
        let value = |estimate: Option<&EstimateFound>| {
            estimate.map_or("–".to_owned(), |estimate| {
                let error = estimate
                    .standard_error
                    .map_or(String::new(), |error| format!(" ± {}", shown(estimate, error, units)));
                shown(estimate, estimate.value, units) + &error
            })
        };
        let (own, same) = (value(Some(estimate)), value(same));
        let [all, without] = if other.left_out { [same, own] } else { [own, same] };
        table.row(vec![estimate.words.clone(), all, without]);
    }
    table.text()
}

/// Readings next to the results of the dynamic model.
fn dynamics(summary: &CalibrationSummary, units: UnitSet) -> String {
    let depth = Dimension::Length.unit_in(units);
    let title = "Checked by the dynamics: mean and standard deviation";
    let fitted = format!("{} string", summary.model);
    let at = format!("bit at, {}", depth.symbol);
    let headings = ["reading", "unit", &at, "measured", &fitted, "in motion", "±"];
    let mut table = Table::new(title, 2, &headings);
    for dynamic in &summary.dynamics {
        let unit =
            if dynamic.is_torque { Dimension::Torque } else { Dimension::Force }.unit_in(units);
        let digits = if unit.from_si(dynamic.measured).abs() < 1000.0 { 2 } else { 0 };
        let number = |value: f64| format!("{:.digits$}", unit.from_si(value));
        let [mean, std] =
            dynamic.dynamic.map_or(["no answer".to_owned(), "–".to_owned()], |found| {
                [number(found.mean), number(found.std)]
            });
        let reading = dynamic.reading.replace('_', "-");
        let at = format!("{:.0}", depth.from_si(dynamic.bit_depth_m));
        let symbol = unit.symbol.to_owned();
        table.row(vec![
            reading,
            symbol,
            at,
            number(dynamic.measured),
            number(dynamic.predicted),
            mean,
            std,
        ]);
    }
    table.text()
}
