//! The words of a case file that are the names of the engine's enumerations.

/// Returns all values of an enumeration by their names, for a
/// [`Choice`](wholestring_config::rule::Choice).
macro_rules! words {
    ($enumeration:ident) => {
        &{
            let mut words = [("", $enumeration::ALL[0]); $enumeration::ALL.len()];
            let mut i = 0;
            while i < words.len() {
                words[i] = ($enumeration::ALL[i].name(), $enumeration::ALL[i]);
                i += 1;
            }
            words
        }
    };
}

pub(crate) use words;
