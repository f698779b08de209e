//! What is to be known of a calibration, in sentences.

use wholestring_plan::calibration::{Calibration, Parameter, Settings};
use wholestring_units::{Dimension, UnitSet};

use crate::readings::Readings;

/// Given errors are too small where the sum of squares lies so many standard deviations beyond what
/// it should be, its cube root being nearly normal (Wilson and Hilferty 1931).
const TOO_FAR: f64 = 3.0;

/// A number in three digits, with its unit.
pub(super) fn shown(value: f64, dimension: Dimension, units: UnitSet) -> String {
    let unit = dimension.unit_in(units);
    let value = unit.from_si(value);
    let digits = 2 - libm::log10(value.abs().max(1e-9)).floor() as i32;
    format!("{value:.*} {}", digits.clamp(0, 6) as usize, unit.symbol)
}

/// A depth in whole units.
fn whole(depth_m: f64, units: UnitSet) -> String {
    let unit = Dimension::Length.unit_in(units);
    format!("{:.0} {}", unit.from_si(depth_m), unit.symbol)
}

fn dimension(is_torque: bool) -> Dimension {
    if is_torque { Dimension::Torque } else { Dimension::Force }
}

/// What is good to know.
pub(super) fn notes(
    data: &Readings,
    found: &Calibration,
    settings: &Settings,
    units: UnitSet,
) -> Vec<String> {
    let mut notes = vec![data.notes.join("; ")];
    for of in found.errors.iter().filter(|of| !of.given) {
        let is_torque = matches!(of.kind, wholestring_plan::calibration::ErrorKind::Torque);
        notes.push(format!(
            "the standard error of the {} is estimated from {} residuals: {}",
            of.kind.name(),
            of.readings,
            shown(of.value, dimension(is_torque), units)
        ));
    }
    let looked_for = |of: Parameter| settings.parameters.contains(&of);
    if !looked_for(Parameter::BlockWeight) {
        let weight = shown(found.state.block_weight_N, Dimension::Force, units);
        notes.push(format!("the block is held at {weight}, which the weights hold too"));
    }
    notes
}

/// What is to be wary of.
pub(super) fn warnings(
    data: &Readings,
    found: &Calibration,
    settings: &Settings,
    units: UnitSet,
) -> Vec<String> {
    let mut warnings = Vec::new();
    for of in found.estimates.iter().filter(|of| of.at_bound) {
        warnings.push(format!(
            "the {} would be negative and is held at zero: the readings are below what the string \
             weighs or turns with, or another number is off",
            of.parameter.words()
        ));
    }
    for of in &found.confused {
        warnings.push(format!(
            "the readings do not tell the {} from the {}: their correlation is {:.3}; hold one of \
             them, or read at other depths",
            of.first.words(),
            of.second.words(),
            of.correlation
        ));
    }
    for of in found.estimates.iter().filter(|of| of.interval.contains(&None)) {
        warnings.push(format!(
            "an end of the interval of the {} was not found: the readings hardly tell it",
            of.parameter.words()
        ));
    }
    let given = found.errors.iter().all(|of| of.given);
    let freedom = found.degrees_of_freedom as f64;
    if given && freedom > 0.0 {
        let spread = 2.0 / (9.0 * freedom);
        let z = (libm::cbrt(found.chi2 / freedom) - (1.0 - spread)) / spread.sqrt();
        if z > TOO_FAR {
            warnings.push(format!(
                "the readings scatter {:.1} times as much as their errors say: the model does not \
                 describe this well, or the errors are too small; so are those of what was found",
                (found.chi2 / freedom).sqrt()
            ));
        }
    }
    for (point, place) in found.points.iter().zip(&data.places).filter(|(of, _)| of.outlier) {
        let channel = point.reading.channel;
        let said = |value: f64| shown(value, dimension(channel.is_torque()), units);
        warnings.push(format!(
            "outlier: {} of {} with the bit at {} ({place}), where {} is expected, {:.1} standard \
             errors off",
            channel.name().replace('_', "-"),
            said(point.reading.value),
            whole(point.reading.bit_depth_m, units),
            said(point.predicted),
            point.standardised
        ));
    }
    let beyond = found.points.iter().filter(|of| !of.within_band).count();
    let part = beyond as f64 / found.points.len() as f64;
    let allowed = 1.0 - settings.band_confidence;
    if part > 2.0 * allowed && beyond > 3 {
        warnings.push(format!(
            "{beyond} of {} readings lie outside the band of {:.0} %",
            found.points.len(),
            100.0 * settings.band_confidence
        ));
    }
    warnings
}
