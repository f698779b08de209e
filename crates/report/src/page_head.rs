//! Head of a page.

use serde_json::Value as Json;
use wholestring_units::UnitSet;

use crate::{Fact, PageHead, dimensions::display_units};

/// Name and version of the program.
pub const PROGRAM: &str = concat!("wholestring ", env!("CARGO_PKG_VERSION"));

impl PageHead {
    /// Head of a page that opens in these units, by default in those of the case.
    pub fn new(
        title: String,
        units: Option<UnitSet>,
        settings: Option<&Json>,
        facts: Vec<Fact>,
    ) -> Self {
        Self {
            program: PROGRAM.into(),
            title,
            units: opening_units(units, settings),
            dimensions: display_units(),
            facts,
        }
    }
}

/// Name of the units that a page opens with.
pub fn opening_units(units: Option<UnitSet>, settings: Option<&Json>) -> String {
    let of_the_case = || settings.and_then(|settings| settings["units"].as_str());
    units.map(UnitSet::name).or_else(of_the_case).unwrap_or("si").into()
}

impl Fact {
    /// A value under its label.
    pub(crate) fn new(label: &str, value: crate::Cell) -> Self {
        Self { label: label.into(), value }
    }
}
