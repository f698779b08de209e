//! The words of a case file that are the names of the engine's enumerations.

/// All of an enumeration by their names, for a [`Choice`](wholestring_config::rule::Choice).
macro_rules! words {
    ($of:ident) => {
        &{
            let mut words = [("", $of::ALL[0]); $of::ALL.len()];
            let mut i = 0;
            while i < words.len() {
                words[i] = ($of::ALL[i].name(), $of::ALL[i]);
                i += 1;
            }
            words
        }
    };
}

pub(crate) use words;
