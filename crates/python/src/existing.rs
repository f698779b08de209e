//! Treatment of existing results in a folder, by the package's words.

use wholestring_runner::Existing;

/// Treatment of existing results in a folder.
pub(crate) fn existing_of(word: &str) -> Existing {
    match word {
        "resume" => Existing::Resume,
        "overwrite" => Existing::Overwrite,
        _ => Existing::Protect,
    }
}
