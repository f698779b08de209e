//! From files to a case, and to what they hold.

use crate::{
    case_text,
    choices::Choices,
    error::{ImportError, ImportErrorKind},
    format::Format,
    fragment::Contents,
    imported::Imported,
    input::Input,
    log::picking::Picks,
    merge::{self, Source},
};

/// Makes one case of some files.
///
/// # Errors
/// A file is none that is known or cannot be read, a unit is missing, several things may be meant,
/// or two files hold the same.
pub fn import(inputs: Vec<Input>, choices: &Choices) -> Result<Imported, ImportError> {
    let mut sources = Vec::with_capacity(inputs.len());
    for mut input in inputs {
        let name = input.name().to_owned();
        let format = Format::of(&mut input)?;
        sources.push(Source { name, fragment: format.read(input, choices)? });
    }
    let picks = sources.iter_mut().filter_map(|source| source.fragment.picks.take());
    let picks: Vec<Picks> = picks.map(|picks| *picks).collect();
    let draft = merge::merge(sources, choices)?;
    let unused = choices.unused();
    if !unused.is_empty() {
        let kind = ImportErrorKind::Unused { options: unused };
        let names: Vec<&str> = draft.files.iter().map(|(name, _)| name.as_str()).collect();
        return Err(ImportError::new(&names.join(", "), None, kind));
    }
    Ok(Imported { picks, ..case_text::write(draft) })
}

/// What a file is, and what it holds.
///
/// # Errors
/// It is none of the formats, or damaged.
pub fn contents(mut input: Input) -> Result<Contents, ImportError> {
    Format::of(&mut input)?.contents(input)
}
