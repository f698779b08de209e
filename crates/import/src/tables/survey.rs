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
    tables::note,
};

/// What `--pick` calls one of several surveys in a file, and what `--unit` calls measured depths and
/// the lengths of positions.
const TABLE: &str = "table";
const DEPTH: &str = "md";
const POSITION: &str = "tvd";

/// The survey of a file.
pub(crate) fn read(bytes: &[u8], name: &str, choices: &Choices) -> Result<Fragment, ImportError> {
    let (survey, left_out) = picked(tables(bytes, name, choices)?, name, choices)?;
    let mut notes: Vec<Note> = left_out.into_iter().collect();
    notes.extend(columns(&survey));
    notes.extend(checked(&survey, name)?);
    notes.extend(reference(&survey.preamble));
    notes.extend(survey.notes.iter().map(|text| match is_assumed(text) {
        true => Note::Assumed(text.clone()),
        false => note::of(text.clone()),
    }));
    let of = well(&survey.preamble);
    Ok(Fragment {
        what: format!("a survey of {} stations", survey.stations.len()),
        name: of,
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

/// The positions of the file against those of its path, and turns that are hardly the hole's.
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

/// The tables of a file that are surveys.
fn tables(bytes: &[u8], name: &str, choices: &Choices) -> Result<Vec<SurveyTable>, ImportError> {
    let said = |unit: &str| {
        let unit = choices.unit_of(&[unit], Dimension::Length);
        unit.map_err(|kind| ImportError::new(name, None, kind))
    };
    let mut known = Said { length_unit: said(DEPTH)?, ..Said::default() };
    let found = read_all(bytes, name, &known).map_err(asked)?;
    // Only a file that asks for it is told.
    let lacks = |table: &SurveyTable| {
        let kind = table.survey.as_ref().err().map(|error| error.kind());
        matches!(kind, Some(TableErrorKind::MissingUnit { column, .. })
            if *column != Column::MeasuredDepth)
    };
    if found.iter().any(lacks) {
        known.position_unit = said(POSITION)?;
        return read_all(bytes, name, &known).map_err(asked);
    }
    Ok(found)
}

/// One survey of several, and what the others are.
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
            let at = names.iter().position(|of| of == name);
            let name = name.to_owned();
            at.ok_or_else(|| error(ImportErrorKind::NoSuch { what, name, names: names.clone() }))?
        }
    };
    if tables.is_empty() {
        return Err(error(ImportErrorKind::Missing { what: "a survey".to_owned() }));
    }
    let survey = tables.swap_remove(at).survey.map_err(asked)?;
    let others: Vec<String> = names
        .iter()
        .enumerate()
        .filter(|(other, _)| *other != at)
        .map(|(_, name)| format!("'{name}'"))
        .collect();
    let left_out = (!others.is_empty()).then(|| {
        Note::LeftOut(format!("the survey {}, for '{}' was picked", others.join(", "), names[at]))
    });
    Ok((survey, left_out))
}

/// The error of a table, which asks for a unit as an import is told it.
fn asked(error: wholestring_tabular::TableError) -> ImportError {
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

/// What becomes of the other columns.
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

/// The name of the well: that of the wellbore, after the well's where it does not hold it.
fn well(preamble: &[Stated]) -> Option<Entry> {
    let of = |about| preamble.iter().find(|stated| stated.about == about);
    let (name, place) = match (of(About::Well), of(About::Wellbore)) {
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

/// What azimuths and depths are counted from, and that nothing is turned or moved.
fn reference(preamble: &[Stated]) -> Vec<Note> {
    let of = |about| preamble.iter().find(|stated| stated.about == about);
    let mut notes = Vec::new();
    for (about, what) in [
        (About::Design, "the design"),
        (About::DepthReference, "the reference of depths"),
        (About::Method, "the method of the file"),
    ] {
        if let Some(Stated { value, place, .. }) = of(about) {
            notes.push(Note::Read(format!("{what} is '{value}' ({place})")));
        }
    }
    for (about, what) in [
        (About::NorthReference, "the north reference"),
        (About::Declination, "the magnetic declination"),
        (About::Convergence, "the convergence of the grid"),
    ] {
        if let Some(Stated { value, place, .. }) = of(about) {
            notes.push(Note::Read(format!(
                "{what} is '{value}' ({place}): azimuths stay as they are written"
            )));
        }
    }
    notes
}

/// Notes of the reader that say what the file does not.
fn is_assumed(note: &str) -> bool {
    let begins = ["no unit for inclination", "no unit for azimuth", "three columns read as"];
    begins.iter().any(|of| note.starts_with(of))
        || note.contains("taken as 0")
        || note.contains("taken to be as deep")
}
