//! What becomes of what lies in a folder, by the word that the package has for it.

use wholestring_runner::Existing;

/// What becomes of what lies in a folder.
pub(crate) fn existing_of(word: &str) -> Existing {
    match word {
        "resume" => Existing::Resume,
        "overwrite" => Existing::Overwrite,
        _ => Existing::Protect,
    }
}
