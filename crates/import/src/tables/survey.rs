//! A survey in a table.

use wholestring::well::{Interpolation, Path};
use wholestring_tabular::{
    About, Column, ImportedSurvey, Said, Stated, SurveyTable, TableErrorKind, read_all,
};
use wholestring_units::Dimension;

use crate::{
    choices::Choices,
    doubts,
    error::{ImportError, ImportErrorKind},
    fragment::{Entry, Fragment, Note, Origin, Survey, Value},
};

/// Name in `--pick` of one of several surveys in a file, and names in `--unit` of measured depths
/// and of the lengths of positions.
const TABLE: &str = "table";
const DEPTH: &str = "md";
const POSITION: &str = "tvd";

/// Reads the survey of a file.
pub(crate) fn read(bytes: &[u8], name: &str, choices: &Choices) -> Result<Fragment, ImportError> {
    let (survey, left_out) = picked(tables(bytes, name, choices)?, name, choices)?;
    let mut notes: Vec<Note> = left_out.into_iter().collect();
    notes.extend(columns(&survey));
    notes.extend(checked(&survey, name)?);
    notes.extend(reference(&survey.preamble));
    notes.extend(survey.notes.iter().map(|text| match is_assumed(text) {
        true => Note::Assumed(text.clone()),
        false => doubts::table_note(text.clone()),
    }));
    let well = well(&survey.preamble);
    Ok(Fragment {
        what: format!("a survey of {} stations", survey.stations.len()),
        name: well,
        survey: Some(Survey {
            stations: survey.stations,
            tie_in: survey.tie_in,
            place: survey.place,
            units: survey.units.join(", "),
        }),
        notes,
        ..Fragment::default()
    })
}

/// Notes on positions that differ from those of the path, and on implausible turns.
fn checked(survey: &ImportedSurvey, name: &str) -> Result<Vec<Note>, ImportError> {
    let set = survey.unit_set();
    let path = Path::new(&survey.stations, Interpolation::MinimumCurvature, survey.start());
    let path = path.map_err(|error| {
        let place = error.index().map(|index| survey.places.row_name(index));
        let kind = ImportErrorKind::Refused(format!("its stations make no path: {error}"));
        ImportError::new(name, place, kind)
    })?;
    let place = |index| survey.places.row_name(index);
    let mut notes = doubts::positions(&survey.stations, &survey.stated, &path, set, place);
    notes.extend(doubts::notes(&survey.stations, set, place));
    Ok(notes)
}

/// Returns the tables of a file that are surveys.
fn tables(bytes: &[u8], name: &str, choices: &Choices) -> Result<Vec<SurveyTable>, ImportError> {
    let unit_of = |unit: &str| {
        let unit = choices.unit_of(&[unit], Dimension::Length);
        unit.map_err(|kind| ImportError::new(name, None, kind))
    };
    let mut known = Said { length_unit: unit_of(DEPTH)?, ..Said::default() };
    let found = read_all(bytes, name, &known).map_err(with_option)?;
    // A choice counts as used only for a file that needs it.
    let lacks = |table: &SurveyTable| {
        let kind = table.survey.as_ref().err().map(|error| error.kind());
        matches!(kind, Some(TableErrorKind::MissingUnit { column, .. })
            if *column != Column::MeasuredDepth)
    };
    if found.iter().any(lacks) {
        known.position_unit = unit_of(POSITION)?;
        return read_all(bytes, name, &known).map_err(with_option);
    }
    Ok(found)
}

/// Returns the picked survey of several, with a note on the others.
fn picked(
    mut tables: Vec<SurveyTable>,
    file: &str,
    choices: &Choices,
) -> Result<(ImportedSurvey, Option<Note>), ImportError> {
    let error = |kind| ImportError::new(file, None, kind);
    let names: Vec<String> = tables.iter().map(|table| table.name.clone()).collect();
    let at = match names.len() {
        0 | 1 => 0,
        _ => {
            let what = TABLE.to_owned();
            let Some(name) = choices.picked(TABLE) else {
                return Err(error(ImportErrorKind::Ambiguous { what, names }));
            };
            let at = names.iter().position(|other| other == name);
            let name = name.to_owned();
            at.ok_or_else(|| error(ImportErrorKind::NoSuch { what, name, names: names.clone() }))?
        }
    };
    if tables.is_empty() {
        return Err(error(ImportErrorKind::Missing { what: "a survey".to_owned() }));
    }
    let survey = tables.swap_remove(at).survey.map_err(with_option)?;
    let others: Vec<String> = names
        .iter()
        .enumerate()
        .filter(|(other, _)| *other != at)
        .map(|(_, name)| format!("'{name}'"))
        .collect();
    let left_out = (!others.is_empty()).then(|| {
        Note::LeftOut(format!(
            "the survey {}, because '{}' was picked",
            others.join(", "),
            names[at]
        ))
    });
    Ok((survey, left_out))
}

