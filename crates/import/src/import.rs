//! Entry points of the import.

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

/// Makes one case from several files.
///
/// # Errors
/// A file has an unsupported format or cannot be read, a unit is missing, several items are
/// possible, or two files hold the same part.
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

/// Describes a file and its contents.
///
/// # Errors
/// Its format is not supported, or it is damaged.
pub fn contents(mut input: Input) -> Result<Contents, ImportError> {
    Format::of(&mut input)?.contents(input)
}
