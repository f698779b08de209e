//! Position and dogleg severity along a survey.

use std::{io, path::Path};

use wholestring::well::{
    Interpolation, Path as WellPath, PathError, PathPoint, USUAL_DOGLEG_RAD_PER_M,
};
use wholestring_case::{Diagnostic, Label, Report, Severity, Source, Span, read_file};
pub use wholestring_tabular::{ImportedSurvey, Said};
use wholestring_tabular::{
    Place, TableError, position_checks, read_as, station_doubts, straight_start, surface_doubts,
};

use wholestring_units::{Dimension, UnitSet};

use crate::Error;

/// Reads a survey from a file in any of its formats.
///
/// # Errors
/// It cannot be read, or is no survey.
pub fn read(file: &Path, options: &Said) -> Result<ImportedSurvey, Error> {
    if file.extension().is_some_and(|extension| extension == "toml") {
        return Err(Error::BadInput(format!(
            "{0} is a case file: expected a survey as CSV or Excel\nwrite the survey of the case \
             with `wholestring export --to csv --what survey {0}`",
            file.display()
        )));
    }
    let bytes = bytes(file, "survey")?;
    read_as(&bytes, &file.display().to_string(), options).map_err(|error| explained(&error))
}

/// Content of a file, which error messages call a `noun`.
pub(crate) fn bytes(file: &Path, noun: &str) -> Result<Vec<u8>, Error> {
    read_file(file).map_err(|error| {
        let reason = match error.kind() {
            io::ErrorKind::NotFound => "there is no such file".to_owned(),
            _ => error.to_string(),
        };
        Error::BadInput(format!("the {noun} {} cannot be read: {reason}", file.display()))
    })
}

/// Error of a mistake in a table, underlined if possible.
pub(crate) fn explained(error: &TableError) -> Error {
    match report(error) {
        Some(report) => report.into(),
        None => Error::BadInput(error.to_string()),
    }
}

/// The mistake underlined in the survey, if it is a text file.
fn report(error: &TableError) -> Option<Report> {
    let (text, span) = error.text().zip(error.span())?;
    let sentence = error.sentence();
    let (message, expected) = sentence.split_once("; ").unwrap_or((&sentence, ""));
    Some(Report {
        sources: vec![Source { name: error.file().to_owned(), text: text.to_owned() }],
        diagnostics: vec![Diagnostic {
            severity: Severity::Error,
            message: message.to_owned(),
            labels: vec![Label {
                place: Span { source: 0, start: span.start, end: span.end },
                text: expected.to_owned(),
            }],
            help: Vec::new(),
        }],
    })
}

/// Reports doubtful data of a survey, each with its row: positions in the file that differ from
/// those of its path, a path to which no hole from the surface leads, and unusually sharp turns. Positions that agree are among the notes.
///
/// # Errors
/// There is no path through the stations; the error contains the row of the station and the reason.
pub fn check(
    survey: &ImportedSurvey,
    file: &Path,
    interpolation: Interpolation,
    set: UnitSet,
) -> Result<(Report, Vec<String>), Error> {
    let name = file.display().to_string();
    let path = WellPath::new(&survey.stations, interpolation, survey.start());
    let path = path.map_err(|error| no_path(survey, &name, &error))?;
    let mut notes: Vec<String> = straight_start(&path, set).into_iter().collect();
    let mut diagnostics = Vec::new();
    for check in position_checks(&survey.stations, &survey.stated, &path, set) {
        if check.agrees {
            notes.push(check.sentence);
            continue;
        }
        let warning = Diagnostic::warning(check.sentence).help(check.reason);
        diagnostics.push(at_station(survey, warning, check.index, "the file's position"));
    }
    let turns = station_doubts(&survey.stations, USUAL_DOGLEG_RAD_PER_M, set);
    for doubt in surface_doubts(&path, set).into_iter().chain(turns) {
        let warning = Diagnostic::warning(doubt.sentence).help(doubt.help);
        diagnostics.push(at_station(survey, warning, doubt.index, &doubt.label));
    }
    Ok((Report { sources: vec![source(survey, &name)], diagnostics }, notes))
}

