//! Quantities and places within a sentence.

use wholestring::outcome::QuantityKind;
use wholestring_units::{Dimension, UnitSet};

use crate::{Check, quantities};

/// Writes quantities in the units of a user.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Text {
    pub(crate) units: UnitSet,
}

impl Text {
    pub(crate) fn force(&self, force_N: f64) -> String {
        self.quantity(Dimension::Force, force_N)
    }

    pub(crate) fn torque(&self, torque_N_m: f64) -> String {
        self.quantity(Dimension::Torque, torque_N_m)
    }

    pub(crate) fn length(&self, length_m: f64) -> String {
        self.quantity(Dimension::Length, length_m)
    }

    /// A radial length, in small units.
    pub(crate) fn across(&self, length_m: f64) -> String {
        self.quantity(Dimension::Diameter, length_m)
    }

    pub(crate) fn depth(&self, md_m: f64) -> String {
        let unit = Dimension::Length.unit_in(self.units);
        format!("{:.0} {}", unit.from_si(md_m) + 0.0, unit.symbol)
    }

    /// A value of the check's kind of quantity.
    pub(crate) fn of_kind(&self, kind: QuantityKind, si: f64) -> String {
        match quantities::dimension(kind) {
            Some(dimension) => self.quantity(dimension, si),
            None => format!("{si:.3} {}", kind.unit()).trim_end().to_owned(),
        }
    }

    fn quantity(&self, dimension: Dimension, si: f64) -> String {
        dimension.format(self.rounded(dimension, si), self.units)
    }

    /// A value with four significant digits.
    fn rounded(&self, dimension: Dimension, si: f64) -> f64 {
        let unit = dimension.unit_in(self.units);
        let value = unit.from_si(si);
        if value == 0.0 || !value.is_finite() {
            return si;
        }
        let scale = libm::pow(10.0_f64, 3.0 - libm::log10(value.abs()).floor());
        si * ((value * scale).round() / scale / value)
    }

    /// ` at 4310 m`, ` from 50 m to 3350 m` or nothing.
    pub(crate) fn place(&self, check: &Check) -> String {
        match (check.md_m, check.to_md_m) {
            (Some(from), Some(to)) => format!(" from {} to {}", self.depth(from), self.depth(to)),
            (Some(at), None) => format!(" at {}", self.depth(at)),
            _ => String::new(),
        }
    }
}

/// `12 %`, below ten per cent with one decimal.
pub(crate) fn percent(part: f64) -> String {
    let percent = part * 100.0;
    if percent.abs() < 10.0 { format!("{percent:.1} %") } else { format!("{percent:.0} %") }
}

/// A factor in two decimals; `over 100` of a large one.
pub(crate) fn factor(factor: f64) -> String {
    match factor {
        factor if factor.is_nan() => "–".to_owned(),
        factor if factor >= 100.0 => "over 100".to_owned(),
        factor => format!("{factor:.2}"),
    }
}
