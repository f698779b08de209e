//! Depths and angles of surveys in sentences.

use wholestring_units::{Dimension, UnitSet, number_text};

/// A measured depth to a tenth of its unit.
pub(crate) fn depth(md_m: f64, set: UnitSet) -> String {
    let unit = Dimension::Length.unit_in(set);
    // Adding zero removes the sign of a rounded one.
    let number = (unit.from_si(md_m) * 10.0).round() / 10.0 + 0.0;
    format!("{} {}", number_text(number), unit.symbol)
}

/// A difference of positions to a hundredth of its unit.
pub(crate) fn difference(length_m: f64, set: UnitSet) -> String {
    let unit = Dimension::Length.unit_in(set);
    format!("{:.2} {}", unit.from_si(length_m), unit.symbol)
}

/// A dogleg severity to a tenth of its unit.
pub(crate) fn severity(rad_per_m: f64, set: UnitSet) -> String {
    let unit = Dimension::DoglegSeverity.unit_in(set);
    format!("{:.1} {}", unit.from_si(rad_per_m), unit.symbol)
}

/// An azimuth of up to two turns, reduced to the range of azimuths in a case, which ends at one; and
/// whether it was reduced.
pub fn within_a_turn(azimuth_rad: f64) -> (f64, bool) {
    const TURN_RAD: f64 = std::f64::consts::TAU;
    match azimuth_rad > TURN_RAD {
        true => (azimuth_rad - TURN_RAD, true),
        false => (azimuth_rad, false),
    }
}

/// An angle in degrees to a hundredth.
pub(crate) fn degrees(angle_rad: f64) -> String {
    number_text((angle_rad.to_degrees() * 100.0).round() / 100.0)
}
