//! Tables in text and workbooks: surveys, tallies, and weights read at the surface.

mod survey;
mod tally;

use wholestring_judge::{ReadingCheck, Severity};
use wholestring_tabular::{Held, TableErrorKind, held, read_readings, sheets};
use wholestring_units::{Unit, UnitSet};

use crate::{
    choices::Choices,
    error::{ImportError, ImportErrorKind},
    fragment::{Contents, Fragment, Note},
    input::Input,
    log,
};

/// Maximum bytes of a table; no table of a well is larger.
const LARGEST_BYTES: usize = 64 << 20;

/// Kinds of tables, as in `--pick table=`.
const SURVEY: &str = "survey";
const TALLY: &str = "tally";
const READINGS: &str = "readings";

/// Reads the tables of a file.
pub(crate) fn read(input: Input, choices: &Choices) -> Result<Fragment, ImportError> {
    let name = input.name().to_owned();
    let bytes = input.bytes(LARGEST_BYTES)?;
    let mut held = held(&bytes, &name)?;
    let sheets = sheets(&bytes, &name)?;
    let logs = log::sheet::logs(&sheets);
    if let Some(sheet) = log::sheet::picked(&logs, &name, choices)? {
        let mut whole = log::sheet::read(sheet, &name, choices)?;
        for kinds in [&mut held.surveys, &mut held.tallies, &mut held.readings] {
            kinds.retain(|kind| logs.iter().all(|sheet| sheet.name != *kind));
        }
        let readings = std::mem::take(&mut held.readings);
        if !readings.is_empty() {
            let text =
                format!("the weights in sheet '{}', in addition to a log", readings.join("', '"));
            whole.notes.push(Note::LeftOut(text));
        }
        return others(whole, &bytes, &held, &name, choices);
    }
    if sorts(&held, &name, choices)?.is_empty() {
        // A table without headings may still be a survey.
        return survey::read(&bytes, &name, choices).map_err(|error| unheaded(error, held, &name));
    }
    others(Fragment::default(), &bytes, &held, &name, choices)
}

/// Reads the other tables of a file and joins them to those read before.
fn others(
    mut whole: Fragment,
    bytes: &[u8],
    held: &Held,
    name: &str,
    choices: &Choices,
) -> Result<Fragment, ImportError> {
    for sort in sorts(held, name, choices)? {
        let fragment = match sort {
            SURVEY => survey::read(bytes, name, choices)?,
            TALLY => tally::read(bytes, name, sheet(&held.tallies, name, choices)?, choices)?,
            _ => readings(bytes, name)?,
        };
        join(&mut whole, fragment);
    }
    Ok(whole)
}

/// Describes a table and its contents.
pub(crate) fn contents(input: Input) -> Result<Contents, ImportError> {
    let name = input.name().to_owned();
    let bytes = input.bytes(LARGEST_BYTES)?;
    let sheets = sheets(&bytes, &name)?;
    let logs = log::sheet::logs(&sheets);
    if let [sheet, others @ ..] = logs.as_slice() {
        let mut contents = log::sheet::contents(sheet, &name)?;
        let others = others.iter().map(|sheet| format!("another log in sheet '{}'", sheet.name));
        contents.lines.extend(others);
        return Ok(contents);
    }
    let again = Input::of_bytes(name.clone(), &bytes);
    match read(again, &Choices::default()) {
        Ok(fragment) => {
            let mut lines: Vec<String> = fragment.string.iter().map(tally::line).collect();
            let errors = fragment.refused;
            let notes =
                fragment.notes.iter().filter(|note| !errors.iter().any(|own| own == note.text()));
            lines.extend(notes.map(|note| match note {
                Note::Warning(text) => format!("warning: {text}"),
                note => note.text().to_owned(),
            }));
            Ok(Contents { what: fragment.what, lines, errors })
        }
        // The table is recognised; the message lists the option that its import requires.
        Err(error) if is_asked(error.kind()) => {
            let held = held(&bytes, &name)?;
            let what = match (held.tallies.is_empty(), held.surveys.is_empty()) {
                (false, true) => "a tally",
                (true, false) => "a survey",
                _ => "a table",
            };
            let place = error.place().map_or(String::new(), |place| format!("{place}: "));
            let line = format!("to import it: {place}{}", error.kind());
            Ok(Contents { what: what.to_owned(), lines: vec![line], ..Contents::default() })
        }
        Err(error) => Err(error),
    }
}

/// Whether an option resolves the error.
fn is_asked(kind: &ImportErrorKind) -> bool {
    matches!(kind, ImportErrorKind::MissingUnit { .. } | ImportErrorKind::Ambiguous { .. })
}

