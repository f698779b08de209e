//! Origin of a value.

/// Origin of a value.
#[derive(Debug, Clone, PartialEq)]
pub enum Origin {
    /// A place in the file and its text, including the unit where it differs from that of `value`.
    Found {
        /// Such as `line 5, column 'OD'`, `sheet 'BHA', cell C7`, `tubularComponent 3, od`.
        place: String,
        /// The text as written, if the value differs from it: `8 1/2`.
        written: Option<String>,
    },
    /// The value follows from others in the file.
    Derived {
        /// Source and method, in words.
        from: String,
    },
    /// The file does not give it.
    Assumed {
        /// Reason of the assumption.
        because: String,
    },
}

impl Origin {
    /// A place whose text equals the value.
    pub fn at(place: impl Into<String>) -> Self {
        Origin::Found { place: place.into(), written: None }
    }

    /// A place and the text written there.
    pub fn written(place: impl Into<String>, written: impl Into<String>) -> Self {
        Origin::Found { place: place.into(), written: Some(written.into()) }
    }
}
