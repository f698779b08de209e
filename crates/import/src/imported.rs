//! A case that was made of files.

use wholestring_units::UnitSet;

use crate::{
    fragment::{Note, quoted},
    log::picking::Picks,
};

/// What the names of files of readings have after the case's.
pub(crate) const MEASURED: &str = "-measured.csv";
pub(crate) const OVERLAY: &str = "-overlay.csv";

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
    /// The units that the case shows.
    pub units: UnitSet,
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