/// The error of a table, with a missing unit as the option of an import.
fn with_option(error: wholestring_tabular::TableError) -> ImportError {
    let (column, name) = match error.kind() {
        TableErrorKind::NoUnits => (Column::MeasuredDepth, DEPTH),
        TableErrorKind::MissingUnit { column: Column::MeasuredDepth, .. } => {
            (Column::MeasuredDepth, DEPTH)
        }
        TableErrorKind::MissingUnit { column, .. } => (*column, POSITION),
        _ => return error.into(),
    };
    let kind = ImportErrorKind::MissingUnit {
        what: column.to_string(),
        name: name.to_owned(),
        dimension: column.dimension(),
    };
    ImportError::new(error.file(), error.place().map(ToString::to_string), kind)
}

/// Note on the columns that are not used.
fn columns(survey: &ImportedSurvey) -> Option<Note> {
    let first = survey.stated.first().copied().unwrap_or_default();
    let position = [
        (first.tvd_m.is_some(), "true vertical depth"),
        (first.north_m.is_some(), "north"),
        (first.east_m.is_some(), "east"),
    ];
    let mut left: Vec<String> =
        position.iter().filter(|(is, _)| *is).map(|(_, name)| (*name).to_owned()).collect();
    left.extend(survey.unread.iter().map(|heading| format!("'{heading}'")));
    if left.is_empty() {
        return None;
    }
    let tie_in = match survey.tie_in {
        Some(_) => "; of positions, the first station's is kept",
        None => "",
    };
    Some(Note::LeftOut(format!(
        "the columns {}: the path follows from measured depth, inclination and azimuth{tie_in}",
        left.join(", ")
    )))
}

/// Name of the well: that of the wellbore, preceded by the well's unless it already contains it.
fn well(preamble: &[Stated]) -> Option<Entry> {
    let entry = |about| preamble.iter().find(|stated| stated.about == about);
    let (name, place) = match (entry(About::Well), entry(About::Wellbore)) {
        (Some(well), Some(bore)) if !bore.value.contains(&well.value) => (
            format!("{}, {}", well.value, bore.value),
            format!("{} and {}, well and wellbore", well.place, bore.place),
        ),
        (_, Some(bore)) => (bore.value.clone(), format!("{}, wellbore", bore.place)),
        (Some(well), None) => (well.value.clone(), format!("{}, well", well.place)),
        (None, None) => return None,
    };
    Some(Entry { key: "name", value: Value::text(name), origin: Origin::at(place) })
}

/// Notes on the references of azimuths and depths, and that nothing is rotated or shifted.
fn reference(preamble: &[Stated]) -> Vec<Note> {
    let entry = |about| preamble.iter().find(|stated| stated.about == about);
    let mut notes = Vec::new();
    for (about, what) in [
        (About::Design, "the design"),
        (About::DepthReference, "the reference of depths"),
        (About::Method, "the method of the file"),
    ] {
        if let Some(Stated { value, place, .. }) = entry(about) {
            notes.push(Note::Read(format!("{what} is '{value}' ({place})")));
        }
    }
    for (about, what) in [
        (About::NorthReference, "the north reference"),
        (About::Declination, "the magnetic declination"),
        (About::Convergence, "the convergence of the grid"),
    ] {
        if let Some(Stated { value, place, .. }) = entry(about) {
            notes.push(Note::Read(format!(
                "{what} is '{value}' ({place}): azimuths are used as written"
            )));
        }
    }
    notes
}

/// Whether a note of the reader is on an assumption.
fn is_assumed(note: &str) -> bool {
    let begins = ["no unit for inclination", "no unit for azimuth", "three columns read as"];
    begins.iter().any(|begin| note.starts_with(begin))
        || note.contains("taken as 0")
        || note.contains("assumed at a true vertical depth")
}
