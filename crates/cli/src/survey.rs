//! `wholestring survey`: position and dogleg severity along a survey.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use wholestring::well::Interpolation;
use wholestring_results::write_file;
use wholestring_runner::survey::{self, Said};
use wholestring_units::{Dimension, Unit, UnitSet};

use crate::{
    failure::Failure,
    screen::color,
    terminal::{print_stderr, print_stdout},
};

/// Shortest step between rows: a well of 10 km is ten million rows of a millimetre.
const SHORTEST_STEP_M: f64 = 0.01;

#[derive(Debug, Args)]
pub(crate) struct SurveyArgs {
    /// Survey: measured depth, inclination, azimuth; CSV or Excel, units in the header or a row of
    /// their own
    #[arg(value_name = "SURVEY.csv")]
    pub(crate) survey: PathBuf,

    /// File for the result [default: the screen]
    #[arg(short, long, value_name = "OUT.csv")]
    pub(crate) output: Option<PathBuf>,

    /// Unit of length of the survey, such as ft, if the file does not give it
    #[arg(long, value_name = "UNIT", value_parser = length_unit)]
    pub(crate) unit: Option<&'static Unit>,

    /// Curve between the stations
    #[arg(long, value_enum, default_value_t = PathKind::MinimumCurvature)]
    pub(crate) path: PathKind,

    /// Units of the result and of messages [default: those of the survey]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,

    /// Interval of additional rows, such as 10m
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    pub(crate) step: Option<f64>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum PathKind {
    /// Circular arcs, the industry standard
    MinimumCurvature,
    /// Spline with continuous curvature
    Spline,
}

impl From<PathKind> for Interpolation {
    fn from(kind: PathKind) -> Self {
        match kind {
            PathKind::MinimumCurvature => Self::MinimumCurvature,
            PathKind::Spline => Self::Spline,
        }
    }
}

pub(crate) fn survey(args: &SurveyArgs) -> Result<(), Failure> {
    let survey = survey::read(&args.survey, &Said { length_unit: args.unit, ..Said::default() })?;
    for note in &survey.notes {
        print_stderr(&format!("note: {note}\n"));
    }
    let interpolation = Interpolation::from(args.path);
    let units = args.units.unwrap_or(survey.unit_set());
    let (doubts, notes) = survey::check(&survey, &args.survey, interpolation, units)?;
    for note in &notes {
        print_stderr(&format!("note: {note}\n"));
    }
    if !doubts.is_empty() {
        print_stderr(&doubts.render(color()));
    }
    let positions = survey::positions(&survey, interpolation, args.step);
    let file = args.survey.display();
    let positions =
        positions.map_err(|error| Failure::BadInput(format!("error: {file}: {error}")))?;
    let text = survey::to_csv(&positions, units);
    match &args.output {
        Some(output) => Ok(write_file(output, text.as_bytes())?),
        None => print_stdout(&text),
    }
}

fn length_unit(text: &str) -> Result<&'static Unit, String> {
    Dimension::Length.find_unit(text).ok_or_else(|| {
        let units = Dimension::Length.units().iter().map(|unit| unit.symbol);
        format!("expected one of {}", units.collect::<Vec<_>>().join(", "))
    })
}

fn length(text: &str) -> Result<f64, String> {
    let length = Dimension::Length.parse(text).map_err(|error| error.to_string())?;
    if length >= SHORTEST_STEP_M && length.is_finite() {
        Ok(length)
    } else {
        Err(format!("expected at least {SHORTEST_STEP_M} m"))
    }
}
