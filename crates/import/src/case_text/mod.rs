//! A case file with comments: every value with its origin.

mod complete;
mod lines;

use crate::{
    fragment::Note,
    import::{Beside, Imported, MEASURED, OVERLAY},
    merge::Draft,
    readings_csv::readings_csv,
};

/// Writes a draft: parts that it lacks are assumed where possible, otherwise written as comments.
pub(crate) fn write(mut draft: Draft) -> Imported {
    let missing = complete::complete(&mut draft);
    let text = lines::text(&draft, &missing);
    let units = lines::shown_units(&draft);
    let beside = [(MEASURED, &draft.measured), (OVERLAY, &draft.overlay)]
        .into_iter()
        .filter(|(_, readings)| !readings.is_empty())
        .map(|(ending, readings)| Beside { ending, text: readings_csv(readings, units) })
        .collect();
    let names: Vec<String> = draft.files.iter().map(|(name, _)| name.clone()).collect();
    let of_file = |file: Option<usize>| file.and_then(|file| names.get(file).cloned());
    Imported {
        text,
        units,
        picks: Vec::new(),
        beside,
        notes: warnings_first(draft.notes.into_iter().map(|(file, note)| (of_file(file), note))),
        files: draft.files,
        missing: missing.iter().map(|part| part.sentence.to_owned()).collect(),
    }
}

/// Notes with the warnings before the others, which may be many.
fn warnings_first<File>(notes: impl Iterator<Item = (File, Note)>) -> Vec<(File, Note)> {
    let (mut warnings, others): (Vec<_>, Vec<_>) =
        notes.partition(|(_, note)| matches!(note, Note::Warning(_)));
    warnings.extend(others);
    warnings
}
