//! A case made from files.

use wholestring_units::UnitSet;

use crate::{
    fragment::{Note, quoted},
    log::picking::Picks,
};

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