/// Error that there is no path, at the row of the station.
fn no_path(survey: &ImportedSurvey, name: &str, error: &PathError) -> Error {
    let sentence = Diagnostic::error(error.to_string());
    let diagnostic = match error.index() {
        Some(index) => at_station(survey, sentence, index, "this station"),
        None => sentence,
    };
    Report { sources: vec![source(survey, name)], diagnostics: vec![diagnostic] }.into()
}

fn source(survey: &ImportedSurvey, name: &str) -> Source {
    Source { name: name.to_owned(), text: survey.places.text().unwrap_or_default().to_owned() }
}

/// Adds the row of a station: underlined in a text file, named for a workbook.
fn at_station(
    survey: &ImportedSurvey,
    mut diagnostic: Diagnostic,
    index: usize,
    label: &str,
) -> Diagnostic {
    match survey.places.place(index) {
        Some(Place::Text { span, .. }) => {
            let place = Span { source: 0, start: span.start, end: span.end };
            diagnostic.labels.push(Label { place, text: label.to_owned() });
        }
        Some(Place::Cell { .. }) => {
            diagnostic.help.insert(0, format!("{}: {label}", survey.places.row_name(index)));
        }
        None => {}
    }
    diagnostic
}

/// A point along a survey.
#[derive(Debug, Clone, Copy)]
pub struct Position {
    /// Measured depth, m.
    pub md_m: f64,
    /// Position and direction of the hole.
    pub point: PathPoint,
    /// Dogleg severity since the point above, rad/m; zero at the first.
    pub dogleg_severity_rad_per_m: f64,
}

/// Every station of a survey, and every multiple of `step_m` between them, on the curve through the
/// stations.
///
/// # Errors
/// There is no path through them.
pub fn positions(
    survey: &ImportedSurvey,
    interpolation: Interpolation,
    step_m: Option<f64>,
) -> Result<Vec<Position>, PathError> {
    let path = WellPath::new(&survey.stations, interpolation, survey.start())?;
    let mut depths: Vec<f64> = path.stations().iter().map(|station| station.md_m).collect();
    if let Some(step_m) = step_m {
        let first = (path.first_md_m() / step_m).ceil() as i64;
        let last = (path.last_md_m() / step_m).floor() as i64;
        depths.extend((first..=last).map(|index| index as f64 * step_m));
        depths.sort_by(f64::total_cmp);
        // Removes a multiple that equals a station except for rounding.
        depths.dedup_by(|b, a| *b - *a < 1e-6);
    }
    let mut above: Option<(f64, PathPoint)> = None;
    let positions = depths.into_iter().map(|md_m| {
        let point = path.at(md_m);
        let dogleg_severity_rad_per_m = above.map_or(0.0, |(md_above_m, point_above)| {
            point_above.dogleg_rad(&point) / (md_m - md_above_m)
        });
        above = Some((md_m, point));
        Position { md_m, point, dogleg_severity_rad_per_m }
    });
    Ok(positions.collect())
}

/// Positions as CSV in the lengths and dogleg severities of a unit set, to millionths of a unit.
/// Angles are in degrees, as in surveys everywhere; the output can be read as a survey again.
pub fn to_csv(positions: &[Position], set: UnitSet) -> String {
    let length = Dimension::Length.unit_in(set);
    let severity = Dimension::DoglegSeverity.unit_in(set);
    let mut text = format!(
        "md_{0},inclination_deg,azimuth_deg,tvd_{0},north_{0},east_{0},dogleg_severity_{1}\n",
        length.symbol,
        severity.symbol.replace('/', "_per_"),
    );
    for Position { md_m, point, dogleg_severity_rad_per_m } in positions {
        let [north_m, east_m, tvd_m] = point.position_m.into();
        let cells = [
            length.from_si(*md_m),
            point.inclination_rad().to_degrees(),
            point.azimuth_rad().to_degrees(),
            length.from_si(tvd_m),
            length.from_si(north_m),
            length.from_si(east_m),
            severity.from_si(*dogleg_severity_rad_per_m),
        ];
        // Removes the sign of a rounded zero.
        let cells = cells.map(|value| format!("{value:.6}").replace("-0.000000", "0.000000"));
        text += &(cells.join(",") + "\n");
    }
    text
}
