//! Head of a page.

use serde_json::Value as Json;
use wholestring_report::{Fact, PageHead};
use wholestring_units::UnitSet;

use super::{dimensions, file::PROGRAM};

/// Head of a page that opens in these units, by default in those of the case.
pub(crate) fn head(
    title: String,
    units: Option<UnitSet>,
    settings: Option<&Json>,
    facts: Vec<Fact>,
) -> PageHead {
    PageHead {
        program: PROGRAM.into(),
        title,
        units: opening_units(units, settings),
        dimensions: dimensions::all(),
        facts,
    }
}

/// Name of the units that a page opens with.
pub(super) fn opening_units(units: Option<UnitSet>, settings: Option<&Json>) -> String {
    let of_the_case = || settings.and_then(|settings| settings["units"].as_str());
    units.map(UnitSet::name).or_else(of_the_case).unwrap_or("si").into()
}
