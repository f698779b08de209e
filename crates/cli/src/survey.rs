//! `wholestring survey`: position and dogleg severity along a survey.

use std::{fs, io, path::Path};

use wholestring::well::{Interpolation, Path as WellPath};
use wholestring_case::{Diagnostic, Label, Report, Severity, Source, Span, read_file};
use wholestring_survey::{ImportedSurvey, Said, SurveyError, read_as};

use crate::{
    args::SurveyArgs,
    color::color,
    failure::Failure,
    terminal::{print_stderr, print_stdout},
};

/// Columns of the result. Surveys are in degrees everywhere, so that this one is too; `survey`
/// reads its own result.
const COLUMNS: [&str; 7] = [
    "md_m",
    "inclination_deg",
    "azimuth_deg",
    "tvd_m",
    "north_m",
    "east_m",
    "dogleg_severity_deg_per_30m",
];

pub(crate) fn survey(args: &SurveyArgs) -> Result<(), Failure> {
    let file = args.survey.display();
    let said = Said { length_unit: args.unit };
    let survey = read(&args.survey, &said)?;
    for note in &survey.notes {
        print_stderr(&format!("note: {note}\n"));
    }
    let interpolation = Interpolation::from(args.path);
    let path = WellPath::new(&survey.stations, interpolation, survey.start())
        .map_err(|error| Failure::BadInput(format!("error: {file}: {error}")))?;
    let text = rows(&path, args.step);
    match &args.output {
        Some(output) => fs::write(output, &text).map_err(|error| {
            Failure::Failed(format!("error: cannot write {}: {error}", output.display()))
        }),
        None => print_stdout(&text),
    }
}

fn read(path: &Path, said: &Said) -> Result<ImportedSurvey, Failure> {
    let name = path.display().to_string();
    let unreadable = |reason: &str| {
        Failure::BadInput(format!("error: the survey {name} cannot be read: {reason}"))
    };
    let bytes = read_file(path).map_err(|error| match error.kind() {
        io::ErrorKind::NotFound => unreadable("there is no such file"),
        _ => unreadable(&error.to_string()),
    })?;
    read_as(&bytes, &name, said).map_err(|error| match report(&error) {
        Some(report) => Failure::BadInput(report.render(color())),
        None => Failure::BadInput(format!("error: {error}")),
    })
}

/// The mistake underlined in the survey, where it is a text.
fn report(error: &SurveyError) -> Option<Report> {
    let (text, span) = error.text().zip(error.span())?;
    let sentence = error.kind().to_string();
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

/// Every station, and every multiple of `step_m` between them.
fn rows(path: &WellPath, step_m: Option<f64>) -> String {
    let mut depths: Vec<f64> = path.stations().iter().map(|station| station.md_m).collect();
    if let Some(step_m) = step_m {
        let first = (path.first_md_m() / step_m).ceil() as i64;
        let last = (path.last_md_m() / step_m).floor() as i64;
        depths.extend((first..=last).map(|index| index as f64 * step_m));
        depths.sort_by(f64::total_cmp);
        // A multiple that is a station but for rounding.
        depths.dedup_by(|b, a| *b - *a < 1e-6);
    }
    let mut text = COLUMNS.join(",") + "\n";
    let mut above: Option<(f64, _)> = None;
    for md_m in depths {
        let point = path.at(md_m);
        let tangent = point.tangent.into();
        let dogleg_deg_per_30m = above.map_or(0.0, |(md_above_m, tangent_above)| {
            angle_rad(&tangent_above, &tangent).to_degrees() / (md_m - md_above_m) * 30.0
        });
        above = Some((md_m, tangent));
        let [north, east, tvd] = point.position_m.into();
        let cells = [
            md_m,
            point.inclination_rad().to_degrees(),
            point.azimuth_rad().to_degrees(),
            tvd,
            north,
            east,
            dogleg_deg_per_30m,
        ];
        // Micrometres and millionths of a degree; without the sign of a rounded zero.
        let cells = cells.map(|value| format!("{value:.6}").replace("-0.000000", "0.000000"));
        text += &(cells.join(",") + "\n");
    }
    text
}

/// Angle between two unit vectors, exact for small ones too.
fn angle_rad(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    let norm = |sign: f64| {
        let squares = a.iter().zip(b).map(|(a, b)| (a + sign * b).powi(2));
        squares.sum::<f64>().sqrt()
    };
    2.0 * norm(-1.0).atan2(norm(1.0))
}
