//! Arguments of `wholestring calibrate`.

use std::{num::NonZeroUsize, path::PathBuf};

use clap::{Args, ValueEnum};
use wholestring::outcome::ModelKind;
use wholestring_case::Override;
use wholestring_runner::job::{CalibrateOptions, Job, Work};

use crate::shared_args::{OutputArgs, PageArgs};

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
    pub(crate) one_factor: bool,

    /// Fit a friction factor for each hole section, such as a liner and the casing above it
    /// separately
    #[arg(long, conflicts_with = "one_factor")]
    pub(crate) by_section: bool,

    /// Fit rotational friction separately from axial friction
    #[arg(long)]
    pub(crate) friction_around: bool,

    /// Fit the block weight although the case gives it
    #[arg(long)]
    pub(crate) block_weight: bool,

    /// Fit the bit torque on bottom
    #[arg(long)]
    pub(crate) bit_torque: bool,

    /// Keep a parameter fixed, such as `friction_cased=0.2` or `block_weight=180kN`.
    /// Repeatable
    #[arg(long, value_name = "NAME=VALUE")]
    pub(crate) hold: Vec<String>,

    /// Standard error of pick-up and slack-off weights, such as 12kN [default: estimated]
    #[arg(long, value_name = "FORCE")]
    pub(crate) weight_error: Option<String>,

    /// Standard error of rotating weights [default: estimated]
    #[arg(long, value_name = "FORCE")]
    pub(crate) rotating_error: Option<String>,

    /// Standard error of torques, such as 500N.m [default: estimated]
    #[arg(long, value_name = "TORQUE")]
    pub(crate) torque_error: Option<String>,

    /// Number of standard errors beyond which a residual is an outlier
    #[arg(long, value_name = "N", default_value = "3")]
    pub(crate) outlier: String,

    /// Exclude the outliers from the fit; by default both fits are shown
    #[arg(long)]
    pub(crate) without_outliers: bool,

    /// Confidence of the bands, %
    #[arg(long, value_name = "PERCENT", default_value = "90")]
    pub(crate) band: String,

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
    pub(crate) check_dynamics: Option<Vec<String>>,

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
