//! The unit sets that people choose between.

use std::fmt;
use std::str::FromStr;

/// The units in which results are shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum UnitSet {
    /// m, kN, kN.m, mm, kg/m3.
    #[default]
    Si,
    /// m, t (tonne-force), kN.m, mm, sg.
    Metric,
    /// ft, klbf, ft-lbf, in, ppg.
    Field,
}

impl UnitSet {
    /// Every unit set.
    pub const ALL: &[UnitSet] = &[UnitSet::Si, UnitSet::Metric, UnitSet::Field];

    /// The name in case files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            UnitSet::Si => "si",
            UnitSet::Metric => "metric",
            UnitSet::Field => "field",
        }
    }
}

impl fmt::Display for UnitSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// A name that is no unit set.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("'{0}' is not a unit set; expected \"si\", \"metric\" or \"field\"")]
pub struct UnknownUnitSet(pub String);

impl FromStr for UnitSet {
    type Err = UnknownUnitSet;

    fn from_str(text: &str) -> Result<Self, UnknownUnitSet> {
        UnitSet::ALL
            .iter()
            .copied()
            .find(|set| set.name() == text)
            .ok_or_else(|| UnknownUnitSet(text.to_owned()))
    }
}
