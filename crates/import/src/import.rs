//! From files to a case.

use crate::{
    case_text,
    choices::Choices,
    error::{ImportError, ImportErrorKind},
    format::Format,
    fragment::{Contents, Note, quoted},
    input::Input,
    log::picking::Picks,
    merge::{self, Source},
};

/// What the file of measured weights has after the case's name.
pub(crate) const MEASURED: &str = "-measured.csv";

/// A file beside the case.
#[derive(Debug, Clone, PartialEq)]
pub struct Beside {
    /// What its name has after the case's: `-measured.csv`.
    pub ending: &'static str,
    /// What it holds.
    pub text: String,
}

/// A case that was made of files.
#[derive(Debug, Clone, PartialEq)]
pub struct Imported {
    /// The case file: TOML with comments.
    pub text: String,
    /// How weights were picked from a log, to be drawn.
    pub picks: Vec<Picks>,
    /// Files that stand beside it.
    pub beside: Vec<Beside>,
    /// What each file is: its name and a few words.
    pub files: Vec<(String, String)>,
    /// What is to be said, with the file that it is said of; none where it is said of all.
    pub notes: Vec<(Option<String>, Note)>,
    /// What the case still needs before it can be solved, in sentences.
    pub missing: Vec<String>,
}

impl Imported {
    /// The case file under a name, such as `well` for `well.toml`: [`text`](Self::text), and the
    /// keys that name the files beside it.
    pub fn text_as(&self, stem: &str) -> String {
        let mut text = self.text.clone();
        if self.beside.iter().any(|file| file.ending == MEASURED) {
            let file = quoted(&format!("{stem}{MEASURED}"));
            text += &format!(
                "\n[plan]\nmeasured = {file}  # drawn over the plan; `wholestring calibrate` finds \
                 friction from it\n"
            );
        }
        text
    }
}

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
