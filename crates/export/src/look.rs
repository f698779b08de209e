//! Names in a file, and its units.

use wholestring_units::{Dimension, Unit, UnitSet, significant};

/// Names in a file, its time of creation, and its units.
#[derive(Debug, Clone, PartialEq)]
pub struct Look {
    /// Name of the case, for the well.
    pub name: String,
    /// Time of creation in XML notation: `2026-01-31T12:00:00Z`.
    pub created: String,
    /// Program and version.
    pub program: String,
    /// Field units or SI; metric units are written as SI, because WITSML has no tonne-force in
    /// common use.
    pub units: UnitSet,
}

/// A WITSML unit: its symbol, common to both generations, and one conversion.
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

    /// The same with its symbol in WITSML 2, if that differs from 1.4.1.1.
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
    /// The WITSML unit of a dimension.
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

// Numbers as texts.

/// Significant digits of the numbers in WITSML: a tenth of a millimetre in 10 km.
pub const DIGITS: usize = 8;

/// A number to [`DIGITS`], without trailing zeros and without a power of ten; none if it is not
/// finite.
///
/// ```
/// use wholestring_export::number;
///
/// assert_eq!(number(1.0 / 3.0).as_deref(), Some("0.33333333"));
/// assert_eq!(number(-0.0).as_deref(), Some("0"));
/// assert_eq!(number(f64::NAN), None);
/// ```
pub fn number(value: f64) -> Option<String> {
    // Without negative zero.
    value.is_finite().then(|| (significant(value, DIGITS) + 0.0).to_string())
}
