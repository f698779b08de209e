//! Notes on a calibration, in sentences.

use wholestring_plan::calibration::{Calibration, ErrorKind, Parameter, Settings};
use wholestring_units::Dimension;

use super::checks::{median, shown};
use crate::readings::Readings;

/// Notes on the file, on estimated errors, and on a block weight that is kept fixed; quantities are
/// marked.
pub(super) fn notes(data: &Readings, found: &Calibration, settings: &Settings) -> Vec<String> {
    let mut notes = vec![data.notes.join("; ")];
    for error in found.errors.iter().filter(|error| !error.given) {
        notes.push(format!(
            "the standard error of the {} is estimated from {} residual{}: {}",
            error.kind.name(),
            error.readings,
            if error.readings == 1 { "" } else { "s" },
            shown(error.value, dimension(error.kind))
        ));
    }
    let looked_for = |parameter: Parameter| settings.parameters.contains(&parameter);
    if !looked_for(Parameter::BlockWeight) {
        let weight = shown(found.state.block_weight_N, Dimension::Force);
        notes.push(format!(
            "the block weight is fixed at {weight}, and the weights include the block"
        ));
    }
    notes
}

/// Dimension of the readings of a kind.
pub(super) fn dimension(kind: ErrorKind) -> Dimension {
    if kind == ErrorKind::Torque { Dimension::Torque } else { Dimension::Force }
}

/// The median of the readings of a kind.
pub(super) fn size(found: &Calibration, kind: ErrorKind) -> f64 {
    let points = found.points.iter().filter(|point| point.reading.channel.error() == kind);
    median(points.map(|point| point.reading.value.abs()).collect())
}

/// Number of readings within their band, and the width of the band: 32 of 32 within a band as wide
/// as the weights themselves would not be agreement. Quantities are marked.
pub(super) fn status(found: &Calibration, settings: &Settings) -> String {
    let within = found.points.iter().filter(|point| point.within_band).count();
    let widths = found.errors.iter().map(|error| {
        let half = found.band_factor * error.value;
        let part = 100.0 * half / size(found, error.kind).max(1e-9);
        format!(
            "±{} ({part:.1} %) of the {}",
            shown(half, dimension(error.kind)),
            error.kind.name()
        )
    });
    format!(
        "{within} of {} readings within the band of {:.0} %: {}",
        found.points.len(),
        100.0 * settings.band_confidence,
        widths.collect::<Vec<_>>().join(", ")
    )
}
