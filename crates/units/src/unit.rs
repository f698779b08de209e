//! One unit of measurement.

/// Words in field units.
const FIELD: &[&str] = &[
    "ft", "usft", "in", "yd", "lb", "lbf", "klb", "klbf", "kft", "psi", "ksi", "Mpsi", "ppg",
    "gpm", "gal", "bbl", "tonUS", "tonfUS",
];

/// A unit of one dimension.
#[derive(Debug, PartialEq)]
pub struct Unit {
    /// Printed symbol, which is also one of its spellings.
    pub symbol: &'static str,
    /// Other spellings. Spaces, and the sign of a product (`.`, `·`, `*`, `-`, none), are free in
    /// all of them.
    pub aliases: &'static [&'static str],
    /// SI units per this unit: `kN` has 1000, `deg` has π/180.
    pub factor: f64,
}

impl Unit {
    /// Converts a value in this unit to SI.
    pub fn to_si(&self, value: f64) -> f64 {
        value * self.factor
    }

    /// Converts an SI value to this unit.
    pub fn from_si(&self, si: f64) -> f64 {
        si / self.factor
    }

    /// Whether it is a field unit: of feet, pounds, gallons. With these units a comma separates
    /// thousands.
    pub fn is_field(&self) -> bool {
        self.symbol.split(|c: char| !c.is_alphabetic()).any(|word| FIELD.contains(&word))
    }

    /// The symbol and the aliases.
    pub fn spellings(&self) -> impl Iterator<Item = &'static str> {
        std::iter::once(self.symbol).chain(self.aliases.iter().copied())
    }
}

/// A quantity as written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Written {
    /// The number before its unit.
    pub number: f64,
    /// The unit after it.
    pub unit: &'static Unit,
    /// Value in SI.
    pub si: f64,
}
