//! Whose names stand in a file, and its units.

use wholestring_units::{Dimension, Unit, UnitSet};

/// Whose names stand in a file, when it was made, and its units.
#[derive(Debug, Clone, PartialEq)]
pub struct Look {
    /// Name of the case, for the well.
    pub name: String,
    /// When the file is made, as XML writes it: `2026-01-31T12:00:00Z`.
    pub created: String,
    /// Program and version.
    pub program: String,
    /// Field units or SI; metric ones are SI here, for WITSML has no tonne of force in use.
    pub units: UnitSet,
}

/// A unit as WITSML calls it, both generations: what they share, and one way to write it here.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Uom {
    pub(crate) symbol: &'static str,
    unit: &'static Unit,
}

impl Uom {
    /// A value in SI, in this unit.
    pub(crate) fn of(&self, si: f64) -> f64 {
        self.unit.from_si(si)
    }

    /// The same as WITSML 2 calls it, where that differs from what 1.4.1.1 does.
    pub(crate) fn of_series_2(self) -> Self {
        let symbol = match self.symbol {
            "dega/30m" => "1/30 dega/m",
            "dega/100ft" => "0.01 dega/ft",
            other => other,
        };
        Self { symbol, ..self }
    }
}

impl Look {
    /// The unit of a dimension, as WITSML calls it.
    pub(crate) fn uom(&self, dimension: Dimension) -> Uom {
        let set = match self.units {
            UnitSet::Field => UnitSet::Field,
            UnitSet::Si | UnitSet::Metric => UnitSet::Si,
        };
        let unit = dimension.unit_in(set);
        let symbol = match unit.symbol {
            "deg" => "dega",
            "deg/30m" => "dega/30m",
            "deg/100ft" => "dega/100ft",
            "ft-lbf" => "lbf.ft",
            "lb/ft" => "lbm/ft",
            other => other,
        };
        Uom { symbol, unit }
    }
}
