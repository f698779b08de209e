//! Where a value comes from.

/// Where a value comes from.
#[derive(Debug, Clone, PartialEq)]
pub enum Origin {
    /// A place of the file, and what stands there, its unit included where it is not in `value`.
    Found {
        /// Such as `line 5, column 'OD'`, `sheet 'BHA', cell C7`, `tubularComponent 3, od`.
        place: String,
        /// As it is written there, where the value does not show it: `8 1/2`.
        written: Option<String>,
    },
    /// It follows from something in the file.
    Derived {
        /// From what, and how, in words.
        from: String,
    },
    /// The file does not tell it.
    Assumed {
        /// Why it is taken to be so.
        because: String,
    },
}

impl Origin {
    /// A place whose value says all that stands there.
    pub fn at(place: impl Into<String>) -> Self {
        Origin::Found { place: place.into(), written: None }
    }

    /// A place, and what is written there.
    pub fn written(place: impl Into<String>, written: impl Into<String>) -> Self {
        Origin::Found { place: place.into(), written: Some(written.into()) }
    }
}
