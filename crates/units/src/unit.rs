//! One unit of measurement.

/// Words of units of the field.
const FIELD: &[&str] = &[
    "ft", "usft", "in", "yd", "lb", "lbf", "klb", "klbf", "kft", "psi", "ksi", "Mpsi", "ppg",
    "gpm", "gal", "bbl", "tonUS", "tonfUS",
];

/// A unit of one dimension.
#[derive(Debug, PartialEq)]
pub struct Unit {
    /// How the unit is printed, and one way to write it.
    pub symbol: &'static str,
    /// Other ways to write it. Spaces, and the sign of a product (`.`, `·`, `*`, `-`, none), are
    /// free in all of them.
    pub aliases: &'static [&'static str],
    /// SI units per this unit: `kN` has 1000, `deg` has π/180.
    pub factor: f64,
}

impl Unit {
    /// A value in this unit, in SI.
    pub fn to_si(&self, value: f64) -> f64 {
        value * self.factor
    }

    /// An SI value, in this unit.
    pub fn from_si(&self, si: f64) -> f64 {
        si / self.factor
    }

    /// Whether it is of the field: of feet, pounds, gallons. Where they are used a comma parts
    /// thousands.
    pub fn is_field(&self) -> bool {
        self.symbol.split(|c: char| !c.is_alphabetic()).any(|word| FIELD.contains(&word))
    }

    /// The symbol and the aliases.
    pub fn spellings(&self) -> impl Iterator<Item = &'static str> {
        std::iter::once(self.symbol).chain(self.aliases.iter().copied())
    }
}

/// A quantity as it was written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Written {
    /// The number before its unit.
    pub number: f64,
    /// The unit behind it.
    pub unit: &'static Unit,
    /// What both make in SI.
    pub si: f64,
}