/// Kinds of the tables of a file: the picked one, or those of all its sheets, each once.
fn sorts(held: &Held, name: &str, choices: &Choices) -> Result<Vec<&'static str>, ImportError> {
    let all: Vec<(&'static str, &Vec<String>)> =
        [(SURVEY, &held.surveys), (TALLY, &held.tallies), (READINGS, &held.readings)]
            .into_iter()
            .filter(|(_, sheets)| !sheets.is_empty())
            .collect();
    let names = || all.iter().map(|(sort, _)| (*sort).to_owned()).collect();
    let two_fit = all.iter().enumerate().any(|(i, (_, sheets))| {
        all[i + 1..].iter().any(|(_, others)| sheets.iter().any(|sheet| others.contains(sheet)))
    });
    if all.len() > 1
        && let Some(picked) = choices.picked("table")
    {
        return match all.iter().find(|(sort, _)| *sort == picked) {
            Some((sort, _)) => Ok(vec![sort]),
            None => {
                let kind = ImportErrorKind::NoSuch {
                    what: "table".to_owned(),
                    name: picked.to_owned(),
                    names: names(),
                };
                Err(ImportError::new(name, None, kind))
            }
        };
    }
    if two_fit {
        let kind = ImportErrorKind::Ambiguous { what: "table".to_owned(), names: names() };
        return Err(ImportError::new(name, None, kind));
    }
    Ok(all.into_iter().map(|(sort, _)| sort).collect())
}

/// Returns the sheet of the tally: the only one, or the picked one.
fn sheet<'a>(
    sheets: &'a [String],
    name: &str,
    choices: &Choices,
) -> Result<Option<&'a str>, ImportError> {
    let [_, _, ..] = sheets else { return Ok(sheets.first().map(String::as_str)) };
    let kind = match choices.picked("tally") {
        None => ImportErrorKind::Ambiguous { what: "tally".to_owned(), names: sheets.to_vec() },
        Some(picked) => match sheets.iter().find(|sheet| *sheet == picked) {
            Some(sheet) => return Ok(Some(sheet)),
            None => ImportErrorKind::NoSuch {
                what: "tally".to_owned(),
                name: picked.to_owned(),
                names: sheets.to_vec(),
            },
        },
    };
    Err(ImportError::new(name, None, kind))
}

/// Weights and torques at the surface.
fn readings(bytes: &[u8], name: &str) -> Result<Fragment, ImportError> {
    let read = read_readings(bytes, name)?;
    let is_field = read.units.into_iter().flatten().any(Unit::is_field);
    let units = if is_field { UnitSet::Field } else { UnitSet::Si };
    // The case gets the readings as they were read; a calibration checks them again.
    let (_, checks) = read.clone().measured(units);
    let sentence = |check: &ReadingCheck| check.check.sentence.clone();
    let is_error = |check: &&ReadingCheck| check.check.severity == Severity::Error;
    let notes = read.notes.into_iter().map(crate::doubts::table_note);
    Ok(Fragment {
        units: Some(units),
        what: format!("weights and torques at {} depths of the bit", read.readings.len()),
        measured: read.readings,
        notes: notes.chain(checks.iter().map(|check| Note::Warning(sentence(check)))).collect(),
        refused: checks.iter().filter(is_error).map(sentence).collect(),
        ..Fragment::default()
    })
}

/// Adds the contents of another sheet of the same file.
fn join(whole: &mut Fragment, part: Fragment) {
    let what = match whole.what.is_empty() {
        true => part.what,
        false => format!("{}, and {}", whole.what, part.what),
    };
    whole.what = what;
    whole.name = whole.name.take().or(part.name);
    whole.survey = whole.survey.take().or(part.survey);
    whole.hole.extend(part.hole);
    whole.string.extend(part.string);
    for (all, own) in [
        (&mut whole.mud, part.mud),
        (&mut whole.rig, part.rig),
        (&mut whole.operation, part.operation),
        (&mut whole.bit, part.bit),
    ] {
        all.entries.extend(own.entries);
    }
    whole.units = whole.units.or(part.units);
    whole.refused.extend(part.refused);
    whole.measured.extend(part.measured);
    whole.overlay.extend(part.overlay);
    whole.picks = whole.picks.take().or(part.picks);
    // Notes on hidden sheets apply to the whole file.
    let new = |note: &Note| !whole.notes.contains(note);
    let notes: Vec<Note> = part.notes.into_iter().filter(new).collect();
    whole.notes.extend(notes);
}

/// The error of a file without a header row.
fn unheaded(error: ImportError, held: Held, name: &str) -> ImportError {
    if let Some(nearly) = held.nearly_tally {
        return nearly.into();
    }
    let ImportErrorKind::Table(table) = error.kind() else { return error };
    if !matches!(table.kind(), TableErrorKind::NoHeader | TableErrorKind::NoSurveySheet { .. }) {
        return error;
    }
    let mut sentence =
        "no row names the columns; write headings above the numbers, such as 'MD (m), \
                        Inc (deg), Azi (deg)' for a survey or 'Component, OD (in), ID (in), Length \
                        (ft), Weight (lb/ft)' for a tally"
            .to_owned();
    if !held.unread.is_empty() {
        sentence.push_str(&format!(" ({})", held.unread));
    }
    ImportError::new(name, None, ImportErrorKind::Refused(sentence))
}
