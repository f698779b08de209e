//! What a survey file gives.

use wholestring::well::{Station, TieIn};

/// A survey and how it was understood.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportedSurvey {
    /// Two stations or more, by growing measured depth. Azimuths are as written, between -360 and
    /// 720 degrees: they are not wrapped.
    pub stations: Vec<Station>,
    /// Where the first station lies, if the file says so: its true vertical depth, north and east.
    pub tie_in: Option<TieIn>,
    /// What was recognised, assumed and passed over, in sentences for people.
    pub notes: Vec<String>,
}

impl ImportedSurvey {
    /// Where the first station lies: as the file says, or else on the vertical under the origin, as
    /// deep as its measured depth.
    pub fn start(&self) -> TieIn {
        self.tie_in.unwrap_or_else(|| under_origin(&self.stations))
    }
}

/// The first station on the vertical under the origin, as deep as its measured depth.
pub fn under_origin(stations: &[Station]) -> TieIn {
    TieIn { tvd_m: stations.first().map_or(0.0, |first| first.md_m), ..TieIn::default() }
}
