//! One case from the fragments of several files.

use wholestring_tabular::ImportedReading;
use wholestring_units::UnitSet;

use crate::{
    choices::Choices,
    error::{ImportError, ImportErrorKind},
    fragment::{Block, Entry, Fragment, Note, Part, Survey},
};

/// A file and its contribution.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Source {
    pub(crate) name: String,
    pub(crate) fragment: Fragment,
}

/// A value and the index of the file that it comes from.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Sourced<T> {
    pub(crate) file: usize,
    pub(crate) item: T,
}

/// A case before it is written: every part from one file, every key from one.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Draft {
    /// Names of the files and their kinds.
    pub(crate) files: Vec<(String, String)>,
    pub(crate) name: Option<Sourced<Entry>>,
    pub(crate) survey: Option<Sourced<Survey>>,
    pub(crate) hole: Option<Sourced<Vec<Block>>>,
    pub(crate) string: Option<Sourced<Vec<Block>>>,
    pub(crate) mud: Vec<Sourced<Entry>>,
    pub(crate) rig: Vec<Sourced<Entry>>,
    pub(crate) operation: Vec<Sourced<Entry>>,
    pub(crate) bit: Vec<Sourced<Entry>>,
    /// Weights and torques that were measured, of all files.
    pub(crate) measured: Vec<ImportedReading>,
    /// Those of another program.
    pub(crate) overlay: Vec<ImportedReading>,
    /// Units of measured weights and depths, if field units in one of the files.
    pub(crate) units: Option<UnitSet>,
    /// Notes by file; `None` for those on the whole case.
    pub(crate) notes: Vec<(Option<usize>, Note)>,
}

/// Joins fragments: a part in two files is an error unless one is picked.
pub(crate) fn merge(mut sources: Vec<Source>, choices: &Choices) -> Result<Draft, ImportError> {
    let mut draft = Draft::default();
    for part in Part::ALL {
        pick(part, &mut sources, choices, &mut draft.notes)?;
    }
    for (file, Source { name, fragment }) in sources.into_iter().enumerate() {
        if draft.name.is_none() {
            draft.name = fragment.name.map(|name| Sourced { file, item: name });
        }
        draft.survey =
            draft.survey.or(fragment.survey.map(|survey| Sourced { file, item: survey }));
        let blocks = |own: Vec<Block>| (!own.is_empty()).then_some(Sourced { file, item: own });
        draft.hole = draft.hole.or(blocks(fragment.hole));
        draft.string = draft.string.or(blocks(fragment.string));
        for (all, own) in [
            (&mut draft.mud, fragment.mud),
            (&mut draft.rig, fragment.rig),
            (&mut draft.operation, fragment.operation),
            (&mut draft.bit, fragment.bit),
        ] {
            all.extend(own.entries.into_iter().map(|entry| Sourced { file, item: entry }));
        }
        if draft.units != Some(UnitSet::Field) {
            draft.units = fragment.units.or(draft.units);
        }
        draft.measured.extend(fragment.measured);
        draft.overlay.extend(fragment.overlay);
        draft.notes.extend(fragment.notes.into_iter().map(|note| (Some(file), note)));
        draft.files.push((name, fragment.what));
    }
    Ok(draft)
}

/// Keeps a part in the picked one of the files that contain it, and drops it from the others.
fn pick(
    part: Part,
    sources: &mut [Source],
    choices: &Choices,
    notes: &mut Vec<(Option<usize>, Note)>,
) -> Result<(), ImportError> {
    let holders: Vec<usize> =
        (0..sources.len()).filter(|&file| sources[file].fragment.parts().contains(&part)).collect();
    let [first, second, ..] = holders[..] else { return Ok(()) };
    let names: Vec<String> = holders.iter().map(|&file| sources[file].name.clone()).collect();
    let Some(picked) = choices.picked(part.name()) else {
        let kind =
            ImportErrorKind::InTwoFiles { what: part.name(), first: sources[first].name.clone() };
        return Err(ImportError::new(&sources[second].name, None, kind));
    };
    let is_picked = |name: &str| name == picked || name.rsplit(['/', '\\']).next() == Some(picked);
    if !names.iter().any(|name| is_picked(name)) {
        let kind = ImportErrorKind::NoSuch {
            what: part.name().to_owned(),
            name: picked.to_owned(),
            names: names.clone(),
        };
        return Err(ImportError::new(&names.join(", "), None, kind));
    }
    for (&file, name) in holders.iter().zip(&names) {
        if !is_picked(name) {
            sources[file].fragment.drop_part(part);
            let text = format!("the {}, because that of {picked} was picked", part.name());
            notes.push((Some(file), Note::LeftOut(text)));
        }
    }
    Ok(())
}
