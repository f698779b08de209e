//! Entry points of the import.

use wholestring_units::UnitSet;

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

// A case made from files.

/// Suffix of the names of readings files, after the case's name.
pub(crate) const MEASURED: &str = "-measured.csv";
pub(crate) const OVERLAY: &str = "-overlay.csv";

/// A file that accompanies the case.
#[derive(Debug, Clone, PartialEq)]
pub struct Beside {
    /// Suffix of its name, after the case's name: `-measured.csv`.
    pub ending: &'static str,
    /// Contents of the file.
    pub text: String,
}

/// A case made from files.
#[derive(Debug, Clone, PartialEq)]
pub struct Imported {
    /// The case file: TOML with comments.
    pub text: String,
    /// The units of the case.
    pub units: UnitSet,
    /// Evidence of weights picked from a log, for drawing.
    pub picks: Vec<Picks>,
    /// Files that accompany it.
    pub beside: Vec<Beside>,
    /// Each input file: its name and a short description.
    pub files: Vec<(String, String)>,
    /// Notes, with the file that they concern; `None` if they concern all.
    pub notes: Vec<(Option<String>, Note)>,
    /// Parts that the case still lacks before it can be solved, in sentences.
    pub missing: Vec<String>,
}

impl Imported {
    /// The case file under a name, such as `well` for `well.toml`: [`text`](Self::text), and the
    /// keys with the names of the accompanying files.
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
