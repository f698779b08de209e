//! Information in a report above its table.

use crate::cells::table::{Position, Source, Table};

/// A label of a report, with its spellings in lower case without blanks.
const LABELS: &[(About, &str)] = &[
    (About::Well, "well wellname nameofwell"),
    (About::Wellbore, "wellbore wellborename borehole boreholename"),
    (About::Design, "design surveyname planname trajectoryname"),
    (About::NorthReference, "northreference azimuthreference northref azimuthnorthreference"),
    (About::DepthReference, "mdreference depthreference mdref tvdreference tvdref"),
    (
        About::Method,
        "surveycalculationmethod calculationmethod surveycalculation calcmethod tvdcalculationmethod",
    ),
    (About::Declination, "magneticdeclination declination magdec magneticdecl"),
    (About::Convergence, "gridconvergence convergence gridconv"),
];

/// Number of lines above a table that are searched for labels.
const LINES: usize = 200;

/// Maximum length of a label or its value, bytes.
const LONGEST: usize = 200;

/// Kind of information above a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum About {
    /// Name of the well.
    Well,
    /// Name of the wellbore.
    Wellbore,
    /// Name of the design or of the survey.
    Design,
    /// Reference of azimuths.
    NorthReference,
    /// Reference of depths.
    DepthReference,
    /// Method by which positions were computed.
    Method,
    /// Magnetic declination.
    Declination,
    /// Grid convergence.
    Convergence,
}

/// Information above a table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Stated {
    /// Its kind.
    pub about: About,
    /// The text as written.
    pub value: String,
    /// Its place: `line 5`, `row 2 of sheet 'Survey'`.
    pub place: String,
}

/// Information above a row of a table; the first of each kind.
pub(crate) fn above(table: &Table, row: usize) -> Vec<Stated> {
    let mut found: Vec<Stated> = Vec::new();
    for row in &table.rows[row.saturating_sub(LINES)..row] {
        // A line that was cut under columns of numbers is cut again at its own separators.
        let parts: Vec<&str> = match (table.source, table.parted_by) {
            (Source::Text { text, .. }, Some("blanks")) => {
                let line = text[..row.end.0].rfind(['\n', '\r']).map_or(0, |end| end + 1);
                text[line..row.end.0].split("  ").flat_map(|part| part.split('\t')).collect()
            }
            _ => row.texts().collect(),
        };
        let parts: Vec<&str> = parts.into_iter().map(str::trim).filter(|p| !p.is_empty()).collect();
        let are_cells = table.parted_by != Some("blanks");
        for (about, value) in pairs(&parts, are_cells) {
            if !found.iter().any(|stated| stated.about == about) {
                let place = table.source.row_name(Position(row.end.0, 0));
                found.push(Stated { about, value: value.to_owned(), place });
            }
        }
    }
    found
}

/// Labels and values in the parts of a line: `Well: S-1`, or a label with its value in the next
/// part. A label in its own cell needs no colon.
fn pairs<'a>(parts: &[&'a str], are_cells: bool) -> Vec<(About, &'a str)> {
    let mut pairs = Vec::new();
    for (at, part) in parts.iter().enumerate() {
        let part = part.trim_start_matches(['#', '%', '/', ' ']);
        let (label, value) = match part.split_once([':', '=']) {
            Some(pair) => pair,
            None if are_cells => (part, ""),
            None => continue,
        };
        let next = parts.get(at + 1).copied().filter(|next| !next.contains(':'));
        let value = if value.trim().is_empty() { next.unwrap_or("") } else { value };
        let value = value.trim();
        let bare = value.strip_prefix('"').and_then(|value| value.strip_suffix('"'));
        let value = bare.unwrap_or(value).trim();
        if let Some(about) = label_of(label).filter(|_| !value.is_empty() && value.len() <= LONGEST)
        {
            pairs.push((about, value));
        }
    }
    pairs
}

fn label_of(label: &str) -> Option<About> {
    if label.len() > LONGEST {
        return None;
    }
    let plain: String =
        label.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase).collect();
    let is = |(_, names): &&(About, &str)| names.split(' ').any(|name| name == plain);
    LABELS.iter().find(is).map(|(about, _)| *about)
}

/// The title above a row: the nearest line of one phrase within a few lines.
pub(crate) fn title(table: &Table, row: usize) -> Option<String> {
    /// Maximum number of lines between a title and the header below it, including the header's
    /// other lines.
    const NEAR: usize = 6;
    table.rows[row.saturating_sub(NEAR)..row].iter().rev().find_map(|row| {
        let mut texts = row.texts();
        let (Some(only), None) = (texts.next(), texts.next()) else { return None };
        let title = only.trim_start_matches(['#', '%', '/', ' ']);
        let is_title = !title.is_empty()
            && title.len() <= 60
            && !title.contains(':')
            && !row.is_rule()
            && title.chars().any(char::is_alphabetic);
        is_title.then(|| title.to_owned())
    })
}
