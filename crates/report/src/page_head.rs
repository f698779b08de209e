//! Head of a page.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::Value as Json;
use wholestring_units::UnitSet;

use crate::{Cell, DisplayUnit, dimensions::display_units};

/// Name and version of the program.
pub const PROGRAM: &str = concat!("wholestring ", env!("CARGO_PKG_VERSION"));

/// Head of a page.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PageHead {
    /// Name and version of the program.
    pub program: String,
    /// Its title.
    pub title: String,
    /// Units that it opens with: `si`, `metric` or `field`.
    pub units: String,
    /// By dimension: its unit in SI, metric and field units.
    pub dimensions: BTreeMap<String, [DisplayUnit; 3]>,
    /// The case in a few facts, such as operations, depth and models; those common to all cases or
    /// points.
    pub facts: Vec<Fact>,
}

impl PageHead {
    /// Head of a page that opens in these units, by default in those of the case.
    pub fn new(
        title: String,
        units: Option<UnitSet>,
        settings: Option<&Json>,
        facts: Vec<Fact>,
    ) -> Self {
        let of_the_case = || settings.and_then(|settings| settings["units"].as_str());
        let units = units.map(UnitSet::name).or_else(of_the_case).unwrap_or("si");
        let dimensions = display_units();
        Self { program: PROGRAM.into(), title, units: units.into(), dimensions, facts }
    }
}

/// A value with its label.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Fact {
    /// Its label.
    pub label: String,
    /// The value.
    pub value: Cell,
}

impl Fact {
    /// A value under its label.
    pub(crate) fn new(label: &str, value: Cell) -> Self {
        Self { label: label.into(), value }
    }
}
