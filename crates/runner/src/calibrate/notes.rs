//! What is to be known of a calibration, in sentences.

use wholestring_plan::calibration::{Calibration, ErrorKind, Parameter, Settings};
use wholestring_units::{Dimension, UnitSet};

use super::checks::{median, shown};
use crate::readings::Readings;

/// Notes on the file, on errors that are estimated, and on a block that is held.
pub(super) fn notes(
    data: &Readings,
    found: &Calibration,
    settings: &Settings,
    units: UnitSet,
) -> Vec<String> {
    let mut notes = vec![data.notes.join("; ")];
    for of in found.errors.iter().filter(|of| !of.given) {
        notes.push(format!(
            "the standard error of the {} is estimated from {} residuals: {}",
            of.kind.name(),
            of.readings,
            shown(of.value, dimension(of.kind), units)
        ));
    }
    let looked_for = |of: Parameter| settings.parameters.contains(&of);
    if !looked_for(Parameter::BlockWeight) {
        let weight = shown(found.state.block_weight_N, Dimension::Force, units);
        notes.push(format!("the block is held at {weight}, which the weights hold too"));
    }
    notes
}

/// What readings of a kind measure.
pub(super) fn dimension(kind: ErrorKind) -> Dimension {
    if kind == ErrorKind::Torque { Dimension::Torque } else { Dimension::Force }
}

/// The median of the readings of a kind.
pub(super) fn size(found: &Calibration, kind: ErrorKind) -> f64 {
    let of = found.points.iter().filter(|point| point.reading.channel.error() == kind);
    median(of.map(|point| point.reading.value.abs()).collect())
}

/// How many readings lie within their band, and how wide the band is: 32 of 32 within a band as wide as the
/// weights themselves are no agreement.
pub(super) fn status(found: &Calibration, settings: &Settings, units: UnitSet) -> String {
    let within = found.points.iter().filter(|of| of.within_band).count();
    let widths = found.errors.iter().map(|of| {
        let half = found.band_factor * of.value;
        let part = 100.0 * half / size(found, of.kind).max(1e-9);
        format!(
            "±{} ({part:.1} %) of the {}",
            shown(half, dimension(of.kind), units),
            of.kind.name()
        )
    });
    format!(
        "{within} of {} readings within the band of {:.0} %: {}",
        found.points.len(),
        100.0 * settings.band_confidence,
        widths.collect::<Vec<_>>().join(", ")
    )
}
